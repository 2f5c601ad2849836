// How things that touch the grass bend a plant that isn't a blade: as the blades around it. Needs grass_tiles.glsl,
// grass_blades.glsl, grass_patches.glsl.

// The lean of its tip; false: blades there are hidden.
bool touchedNear(vec2 root, out vec2 lean) {
  // The first blades of a tile cover it evenly.
  const uint kLooked = 128u;
  const float kReach2 = 0.25;  // m^2
  lean = vec2(0.0);
  ivec2 tile = ivec2(floor(root / grass.tiles.x));
  int slot = patchOf(tile);
  if (slot < 0) return true;
  uint seed = tileHash(tile);
  uint count = min(min(bladesInTile(seed), patchTable.stride), kLooked);
  float shown = 1e-6;
  float hidden = 0.0;
  for (uint i = 0u; i < count; ++i) {
    vec2 away = rootInTile(tile, i, seed) - root;
    float distance2 = dot(away, away);
    if (distance2 > kReach2) continue;
    float weight = 1.0 / (distance2 * distance2 + 1e-4);
    ChainLeans leans;
    if (patchLeans(slot, i, leans)) {
      lean += weight * leans.e[CHAIN_SEGMENTS - 1];
      shown += weight;
    } else {
      hidden += weight;
    }
  }
  lean /= shown;
  return shown >= hidden;
}
