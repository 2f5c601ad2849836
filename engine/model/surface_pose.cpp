#include "engine/model/surface_pose.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include "engine/model/surface_shapes.hpp"

namespace windloom {
namespace {

/// Height of the lowest vertex under a turn, in the mesh's own metres.
float lowest(const Surface& surface, const glm::mat4& turn) {
  const std::shared_ptr<const PlantMesh> mesh = surfaceMesh(surface);
  if (!mesh || mesh->indices.empty()) return 0.0f;
  if (surface.tilt == 0.0f) return mesh->low.y;
  const glm::vec3 up(turn[0].y, turn[1].y, turn[2].y);
  float low = std::numeric_limits<float>::max();
  for (const PlantVertex& vertex : mesh->vertices) {
    const float height = glm::dot(up, vertex.position);
    if (height < low) low = height;
  }
  return std::isfinite(low) && low < std::numeric_limits<float>::max() ? low : 0.0f;
}

}  // namespace

float surfaceScale(const Surface& surface) {
  return surface.shape == SurfaceShape::Mesh ? surface.scale : surface.size;
}

glm::mat4 surfacePose(const Surface& surface, const HeightField* ground) {
  const glm::mat4 one(1.0f);
  const glm::mat4 turn = glm::rotate(one, -glm::radians(surface.rotation), glm::vec3(0.0f, 1.0f, 0.0f)) *
                         glm::rotate(one, glm::radians(surface.tilt), glm::vec3(1.0f, 0.0f, 0.0f));
  const float scale = surfaceScale(surface);
  const float under = ground != nullptr ? heightAt(*ground, surface.position) : 0.0f;
  const glm::vec3 origin(surface.position.x, under + surface.lift - scale * lowest(surface, turn), surface.position.y);
  return glm::translate(one, origin) * turn * glm::scale(one, glm::vec3(scale));
}

}  // namespace windloom
