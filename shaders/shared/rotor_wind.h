// Air that rotors throw down and that runs outwards over the ground, the same in C++ (tests) and GLSL. A pure function of
// place and time, so it stands beside the simulated field, which is free of divergence and can't hold a source.
//
// The flow is that of a jet that meets a plate at right angles (Glauert, "The wall jet", 1956; Poreh, Tsuei & Cermak,
// "Investigation of a turbulent radial wall jet", 1967): under the jet air turns aside, fastest near its rim; beyond, it
// runs outwards as a wall jet whose speed falls about as 1/r. Tip vortices land at the rim and are carried outwards by the
// wall jet, as rings of faster air (Lee, Leishman & Ramasamy, "Fluid dynamics of interacting blade tip vortices with a
// ground plane", 2010).
#ifndef WINDLOOM_SHARED_ROTOR_WIND_H
#define WINDLOOM_SHARED_ROTOR_WIND_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN
#ifdef __cplusplus
using glm::dot;
using glm::smoothstep;
using std::cos;
using std::max;
using std::sqrt;
#endif

#define ROTOR_MOST 16
// The jet keeps its speed for so many radii, then slows down as 1 / distance; it widens by this part of its way.
#define ROTOR_CORE_RADII 4.0f
#define ROTOR_WIDENING 0.1f
// Of the wall jet's speed: how fast rings run outwards.
#define ROTOR_RING_SPEED 0.6f
// Height of the layer that runs outwards: part of the jet's radius, and of the distance from its middle.
#define ROTOR_LAYER 0.5f
#define ROTOR_LAYER_GROWTH 0.12f

/// A rotor as the air near the ground knows it (std140, 32 bytes).
struct RotorAir {
  vec4 jet;    // x, z m of its middle; radius where it meets the ground, m; m/s that it has there
  vec4 rings;  // their strength; turns per metre outwards; turns done at the frame's time; turns per second
};

struct RotorBlock {
  vec4 count;  // x: rotors that blow
  RotorAir rotors[ROTOR_MOST];
};

/// `lift` m over the ground, `speed` m/s right under it; `turn`: rings that have left it until now, its whole part left out.
WL_FUNCTION RotorAir rotorAirOf(vec2 middle, float lift, float radius, float speed, float rings, float rate, float turn) {
  float fall = lift / (ROTOR_CORE_RADII * radius);
  float below = speed / sqrt(1.0f + fall * fall);
  bool ringed = rate > 0.0f && below > 0.0f;
  RotorAir air;
  air.jet = vec4(middle.x, middle.y, radius + ROTOR_WIDENING * lift, below);
  air.rings = ringed ? vec4(rings, rate / (ROTOR_RING_SPEED * below), turn, rate) : vec4(0.0f);
  return air;
}

/// m/s at a place `above` m (0 or more) over the ground, `later` s after the frame's time.
WL_FUNCTION vec3 rotorWind(RotorAir rotor, vec2 place, float above, float later) {
  vec2 way = place - vec2(rotor.jet.x, rotor.jet.y);
  float radius = rotor.jet.z;
  float distance2 = dot(way, way) / (radius * radius);
  float far = sqrt(distance2) * radius;
  // 1 in the mean over a ring; short bumps, long lulls.
  float turn = far * rotor.rings.y - rotor.rings.z - rotor.rings.w * later;
  float bump = 0.5f + 0.5f * cos(6.2831853f * turn);
  float ring = 1.0f + rotor.rings.x * (2.0f * bump * bump - 0.75f) * smoothstep(0.5f, 1.0f, far / radius);
  float layer = above / (ROTOR_LAYER * radius + ROTOR_LAYER_GROWTH * far);
  // 2 x / (1 + x^2) of the speed outwards: all of it at the rim, 1 / x beyond.
  vec2 outwards = way * (2.0f * rotor.jet.w * ring / (radius * (1.0f + distance2) * (1.0f + layer * layer)));
  // What runs outwards comes from above: near the ground as its divergence asks, at most the jet's speed.
  float rise = 4.0f * max(above, 0.0f) / radius;
  float under = 1.0f / (1.0f + distance2);
  float down = rotor.jet.w * under * under * rise / (1.0f + rise);
  return vec3(outwards.x, -down, outwards.y);
}

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::RotorAir) == 32, "std140 layout");
static_assert(sizeof(windloom::shared::RotorBlock) == 16 + ROTOR_MOST * 32, "std140 layout");
#endif
#endif
