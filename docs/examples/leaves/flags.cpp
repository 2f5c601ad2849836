#include "flags.hpp"

// The cloth: Verlet integration with threads as distances that are put right again and again (T. Jakobsen, "Advanced
// Character Physics", 2001). Wind presses on the cloth along its normal and drags along it a little.

namespace game {

namespace {

constexpr float kLength = 4.4f, kHoist = 2.7f;  // m, on a field of 100 m
constexpr float kGravity = 4.5f;                // m/s^2: light cloth, the air carries some of it
constexpr float kPress = 3.2f;                  // 1/s: how quickly the wind takes the cloth along, across it
constexpr float kDrag = 0.55f;                  // and along it
constexpr int kRounds = 10;                     // of putting the threads right, a step

const Vec3 kColours[][2] = {
    {{0.50f, 0.02f, 0.03f}, {0.85f, 0.78f, 0.62f}}, {{0.03f, 0.09f, 0.30f}, {0.85f, 0.62f, 0.10f}},
    {{0.80f, 0.42f, 0.03f}, {0.35f, 0.04f, 0.04f}}, {{0.02f, 0.22f, 0.20f}, {0.86f, 0.80f, 0.66f}},
    {{0.80f, 0.76f, 0.66f}, {0.55f, 0.05f, 0.04f}}, {{0.20f, 0.05f, 0.22f}, {0.86f, 0.66f, 0.22f}}};

float distance(Vec3 a, Vec2 b) {
  return length(Vec2{a.x - b.x, a.z - b.z});
}

/// Moves both ends so that they come nearer to `rest` apart; an end with weight 0 is held.
void pull(Vec3& a, Vec3& b, float rest, float weightA, float weightB) {
  const Vec3 between = b - a;
  const float size = length(between);
  if (size < 1e-6f || weightA + weightB == 0) return;
  const Vec3 fix = between * ((size - rest) / size / (weightA + weightB));
  a += fix * weightA;
  b += fix * -weightB;
}

}  // namespace

Flags::Flags(int count, const WindSource& wind)
    : m_bounds(wind.bounds()), m_scale(std::min(m_bounds.width(), m_bounds.depth()) / 100) {
  choosePlaces(count, wind);
  for (const Vec3& pole : m_poles) hang(pole, wind.sample(pole.x, pole.z));
  m_vertices.resize(m_points.size());
  for (std::size_t i = 0; i < m_poles.size(); ++i) m_ripple.push_back(1.7f * static_cast<float>(i));
  for (int i = 0; i < 120; ++i) step(wind, 1.0f / 60);
}

/// The windiest place first, then the windiest one that is far enough from all others, and so on.
void Flags::choosePlaces(int count, const WindSource& wind) {
  constexpr int kSide = 24;
  const float apart = 17 * m_scale;
  for (int n = 0; n < count; ++n) {
    float best = -1;
    Vec3 place;
    for (int i = 0; i < kSide * kSide; ++i) {
      const float x = m_bounds.minX + m_bounds.width() * (0.08f + 0.84f * static_cast<float>(i % kSide) / (kSide - 1));
      const float z = m_bounds.minZ + m_bounds.depth() * (0.08f + 0.84f * static_cast<float>(i / kSide) / (kSide - 1));
      const float speed = wind.usualSpeed(x, z);
      bool free = true;
      for (const Vec3& pole : m_poles) free = free && distance(pole, {x, z}) >= apart;
      if (free && speed > best) {
        best = speed;
        place = {x, 0, z};
      }
    }
    if (best < 0) return;  // the field is full
    m_poles.push_back(place);
  }
}

/// A cloth that is stretched out down the wind.
void Flags::hang(Vec3 pole, Vec2 wind) {
  const Vec3 out = normalized({wind.x, 0, wind.z}, {1, 0, 0});
  for (int down = 0; down < kDown; ++down) {
    for (int along = 0; along < kAlong; ++along) {
      const float far = kLength * m_scale * static_cast<float>(along) / (kAlong - 1);
      const float low = kHoist * m_scale * static_cast<float>(down) / (kDown - 1);
      const Vec3 at = pole + out * far + Vec3{0, poleHeight() * 0.985f - low, 0};
      m_points.push_back({at, at});
    }
  }
}

void Flags::step(const WindSource& wind, float dt) {
  for (std::size_t flag = 0; flag < m_poles.size(); ++flag) {
    const Vec3 pole = m_poles[flag];
    blow(flag, wind.sample(pole.x, pole.z), wind.heightFactor(poleHeight() - kHoist * m_scale / 2), dt);
    Point* cloth = &m_points[flag * kPoints];
    for (int round = 0; round < kRounds; ++round) holdTogether(cloth);
    updateVertices(flag);
  }
}

/// Wind and weight on each point. Behind the pole the air sheds whirls from side to side: that is what makes a flag
/// wave in a steady wind. The folds run along the cloth at about half the wind's speed.
void Flags::blow(std::size_t flag, Vec2 wind, float factor, float dt) {
  Point* cloth = &m_points[flag * kPoints];
  const float speed = length(wind) * factor;
  const Vec3 air{wind.x * factor, 0, wind.z * factor};
  const Vec3 aside = normalized({-wind.z, 0, wind.x}, {0, 0, 1});
  m_ripple[flag] += dt * 2 * kPi * (0.35f + 0.16f * speed) / std::max(m_scale, 0.2f);
  for (int down = 0; down < kDown; ++down) {
    for (int along = 1; along < kAlong; ++along) {
      Point& point = cloth[down * kAlong + along];
      const float s = static_cast<float>(along) / (kAlong - 1), t = static_cast<float>(down) / (kDown - 1);
      const float fold =
          std::sin(9.5f * s - m_ripple[flag] + 1.3f * t) + 0.4f * std::sin(17 * s - 1.7f * m_ripple[flag] - 2 * t);
      const Vec3 velocity = (point.now - point.before) * (1 / dt);
      const Vec3 relative = air + aside * (0.55f * speed * (0.3f + s) * fold) - velocity;
      const Vec3 normal = normalAt(cloth, along, down);
      const Vec3 push = normal * (dot(normal, relative) * kPress) + relative * kDrag + Vec3{0, -kGravity, 0};
      const Vec3 next = point.now + velocity * (dt * 0.985f) + push * (dt * dt);
      point.before = point.now;
      point.now = next;
    }
  }
}

void Flags::holdTogether(Point* cloth) const {
  const float dx = kLength * m_scale / (kAlong - 1), dy = kHoist * m_scale / (kDown - 1);
  const float diagonal = std::sqrt(dx * dx + dy * dy);
  for (int along = 0; along < kAlong; ++along) {
    const float mine = along == 0 ? 0.0f : 1.0f;
    for (int down = 0; down < kDown; ++down) {
      Vec3& here = cloth[down * kAlong + along].now;
      const bool right = along + 1 < kAlong, below = down + 1 < kDown;
      if (right) pull(here, cloth[down * kAlong + along + 1].now, dx, mine, 1);
      if (below) pull(here, cloth[(down + 1) * kAlong + along].now, dy, mine, mine);
      if (right && below) pull(here, cloth[(down + 1) * kAlong + along + 1].now, diagonal, 0.6f * mine, 0.6f);
      if (right && down > 0) pull(here, cloth[(down - 1) * kAlong + along + 1].now, diagonal, 0.6f * mine, 0.6f);
    }
  }
}

Vec3 Flags::normalAt(const Point* cloth, int along, int down) const {
  const auto at = [&](int a, int d) {
    return cloth[std::clamp(d, 0, kDown - 1) * kAlong + std::clamp(a, 0, kAlong - 1)].now;
  };
  return normalized(cross(at(along, down - 1) - at(along, down + 1), at(along + 1, down) - at(along - 1, down)),
                    {0, 0, 1});
}

void Flags::updateVertices(std::size_t flag) {
  const Point* cloth = &m_points[flag * kPoints];
  const auto& colours = kColours[flag % std::size(kColours)];
  for (int i = 0; i < kPoints; ++i) {
    const int along = i % kAlong, down = i / kAlong;
    m_vertices[flag * kPoints + i] = {cloth[i].now,
                                      normalAt(cloth, along, down),
                                      static_cast<float>(along) / (kAlong - 1),
                                      static_cast<float>(down) / (kDown - 1),
                                      colours[0],
                                      colours[1]};
  }
}

std::vector<unsigned> Flags::indices() const {
  std::vector<unsigned> indices;
  for (unsigned flag = 0; flag < m_poles.size(); ++flag) {
    for (unsigned down = 0; down + 1 < kDown; ++down) {
      for (unsigned along = 0; along + 1 < kAlong; ++along) {
        const unsigned a = flag * kPoints + down * kAlong + along, b = a + kAlong;
        indices.insert(indices.end(), {a, b, a + 1, a + 1, b, b + 1});
      }
    }
  }
  return indices;
}

}  // namespace game
