// Jahrmann & Wimmer, "Responsive real-time grass rendering", 2017, section 3. Deviations: blades are sorted along a
// Morton curve rather than by rows, and within a patch so that any first part of them covers it.
#include "engine/grass/bezier_placement.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "engine/core/thread_pool.hpp"
#include "engine/grass/blade_traits.hpp"
#include "engine/grass/ground_area.hpp"
#include "engine/grass/mesh_area.hpp"
#include "engine/grass/patch_order.hpp"
#include "engine/grass/tufts.hpp"
#include "engine/model/surface_pose.hpp"
#include "engine/model/surface_shapes.hpp"

namespace windloom {
namespace {

constexpr float kMostWidening = 4.0f;
constexpr int kChunk = 4096;        // blades
constexpr int kTuftTries = 4;       // for a place in a tuft, where part of it grows nothing
constexpr float kTuftDense = 0.6f;  // exponent of the way from the middle: 0.5 would be even

/// One area with all that its blades need.
struct Growing {
  std::unique_ptr<GrowthArea> area;
  BladeTraits traits;
  int surface = -1;
  double wanted[2] = {0, 0};  // blades of each part
  float tufts = 0, tuftSpacing = 0.6f, tuftRadius = 0.12f;
  std::uint32_t seed = 0;
};

float share(float value) {
  return value > 0.0f ? std::min(value, 1.0f) : 0.0f;
}

Growing growGround(const Project& project, ThreadPool& pool, float& kept) {
  const GrassSettings& grass = *project.grass;
  const BezierSettings& bezier = *project.bezier;
  Growing ground;
  const double level = static_cast<double>(project.field->size.x) * static_cast<double>(project.field->size.y);
  const double density = grass.density;
  auto area = std::make_unique<GroundArea>(project, std::min(density * level, static_cast<double>(bezier.most)), pool);
  const double all = density * (area->area(0) + area->area(1));
  const double most = std::max(bezier.most, 0);
  kept = all > most ? static_cast<float>(most / all) : 1.0f;
  ground.wanted[1] = std::round(density * area->area(1) * (all > most ? most / all : 1.0));
  ground.wanted[0] = all > most ? most - ground.wanted[1] : density * area->area(0);
  ground.area = std::move(area);
  ground.traits = groundTraits(grass, bezier);
  ground.tufts = share(bezier.tufts);
  ground.tuftSpacing = bezier.tuftSpacing;
  ground.tuftRadius = bezier.tuftRadius;
  ground.seed = hashCombine(0x47726f75u, static_cast<std::uint32_t>(grass.seed));
  return ground;
}

/// Null area: nothing grows on it.
Growing growSurface(const Project& project, std::size_t index, ThreadPool& pool) {
  const Surface& surface = (*project.surfaces)[index];
  const BezierSettings& bezier = *project.bezier;
  Growing growing;
  if (surface.hidden || !(surface.density > 0.0f)) return growing;
  const std::shared_ptr<const PlantMesh> mesh = surfaceMesh(surface);
  if (!mesh || mesh->indices.size() < 3) return growing;
  growing.tufts = share(bezier.tufts);
  growing.area = std::make_unique<MeshArea>(mesh, surfacePose(surface, project.terrain->heights.get()),
                                            surface.bothSides, growing.tufts > 0.0f, pool);
  growing.surface = static_cast<int>(index);
  growing.wanted[0] = static_cast<double>(surface.density) * growing.area->area(0);
  growing.traits = surfaceTraits(*project.grass, bezier, surface);
  // Tufts are as large beside their blades as on the ground.
  const float size = std::clamp(surface.height / std::max(project.grass->height, 1e-3f), 0.02f, 10.0f);
  growing.tuftSpacing = size * bezier.tuftSpacing;
  growing.tuftRadius = size * bezier.tuftRadius;
  growing.seed = hashCombine(hashCombine(0x53757266u, surface.id), growing.traits.seed);
  return growing;
}

/// How many blades of which kind an area gets; blades are counted through: single ones of each part, then those of
/// tufts.
struct Counts {
  long long part[2] = {0, 0}, tufts[2] = {0, 0};
  [[nodiscard]] long long singles(int p) const { return part[p] - tufts[p]; }
  [[nodiscard]] long long all() const { return part[0] + part[1]; }
};

Counts countsOf(const Growing& growing, double factor) {
  Counts counts;
  for (int p = 0; p < growing.area->parts(); ++p) {
    const double wanted = growing.wanted[p] * factor;
    counts.part[p] = growing.area->area(p) > 0 ? static_cast<long long>(factor < 1.0 ? wanted : std::round(wanted)) : 0;
    if (growing.area->holdsTufts())
      counts.tufts[p] = std::llround(static_cast<double>(growing.tufts) * static_cast<double>(counts.part[p]));
  }
  return counts;
}

class Planting {
 public:
  Planting(const Growing& growing, const Counts& counts, ThreadPool& pool, const std::atomic<bool>* cancelled)
      : m_growing(growing), m_counts(counts) {
    const TuftWish wish{{counts.tufts[0], counts.tufts[1]}, growing.tuftSpacing, growing.tuftRadius, growing.seed};
    m_tufts = plantTufts(*growing.area, wish, pool, cancelled);
    // Blades that found no tuft stand alone.
    if (m_tufts.first.back() != counts.tufts[0] + counts.tufts[1]) {
      m_counts.tufts[0] = m_counts.tufts[1] = 0;
      m_tufts = {};
    }
  }

