@CORE@
// Wind at a place and moment from a texture array (DDS, KTX2) of half floats, sampled linearly, clamped or repeated as the
// manifest says.
vec2 windAt(sampler2DArray frames, vec2 ground, float seconds) {
  vec3 f = windFrames(seconds);
  vec2 uv = windUv(ground);
  return mix(windFromHalf(texture(frames, vec3(uv, f.x))), windFromHalf(texture(frames, vec3(uv, f.y))), f.z);
}

// The same from two images of a sequence, e.g. two 8-bit flow maps: frames x and y of windFrames(seconds).
vec2 windBetween(sampler2D early, sampler2D late, vec2 ground, float seconds) {
  vec2 uv = windUv(ground);
  return mix(windFrom8(texture(early, uv)), windFrom8(texture(late, uv)), windFrames(seconds).z);
}
