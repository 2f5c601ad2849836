#pragma once
// Wind combed into the live air for trying things out: short strokes that fade. No part of the project, never saved,
// never in the history.

#include <cstddef>
#include <vector>

#include "engine/model/evaluate.hpp"

namespace windloom::editor {

/// What strokes are made with.
struct BrushSettings {
  float radiusM = 3.0f;   ///< kMinBrushM..kMaxBrushM
  float strength = 1.0f;  ///< factor on the pointer's speed over the ground, 0.1..10
};
inline constexpr float kMinBrushM = 0.2f, kMaxBrushM = 100.0f;
inline constexpr float kMinBrushStrength = 0.1f, kMaxBrushStrength = 10.0f;
inline constexpr float kMaxBrushSpeedMps = 60.0f;

class BrushStrokes {
 public:
  static constexpr double kLifeS = 1.5;          ///< of wind time: strokes made while the wind stands wait for it
  static constexpr double kFullS = 0.25;         ///< as strong as drawn for so long, then fading
  static constexpr std::size_t kMaxCount = 256;  ///< the oldest go first

  /// The pointer went from one place to the other with this speed; what has no length is left out.
  void add(glm::vec2 from, glm::vec2 to, float speedMps, float radiusM);
  /// The wind ran for `windSeconds`; strokes older than kLifeS go.
  void age(double windSeconds);
  void clear() { m_strokes.clear(); }

  [[nodiscard]] bool empty() const { return m_strokes.empty(); }
  [[nodiscard]] std::size_t size() const { return m_strokes.size(); }
  /// As arrows that blow now, faded by their age.
  [[nodiscard]] std::vector<ArrowForce> forces() const;

 private:
  struct Stroke {
    glm::vec2 from{0.0f}, to{0.0f};
    float speedMps = 0, radiusM = 1;
    double ageS = 0;
  };
  std::vector<Stroke> m_strokes;
};

}  // namespace windloom::editor
