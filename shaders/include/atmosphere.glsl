// Light from the sky and through the air. Needs frame.glsl.

const vec3 kZenith = vec3(0.13, 0.27, 0.56);
const vec3 kHorizon = vec3(0.60, 0.66, 0.70);
const vec3 kSunward = vec3(1.30, 0.86, 0.46);

// The sky's radiance without clouds; below the horizon that of the horizon.
vec3 clearSky(vec3 direction) {
  float up = max(direction.y, 0.0);
  float sunward = dot(direction, frame.sunDirection.xyz);
  vec3 colour = mix(kHorizon, kZenith, pow(up, 0.42));
  float low = exp(-up * 5.0);
  colour = mix(colour, kSunward, low * 0.75 * exp2((sunward - 1.0) * 3.2));
  return colour + kSunward * (0.22 * exp2((sunward - 1.0) * 9.0) + 0.9 * exp2((sunward - 1.0) * 160.0));
}

// What the air puts before distant things: the horizon in the direction of a unit vector. It is not made unit again:
// looking straight down it has no direction, and the glow around the sun must fade out there.
// clearSky at 0.02 above the horizon, whose powers are known.
vec3 hazeColour(vec3 fromCamera) {
  vec3 direction = vec3(fromCamera.x, 0.02, fromCamera.z);
  float sunward = dot(direction, frame.sunDirection.xyz) - 1.0;
  vec3 colour = mix(mix(kHorizon, kZenith, 0.19341), kSunward, 0.67863 * exp2(sunward * 3.2));
  return (colour + kSunward * (0.22 * exp2(sunward * 9.0) + 0.9 * exp2(sunward * 160.0))) * 0.92;
}

float hazeAmount(float distanceM) { return isOrthographic() ? 0.0 : 1.0 - exp(-frame.pixelScale.y * distanceM); }

vec3 throughAir(vec3 colour, vec3 world) {
  vec3 ray = world - frame.cameraPosition.xyz;
  float amount = hazeAmount(length(ray));
  if (amount < 0.004) return colour;
  return mix(colour, hazeColour(normalize(ray)), amount);
}
