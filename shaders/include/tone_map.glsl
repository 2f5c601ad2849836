// From scene light to the picture: the one place where it becomes sRGB. Every sample of the scene is tone
// mapped before the samples are averaged, so that bright edges stay smooth. Needs frame.glsl.

// A filmic curve: the rational fit to the ACES reference by Narkowicz (2015), per channel.
vec3 filmic(vec3 light) {
  vec3 x = light * 0.8;
  return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

// The sRGB curve from square roots, within 2.6 of 255 near black and 1 elsewhere: powers cost a software renderer three times as much.
vec3 encodeSrgb(vec3 linear) {
  vec3 root2 = sqrt(linear);
  vec3 root4 = sqrt(root2);
  vec3 root8 = sqrt(root4);
  return max(0.662002687 * root2 + 0.684122060 * root4 - 0.323583601 * root8 - 0.0225411470 * linear, vec3(0.0));
}

vec3 toPicture(vec3 light) { return encodeSrgb(filmic(light * frame.sunDirection.w)); }