  [[nodiscard]] BezierBlade blade(long long index) const {
    const std::uint32_t seed = hashCombine(m_growing.seed, static_cast<std::uint32_t>(index));
    RandomStream random(seed ^ 0xbb67ae85u);
    for (int p = 0; p < m_growing.area->parts(); ++p) {
      const long long singles = m_counts.singles(p);
      if (index < singles) {
        const double along =
            (static_cast<double>(index) + static_cast<double>(random.next())) / static_cast<double>(singles);
        return makeBlade(m_growing.traits, m_growing.area->at(p, std::min(along, 1.0), random), seed, nullptr);
      }
      index -= singles;
    }
    return bladeOfTuft(index, seed, random);
  }

 private:
  [[nodiscard]] BezierBlade bladeOfTuft(long long index, std::uint32_t seed, RandomStream& random) const {
    const auto next = std::upper_bound(m_tufts.first.begin(), m_tufts.first.end(), index);
    const auto tuft = static_cast<std::size_t>(next - m_tufts.first.begin()) - 1;
    const GrowthPoint& centre = m_tufts.centres[tuft];
    const int part = index < m_counts.tufts[0] ? 0 : 1;
    TuftPlace place{.hash = hashCombine(m_growing.seed ^ 0x510e527fu, static_cast<std::uint32_t>(tuft))};
    const glm::vec3 first = frame(centre.up), second = glm::cross(centre.up, first);
    for (int i = 0; i < kTuftTries; ++i) {
      const float angle = 6.2831853f * random.next();
      place.part = std::pow(random.next(), kTuftDense);
      place.outwards = first * std::cos(angle) + second * std::sin(angle);
      const glm::vec3 offset = place.outwards * (place.part * m_tufts.radius);
      if (const auto point = m_growing.area->beside(part, centre, offset, random))
        return makeBlade(m_growing.traits, *point, seed, &place);
    }
    place.part = 0.0f;
    return makeBlade(m_growing.traits, centre, seed, &place);
  }

  static glm::vec3 frame(glm::vec3 up) {
    const glm::vec3 aside = std::abs(up.x) < 0.7f ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
    return glm::normalize(aside - up * glm::dot(aside, up));
  }

  const Growing& m_growing;
  Counts m_counts;
  TuftField m_tufts;
};

void plant(const Growing& growing, const Counts& counts, ThreadPool& pool, const std::atomic<bool>* cancelled,
           BezierMeadow& meadow) {
  const long long all = counts.all();
  if (all <= 0) return;
  const Planting planting(growing, counts, pool, cancelled);
  std::vector<BezierBlade> blades(static_cast<std::size_t>(all));
  pool.parallelFor(static_cast<int>((all + kChunk - 1) / kChunk), [&](int chunk) {
    if (cancelled != nullptr && cancelled->load()) return;
    const long long from = static_cast<long long>(chunk) * kChunk;
    for (long long i = from; i < std::min(from + kChunk, all); ++i)
      blades[static_cast<std::size_t>(i)] = planting.blade(i);
  });
  if (cancelled != nullptr && cancelled->load()) return;
  appendPatches(blades, growing.surface, pool, meadow.blades, meadow.patches);
  meadow.count += all;
  for (int p = 0; p < growing.area->parts(); ++p) meadow.area += growing.area->area(p);
}

}  // namespace

BezierMeadow placeBezier(const Project& project, const std::atomic<bool>* cancelled) {
  const auto stopped = [&] { return cancelled != nullptr && cancelled->load(); };
  ThreadPool pool;
  BezierMeadow meadow;
  std::vector<Growing> all;
  float kept = 1.0f;
  if (project.grass->density > 0.0f && project.bezier->most > 0) all.push_back(growGround(project, pool, kept));
  for (std::size_t i = 0; i < project.surfaces->size(); ++i) {
    if (stopped()) return {};
    if (Growing growing = growSurface(project, i, pool); growing.area) all.push_back(std::move(growing));
  }
  double wanted = 0;
  for (const Growing& growing : all) wanted += growing.wanted[0] + growing.wanted[1];
  const double most = static_cast<double>(kMaxBezierBlades);
  const double factor = wanted > most ? most / wanted : 1.0;
  meadow.widening = std::clamp(1.0f / std::max(kept * static_cast<float>(factor), 1e-6f), 1.0f, kMostWidening);
  for (Growing& growing : all) {
    if (stopped()) return {};
    if (growing.surface < 0) growing.traits.width *= meadow.widening;
    plant(growing, countsOf(growing, factor), pool, cancelled, meadow);
  }
  if (stopped()) return {};
  return meadow;
}

}  // namespace windloom
