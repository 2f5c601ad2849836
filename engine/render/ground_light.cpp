#include "engine/render/ground_light.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr float kDeepest = -50.0f, kHighest = 1000.0f;  // m; beyond these it makes no difference

/// Heights of the shadow over y = 0, in the field's order.
std::vector<float> sweepShadows(const HeightField& field, glm::vec3 towardsSun) {
  const glm::ivec2 samples = field.source->samples;
  const glm::vec2 spacing = field.spacing();
  const glm::vec2 flat(towardsSun.x, towardsSun.z);
  const auto index = [&](int i, int k) {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(samples.x) + static_cast<std::size_t>(i);
  };
  std::vector<float> shadow(field.source->values.size(), -1e9f);
  const float length = glm::length(flat);
  if (length < 1e-4f) return shadow;  // overhead: nothing hides it
  // Steps from line to line along the axis that the light crosses faster.
  const glm::vec2 perStep = flat / spacing;
  const int axis = std::abs(perStep.x) >= std::abs(perStep.y) ? 0 : 1, other = 1 - axis;
  const int way = perStep[axis] > 0 ? 1 : -1;
  const float aside = perStep[other] / std::abs(perStep[axis]);
  const float drop = towardsSun.y * spacing[axis] / std::abs(flat[axis]);
  const int last = samples[axis] - 1, lastOther = samples[other] - 1;
  const auto at = [&](int line, int place) { return axis == 0 ? index(line, place) : index(place, line); };
  const auto height = [&](int line, int place) { return axis == 0 ? field.at(line, place) : field.at(place, line); };
  for (int n = 1; n <= last; ++n) {
    const int line = way > 0 ? last - n : n, before = line + way;
    for (int place = 0; place <= lastOther; ++place) {
      const float from = std::clamp(static_cast<float>(place) + aside, 0.0f, static_cast<float>(lastOther));
      const int low = std::min(static_cast<int>(from), std::max(lastOther - 1, 0)), high = std::min(low + 1, lastOther);
      const auto hides = [&](int p) { return std::max(height(before, p), shadow[at(before, p)]); };
      shadow[at(line, place)] = glm::mix(hides(low), hides(high), from - static_cast<float>(low)) - drop;
    }
  }
  return shadow;
}

}  // namespace

std::vector<glm::vec4> makeGroundLight(const HeightField& field, glm::vec3 towardsSun) {
  const std::vector<float> shadow = sweepShadows(field, towardsSun);
  const glm::ivec2 last = field.source->samples - 1;
  const glm::vec2 spacing = field.spacing();
  std::vector<glm::vec4> light;
  light.reserve(shadow.size());
  for (int k = 0; k <= last.y; ++k) {
    const int near = std::max(k - 1, 0), far = std::min(k + 1, last.y);
    for (int i = 0; i <= last.x; ++i) {
      const int left = std::max(i - 1, 0), right = std::min(i + 1, last.x);
      const float x = (field.at(left, k) - field.at(right, k)) / (static_cast<float>(right - left) * spacing.x);
      const float z = (field.at(i, near) - field.at(i, far)) / (static_cast<float>(far - near) * spacing.y);
      const float scale = 1.0f / std::sqrt(1.0f + x * x + z * z);
      light.emplace_back(x * scale, z * scale, std::clamp(shadow[light.size()] - field.at(i, k), kDeepest, kHighest), 0.0f);
    }
  }
  return light;
}

}  // namespace windloom
