#pragma once
// Keeps a frame time by drawing less grass. Pure: frame times in, detail out.

#include <array>
#include <cstddef>

namespace windloom {

/// What a machine is expected to do.
struct QualityTarget {
  double frameMs = 30;       ///< to be kept
  float firstDetail = 1.0f;  ///< to begin with, where the first frames would else take seconds
};
inline constexpr QualityTarget kGpuTarget{};
/// 15 frames a second with room to spare.
inline constexpr QualityTarget kSoftwareTarget{.frameMs = 60, .firstDetail = 0.2f};

/// Never pumps: it looks at many frames before it decides, aims below the target by what it learned of how the time
/// follows the detail, and between "too slow" and "room to spare" there is room for a machine's noise. Raising waits
/// longer each time that it proved too much. The detail glides from one value to the next, so that no frame shows a
/// jump; only frames that are far too slow are helped at once.
class QualityControl {
 public:
  explicit QualityControl(const QualityTarget& target = kGpuTarget);

  /// A frame that drew the scene took so long.
  void frameDone(double milliseconds);

  /// For FrameQuality::detail: kLeastDetail..1.
  [[nodiscard]] float detail() const { return m_detail; }
  [[nodiscard]] double targetMs() const { return m_targetMs; }

  static constexpr float kLeastDetail = 0.05f;

 private:
  static constexpr std::size_t kLong = 45;  // frames looked at, at most
  [[nodiscard]] double ranked(std::size_t frames, double part) const;
  void judge();
  void lower(double now, float glide);
  void raise(double now);
  void moveTo(double factor, double now, float glide);
  void learn(double now);
  bool glide();

  double m_targetMs;
  std::array<double, kLong> m_times{};
  std::size_t m_count = 0;  // frames seen since the detail came to rest
  int m_calmFrames = 0;     // in a row with room to spare
  int m_patience = 0;       // calm frames wanted before the detail is raised
  float m_detail, m_goal;
  float m_glide = 1.0f;  // factor of a frame on the way to the goal
  double m_exponent;     // the time goes as the detail to the power of this
  double m_lastMs = 0;   // at the detail before the last change; 0: not known
  float m_lastDetail = 1.0f;
  bool m_raisedLast = false;
};

}  // namespace windloom
