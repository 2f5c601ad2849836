#include "engine/grass/patch_cells.hpp"

#include <algorithm>
#include <cmath>

#include "shaders/shared/chain_contact.h"

namespace windloom {
namespace {

bool before(glm::ivec2 a, glm::ivec2 b) {
  return a.y != b.y ? a.y < b.y : a.x < b.x;
}

/// Distance of a point to a rectangle.
float toRectangle(glm::vec2 point, glm::vec2 low, glm::vec2 high) {
  return glm::length(glm::max(glm::max(low - point, point - high), glm::vec2(0.0f)));
}

float toSegment(glm::vec2 point, glm::vec2 a, glm::vec2 b) {
  const glm::vec2 way = b - a;
  const float t = std::clamp(glm::dot(point - a, way) / std::max(glm::dot(way, way), 1e-12f), 0.0f, 1.0f);
  return glm::length(point - a - way * t);
}

/// Whether a segment comes closer to a square than `reach`. Never misses; may count a square just beyond reach.
bool nearSquare(glm::vec2 a, glm::vec2 b, glm::vec2 low, float side, float reach) {
  const glm::vec2 high = low + side, centre = low + 0.5f * side;
  if (toRectangle(a, low, high) <= reach || toRectangle(b, low, high) <= reach) return true;
  return toSegment(centre, a, b) <= reach + side * std::sqrt(0.5f);
}

}  // namespace

void PatchCells::configure(const PatchLimits& limits) {
  if (limits == m_limits) return;
  m_limits = limits;
  m_stride = std::min(limits.blades, std::max(limits.bladesInTile, 1));
  m_slots = m_stride > 0 ? std::min(limits.blades / m_stride, kMostPatches) : 0;
  m_patches.assign(static_cast<std::size_t>(m_slots), {});
  m_list.clear();
  m_near.clear();
  ++m_generation;
}

void PatchCells::clear() {
  for (Patch& patch : m_patches) release(patch);
  m_list.clear();
  m_near.clear();
}

void PatchCells::release(Patch& patch) {
  if (patch.used) ++m_generation;
  patch = {};
}

void PatchCells::step(float dtSeconds, std::span<const ColliderPrimitive> primitives, const HeightField* ground) {
  m_time += static_cast<double>(dtSeconds);
  for (Patch& patch : m_patches) patch.isNew = false;
  collectTouches(primitives, ground);
  for (Patch& patch : m_patches) {
    if (!patch.used || touchesOf(patch.cell).empty()) continue;
    patch.touched = m_time;
    patch.fadeLeft = -1.0f;
  }
  dropSettled();
  fade(dtSeconds);
  for (std::size_t i = 0; i < m_touches.size(); ++i) {
    if (i == 0 || m_touches[i].cell != m_touches[i - 1].cell) take(m_touches[i].cell);
  }
  keepReserve();
  fillList(dtSeconds, primitives);
}

std::span<const PatchCells::Touch> PatchCells::touchesOf(glm::ivec2 cell) const {
  const auto found = std::ranges::equal_range(m_touches, cell, before, &Touch::cell);
  return {found.begin(), found.end()};
}

void PatchCells::collectTouches(std::span<const ColliderPrimitive> primitives, const HeightField* ground) {
  m_touches.clear();
  if (m_slots == 0) return;
  const float side = m_limits.tileSideM, bladeReach = m_limits.reachM + 2.0f * CONTACT_MARGIN;
  for (std::uint32_t n = 0; n < primitives.size(); ++n) {
    const ColliderPrimitive& primitive = primitives[n];
    const glm::vec2 a(primitive.a.x, primitive.a.z), b(primitive.b.x, primitive.b.z);
    const float reach = primitive.a.w + bladeReach;
    const glm::ivec2 low(glm::floor((glm::min(a, b) - reach) / side)),
        high(glm::floor((glm::max(a, b) + reach) / side));
    const float lowest = std::min(primitive.a.y, primitive.b.y) - primitive.a.w;
    for (int z = low.y; z <= high.y; ++z) {
      for (int x = low.x; x <= high.x; ++x) {
        const glm::vec2 corner = side * glm::vec2(x, z);
        if (!nearSquare(a, b, corner, side, reach)) continue;
        const float top = ground != nullptr ? heightsOver(*ground, corner, corner + side).highest : 0.0f;
        if (lowest <= top + bladeReach) m_touches.push_back({{x, z}, n});
      }
    }
  }
  // Of a cell they came in the primitives' order, which decides how a blade between two of them bends.
  std::ranges::stable_sort(m_touches, before, &Touch::cell);
}

void PatchCells::dropSettled() {
  for (Patch& patch : m_patches) {
    if (patch.used && m_time - patch.touched > static_cast<double>(m_limits.settledAfterS)) release(patch);
  }
}

void PatchCells::fade(float dtSeconds) {
  for (Patch& patch : m_patches) {
    if (!patch.used || patch.fadeLeft < 0.0f) continue;
    // The step that leaves nothing has been drawn.
    if (patch.fadeLeft == 0.0f) {
      release(patch);
    } else {
      patch.fadeLeft = std::max(patch.fadeLeft - dtSeconds, 0.0f);
    }
  }
}

/// The patch that was touched least recently, of those not touched now; null: there is none.
PatchCells::Patch* PatchCells::leastRecent() {
  Patch* found = nullptr;
  for (Patch& patch : m_patches) {
    if (!patch.used || patch.touched >= m_time) continue;
    if (found == nullptr || patch.touched < found->touched) found = &patch;
  }
  return found;
}

/// Makes a touched tile a patch, unless it is one or all patches are touched now.
void PatchCells::take(glm::ivec2 cell) {
  Patch* free = nullptr;
  for (Patch& patch : m_patches) {
    if (patch.used && patch.cell == cell) return;
    if (!patch.used && free == nullptr) free = &patch;
  }
  if (free == nullptr) free = leastRecent();
  if (free == nullptr) return;
  *free = {cell, m_time, -1.0f, true, true};
  ++m_generation;
}

/// Lets the oldest patches fade in time, so that new ones seldom have to wait or to push one away.
void PatchCells::keepReserve() {
  const int reserve = m_slots / 8;
  int room = 0;
  for (const Patch& patch : m_patches) room += !patch.used || patch.fadeLeft >= 0.0f ? 1 : 0;
  for (; room < reserve; ++room) {
    Patch* oldest = nullptr;
    for (Patch& patch : m_patches) {
      if (patch.fadeLeft >= 0.0f || patch.touched >= m_time) continue;
      if (oldest == nullptr || patch.touched < oldest->touched) oldest = &patch;
    }
    if (oldest == nullptr) return;
    oldest->fadeLeft = kPatchFadeSeconds;
  }
}

void PatchCells::fillList(float dtSeconds, std::span<const ColliderPrimitive> primitives) {
  m_list.clear();
  m_near.clear();
  for (std::size_t slot = 0; slot < m_patches.size(); ++slot) {
    const Patch& patch = m_patches[slot];
    if (!patch.used) continue;
    float keep = patch.isNew ? 0.0f : 1.0f;
    // A straight line to nothing: of what was left before this step.
    if (patch.fadeLeft >= 0.0f && patch.fadeLeft < kPatchFadeSeconds)
      keep = patch.fadeLeft / (patch.fadeLeft + dtSeconds);
    if (patch.fadeLeft == 0.0f) keep = 0.0f;
    const std::span<const Touch> touches = touchesOf(patch.cell);
    m_list.push_back({patch.cell.x, patch.cell.y, static_cast<std::uint32_t>(slot), keep,
                      static_cast<std::uint32_t>(m_near.size()), static_cast<std::uint32_t>(touches.size())});
    for (const Touch& touch : touches) m_near.push_back(primitives[touch.primitive]);
  }
}

std::vector<shared::PatchEntry> patchTable(std::span<const GrassPatch> patches) {
  std::size_t size = 16;
  while (size < 2 * patches.size()) size *= 2;
  std::vector<shared::PatchEntry> table(size, {0, 0, 0, 0});
  for (const GrassPatch& patch : patches) {
    std::size_t at = shared::patchHash(patch.x, patch.z) & (size - 1);
    while (table[at].used != 0) at = (at + 1) & (size - 1);
    table[at] = {patch.x, patch.z, patch.slot, 1};
  }
  return table;
}

}  // namespace windloom
