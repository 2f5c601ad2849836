#include "leaves.hpp"

#include <iomanip>
#include <iostream>

namespace game {

namespace {

constexpr float kFallSpeed = 1.15f;    // m/s in still air
constexpr float kGroundHeight = 0.6f;  // m over the ground whose wind counts for what lies there: the grass's height
constexpr float kLongestRest = 30;     // s; then a new leaf falls instead, so that the air never empties

const Vec3 kColours[] = {{0.80f, 0.30f, 0.02f}, {0.85f, 0.47f, 0.03f}, {0.60f, 0.09f, 0.02f}, {0.90f, 0.62f, 0.08f},
                         {0.42f, 0.14f, 0.04f}, {0.72f, 0.18f, 0.02f}, {0.55f, 0.50f, 0.06f}};

/// A smooth noise of time, about -1..1: sines whose periods never meet.
float waver(float time, float phase) {
  return 0.6f * std::sin(time * 2.3f + phase) + 0.4f * std::sin(time * 5.1f + phase * 2.7f);
}

}  // namespace

Leaves::Leaves(int count, std::uint32_t seed, const WindSource& wind)
    : m_leaves(count),
      m_places(2 * count),
      m_looks(count),
      m_random(seed),
      m_bounds(wind.bounds()),
      m_scale(std::min(m_bounds.width(), m_bounds.depth()) / 100) {
  for (Leaf& leaf : m_leaves) {
    leaf.size = m_random.between(0.55f, 1.0f) * m_scale;
    leaf.phase = m_random.between(0, 100);
    leaf.sluggishness = m_random.between(0.2f, 0.5f);
    leaf.grip = m_random.between(1.6f, 3.0f);
    const Vec3 colour = kColours[static_cast<int>(m_random.unit() * std::size(kColours))];
    leaf.colour = colour * m_random.between(0.75f, 1.15f);
    place(leaf, true);
    leaf.start = {leaf.position.x, leaf.position.z};
  }
  for (std::size_t i = 0; i < m_leaves.size(); ++i) m_looks[i] = lookOf(m_leaves[i]);
}

/// Somewhere over the field; `fresh` ones also lie on the ground, as most leaves do, later ones fall from above.
void Leaves::place(Leaf& leaf, bool fresh) {
  const bool lies = fresh && m_random.unit() < 0.55f;
  leaf.position = {m_random.between(m_bounds.minX, m_bounds.maxX), lies ? 0 : m_random.between(0.5f, 6) * m_scale,
                   m_random.between(m_bounds.minZ, m_bounds.maxZ)};
  leaf.velocity = {};
  leaf.lies = lies;
  leaf.yaw = m_random.between(-kPi, kPi);
  leaf.pitch = lies ? m_random.between(-0.25f, 0.25f) : m_random.between(-kPi, kPi);
  leaf.roll = lies ? m_random.between(-0.3f, 0.3f) : m_random.between(-kPi, kPi);
  leaf.spin = {m_random.between(-1, 1), m_random.between(-1, 1), m_random.between(-1, 1)};
  leaf.rest = lies ? m_random.between(0, kLongestRest * 0.6f) : 0;
  leaf.age = fresh ? 10.0f : 0.0f;
}

void Leaves::step(const WindSource& wind, float dt) {
  // All places are asked for in one call: that is the quick way.
  for (std::size_t i = 0; i < m_leaves.size(); ++i) {
    m_places[2 * i] = m_leaves[i].position.x;
    m_places[2 * i + 1] = m_leaves[i].position.z;
  }
  wind.sampleMany(m_places, m_winds);
  for (std::size_t i = 0; i < m_leaves.size(); ++i) {
    Leaf& leaf = m_leaves[i];
    const float factor = wind.heightFactor(std::max(leaf.position.y, kGroundHeight));
    const Vec2 here{m_winds[2 * i] * factor, m_winds[2 * i + 1] * factor};
    const Vec3 before = leaf.position;
    leaf.age += dt;
    if (leaf.lies) {
      lie(leaf, here, dt);
    } else {
      fly(leaf, here, dt);
    }
    leaf.position += leaf.velocity * dt;
    tumble(leaf, length(here), dt);
    leaf.travelled.x += leaf.position.x - before.x;
    leaf.travelled.z += leaf.position.z - before.z;
    const bool gone = leaf.position.x < m_bounds.minX || leaf.position.x > m_bounds.maxX ||
                      leaf.position.z < m_bounds.minZ || leaf.position.z > m_bounds.maxZ;
    if (gone || leaf.rest > kLongestRest) {
      place(leaf, false);
      ++leaf.jumps;
    }
    m_looks[i] = lookOf(leaf);
  }
}

/// In the air a leaf takes on the wind's speed with some inertia, sinks, is lifted by gusts and slips from side to
/// side.
void Leaves::fly(Leaf& leaf, Vec2 wind, float dt) const {
  const float speed = length(wind);
  const float lift = (0.13f + 0.2f * waver(leaf.age, leaf.phase)) * speed;
  const float ceiling = std::clamp(leaf.position.y / (9 * m_scale), 0.0f, 1.0f);
  const float slip = 0.9f * waver(leaf.age * 1.7f, leaf.phase + 4);
  const Vec3 air{wind.x + slip * std::cos(leaf.yaw), (1 - ceiling) * lift - kFallSpeed,
                 wind.z + slip * std::sin(leaf.yaw)};
  const float follow = 1 - std::exp(-dt / leaf.sluggishness);
  leaf.velocity += (air - leaf.velocity) * follow;
  if (leaf.position.y <= 0 && leaf.velocity.y < 0) {
    leaf.lies = true;
    leaf.rest = 0;
    leaf.position.y = 0;
    leaf.velocity.y = 0;
  }
}

/// On the ground it slides to a stop in the grass, until the wind is stronger than its grip.
void Leaves::lie(Leaf& leaf, Vec2 wind, float dt) {
  const float stop = std::exp(-5 * dt);
  leaf.velocity = {leaf.velocity.x * stop, 0, leaf.velocity.z * stop};
  leaf.rest += dt;
  const float excess = length(wind) - leaf.grip;
  // Not all at once: the stronger the gust, the sooner a leaf finds itself under it.
  if (excess <= 0 || m_random.unit() > excess * 2.5f * dt) return;
  leaf.lies = false;
  leaf.velocity = {wind.x * 0.4f, m_random.between(0.8f, 2.0f), wind.z * 0.4f};
  leaf.spin = {m_random.between(-5, 5), m_random.between(-2, 2), m_random.between(-5, 5)};
}

/// Turns on in the air, the faster the stronger the wind; lays itself flat on the ground.
void Leaves::tumble(Leaf& leaf, float speed, float dt) const {
  if (leaf.lies) {
    const float settle = 1 - std::exp(-6 * dt);
    // Either side may be up: the nearest half turn is flat.
    leaf.pitch += (kPi * std::round(leaf.pitch / kPi) + 0.2f * std::sin(leaf.phase) - leaf.pitch) * settle;
    leaf.roll += (kPi * std::round(leaf.roll / kPi) + 0.25f * std::cos(leaf.phase * 3) - leaf.roll) * settle;
    return;
  }
  const float pace = (0.6f + 0.22f * speed) * dt;
  leaf.pitch += (leaf.spin.x + 1.5f * waver(leaf.age, leaf.phase)) * pace;
  leaf.yaw += leaf.spin.y * pace;
  leaf.roll += (leaf.spin.z + 1.5f * waver(leaf.age * 1.3f, leaf.phase + 9)) * pace;
}

LeafLook Leaves::lookOf(const Leaf& leaf) const {
  // New leaves grow in the air and old ones shrink away, so that nothing pops.
  const float grown = std::min(leaf.age * 1.5f, 1.0f) * std::clamp((kLongestRest - leaf.rest) * 0.7f, 0.0f, 1.0f);
  const float lift = 0.25f * leaf.size;  // lying leaves are caught by the tips of the grass
  return {leaf.position + Vec3{0, lift, 0}, leaf.size * grown, turned(leaf.yaw, leaf.pitch, leaf.roll), leaf.colour,
          0.35f + 0.25f * std::sin(leaf.phase)};
}

void Leaves::print() const {
  Vec2 sum;
  std::cout << std::fixed << std::setprecision(3);
  for (std::size_t i = 0; i < m_leaves.size(); ++i) {
    const Leaf& leaf = m_leaves[i];
    std::cout << "leaf " << i << " start " << leaf.start.x << ' ' << leaf.start.z << " end " << leaf.position.x << ' '
              << leaf.position.z << " drift " << leaf.travelled.x << ' ' << leaf.travelled.z << " jumps " << leaf.jumps
              << '\n';
    sum.x += leaf.travelled.x;
    sum.z += leaf.travelled.z;
  }
  const float count = static_cast<float>(m_leaves.size());
  std::cout << "mean drift " << sum.x / count << ' ' << sum.z / count << '\n';
}

}  // namespace game
