#include "engine/session/quality_control.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

// The more frames are looked at, the less they need to be too slow: machines of 2 cores were seen to vary by a fifth
// from frame to frame and by a tenth over seconds. `glide` is the detail's factor from frame to frame on its way down:
// where all is well but for a little it is too small to be seen.
struct Look {
  std::size_t frames;
  double part;     // of them that may be faster
  double tooSlow;  // times the target
  float glide;
};
constexpr Look kLooks[] = {{4, 0, 2.5, 0.6f}, {9, 0.5, 1.4, 0.85f}, {18, 0.5, 1.18, 0.97f}, {45, 0.5, 1.04, 0.985f}};
constexpr float kGlideUp = 1.015f;

// Times the target.
constexpr double kAim = 0.87;    // where lowering wants to get
constexpr double kAimUp = 0.83;  // and raising, if all of the frame were grass
constexpr double kRoomToSpare = 0.72;
constexpr double kSlowestOfCalm = 0.9;                   // of the slowest fifth
constexpr int kLeastPatience = 45, kMostPatience = 720;  // frames
// Not all of a frame is grass, and twice the detail is never less than that much more work.
constexpr double kLeastExponent = 0.35, kMostExponent = 1.0, kFirstExponent = 0.8;
constexpr double kSmallestFactor = 0.2, kLargestFactor = 2.0;
// The first frames after a change still show the old detail, and new buffers cost once.
constexpr std::size_t kSettling = 2;

}  // namespace

QualityControl::QualityControl(const QualityTarget& target)
    : m_targetMs(target.frameMs),
      m_patience(kLeastPatience),
      m_detail(target.firstDetail),
      m_goal(target.firstDetail),
      m_exponent(kFirstExponent) {}

/// Of the last `frames`: the time that a `part` of them doesn't reach.
double QualityControl::ranked(std::size_t frames, double part) const {
  std::array<double, kLong> sorted{};
  for (std::size_t i = 0; i < frames; ++i) sorted[i] = m_times[(m_count - 1 - i) % kLong];
  const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(frames - 1) + 0.5);
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.begin() + static_cast<std::ptrdiff_t>(frames));
  return sorted[static_cast<std::size_t>(at)];
}

/// From what the last change did to the time.
void QualityControl::learn(double now) {
  if (m_lastMs <= 0 || m_lastDetail == m_detail) return;
  const double exponent = std::log(now / m_lastMs) / std::log(static_cast<double>(m_detail / m_lastDetail));
  // Half of it: frames are noisy.
  m_exponent = 0.5 * (m_exponent + std::clamp(exponent, kLeastExponent, kMostExponent));
  m_lastMs = 0;
}

void QualityControl::moveTo(double factor, double now, float glide) {
  m_goal = std::clamp(static_cast<float>(static_cast<double>(m_detail) * factor), kLeastDetail, 1.0f);
  m_glide = glide;
  m_lastMs = now;
  m_lastDetail = m_detail;
  m_count = 0;
  m_calmFrames = 0;
}

void QualityControl::lower(double now, float glide) {
  if (m_raisedLast) m_patience = std::min(m_patience * 2, kMostPatience);
  m_raisedLast = false;
  if (m_detail <= kLeastDetail) return;
  learn(now);
  moveTo(std::clamp(std::pow(kAim * m_targetMs / now, 1.0 / m_exponent), kSmallestFactor, 0.95), now, glide);
}

void QualityControl::raise(double now) {
  m_raisedLast = true;
  learn(now);
  moveTo(std::min(kAimUp * m_targetMs / now, kLargestFactor), now, kGlideUp);
}

/// A frame's way to the goal; true: not there yet.
bool QualityControl::glide() {
  if (m_detail == m_goal) return false;
  const float next = m_detail * m_glide;
  m_detail = m_glide < 1.0f ? std::max(next, m_goal) : std::min(next, m_goal);
  return true;
}

void QualityControl::frameDone(double milliseconds) {
  if (!std::isfinite(milliseconds) || milliseconds <= 0.0 || glide()) return;
  m_times[m_count++ % kLong] = milliseconds;
  judge();
}

void QualityControl::judge() {
  for (const Look& look : kLooks) {
    if (m_count < kSettling + look.frames) return;
    if (const double now = ranked(look.frames, look.part); now > look.tooSlow * m_targetMs)
      return lower(now, look.glide);
  }
  const double now = ranked(kLong, 0.5);
  const bool calm = now < kRoomToSpare * m_targetMs && ranked(kLong, 0.8) < kSlowestOfCalm * m_targetMs;
  m_calmFrames = calm ? m_calmFrames + 1 : 0;
  if (m_calmFrames >= m_patience && m_detail < 1.0f) raise(now);
}

}  // namespace windloom
