#include "streaks.hpp"

namespace game {

namespace {

constexpr float kMarkEvery = 0.055f;           // s between two points of a trail
constexpr float kFaint = 2.4f, kClear = 6.5f;  // m/s: slower air is not shown, faster air shown in full

float smoothstep(float low, float high, float value) {
  const float part = std::clamp((value - low) / (high - low), 0.0f, 1.0f);
  return part * part * (3 - 2 * part);
}

}  // namespace

Streaks::Streaks(int count, std::uint32_t seed, const WindSource& wind)
    : m_specks(count),
      m_places(2 * count),
      m_random(seed),
      m_bounds(wind.bounds()),
      m_scale(std::min(m_bounds.width(), m_bounds.depth()) / 100) {
  m_vertices.reserve(static_cast<std::size_t>(count) * kPieces * 6);
  for (Speck& speck : m_specks) {
    place(speck);
    speck.age = m_random.between(0, speck.life);
  }
}

void Streaks::place(Speck& speck) {
  const Vec3 at{m_random.between(m_bounds.minX, m_bounds.maxX), m_random.between(0.5f, 2.6f) * m_scale,
                m_random.between(m_bounds.minZ, m_bounds.maxZ)};
  std::fill(std::begin(speck.trail), std::end(speck.trail), at);
  std::fill(std::begin(speck.speed), std::end(speck.speed), 0.0f);
  speck.age = 0;
  speck.life = m_random.between(1.6f, 3.2f);
}

void Streaks::step(const WindSource& wind, float dt) {
  for (std::size_t i = 0; i < m_specks.size(); ++i) {
    m_places[2 * i] = m_specks[i].trail[0].x;
    m_places[2 * i + 1] = m_specks[i].trail[0].z;
  }
  wind.sampleMany(m_places, m_winds);
  m_sinceMark += dt;
  const bool mark = m_sinceMark >= kMarkEvery;
  if (mark) m_sinceMark -= kMarkEvery;
  m_vertices.clear();
  for (std::size_t i = 0; i < m_specks.size(); ++i) {
    Speck& speck = m_specks[i];
    speck.age += dt;
    if (speck.age > speck.life) place(speck);
    if (mark) {
      std::copy_backward(speck.trail, speck.trail + kPieces, speck.trail + kPieces + 1);
      std::copy_backward(speck.speed, speck.speed + kPieces, speck.speed + kPieces + 1);
    }
    speck.trail[0] += Vec3{m_winds[2 * i], 0, m_winds[2 * i + 1]} * dt;
    speck.speed[0] = length(Vec2{m_winds[2 * i], m_winds[2 * i + 1]});
    addRibbon(speck);
  }
}

/// Widest and clearest at its head, so that one sees which way the air goes.
void Streaks::addRibbon(const Speck& speck) {
  const float fade = smoothstep(0, 0.4f, speck.age) * smoothstep(0, 0.6f, speck.life - speck.age);
  StreakVertex corners[kPieces + 1];
  float clearest = 0;
  for (int i = 0; i <= kPieces; ++i) {
    const Vec3 ahead = speck.trail[std::max(i - 1, 0)] - speck.trail[std::min(i + 1, kPieces)];
    const float tail = 1 - static_cast<float>(i) / kPieces;
    const float opacity = fade * smoothstep(kFaint, kClear, speck.speed[i]) * tail;
    clearest = std::max(clearest, opacity);
    corners[i] = {speck.trail[i], normalized(ahead, {1, 0, 0}), 1, (0.02f + 0.055f * tail) * m_scale, opacity};
  }
  if (clearest < 0.02f) return;
  for (int i = kPieces; i > 0; --i) {
    StreakVertex quad[4] = {corners[i], corners[i], corners[i - 1], corners[i - 1]};
    quad[0].side = quad[2].side = -1;
    m_vertices.insert(m_vertices.end(), {quad[0], quad[1], quad[2], quad[2], quad[1], quad[3]});
  }
}

}  // namespace game
