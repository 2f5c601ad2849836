#include "engine/grass/patch_cells.hpp"

#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "engine/grass/dynamics_clock.hpp"

namespace windloom {
namespace {

constexpr float kDt = 1.0f / 60.0f;

ColliderPrimitive ballAt(float x, float z, float radius = 0.4f, float height = 0.4f) {
  return {glm::vec4(x, height, z, radius), glm::vec4(x, height, z, 0.0f)};
}

/// Tiles of 2 m with 100 blades.
PatchLimits limits(int blades, float settledAfter = 5.0f) {
  return {.tileSideM = 2.0f, .reachM = 0.6f, .bladesInTile = 100, .blades = blades, .settledAfterS = settledAfter};
}

std::optional<GrassPatch> find(const PatchCells& cells, int x, int z) {
  for (const GrassPatch& patch : cells.patches()) {
    if (patch.x == x && patch.z == z) return patch;
  }
  return std::nullopt;
}

/// As find(), of a tile that should be a patch.
GrassPatch patchAt(const PatchCells& cells, int x, int z) {
  const auto found = find(cells, x, z);
  EXPECT_TRUE(found.has_value()) << x << ", " << z;
  return found.value_or(GrassPatch{0, 0, 99'999, -1.0f, 0, 0});
}

void stepWith(PatchCells& cells, const std::vector<ColliderPrimitive>& primitives, int steps = 1) {
  for (int n = 0; n < steps; ++n) cells.step(kDt, primitives, nullptr);
}

TEST(PatchCells, TilesThatABallMayTouchBecomePatches) {
  PatchCells cells;
  cells.configure(limits(10'000));
  stepWith(cells, {ballAt(5.0f, 1.0f)});  // the middle of tile (2, 0); reaches 1 m to each side
  EXPECT_TRUE(find(cells, 2, 0).has_value());
  EXPECT_FALSE(find(cells, 4, 0).has_value());
  EXPECT_LE(cells.patches().size(), 5u);
  stepWith(cells, {ballAt(-0.2f, -0.2f)});
  for (const auto& [x, z] : {std::pair(-1, -1), {0, -1}, {-1, 0}, {0, 0}})
    EXPECT_TRUE(find(cells, x, z).has_value()) << x << z;
}

TEST(PatchCells, ACapsuleTouchesAllTilesAlongIt) {
  PatchCells cells;
  cells.configure(limits(10'000));
  stepWith(cells, {{glm::vec4(1.0f, 0.3f, 1.0f, 0.3f), glm::vec4(9.0f, 0.3f, 1.0f, 0.0f)}});
  for (int x = 0; x <= 4; ++x) EXPECT_TRUE(find(cells, x, 0).has_value()) << x;
  EXPECT_FALSE(find(cells, 2, 2).has_value());
}

TEST(PatchCells, APatchIsGivenWhatMayTouchItInItsOrder) {
  PatchCells cells;
  cells.configure(limits(10'000));
  // Far from each other but for the first and the last; the second lies on two tiles.
  const std::vector<ColliderPrimitive> balls = {ballAt(1.0f, 1.0f), ballAt(12.0f, 1.0f), ballAt(41.0f, 41.0f),
                                                ballAt(1.2f, 1.2f, 0.3f)};
  stepWith(cells, balls);
  const auto givenTo = [&](int x, int z) {
    const GrassPatch patch = patchAt(cells, x, z);
    const auto from = cells.near().begin() + patch.first;
    return std::vector<ColliderPrimitive>(from, from + patch.count);
  };
  ASSERT_EQ(givenTo(0, 0).size(), 2u);
  EXPECT_EQ(givenTo(0, 0)[0].a, balls[0].a);
  EXPECT_EQ(givenTo(0, 0)[1].a, balls[3].a);
  for (const int x : {5, 6}) {
    ASSERT_EQ(givenTo(x, 0).size(), 1u) << x;
    EXPECT_EQ(givenTo(x, 0)[0].a, balls[1].a) << x;
  }
  ASSERT_EQ(givenTo(20, 20).size(), 1u);
  stepWith(cells, {balls[2]});
  EXPECT_TRUE(givenTo(0, 0).empty()) << "it remembers, and nothing touches it";
  EXPECT_EQ(givenTo(20, 20).size(), 1u);
}

TEST(PatchCells, NothingOverTheGrassTouchesIt) {
  PatchCells cells;
  cells.configure(limits(10'000));
  stepWith(cells, {ballAt(1.0f, 1.0f, 0.4f, 1.1f)});
  EXPECT_TRUE(cells.patches().empty());
  stepWith(cells, {ballAt(1.0f, 1.0f, 0.4f, 0.9f)});
  EXPECT_FALSE(cells.patches().empty());
}

TEST(PatchCells, StandsStillInItsSlotWhileTouched) {
  PatchCells cells;
  cells.configure(limits(10'000));
  stepWith(cells, {ballAt(1.0f, 1.0f)});
  const std::uint32_t slot = patchAt(cells, 0, 0).slot;
  EXPECT_EQ(patchAt(cells, 0, 0).keep, 0.0f) << "its blades remember nothing yet";
  const auto generation = cells.generation();
  stepWith(cells, {ballAt(1.0f, 1.0f)}, 1000);
  EXPECT_EQ(patchAt(cells, 0, 0).slot, slot);
  EXPECT_EQ(patchAt(cells, 0, 0).keep, 1.0f);
  EXPECT_EQ(cells.generation(), generation) << "the table is not sent again";
}

TEST(PatchCells, ReturnsToABlockOnceSettled) {
  PatchCells cells;
  cells.configure(limits(10'000, 2.0f));
  stepWith(cells, {ballAt(1.0f, 1.0f)});
  EXPECT_EQ(patchAt(cells, 0, 0).count, 1u);
  stepWith(cells, {}, 115);
  EXPECT_EQ(patchAt(cells, 0, 0).count, 0u);
  EXPECT_TRUE(find(cells, 0, 0).has_value()) << "after 1.9 s it still swings";
  stepWith(cells, {}, 10);
  EXPECT_TRUE(cells.patches().empty()) << "after 2.1 s it does not";
}

TEST(PatchCells, NeverRemembersMoreBladesThanAllowed) {
  for (const int blades : {0, 1, 99, 100, 1000, 100'000}) {
    PatchCells cells;
    cells.configure(limits(blades));
    EXPECT_LE(cells.slots() * cells.stride(), blades);
    for (int n = 0; n < 300; ++n) {
      stepWith(cells, {ballAt(static_cast<float>(n), 1.0f), ballAt(static_cast<float>(n), 9.0f)});
      ASSERT_LE(static_cast<int>(cells.patches().size()), cells.slots());
    }
    EXPECT_EQ(cells.patches().empty(), blades == 0) << blades;
  }
}

TEST(PatchCells, TheLeastRecentlyTouchedGivesWayFadingFirst) {
  PatchCells cells;
  cells.configure(limits(1600, 1000.0f));  // 16 slots, 2 of them in reserve
  ASSERT_EQ(cells.slots(), 16);
  int faded = 0, cut = 0;
  std::map<std::uint32_t, GrassPatch> last;
  for (int n = 0; n < 3600; ++n) {
    const float x = 0.02f * static_cast<float>(n);  // 1.2 m/s, a walk
    stepWith(cells, {ballAt(x, 1.0f, 0.3f)});
    std::map<std::uint32_t, GrassPatch> now;
    for (const GrassPatch& patch : cells.patches()) now[patch.slot] = patch;
    for (const auto& [slot, patch] : last) {
      const bool stays = now.contains(slot) && now[slot].x == patch.x && now[slot].z == patch.z;
      if (stays) continue;
      (patch.keep == 0.0f ? faded : cut) += 1;
      EXPECT_LT(2.0f * static_cast<float>(patch.x), x - 2.0f) << "not one that the ball is near";
    }
    last = std::move(now);
    ASSERT_TRUE(find(cells, static_cast<int>(x / 2.0f), 0).has_value()) << "the ball is always on a patch";
  }
  EXPECT_GT(faded, 10);
  EXPECT_EQ(cut, 0) << "a walk leaves time to fade";
}

TEST(PatchCells, FadingLetsGoEvenlyAndATouchKeepsThePatch) {
  PatchCells cells;
  cells.configure(limits(1600, 1000.0f));
  float x = 0.0f;
  std::optional<GrassPatch> fading;
  float left = 1.0f;
  for (; !fading && x < 200.0f; x += 0.1f) {
    stepWith(cells, {ballAt(x, 1.0f, 0.3f)});
    for (const GrassPatch& patch : cells.patches()) {
      if (patch.keep > 0.0f && patch.keep < 1.0f) fading = patch;
    }
  }
  ASSERT_TRUE(fading.has_value());
  const glm::ivec2 cell(fading->x, fading->z);
  left *= fading->keep;
  for (int n = 0; n < 10; ++n) {
    stepWith(cells, {});
    left *= patchAt(cells, cell.x, cell.y).keep;
  }
  // 11 or 12 of 24 steps.
  EXPECT_NEAR(left, 1.0f - 11.0f * kDt / kPatchFadeSeconds, 0.05f);
  stepWith(cells, {ballAt(2.0f * static_cast<float>(cell.x) + 1.0f, 2.0f * static_cast<float>(cell.y) + 1.0f)});
  ASSERT_TRUE(find(cells, cell.x, cell.y).has_value());
  EXPECT_EQ(patchAt(cells, cell.x, cell.y).keep, 1.0f);
  stepWith(cells, {ballAt(2.0f * static_cast<float>(cell.x) + 1.0f, 2.0f * static_cast<float>(cell.y) + 1.0f)}, 60);
  EXPECT_TRUE(find(cells, cell.x, cell.y).has_value());
}

TEST(PatchCells, TakesOverAtOnceWhereThereIsNoTime) {
  PatchCells cells;
  cells.configure(limits(1000, 1000.0f));
  for (int n = 0; n < 40; ++n) {
    stepWith(cells, {ballAt(10.0f * static_cast<float>(n) + 1.0f, 1.0f, 0.3f)});
    ASSERT_TRUE(find(cells, 5 * n, 0).has_value()) << n;
    for (int back = 1; back < std::min(n, 8); ++back) {
      EXPECT_TRUE(find(cells, 5 * (n - back), 0).has_value()) << "the oldest goes first";
    }
    EXPECT_EQ(patchAt(cells, 5 * n, 0).keep, 0.0f);
  }
}

TEST(PatchCells, TheSameTouchesGiveTheSamePatches) {
  PatchCells a, b;
  a.configure(limits(1000, 2.0f));
  b.configure(limits(1000, 2.0f));
  for (int n = 0; n < 400; ++n) {
    const float t = 0.05f * static_cast<float>(n);
    const std::vector<ColliderPrimitive> there{ballAt(8.0f * std::sin(t), 8.0f * std::cos(1.3f * t)),
                                               ballAt(3.0f * t, 2.0f)};
    stepWith(a, there);
    stepWith(b, {there[1], there[0]});
    ASSERT_EQ(a.patches().size(), b.patches().size());
    for (std::size_t i = 0; i < a.patches().size(); ++i) {
      EXPECT_EQ(a.patches()[i].x, b.patches()[i].x);
      EXPECT_EQ(a.patches()[i].slot, b.patches()[i].slot);
      EXPECT_EQ(a.patches()[i].keep, b.patches()[i].keep);
    }
  }
}

TEST(PatchCells, ClearingAndOtherTilesDropAllPatches) {
  PatchCells cells;
  cells.configure(limits(1000));
  stepWith(cells, {ballAt(1.0f, 1.0f)});
  cells.configure(limits(1000));
  EXPECT_FALSE(cells.patches().empty()) << "the same limits change nothing";
  cells.clear();
  EXPECT_TRUE(cells.patches().empty());
  stepWith(cells, {ballAt(1.0f, 1.0f)});
  cells.configure(limits(2000));
  EXPECT_TRUE(cells.patches().empty());
}

TEST(PatchTable, FindsEveryPatchAndNoOther) {
  std::vector<GrassPatch> patches;
  for (int n = 0; n < 300; ++n) patches.push_back({n % 20 - 10, n / 20 - 7, static_cast<std::uint32_t>(n), 1.0f, 0, 0});
  const auto table = patchTable(patches);
  const std::size_t mask = table.size() - 1;
  ASSERT_EQ(table.size() & mask, 0u);
  const auto slotOf = [&](int x, int z) {
    for (std::size_t at = shared::patchHash(x, z) & mask; table[at].used != 0; at = (at + 1) & mask) {
      if (table[at].x == x && table[at].z == z) return static_cast<int>(table[at].slot);
    }
    return -1;
  };
  for (const GrassPatch& patch : patches) EXPECT_EQ(slotOf(patch.x, patch.z), static_cast<int>(patch.slot));
  EXPECT_EQ(slotOf(10, 0), -1);
  EXPECT_EQ(slotOf(0, 8), -1);
}

TEST(DynamicsClock, GoesOnJumpsAndStandsStill) {
  DynamicsClock clock;
  EXPECT_TRUE(clock.advance(3.0).jumped) << "the first time";
  EXPECT_FLOAT_EQ(clock.advance(3.02).seconds, 0.02f);
  const DynamicsStep still = clock.advance(3.02);
  EXPECT_FALSE(still.jumped);
  EXPECT_EQ(still.seconds, 0.0f);
  EXPECT_TRUE(clock.advance(2.9).jumped) << "back";
  EXPECT_TRUE(clock.advance(4.0).jumped) << "far ahead";
  EXPECT_FALSE(clock.advance(4.3).jumped) << "a slow frame";
  clock.forget();
  EXPECT_TRUE(clock.advance(4.31).jumped);
}

}  // namespace
}  // namespace windloom
