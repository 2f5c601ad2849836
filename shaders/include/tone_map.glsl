// From scene light to the picture: the one place where it becomes sRGB. Every sample of the scene is tone
// mapped before the samples are averaged, so that bright edges stay smooth. Needs frame.glsl.

// A filmic curve: the rational fit to the ACES reference by Narkowicz (2015), per channel.
vec3 filmic(vec3 light) {
  vec3 x = light * 0.8;
  return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

vec3 encodeSrgb(vec3 linear) {
  return mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, linear * 12.92, lessThan(linear, vec3(0.0031308)));
}

vec3 toPicture(vec3 light) { return encodeSrgb(filmic(light * frame.sunDirection.w)); }
