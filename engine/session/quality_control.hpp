#pragma once
// Keeps a frame time by drawing less grass. Pure: frame times in, detail out.

#include <array>
#include <cstddef>

namespace windloom {

inline constexpr double kFrameTargetMs = 30.0;          ///< on a GPU
inline constexpr double kSoftwareFrameTargetMs = 66.0;  ///< on a software renderer

/// Follows the median of recent frames, so that a single slow frame changes nothing; lowers the detail at once
/// when the target is missed, raises it only after a long stretch with room to spare, and waits longer each time
/// that raising it proved too much.
class QualityControl {
 public:
  explicit QualityControl(double targetMs = kFrameTargetMs);

  /// A frame that drew the scene took so long.
  void frameDone(double milliseconds);

  /// For FrameQuality::detail: kLeastDetail..1.
  [[nodiscard]] float detail() const { return m_detail; }
  [[nodiscard]] double targetMs() const { return m_targetMs; }

  static constexpr float kLeastDetail = 0.05f;

 private:
  static constexpr std::size_t kWindow = 7;
  [[nodiscard]] double median() const;
  void change(float factor);

  double m_targetMs;
  std::array<double, kWindow> m_times{};
  std::size_t m_count = 0;       // frames seen since the last change
  int m_calmFrames = 0;          // in a row with room to spare
  int m_patience = 0;            // calm frames wanted before the detail is raised
  float m_detail = 1.0f;
  bool m_raisedLast = false;
};

}  // namespace windloom
