// The gusts of the ambient wind. docs/solver.md section 3, engine/wind/gusts.hpp. Needs block.glsl.

layout(std430, binding = WIND_SSBO_GUSTS) readonly buffer Gusts { vec2 gustTable[]; };

vec2 gustTexel(ivec2 place) {
  place &= WIND_GUST_TABLE - 1;
  return gustTable[place.y * WIND_GUST_TABLE + place.x];
}

vec2 gustSample(vec2 place) {
  vec2 low = floor(place);
  vec2 t = place - low;
  ivec2 p = ivec2(low);
  vec2 near = mix(gustTexel(p), gustTexel(p + ivec2(1, 0)), t.x);
  vec2 far = mix(gustTexel(p + ivec2(0, 1)), gustTexel(p + ivec2(1, 1)), t.x);
  return mix(near, far, t.y);
}

vec2 gustIncrement(vec2 place, vec2 v) {
  vec2 sum = vec2(0.0);
  for (int n = 0; n < wind.gusts; ++n) {
    WindGustLayer layer = wind.gustLayers[n];
    vec2 across = vec2(-layer.axis.y, layer.axis.x);
    vec2 texel = gustSample(vec2(dot(place, layer.axis), dot(place, across)) * layer.texelsPerMetre + layer.offset);
    sum += layer.weight * (texel.x * layer.axis + texel.y * across);
  }
  vec2 lacking = wind.ambient + wind.gustAmplitude * sum - v;
  float wide = 2.0 * wind.gustAmplitude;
  return lacking * (wind.gustPart / (1.0 + dot(lacking, lacking) / (wide * wide)));
}
