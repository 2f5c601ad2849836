// Roughly what shaders/include/grass_blades.glsl and shaders/grass/place_blades.comp make of the same settings for the
// instanced grass, so that a meadow looks alike when it is switched from one to the other.
#include "engine/grass/blade_traits.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "engine/grass/value_noise.hpp"
#include "shaders/shared/bezier_pose.h"

namespace windloom {
namespace {

constexpr float kTurn = 6.2831853f;
constexpr float kTuftAlike = 0.6f;  // share of a tuft in its blades' size and colour

std::uint32_t formOf(BladeForm form) {
  switch (form) {
    case BladeForm::Quad:
      return BEZIER_FORM_QUAD;
    case BladeForm::Triangle:
      return BEZIER_FORM_TRIANGLE;
    case BladeForm::Quadratic:
      return BEZIER_FORM_QUADRATIC;
    case BladeForm::TriangleTip:
      break;
  }
  return BEZIER_FORM_TRIANGLE_TIP;
}

/// The clump a root belongs to: the nearest of jittered centres, as a hash.
std::uint32_t clumpOf(const BladeTraits& traits, glm::vec3 root) {
  const glm::vec3 at = root / traits.clumpSizeM;
  const glm::ivec3 cell(glm::clamp(glm::floor(at), glm::vec3(-1e9f), glm::vec3(1e9f)));
  const int rise = traits.level ? 0 : 1;
  float nearest = 1e9f;
  std::uint32_t found = 0;
  for (int y = -rise; y <= rise; ++y) {
    for (int z = -1; z <= 1; ++z) {
      for (int x = -1; x <= 1; ++x) {
        const glm::ivec3 near = cell + glm::ivec3(x, y, z);
        const auto bits = [](int c) { return static_cast<std::uint32_t>(c); };
        const std::uint32_t height = traits.level ? 0u : bits(near.y) * 0xcb1ab31fu;
        const std::uint32_t hash =
            pcgHash((bits(near.x) * 0x8da6b343u + bits(near.z) * 0xd8163841u) ^ (height + traits.seed * 0x9e3779b9u));
        const glm::vec3 jitter = glm::vec3(hash & 0x7ffu, hash >> 11 & 0x3ffu, hash >> 21) * (1.0f / 2048.0f);
        glm::vec3 away = glm::vec3(near) + jitter - at;
        if (traits.level) away.y = 0.0f;
        const float d = glm::dot(away, away);
        if (d >= nearest) continue;
        nearest = d;
        found = hash;
      }
    }
  }
  return found;
}

/// Broad patches: x dryness, y brightness.
glm::vec2 broadPatch(glm::vec3 root, std::uint32_t seed) {
  const glm::vec2 level(root.x + 0.71f * root.y, root.z - 0.53f * root.y);
  const float broad = valueNoise(level / 23.0f, seed ^ 0x1f83d9abu),
              small = valueNoise(level / 5.2f, seed ^ 0x9b05688cu);
  const float t = std::clamp((0.5f * broad + 0.5f * small - 0.42f) / 0.38f, 0.0f, 1.0f);
  return {t * t * (3.0f - 2.0f * t), 0.86f + 0.28f * (0.4f * (1.0f - broad) + 0.6f * small)};
}

std::uint32_t byteOf(float value) {
  return static_cast<std::uint32_t>(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// What the blades of a clump or tuft have in common.
struct Common {
  float size, dry, bright, hue, lean;
  explicit Common(std::uint32_t hash) {
    RandomStream random(hash ^ 0x68bc21ebu);
    size = random.next();
    dry = random.next();
    bright = random.next();
    hue = random.next();
    lean = random.next();
  }
};

std::uint32_t lookOf(const BladeTraits& traits, const GrowthPoint& point, const Common& common, float alike,
                     RandomStream& random, std::uint32_t form) {
  const glm::vec2 patch = broadPatch(point.place, traits.seed);
  const float dryPart = traits.dryness * (0.4f + 1.2f * patch.x);
  const bool isDry =
      glm::mix(random.next(), common.dry, std::max(0.6f * traits.clumping + 0.2f, alike)) >= 1.0f - dryPart;
  const float dry = (isDry ? 0.45f + 0.5f * random.next() : 0.0f) + (traits.dryness > 0.0f ? 0.15f * patch.x : 0.0f);
  const float bright =
      patch.y * (0.78f + 0.44f * glm::mix(random.next(), common.bright, std::max(0.5f * traits.clumping, alike)));
  const float hue = glm::mix(random.next(), common.hue, std::max(0.7f * traits.clumping, alike));
  return byteOf(dry) | byteOf(0.5f * bright) << 8 | byteOf(hue) << 16 | form << 24;
}

}  // namespace

BladeTraits groundTraits(const GrassSettings& grass, const BezierSettings& bezier) {
  BladeTraits traits;
  traits.height = grass.height;
  traits.heightVariation = grass.heightVariation;
  traits.width = grass.width;
  traits.stiffness = grass.stiffness;
  traits.stiffnessVariation = grass.stiffnessVariation;
  traits.clumping = grass.clumping;
  traits.dryness = grass.dryness;
  traits.dandelions = bezier.dandelions;
  traits.form = formOf(bezier.form);
  traits.seed = static_cast<std::uint32_t>(grass.seed);
  return traits;
}

BladeTraits surfaceTraits(const GrassSettings& grass, const BezierSettings& bezier, const Surface& surface) {
  BladeTraits traits = groundTraits(grass, bezier);
  traits.height = surface.height;
  traits.width = surface.width;
  traits.stiffness = surface.stiffness;
  traits.clumpSizeM = std::max(1.4f * surface.height, 0.01f);
  traits.level = false;
  traits.seed = hashCombine(traits.seed, surface.id);
  return traits;
}

float turnTowards(glm::vec3 up, glm::vec3 front) {
  const glm::vec3 across = glm::cross(up, front);
  const float angle =
      std::atan2(glm::dot(across, shared::bezierAcross(up, 0.25f)), glm::dot(across, shared::bezierAcross(up, 0.0f)));
  return angle / kTurn - std::floor(angle / kTurn);
}

BezierBlade makeBlade(const BladeTraits& traits, const GrowthPoint& point, std::uint32_t seed, const TuftPlace* tuft) {
  RandomStream random(seed);
  const Common common(tuft != nullptr ? tuft->hash : clumpOf(traits, point.place));
  const float alike = tuft != nullptr ? kTuftAlike : 0.0f;
  const float own = std::clamp(0.5f + 1.15f * (random.next() - 0.5f), 0.0f, 1.0f);
  const float size = glm::mix(own, common.size, std::max(0.5f * traits.clumping, alike));
  float height = traits.height * (1.0f + traits.heightVariation * (2.0f * size - 1.0f)) * point.lushness;
  // A tuft is highest in its middle.
  if (tuft != nullptr) height *= 1.12f - 0.3f * tuft->part;
  const bool dandelion = random.next() < traits.dandelions;
  if (dandelion) height *= 1.15f + 0.2f * random.next();
  const float width = traits.width * (0.8f + 0.4f * random.next());
  const float stiffness = traits.stiffness * (1.0f + traits.stiffnessVariation * (2.0f * random.next() - 1.0f));
  float turn = random.next();
  if (tuft != nullptr) {
    turn = turnTowards(point.up, tuft->outwards) + 0.3f * (turn - 0.5f);
  } else {
    // Some of the way to where the clump leans.
    const float aside = kTurn * (turn - common.lean);
    turn = common.lean + std::atan2(std::sin(aside), std::cos(aside) + 0.8f * traits.clumping) / kTurn;
  }
  turn -= std::floor(turn);
  BezierBlade blade{};
  blade.x = point.place.x;
  blade.y = point.place.y;
  blade.z = point.place.z;
  blade.up = glm::packSnorm2x16(shared::octahedralPlace(point.up));
  blade.sizes = glm::packHalf2x16(glm::vec2(std::max(height, 1e-3f), width));
  blade.growth = glm::packHalf1x16(std::clamp(stiffness, 0.0f, 60000.0f)) |
                 static_cast<std::uint32_t>(turn * 65535.0f + 0.5f) << 16;
  blade.look = lookOf(traits, point, common, alike, random, dandelion ? BEZIER_FORM_DANDELION : traits.form);
  blade.seed = pcgHash(seed ^ 0xa511e9b3u);
  return blade;
}

glm::vec3 upOf(const BezierBlade& blade) {
  return shared::octahedralVector(glm::unpackSnorm2x16(blade.up));
}

glm::vec2 sizesOf(const BezierBlade& blade) {
  return glm::unpackHalf2x16(blade.sizes);
}

}  // namespace windloom
