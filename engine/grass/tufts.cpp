#include "engine/grass/tufts.hpp"

#include <algorithm>
#include <cmath>

#include "engine/grass/poisson_disk.hpp"

namespace windloom {
namespace {

constexpr double kLeastBlades = 4.0;  // in a tuft, in the mean
constexpr double kPacked = 0.7;       // samples for each least * least m^2 where there is no room for more
constexpr double kCandidates = 5.0;   // for each least * least m^2
constexpr double kMostCandidates = 4'000'000;
constexpr int kChunk = 2048;

/// Random places over all parts, with their parts.
void findCandidates(const GrowthArea& area, const TuftWish& wish, std::size_t count, ThreadPool& pool,
                    const std::atomic<bool>* cancelled, std::vector<GrowthPoint>& points, std::vector<int>& parts) {
  points.resize(count);
  parts.resize(count);
  const double first = wish.blades[0] > 0 ? area.area(0) : 0.0;
  const double second = area.parts() > 1 && wish.blades[1] > 0 ? area.area(1) : 0.0;
  pool.parallelFor(static_cast<int>((count + kChunk - 1) / kChunk), [&](int chunk) {
    if (cancelled != nullptr && cancelled->load()) return;
    const std::size_t from = static_cast<std::size_t>(chunk) * kChunk;
    for (std::size_t i = from; i < std::min(from + kChunk, count); ++i) {
      RandomStream random(hashCombine(wish.seed ^ 0x3c6ef372u, static_cast<std::uint32_t>(i)));
      // Two draws: a large area has more places than one draw has values.
      const double along = (static_cast<double>(random.next()) + static_cast<double>(random.next()) / 16777216.0);
      const double target = along * (first + second);
      parts[i] = target < first ? 0 : 1;
      const double within = parts[i] == 0 ? target / first : (target - first) / second;
      points[i] = area.at(parts[i], std::min(within, 1.0), random);
    }
  });
}

}  // namespace

TuftField plantTufts(const GrowthArea& area, const TuftWish& wish, ThreadPool& pool,
                     const std::atomic<bool>* cancelled) {
  TuftField field;
  field.first.push_back(0);
  field.radius = wish.radius;
  const auto blades = static_cast<double>(wish.blades[0] + wish.blades[1]);
  double whole = 0;
  for (int part = 0; part < area.parts(); ++part) whole += wish.blades[part] > 0 ? area.area(part) : 0.0;
  if (blades < kLeastBlades || !(whole > 0)) return field;
  const double roomy = std::sqrt(kPacked * whole * kLeastBlades / blades);
  const double least = std::max({static_cast<double>(wish.spacing), roomy, 1e-4});
  const double count = std::clamp(kCandidates * whole / (least * least), 16.0, kMostCandidates);
  std::vector<GrowthPoint> points;
  std::vector<int> parts;
  findCandidates(area, wish, static_cast<std::size_t>(count), pool, cancelled, points, parts);
  const std::vector<std::size_t> taken = poissonDisk(points, static_cast<float>(least), cancelled);
  long long before = 0;
  for (int part = 0; part < area.parts(); ++part) {
    double sum = 0, share = 0;
    for (const std::size_t i : taken) sum += parts[i] == part ? static_cast<double>(points[i].grown) : 0.0;
    if (!(sum > 0)) continue;
    for (const std::size_t i : taken) {
      if (parts[i] != part) continue;
      share += static_cast<double>(points[i].grown);
      field.centres.push_back(points[i]);
      field.first.push_back(before + std::llround(static_cast<double>(wish.blades[part]) * std::min(share / sum, 1.0)));
    }
    before += wish.blades[part];
    field.first.back() = before;
  }
  return field;
}

}  // namespace windloom
