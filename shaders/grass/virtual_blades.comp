#version 450 core
// The virtually-inertial model of Belyaev, Laevsky & Chukanov 2011: one upright blade of no picture per texel of a grid over
// the field swings in the wind there. What goes on to the drawn blades are the moments that would hold it in its shape.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/shared/segment_chain.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std140, binding = RENDER_UBO_CHAIN) uniform ChainUniforms { ChainBlock chain; };
layout(rgba16f, binding = RENDER_IMAGE_VIRTUAL_WIND) writeonly uniform image2DArray virtualWindImage;
// Number by number, all blades of each, so that neighbours read side by side: psi and omega of the segments.
layout(std430, binding = RENDER_SSBO_VIRTUAL_BLADES) buffer VirtualBlades { float numbers[]; };

uniform float dtSeconds;  // 0: begin at rest in the present wind

vec3 load(uint vector, uint blade, uint blades) {
  uint at = 3u * vector * blades + blade;
  return vec3(numbers[at], numbers[at + blades], numbers[at + 2u * blades]);
}

void store(uint vector, uint blade, uint blades, vec3 value) {
  uint at = 3u * vector * blades + blade;
  numbers[at] = value.x;
  numbers[at + blades] = value.y;
  numbers[at + 2u * blades] = value.z;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  ivec2 size = ivec2(chain.grid.xy);
  if (any(greaterThanEqual(at, size))) return;
  vec2 world = cellCentreToWorld(vec2(at), frame.field.xy, frame.field.zw / chain.grid.xy);
  vec2 wind = rippledWind(world, smoothWind(world), chain.wind.z);
  uint blade = uint(at.y * size.x + at.x);
  uint blades = uint(size.x * size.y);
  ChainState state;
  if (dtSeconds > 0.0) {
    for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
      state.psi[i] = load(2u * uint(i), blade, blades);
      state.omega[i] = load(2u * uint(i) + 1u, blade, blades);
    }
    state = chainStep(chain, state, wind, dtSeconds);
  } else {
    state = chainSteadyState(chain, wind);
  }
  for (int i = 0; i < CHAIN_SEGMENTS; ++i) {
    store(2u * uint(i), blade, blades, state.psi[i]);
    store(2u * uint(i) + 1u, blade, blades, state.omega[i]);
  }
  ChainLeans moments = chainMoments(chain, chainLeans(state));
  imageStore(virtualWindImage, ivec3(at, 0), vec4(moments.e[0], moments.e[1]));
  imageStore(virtualWindImage, ivec3(at, 1), vec4(moments.e[2], moments.e[3]));
}
