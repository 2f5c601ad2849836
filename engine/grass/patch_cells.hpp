#pragma once
// Which tiles of the meadow are patches: the bookkeeping of Belyaev's interaction. Pure and deterministic; nothing is
// read back from the GPU, as a patch's end follows from the time since it was last touched.

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/model/height_field.hpp"
#include "shaders/shared/collider.h"
#include "shaders/shared/grass_patch.h"

namespace windloom {

using shared::ColliderPrimitive;
using shared::GrassPatch;

/// Time in which a patch that gives way to another lets its blades back, s.
inline constexpr float kPatchFadeSeconds = 0.4f;
/// Most patches at a time.
inline constexpr int kMostPatches = 1024;

struct PatchLimits {
  float tileSideM = 1.0f;
  float reachM = 1.0f;         ///< of the highest blade
  int bladesInTile = 1;        ///< most
  int blades = 0;              ///< remembered at most, of all patches together; 0: no patches
  float settledAfterS = 5.0f;  ///< without a touch a patch is a block again
  bool operator==(const PatchLimits&) const = default;
};

class PatchCells {
 public:
  /// Other limits than before drop all patches.
  void configure(const PatchLimits& limits);

  /// What is touched in a step of `dtSeconds` (>= 0). `ground` null: flat at 0.
  void step(float dtSeconds, std::span<const ColliderPrimitive> primitives, const HeightField* ground);
  /// All tiles are blocks again.
  void clear();

  /// In this step, by slot; GrassPatch::keep is 0 for those new in it.
  [[nodiscard]] const std::vector<GrassPatch>& patches() const { return m_list; }
  /// The primitives of this step that may touch a patch, in their order: GrassPatch::first and count are places here.
  /// One that may touch several patches stands here as often.
  [[nodiscard]] const std::vector<ColliderPrimitive>& near() const { return m_near; }
  [[nodiscard]] int slots() const { return m_slots; }
  [[nodiscard]] int stride() const { return m_stride; }  ///< blades remembered of a patch
  /// Changes whenever another tile has a slot.
  [[nodiscard]] std::uint64_t generation() const { return m_generation; }

 private:
  struct Patch {
    glm::ivec2 cell{0};
    double touched = 0;      // when, s
    float fadeLeft = -1.0f;  // s; negative: it stays
    bool used = false, isNew = false;
  };
  struct Touch {
    glm::ivec2 cell{0};
    std::uint32_t primitive = 0;
  };
  void collectTouches(std::span<const ColliderPrimitive> primitives, const HeightField* ground);
  [[nodiscard]] std::span<const Touch> touchesOf(glm::ivec2 cell) const;
  void dropSettled();
  void fade(float dtSeconds);
  void take(glm::ivec2 cell);
  void keepReserve();
  [[nodiscard]] Patch* leastRecent();
  void fillList(float dtSeconds, std::span<const ColliderPrimitive> primitives);
  void release(Patch& patch);

  PatchLimits m_limits;
  int m_slots = 0, m_stride = 0;
  std::vector<Patch> m_patches;
  std::vector<Touch> m_touches;  // by cell, then by primitive
  std::vector<GrassPatch> m_list;
  std::vector<ColliderPrimitive> m_near;
  double m_time = 0;
  std::uint64_t m_generation = 0;
};

/// The table that shaders find patches with: a power of two of entries, at least twice as many as patches.
std::vector<shared::PatchEntry> patchTable(std::span<const GrassPatch> patches);

}  // namespace windloom
