#include "engine/render/collider_pass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "engine/gpu/debug_group.hpp"
#include "engine/model/collider_motion.hpp"
#include "engine/render/render_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

constexpr int kSectors = 64, kRings = 33;   // as in shaders/terrain/collider.vert, the joint of a capsule included
constexpr std::size_t kCapsuleSpheres = 4;  // that stand for a capsule in the shades
constexpr std::size_t kMeshSpheres = 16;    // and for a mesh
constexpr float kCoverReach = 4.0f;         // radii: beyond it a sphere covers less than 2% of a blade's sky
constexpr float kLongestShadowM = 30.0f;

void addSpheres(const ColliderPrimitive& part, std::vector<glm::vec4>& spheres) {
  const glm::vec3 a(part.a), b(part.b);
  const float length = glm::distance(a, b), radius = part.a.w;
  const std::size_t count = std::min(kCapsuleSpheres, 1 + static_cast<std::size_t>(std::ceil(length / radius)));
  for (std::size_t i = 0; i < count; ++i) {
    const float t = count > 1 ? float(i) / float(count - 1) : 0.0f;
    spheres.emplace_back(glm::mix(a, b, t), radius);
  }
}

std::vector<glm::vec4> spheresOf(const Collider& collider, const HeightField* ground, double seconds) {
  Collider touching = collider;  // what is muted takes light, too
  touching.muted = false;
  std::vector<ColliderPrimitive> parts = colliderPrimitives(touching, ground, seconds);
  std::ranges::stable_sort(parts, std::greater{}, [](const ColliderPrimitive& part) { return part.a.w; });
  if (parts.size() > kMeshSpheres) parts.resize(kMeshSpheres);
  std::vector<glm::vec4> spheres;
  for (const ColliderPrimitive& part : parts) addSpheres(part, spheres);
  return spheres;
}

void keepNearest(std::vector<glm::vec4>& spheres, std::size_t count, glm::vec3 eye) {
  if (spheres.size() <= count) return;
  std::ranges::stable_sort(spheres, {}, [eye](glm::vec4 s) { return glm::distance(glm::vec3(s), eye) - s.w; });
  spheres.resize(count);
}

/// Where a sphere takes light: around it and down its shadow.
void addReach(glm::vec4 sphere, float groundM, glm::vec3 sunDirection, ColliderShadeBlock& block) {
  const glm::vec3 centre(sphere);
  const float drop = std::max(centre.y - groundM, 0.0f) + 2.0f * sphere.w;  // to ground that falls away a little
  const glm::vec3 shadow = centre - sunDirection * std::min(drop / std::max(sunDirection.y, 0.05f), kLongestShadowM);
  const float reach = kCoverReach * sphere.w;
  block.low = glm::vec4(glm::min(glm::vec3(block.low), glm::min(centre, shadow) - reach), block.low.w);
  block.high = glm::vec4(glm::max(glm::vec3(block.high), glm::max(centre, shadow) + reach), block.high.w);
}

}  // namespace

ColliderShadeBlock makeColliderShades(const Project& project, double seconds, glm::vec3 eye, glm::vec3 sunDirection,
                                      std::span<const glm::vec4> surfaces) {
  const HeightField* ground = project.terrain->heights.get();
  std::vector<glm::vec4> spheres;
  for (const Collider& collider : *project.colliders) {
    if (collider.hidden) continue;
    const std::vector<glm::vec4> own = spheresOf(collider, ground, seconds);
    spheres.insert(spheres.end(), own.begin(), own.end());
  }
  keepNearest(spheres, COLLIDER_SHADE_SPHERES, eye);
  const std::size_t moving = spheres.size();
  std::vector<glm::vec4> still(surfaces.begin(), surfaces.end());
  keepNearest(still, COLLIDER_SHADE_SPHERES - moving, eye);
  spheres.insert(spheres.end(), still.begin(), still.end());
  ColliderShadeBlock block{};
  block.low = glm::vec4(glm::vec3(1e9f), static_cast<float>(spheres.size()));
  block.high = glm::vec4(glm::vec3(-1e9f), static_cast<float>(moving));
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    block.spheres[i] = spheres[i];
    const glm::vec2 place(spheres[i].x, spheres[i].z);
    addReach(spheres[i], ground != nullptr ? heightAt(*ground, place) : 0.0f, sunDirection, block);
  }
  return block;
}

Result<ColliderPass> ColliderPass::create(gpu::ShaderLibrary& shaders) {
  ColliderPass pass;
  if (Status loaded =
          loadPrograms(shaders, {{"terrain/collider", &pass.m_drawShape}, {"terrain/collider mesh", &pass.m_drawMesh}});
      !loaded) {
    return loaded.error();
  }
  Result<gpu::Texture> white = gpu::Texture::create2D("collider white", {1, 1}, GL_RGBA8);
  if (!white) return white.error();
  pass.m_white = std::move(*white);
  const std::uint8_t pixel[4] = {255, 255, 255, 255};
  pass.m_white.upload(GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  Result<gpu::Buffer> shades =
      gpu::Buffer::create("collider shades", sizeof(ColliderShadeBlock), gpu::BufferUse::Dynamic);
  if (!shades) return shades.error();
  pass.m_shades = std::move(*shades);
  pass.m_noVertices = gpu::VertexArray::create("colliders");
  return pass;
}

Status ColliderPass::configure(const std::vector<Collider>& colliders) {
  std::vector<std::shared_ptr<const PlantMesh>> meshes;
  for (const Collider& collider : colliders) {
    if (collider.shape == ColliderShape::Mesh) meshes.push_back(collider.mesh);
  }
  return m_objects.configure(meshes);
}

void ColliderPass::bindShades(const Project& project, double seconds, glm::vec3 eye, glm::vec3 sunDirection,
                              std::span<const glm::vec4> surfaces) {
  const ColliderShadeBlock block = makeColliderShades(project, seconds, eye, sunDirection, surfaces);
  m_shades.write(&block, sizeof block);
  m_shades.bindUniform(RENDER_UBO_COLLIDERS);
}

void ColliderPass::drawShape(const Collider& collider, const glm::mat4& world) const {
  m_drawShape->use();
  m_noVertices.bind();
  m_drawShape->set("world", world);
  const float length = collider.shape == ColliderShape::Capsule ? collider.length : 0.0f;
  m_drawShape->set("shape", glm::vec2(collider.radius, length));
  glDrawArrays(GL_TRIANGLES, 0, kSectors * kRings * 6);
}

void ColliderPass::drawMesh(const Collider& collider, const glm::mat4& world) const {
  const ObjectMesh* object = m_objects.find(collider.mesh);
  if (object == nullptr) return;  // not read yet
  m_drawMesh->use();
  m_drawMesh->set("world", world);
  m_drawMesh->set("cutoff", collider.mesh->alphaCutoff);
  (object->texture.name() != 0 ? object->texture : m_white).bind(RENDER_TEXTURE_COLLIDER);
  object->draw();
}

void ColliderPass::draw(const gpu::PassState& state, const Project& project, double seconds) const {
  if (project.colliders->empty()) return;
  const gpu::DebugGroup group("colliders");
  gpu::apply(state);
  for (const Collider& collider : *project.colliders) {
    if (collider.hidden) continue;
    const glm::mat4 world = colliderPose(collider, project.terrain->heights.get(), seconds).world;
    if (collider.shape == ColliderShape::Mesh) {
      drawMesh(collider, world);
    } else {
      drawShape(collider, world);
    }
  }
}

}  // namespace windloom
