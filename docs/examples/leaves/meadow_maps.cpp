#include "meadow_maps.hpp"

namespace game {

namespace {

/// Random values between -1 and 1 on a lattice that repeats, smoothly joined.
class Lattice {
 public:
  Lattice(int side, Random& random) : m_side(side), m_values(side * side) {
    for (float& value : m_values) value = random.between(-1, 1);
  }
  /// x and z in 0..1 across the whole lattice.
  float at(float x, float z) const {
    const float px = x * static_cast<float>(m_side), pz = z * static_cast<float>(m_side);
    const int ix = static_cast<int>(px), iz = static_cast<int>(pz);
    const float fx = px - static_cast<float>(ix), fz = pz - static_cast<float>(iz);
    const float sx = fx * fx * (3 - 2 * fx), sz = fz * fz * (3 - 2 * fz);
    return mix(mix(corner(ix, iz), corner(ix + 1, iz), sx), mix(corner(ix, iz + 1), corner(ix + 1, iz + 1), sx), sz);
  }

 private:
  float corner(int x, int z) const { return m_values[z % m_side * m_side + x % m_side]; }
  int m_side;
  std::vector<float> m_values;
};

/// Finer and finer lattices with less and less weight, about -1..1.
class Noise {
 public:
  Noise(int coarsest, Random& random) {
    for (int side = coarsest; side <= 128; side *= 2) m_octaves.emplace_back(side, random);
  }
  float at(float x, float z) const {
    float sum = 0, weight = 0.6f;
    for (const Lattice& octave : m_octaves) {
      sum += weight * octave.at(x, z);
      weight *= 0.55f;
    }
    return sum;
  }

 private:
  std::vector<Lattice> m_octaves;
};

unsigned char toByte(float value) {
  return static_cast<unsigned char>(std::clamp(value, 0.0f, 1.0f) * 255 + 0.5f);
}

}  // namespace

std::vector<unsigned char> meadowTexels(Random& random) {
  const Vec3 deep{0.085f, 0.150f, 0.026f}, light{0.185f, 0.235f, 0.045f}, dry{0.34f, 0.245f, 0.075f};
  const Noise greens(4, random), dryness(5, random), soft(8, random);
  std::vector<unsigned char> texels;
  texels.reserve(kMeadowSide * kMeadowSide * 4);
  for (int i = 0; i < kMeadowSide * kMeadowSide; ++i) {
    const float x = static_cast<float>(i % kMeadowSide) / kMeadowSide,
                z = static_cast<float>(i / kMeadowSide) / kMeadowSide;
    const float dried = std::clamp(dryness.at(x, z) * 1.3f - 0.05f, 0.0f, 0.75f);
    const Vec3 colour = mix(mix(deep, light, std::clamp(0.5f + 0.7f * greens.at(x, z), 0.0f, 1.0f)), dry, dried);
    for (const float channel : {colour.x, colour.y, colour.z}) texels.push_back(toByte(std::sqrt(channel)));
    texels.push_back(toByte(0.5f + 0.5f * soft.at(x, z)));
  }
  return texels;
}

std::vector<unsigned char> turfTexels(Random& random) {
  constexpr int kStrokes = 16000;
  std::vector<unsigned char> texels(kTurfSide * kTurfSide, 45);
  for (int stroke = 0; stroke < kStrokes; ++stroke) {
    float x = random.between(0, kTurfSide), z = random.between(0, kTurfSide);
    const float angle = random.between(-kPi, kPi), bend = random.between(-0.05f, 0.05f);
    const float light = mix(50, 235, random.unit() * (0.3f + 0.7f * static_cast<float>(stroke) / kStrokes));
    const int steps = static_cast<int>(random.between(9, 24));
    for (int i = 0; i < steps; ++i) {
      const int at = (static_cast<int>(z) & (kTurfSide - 1)) * kTurfSide + (static_cast<int>(x) & (kTurfSide - 1));
      texels[at] =
          static_cast<unsigned char>(light * (0.7f + 0.3f * static_cast<float>(i) / static_cast<float>(steps)));
      x += std::cos(angle + bend * static_cast<float>(i));
      z += std::sin(angle + bend * static_cast<float>(i));
    }
  }
  return texels;
}

}  // namespace game
