#pragma once
// Where the tufts of Bezier grass stand, and which of an area's blades belong to them.

#include <atomic>
#include <vector>

#include "engine/core/thread_pool.hpp"
#include "engine/grass/growth_area.hpp"

namespace windloom {

struct TuftField {
  std::vector<GrowthPoint> centres;  ///< those of part 0 first
  std::vector<long long> first;      ///< for each its first blade; one more at the end
  float radius = 0;                  ///< m
};

struct TuftWish {
  long long blades[2] = {0, 0};  ///< of each part that shall stand in tufts
  float spacing = 0.6f;          ///< m: least distance between centres
  float radius = 0.1f;           ///< m
  std::uint32_t seed = 0;
};

/// Poisson-disk samples of the area; further apart where there would be fewer than four blades for each. Blades are
/// shared out by what grows there. Parts without room for a tuft get none: then TuftField::first ends below the wish.
TuftField plantTufts(const GrowthArea& area, const TuftWish& wish, ThreadPool& pool,
                     const std::atomic<bool>* cancelled);

}  // namespace windloom
