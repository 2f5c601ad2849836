#include "editor/core/brush_strokes.hpp"

#include <algorithm>

namespace windloom::editor {
namespace {

constexpr float kResponseS = 0.05f;  // the air follows the hand at once
constexpr float kMinLengthM = 1e-3f;

}  // namespace

void BrushStrokes::add(glm::vec2 from, glm::vec2 to, float speedMps, float radiusM) {
  if (!(glm::distance(from, to) >= kMinLengthM) || !(speedMps > 0.0f)) return;
  if (m_strokes.size() >= kMaxCount) m_strokes.erase(m_strokes.begin());
  m_strokes.push_back(
      {from, to, std::min(speedMps, kMaxBrushSpeedMps), std::clamp(radiusM, kMinBrushM, kMaxBrushM), 0.0});
}

void BrushStrokes::age(double windSeconds) {
  if (!(windSeconds > 0)) return;
  for (Stroke& stroke : m_strokes) stroke.ageS += windSeconds;
  std::erase_if(m_strokes, [](const Stroke& stroke) { return stroke.ageS >= kLifeS; });
}

std::vector<ArrowForce> BrushStrokes::forces() const {
  std::vector<ArrowForce> forces;
  for (const Stroke& stroke : m_strokes) {
    const double fading = (stroke.ageS - kFullS) / (kLifeS - kFullS);
    const float factor = static_cast<float>(1.0 - std::clamp(fading, 0.0, 1.0));
    ArrowForce force{};
    force.from = stroke.from;
    force.to = stroke.to;
    force.direction = glm::normalize(stroke.to - stroke.from);
    force.radius = stroke.radiusM;
    // It lets go of the air instead of braking it: what fades is how much it pulls, not the speed it pulls to.
    force.strength = stroke.speedMps;
    force.response = kResponseS;
    force.drive = ARROW_DRIVE_SPEED;
    force.factor = factor * factor;
    forces.push_back(force);
  }
  return forces;
}

}  // namespace windloom::editor
