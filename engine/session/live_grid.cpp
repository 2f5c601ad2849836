#include "engine/session/live_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace windloom {
namespace {

constexpr std::array kSides{64, 96, 128, 160, 192, 224, 256, 320, 384, 512, 640, 768, 1000, 1280, 1536, 2048, 4096};
// Part of a time step that computing it may take: the rest is for drawing, on the same cores.
constexpr double kMostShare = 0.45, kWantedShare = 0.3;
constexpr std::size_t kMeasured = 40;  // steps

int longer(glm::ivec2 v) {
  return std::max(v.x, v.y);
}

}  // namespace

glm::ivec2 shrinkResolution(glm::ivec2 resolution, int side) {
  if (longer(resolution) <= side) return resolution;
  const double scale = static_cast<double>(side) / longer(resolution);
  const auto shrink = [&](int cells) { return std::max(8, static_cast<int>(std::lround(cells * scale))); };
  return {shrink(resolution.x), shrink(resolution.y)};
}

LiveGridControl::LiveGridControl(const FieldSettings& field, LiveGridStart start)
    : m_field(field),
      m_resolution(start == LiveGridStart::Project ? field.resolution : shrinkResolution(field.resolution, kFirstSide)),
      m_ceiling(longer(field.resolution) + 1) {}

bool LiveGridControl::moveTo(int side) {
  const glm::ivec2 next = shrinkResolution(m_field.resolution, side);
  m_times.clear();
  if (next == m_resolution) return false;
  m_resolution = next;
  return true;
}

bool LiveGridControl::stepDone(double milliseconds) {
  m_times.push_back(milliseconds);
  if (m_times.size() < kMeasured) return false;
  std::nth_element(m_times.begin(), m_times.begin() + kMeasured / 2, m_times.end());
  const double median = m_times[kMeasured / 2];
  const double stepMs = 1000.0 * static_cast<double>(m_field.timeStep);
  const int side = longer(m_resolution);
  if (median > kMostShare * stepMs) {
    m_ceiling = std::min(m_ceiling, side);
    // Cost goes with the number of cells.
    const double fits = side * std::sqrt(kWantedShare * stepMs / median);
    const auto* above = std::ranges::upper_bound(kSides, static_cast<int>(fits));
    return moveTo(above == kSides.begin() ? kSides.front() : *(above - 1));
  }
  const auto* next = std::ranges::upper_bound(kSides, side);
  const bool more = next != kSides.end() && side < longer(m_field.resolution);
  if (!more) {
    m_times.clear();
    return false;
  }
  const int wanted = std::min(*next, longer(m_field.resolution));
  const double expected = median * (static_cast<double>(wanted) / side) * (static_cast<double>(wanted) / side);
  if (wanted >= m_ceiling || expected > kWantedShare * stepMs) {
    m_times.clear();
    return false;
  }
  return moveTo(wanted);
}

}  // namespace windloom
