#pragma once
// A handful of Bezier blades in GPU memory, and one of them stepped on the processor as bezier_step.comp does.

#include <algorithm>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <optional>
#include <random>
#include <vector>

#include "engine/grass/bezier_physics.hpp"
#include "engine/model/collider_motion.hpp"
#include "shaders/shared/bezier_blade.h"
#include "tests/gpu/grass/grass_scene.hpp"

namespace windloom::testing {

using glm::vec3;
using shared::BezierBlade;
using shared::BezierCurve;
using shared::BezierForces;
using shared::BezierMotion;
using shared::BezierPatch;
using shared::BezierState;

struct BladePlan {
  vec3 root{0.0f}, up{0.0f, 1.0f, 0.0f};
  float height = 0.5f, stiffness = 1.0f, turn = 0.0f;
};

inline BezierBlade packBlade(const BladePlan& plan) {
  BezierBlade blade{};
  blade.x = plan.root.x;
  blade.y = plan.root.y;
  blade.z = plan.root.z;
  blade.up = glm::packSnorm2x16(shared::octahedralPlace(plan.up));
  blade.sizes = glm::packHalf2x16({plan.height, 0.01f});
  blade.growth =
      (glm::packHalf2x16({plan.stiffness, 0.0f}) & 0xffffu) | (static_cast<unsigned>(plan.turn * 65535.0f) << 16);
  return blade;
}

/// As its record says, which is rounded.
inline BladePlan unpackBlade(const BezierBlade& blade) {
  BladePlan plan;
  plan.root = {blade.x, blade.y, blade.z};
  plan.up = shared::octahedralVector(glm::unpackSnorm2x16(blade.up));
  plan.height = glm::unpackHalf2x16(blade.sizes).x;
  plan.stiffness = glm::unpackHalf2x16(blade.growth).x;
  plan.turn = static_cast<float>(blade.growth >> 16) / 65535.0f;
  return plan;
}

/// `wind`: what blows over the ground there, m/s.
inline BezierForces forcesOn(const BladePlan& blade, const BezierPhysicsBlock& block, vec3 wind) {
  BezierForces forces;
  forces.up = blade.up;
  forces.front = shared::bezierFront(blade.up, shared::bezierAcross(blade.up, blade.turn));
  forces.gravity = shared::bezierGravity(block.gravity, block.centre, blade.root, forces.front);
  forces.wind = (wind - blade.up * glm::dot(blade.up, wind)) * block.motion.y;
  forces.recovery = block.motion.x * blade.stiffness;
  return forces;
}

inline void touchAll(BezierMotion& motion, const BladePlan& blade, const BezierForces& forces,
                     const BezierPhysicsBlock& block, const std::vector<BezierMover>& movers, float part,
                     float seconds) {
  float gained = 0.0f;
  for (const BezierMover& mover : movers) {
    const BezierCurve curve = shared::bezierCurveOf(motion.direction, blade.up, blade.height);
    const vec3 moved = shared::bezierHit(shared::bezierMoverAt(mover, part), blade.root, curve);
    if (moved == vec3(0.0f)) continue;
    gained += shared::bezierGain(moved, blade.height, block.motion.z, seconds);
    motion.direction = shared::bezierDirection(curve.tip + moved, forces.up, forces.front);
  }
  motion.strength = std::min(motion.strength + gained, BEZIER_STRENGTH_MOST);
}

/// A step of an awake patch.
inline BezierState stepped(const BezierState& state, const BladePlan& blade, const BezierPhysicsBlock& block, vec3 wind,
                           const std::vector<BezierMover>& movers, float stepSeconds) {
  const BezierForces forces = forcesOn(blade, block, wind);
  BezierMotion motion{shared::bezierDirection(vec3(state.tip), forces.up, forces.front), state.tip.w};
  const float parts = std::max(shared::bezierParts(stepSeconds, forces.wind),
                               movers.empty() ? 1.0f : bezierTouchParts(movers, stepSeconds));
  const float seconds = stepSeconds / parts;
  for (float i = 1.0f; i <= parts; ++i) {
    motion = shared::bezierSwing(forces, motion, block.motion.w, seconds);
    touchAll(motion, blade, forces, block, movers, i / parts, seconds);
  }
  return {
      glm::vec4(motion.direction * (blade.height * shared::bezierReach(motion.direction, forces.up)), motion.strength)};
}

/// What BezierGrass would own.
struct BladeStore {
  explicit BladeStore(const std::vector<BladePlan>& plans) {
    std::vector<BezierPatch> boxes;
    for (std::size_t first = 0; first < plans.size(); first += BEZIER_PATCH) {
      vec3 low(1e9f), high(-1e9f);
      const std::size_t end = std::min(first + BEZIER_PATCH, plans.size());
      for (std::size_t i = first; i < end; ++i) {
        records.push_back(packBlade(plans[i]));
        blades.push_back(unpackBlade(records.back()));
        low = glm::min(low, plans[i].root - 1.15f * plans[i].height);
        high = glm::max(high, plans[i].root + 1.15f * plans[i].height);
      }
      boxes.push_back({glm::vec4(0.5f * (low + high), float(end - first)), glm::vec4(0.5f * (high - low), -1.0f)});
    }
    records.resize(boxes.size() * BEZIER_PATCH);
    patchCount = boxes.size();
    const std::vector<std::uint32_t> ones(patchCount, 1);
    m_blades = taken(gpu::Buffer::create("test blades", std::span<const BezierBlade>(records)));
    m_patches = taken(gpu::Buffer::create("test patches", std::span<const BezierPatch>(boxes)));
    m_states = taken(gpu::Buffer::create("test states", records.size() * sizeof(BezierState), gpu::BufferUse::Dynamic));
    m_seen = taken(gpu::Buffer::create("test seen", std::span<const std::uint32_t>(ones), gpu::BufferUse::Dynamic));
  }
  [[nodiscard]] BezierStore store() const {
    return {&m_blades, &m_states, &m_patches, &m_seen, static_cast<std::uint32_t>(patchCount), kept};
  }
  [[nodiscard]] std::vector<BezierState> states() const {
    std::vector<BezierState> found(records.size());
    m_states.read(found.data(), found.size() * sizeof(BezierState));
    found.resize(blades.size());
    return found;
  }
  void setStates(const std::vector<BezierState>& states) { m_states.write(std::span<const BezierState>(states)); }
  void setSeen(bool seen) {
    const std::vector<std::uint32_t> flags(patchCount, seen ? 1 : 0);
    m_seen.write(std::span<const std::uint32_t>(flags));
  }

  std::vector<BezierBlade> records;
  std::vector<BladePlan> blades;
  std::size_t patchCount = 0;
  std::uint32_t kept = BEZIER_PATCH;

 private:
  gpu::Buffer m_blades, m_patches, m_states, m_seen;
};

}  // namespace windloom::testing
