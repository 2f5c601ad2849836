#include "engine/render/frame_block.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

// Room around the field in the map of solids, m: the longest shadow of a 4 m solid under defaultLight().
constexpr float kSolidMargin = 10.0f;
// Haze over a field's longer side is at most so thick (optical depth): a field of kilometres stays visible as a whole.
constexpr float kMostHaze = 0.5f;
// Time given to the shaders repeats after this, s, so that a float holds it to a tenth of a millisecond.
constexpr double kTimeWrap = 1200.0;

/// Planes of the view volume, normals inwards (Gribb & Hartmann 2001).
void fillFrustum(const glm::mat4& viewProjection, glm::vec4 (&planes)[6]) {
  const glm::mat4 rows = glm::transpose(viewProjection);
  for (int axis = 0; axis < 3; ++axis) {
    planes[2 * axis] = rows[3] + rows[axis];
    planes[2 * axis + 1] = rows[3] - rows[axis];
  }
  for (glm::vec4& plane : planes) plane /= std::max(glm::length(glm::vec3(plane)), 1e-12f);
}

glm::vec3 forwardOf(const glm::mat4& view) {
  return -glm::vec3(view[0][2], view[1][2], view[2][2]);
}

}  // namespace

Light defaultLight() {
  return {.sunDirection = glm::normalize(glm::vec3(-0.62f, 0.40f, -0.68f)),
          .sunColour = glm::vec3(1.0f, 0.79f, 0.54f) * 4.6f,
          .skyColour = glm::vec3(0.50f, 0.62f, 0.80f) * 1.25f,
          .exposure = 0.78f,
          .haze = 0.0022f};
}

SolidMapArea solidMapArea(const FieldSettings& field) {
  const glm::vec2 size = field.size + 2.0f * kSolidMargin;
  return {field.centre - 0.5f * size, size};
}

FrameBlock makeFrameBlock(const FrameInput& input, const Light& light) {
  const FieldSettings& field = *input.project->field;
  const ViewCamera& camera = input.camera;
  const float aspect = static_cast<float>(input.size.x) / static_cast<float>(input.size.y);
  const glm::mat4 view = camera.view();
  const float height = static_cast<float>(input.size.y);
  const float perMetre = camera.orthographic ? height / camera.orthographicHeight
                                             : 0.5f * height / std::tan(0.5f * glm::radians(camera.fieldOfView));
  const SolidMapArea solids = solidMapArea(field);
  const float haze = std::min(light.haze, kMostHaze / std::max(field.size.x, field.size.y));
  const bool wind = input.wind.name != 0;
  const GridMapping grid = wind ? input.wind.grid : makeGridMapping(field.centre, field.size, field.resolution);

  FrameBlock block{};
  block.viewProjection = camera.projection(aspect) * view;
  block.inverseViewProjection = glm::inverse(block.viewProjection);
  block.cameraPosition = {camera.position, camera.orthographic ? 1.0f : 0.0f};
  block.viewForward = {forwardOf(view), static_cast<float>(std::fmod(input.time, kTimeWrap))};
  block.sunDirection = {light.sunDirection, light.exposure};
  block.sunColour = {light.sunColour, 0.0f};
  block.skyColour = {light.skyColour, 0.0f};
  block.viewport = {glm::vec2(input.size), 1.0f / glm::vec2(input.size)};
  block.pixelScale = {perMetre, haze, std::max(input.overlays.speedRange, 1e-3f), wind ? 1.0f : 0.0f};
  block.field = {grid.minCorner, grid.size};
  block.fieldCells = {glm::vec2(grid.resolution), grid.cellSize};
  block.solidMap = {solids.minCorner, 1.0f / solids.size};
  block.groundColour = {input.project->terrain->colour, 0.0f};
  block.ambientWind = {ambientVelocity(*input.project->ambient), 0.0f, 0.0f};
  if (const HeightField* heights = input.project->terrain->heights.get()) {
    block.ground = {heights->low, 1.0f / heights->spacing()};
    block.groundGrid = {glm::vec2(heights->source->samples), heights->base, heights->factor};
    block.groundRange = {heights->lowest(), heights->highest(), 0.0f, 0.0f};
  }
  fillFrustum(block.viewProjection, block.frustum);
  return block;
}

}  // namespace windloom
