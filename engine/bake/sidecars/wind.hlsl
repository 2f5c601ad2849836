@CORE@
// Wind at a place and moment from a texture array of half floats (assembled from the images), sampled linearly.
float2 windAt(Texture2DArray frames, SamplerState linearSampler, float2 ground, float seconds) {
  float3 f = windFrames(seconds);
  float2 uv = windUv(ground);
  return lerp(windFromHalf(frames.SampleLevel(linearSampler, float3(uv, f.x), 0)),
              windFromHalf(frames.SampleLevel(linearSampler, float3(uv, f.y), 0)), f.z);
}

// The same from an array of 8-bit codes, e.g. the flipbook atlas imported as an array.
float2 windAt8(Texture2DArray frames, SamplerState linearSampler, float2 ground, float seconds) {
  float3 f = windFrames(seconds);
  float2 uv = windUv(ground);
  return lerp(windFrom8(frames.SampleLevel(linearSampler, float3(uv, f.x), 0)),
              windFrom8(frames.SampleLevel(linearSampler, float3(uv, f.y), 0)), f.z);
}

// The same from two images of a sequence, e.g. two 8-bit flow maps: frames x and y of windFrames(seconds).
float2 windBetween(Texture2D early, Texture2D late, SamplerState linearSampler, float2 ground, float seconds) {
  float2 uv = windUv(ground);
  return lerp(windFrom8(early.SampleLevel(linearSampler, uv, 0)), windFrom8(late.SampleLevel(linearSampler, uv, 0)),
              windFrames(seconds).z);
}

// From two EXR images: as they are, no decoding.
float2 windBetweenHalf(Texture2D early, Texture2D late, SamplerState linearSampler, float2 ground, float seconds) {
  float2 uv = windUv(ground);
  return lerp(windFromHalf(early.SampleLevel(linearSampler, uv, 0)),
              windFromHalf(late.SampleLevel(linearSampler, uv, 0)), windFrames(seconds).z);
}
