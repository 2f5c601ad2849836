#include "engine/render/overlay_lattice.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/hash.hpp"

namespace windloom {
namespace {

constexpr int kFinest = -5, kCoarsest = 9;  // exponents of two, m
constexpr std::size_t kMostSeeds = 8192;    // about three times what a 4K picture holds
constexpr float kMargin = 1.15f;            // of the picture, for marks that reach in
constexpr float kLeastSlant = 0.15f;

/// Where a ray through the picture meets the height `y`, or the field's height far away along it.
glm::vec2 onGround(const glm::mat4& inverse, glm::vec2 clip, float y, float reach) {
  const glm::vec4 a = inverse * glm::vec4(clip, -1.0f, 1.0f), b = inverse * glm::vec4(clip, 1.0f, 1.0f);
  const glm::vec3 from = glm::vec3(a) / a.w, to = glm::vec3(b) / b.w;
  const glm::vec3 ray = glm::normalize(to - from);
  const float distance = ray.y < -1e-4f ? std::clamp((y - from.y) / ray.y, 0.0f, reach) : reach;
  return {from.x + ray.x * distance, from.z + ray.z * distance};
}

float smooth(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Pixels that a metre of ground covers at places of the picture.
class Projector {
 public:
  Projector(const ViewCamera& camera, glm::ivec2 size, const HeightField* ground)
      : m_camera(camera),
        m_ground(ground),
        m_toClip(camera.projection(static_cast<float>(size.x) / static_cast<float>(size.y)) * camera.view()),
        m_forward(glm::normalize(camera.target - camera.position)) {
    const auto height = static_cast<float>(size.y);
    m_scale = camera.orthographic ? height / camera.orthographicHeight
                                  : 0.5f * height / std::tan(0.5f * glm::radians(camera.fieldOfView));
  }

  /// 0 outside the picture. The geometric mean of the scales along and across the view.
  [[nodiscard]] float pixelsPerMetre(glm::vec2 place) const {
    const glm::vec3 world(place.x, m_ground != nullptr ? heightAt(*m_ground, place) : 0.0f, place.y);
    const glm::vec4 clip = m_toClip * glm::vec4(world, 1.0f);
    const float limit = kMargin * clip.w;
    if (clip.w <= 0.0f || std::abs(clip.x) > limit || std::abs(clip.y) > limit) return 0.0f;
    const glm::vec3 ray = m_camera.orthographic ? m_forward : glm::normalize(world - m_camera.position);
    const float slant = std::max(std::abs(ray.y), kLeastSlant);
    return (m_camera.orthographic ? m_scale : m_scale / clip.w) * std::sqrt(slant);
  }
  /// How far from the camera's foot a metre still covers `pixels`, m.
  [[nodiscard]] float reach(float pixels) const {
    return m_camera.orthographic ? 1e9f : 2.0f * m_scale / pixels + std::abs(m_camera.position.y);
  }

 private:
  const ViewCamera& m_camera;
  const HeightField* m_ground;
  glm::mat4 m_toClip;
  glm::vec3 m_forward;
  float m_scale = 1.0f;
};

void addLattice(std::vector<FlowSeed>& seeds, const Projector& view, const GroundArea& area, int level, float pixels) {
  const float spacing = std::exp2(static_cast<float>(level));
  const glm::ivec2 first = glm::ceil(area.low / spacing), last = glm::floor(area.high / spacing);
  for (int k = first.y; k <= last.y; ++k) {
    for (int i = first.x; i <= last.x; ++i) {
      const glm::vec2 place = glm::vec2(i, k) * spacing;
      const float apart = spacing * view.pixelsPerMetre(place);
      if (apart <= pixels || apart >= 2.5f * pixels) continue;
      if (seeds.size() >= kMostSeeds) return;
      const float weight = smooth(1.0f, 1.3f, apart / pixels) * (1.0f - smooth(2.0f, 2.5f, apart / pixels));
      const std::uint32_t key = hashCombine(hashCombine(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k)),
                                            static_cast<std::uint32_t>(level - kFinest));
      seeds.push_back({{place, spacing, weight}, key, 0, 0, 0});
    }
  }
}

}  // namespace

GroundArea seenArea(const ViewCamera& camera, glm::ivec2 size, const FieldSettings& field, const HeightField* ground) {
  const float aspect = static_cast<float>(size.x) / static_cast<float>(size.y);
  const glm::mat4 inverse = glm::inverse(camera.projection(aspect) * camera.view());
  const glm::vec2 fieldLow = field.centre - 0.5f * field.size, fieldHigh = field.centre + 0.5f * field.size;
  const float reach =
      glm::length(field.size) + glm::length(camera.position - glm::vec3(field.centre.x, 0.0f, field.centre.y));
  GroundArea area{glm::vec2(1e30f), glm::vec2(-1e30f)};
  for (const float x : {-1.0f, 0.0f, 1.0f}) {
    for (const float y : {-1.0f, 0.0f, 1.0f}) {
      for (const float height :
           {ground != nullptr ? ground->lowest() : 0.0f, ground != nullptr ? ground->highest() : 0.0f}) {
        const glm::vec2 at = onGround(inverse, {x, y}, height, reach);
        area.low = glm::min(area.low, at);
        area.high = glm::max(area.high, at);
      }
    }
  }
  // Uneven ground shows a little more of itself than a plane does.
  const glm::vec2 more = 0.08f * (area.high - area.low);
  area.low = glm::max(area.low - more, fieldLow);
  area.high = glm::min(area.high + more, fieldHigh);
  return area.empty() ? GroundArea{} : area;
}

std::vector<FlowSeed> makeFlowSeeds(const ViewCamera& camera, glm::ivec2 size, const FieldSettings& field, float pixels,
                                    const HeightField* ground) {
  std::vector<FlowSeed> seeds;
  const GroundArea seen = seenArea(camera, size, field, ground);
  if (seen.empty()) return seeds;
  const Projector view(camera, size, ground);
  const glm::vec2 foot{camera.position.x, camera.position.z};
  // Coarse first: where there are too many, fine ones near the camera are left out.
  for (int level = kCoarsest; level >= kFinest; --level) {
    const float reach = view.reach(pixels / std::exp2(static_cast<float>(level)));
    const GroundArea area{glm::max(seen.low, foot - reach), glm::min(seen.high, foot + reach)};
    const glm::vec2 nodes = (area.high - area.low) / std::exp2(static_cast<float>(level));
    // A lattice with very many nodes in sight is much finer than the picture wants.
    if (area.empty() || nodes.x * nodes.y > 4e5f) continue;
    addLattice(seeds, view, area, level, pixels);
  }
  return seeds;
}

}  // namespace windloom
