#version 450 core
// Divergence or vorticity as colour: central differences of the cell-centred wind, bilinear between cells, 1/s.
// Over less than a pixel nothing could be seen, so the differences are never taken over less.
#include "shaders/include/frame.glsl"
#include "shaders/include/noise.glsl"
#include "shaders/include/wind_field.glsl"
#include "shaders/include/solids.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/shared/diverging_colour.h"

in vec2 mapWorld;
uniform float range;  // 1/s at the ends of the colours
layout(location = 0) out vec4 colour;

// Change of the wind per metre along an axis; one-sided at the field's edge and beside a solid.
vec2 slope(vec2 axis, float reach) {
  vec2 inset = 0.5 * frame.fieldCells.zw;
  vec2 low = clamp(mapWorld - axis * reach, frame.field.xy + inset, frame.field.xy + frame.field.zw - inset);
  vec2 high = clamp(mapWorld + axis * reach, frame.field.xy + inset, frame.field.xy + frame.field.zw - inset);
  if (solidsNear(low).distanceM < 0.0) low = mapWorld;
  if (solidsNear(high).distanceM < 0.0) high = mapWorld;
  float apart = dot(high - low, axis);
  return apart > 1e-5 ? (fieldWind(high) - fieldWind(low)) / apart : vec2(0.0);
}

void main() {
  float pixel = 1.0 / max(pixelsPerMetre(overGround(mapWorld, 0.0)), 1e-3);
  vec2 reach = max(frame.fieldCells.zw, vec2(pixel));
  vec2 alongX = slope(vec2(1.0, 0.0), reach.x);
  vec2 alongZ = slope(vec2(0.0, 1.0), reach.y);
#ifdef VORTICITY
  float value = alongX.y - alongZ.x;
#else
  float value = alongX.x + alongZ.y;
#endif
  float part = value / range;
  float alpha = mix(0.34, 0.85, smoothstep(0.0, 0.6, abs(part)));
  alpha *= smoothstep(-0.05, 0.1, solidsNear(mapWorld).distanceM);
  colour = vec4(divergingColourAt(part) * alpha, alpha);
}
