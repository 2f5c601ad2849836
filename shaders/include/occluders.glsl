// Whether hills and solids hide a place: a pyramid of the farthest depths, drawn before the grass. Needs frame.glsl and the
// grass settings.
layout(binding = RENDER_TEXTURE_OCCLUDERS) uniform sampler2D occluderTexture;

bool isOccluded(vec3 centre, vec3 halfSize) {
  if (grass.limits.z < 0.5 || grass.boundsRange.w < 0.5) return false;
  float radius = length(halfSize);
  vec3 near = centre - frame.viewForward.xyz * radius;
  vec4 clip = frame.viewProjection * vec4(near, 1.0);
  if (clip.w <= radius) return false;
  vec2 uv = 0.5 + 0.5 * clip.xy / clip.w;
  vec2 reach = radius * pixelsPerMetre(near) * frame.viewport.zw;
  vec2 size = vec2(textureSize(occluderTexture, 0));
  float level = ceil(log2(max(max(2.0 * reach.x * size.x, 2.0 * reach.y * size.y), 1.0)));
  if (level > grass.limits.w - 1.0) return false;
  vec4 corners = vec4(textureLod(occluderTexture, uv - reach, level).r, textureLod(occluderTexture, uv + reach, level).r,
                      textureLod(occluderTexture, uv + vec2(reach.x, -reach.y), level).r,
                      textureLod(occluderTexture, uv + vec2(-reach.x, reach.y), level).r);
  float farthest = max(max(corners.x, corners.y), max(corners.z, corners.w));
  return 0.5 + 0.5 * clip.z / clip.w > farthest;
}
