#include "engine/session/quality_control.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr double kTooSlow = 1.08;     // times the target
constexpr double kRoomToSpare = 0.78;
constexpr int kLeastPatience = 20, kMostPatience = 320;  // frames
constexpr float kRaise = 1.15f;
// The first frames after a change still show the old detail, and new buffers cost once.
constexpr std::size_t kSettling = 2;

}  // namespace

QualityControl::QualityControl(double targetMs) : m_targetMs(targetMs), m_patience(kLeastPatience) {}

double QualityControl::median() const {
  std::array<double, kWindow> sorted = m_times;
  std::nth_element(sorted.begin(), sorted.begin() + kWindow / 2, sorted.end());
  return sorted[kWindow / 2];
}

void QualityControl::change(float factor) {
  m_detail = std::clamp(m_detail * factor, kLeastDetail, 1.0f);
  m_count = 0;
  m_calmFrames = 0;
}

void QualityControl::frameDone(double milliseconds) {
  if (!std::isfinite(milliseconds) || milliseconds <= 0.0) return;
  ++m_count;
  if (m_count <= kSettling) return;
  m_times[m_count % kWindow] = milliseconds;
  if (m_count < kSettling + kWindow) return;
  const double now = median();
  if (now > kTooSlow * m_targetMs) {
    if (m_raisedLast) m_patience = std::min(m_patience * 2, kMostPatience);
    m_raisedLast = false;
    // Not all of a frame is grass: half-way steps come to rest without falling below what is needed.
    if (m_detail > kLeastDetail) change(static_cast<float>(std::clamp(std::pow(m_targetMs / now, 0.8), 0.5, 0.95)));
    return;
  }
  m_calmFrames = now < kRoomToSpare * m_targetMs ? m_calmFrames + 1 : 0;
  if (m_calmFrames < m_patience || m_detail >= 1.0f) return;
  m_raisedLast = true;
  change(kRaise);
}

}  // namespace windloom
