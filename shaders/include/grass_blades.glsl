// One blade of the meadow from its tile and index: where it stands and what it is like. The same wherever the camera is.
// Needs frame.glsl, noise.glsl, meadow.glsl, grass_tiles.glsl, solids.glsl, ground.glsl.

const float kClumpM = 0.75;

float unit(inout uint state) {
  state = pcgHash(state);
  return hashToUnit(state);
}

// The clump a root belongs to: the nearest of jittered centres, as a hash.
uint clumpOf(vec2 root) {
  ivec2 cell = ivec2(floor(root / kClumpM));
  float nearest = 1e9;
  uint found = 0u;
  for (int z = -1; z <= 1; ++z) {
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = cell + ivec2(x, z);
      uint hash = hashCombine(hashCombine(uint(at.x), uint(at.y)), uint(grass.droop.w));
      vec2 away = (vec2(at) + vec2(hash & 0xffffu, hash >> 16u) / 65536.0) * kClumpM - root;
      float d = dot(away, away);
      if (d < nearest) {
        nearest = d;
        found = hash;
      }
    }
  }
  return found;
}

// Owen's scrambling of a number in [0, 1) given by its bits, after Laine & Karras 2011 with the constants of Vegdahl 2021.
uint scrambled(uint bits, uint seed) {
  bits = bitfieldReverse(bits);
  bits ^= bits * 0x3d20adeau;
  bits += seed;
  bits *= (seed >> 16u) | 1u;
  bits ^= bits * 0x05526c56u;
  bits ^= bits * 0x53a22864u;
  return bitfieldReverse(bits);
}

// Second coordinate of Sobol's sequence; the first is the reversed index.
uint sobolSecond(uint index) {
  uint bits = 0u;
  for (uint v = 0x80000000u; index != 0u; index >>= 1u, v ^= v >> 1u) {
    if ((index & 1u) != 0u) bits ^= v;
  }
  return bits;
}

// Every first part of the list covers the tile evenly, so that thinning leaves no holes, and without any lattice.
vec2 rootInTile(ivec2 tile, uint index, uint seed) {
  uvec2 place = uvec2(scrambled(bitfieldReverse(index), pcgHash(seed)), scrambled(sobolSecond(index), pcgHash(seed ^ 0x9e3779b9u)));
  return tileLow(tile) + vec2(place >> 8u) / 16777216.0 * grass.tiles.x;
}

// How far in the margin around the field, 0..1 and more; ragged.
float inMargin(vec2 root) {
  float beyond = beyondField(root);
  return beyond <= 0.0 ? 0.0 : max(beyond / grass.tileCentre.z + 0.7 * (noiseAtLevel(root, 19.0, 1.0).r - 0.5), 0.0);
}

// Blades of a species for each of the meadow's own at a place.
float speciesWeight(uint species, vec2 root) {
  vec4 form = grass.species[species].form;
  vec4 patches = grass.species[species].patches;
  // In patches as many as the patch is rare, so that the mean over the meadow stays.
  float noise = noiseAtLevel(root + patches.yz * 100.0, patches.x * 3.0, 0.0).g;
  return form.z * mix(1.0, 3.0 * smoothstep(0.5, 0.62, noise), form.w);
}

uint speciesAt(vec2 root, float pick) {
  uint count = uint(grass.tiles.w);
  if (count <= 1u) return 0u;
  float total = 1.0;
  for (uint s = 1u; s < count; ++s) total += speciesWeight(s, root);
  float left = pick * total - 1.0;
  for (uint s = 1u; s < count && left > 0.0; ++s) {
    float weight = speciesWeight(s, root);
    if (left < weight) return s;
    left -= weight;
  }
  return 0u;
}

struct BladeRoot {
  vec2 root;      // m
  uint state;     // of its random numbers, for what follows
  uint clump;     // hash that it shares with its neighbours
  uint species;
  float rank;     // 0..1: blades over the kept part are left out
  float size;     // 0..1 among its species
  float height;   // m, in the open meadow
  float factor;   // F over its stiffness, s/m
  vec2 facing;    // unit vector: its front
};

// `total`: bladesInTile.
BladeRoot bladeRoot(ivec2 tile, uint index, uint total) {
  uint seed = tileHash(tile);
  BladeRoot blade;
  blade.root = rootInTile(tile, index, seed);
  blade.state = hashCombine(seed ^ 0x2545f491u, index);
  blade.rank = (float(index) + 0.5) / float(total);
  blade.clump = clumpOf(blade.root);
  uint clumpState = pcgHash(blade.clump);
  float shareClump = grass.size.z;
  blade.species = speciesAt(blade.root, unit(blade.state));
  BladeSpecies kind = grass.species[blade.species];
  // High blades come first in a tile: they are what is seen of a thinned canopy.
  float own = clamp(0.5 + 1.15 * (mix(unit(blade.state), 1.0 - blade.rank, 0.55) - 0.5), 0.0, 1.0);
  blade.size = mix(own, unit(clumpState), shareClump * 0.5);
  blade.height = kind.base.w * (1.0 + kind.tip.w * (2.0 * blade.size - 1.0));
  float yaw = 6.2831853 * unit(blade.state);
  float lean = 6.2831853 * unit(clumpState);
  blade.facing = normalize(vec2(cos(yaw), sin(yaw)) + shareClump * 0.8 * vec2(cos(lean), sin(lean)) + vec2(1e-4));
  float softness = kind.form.y > 0.0 ? grass.species[0].form.y / kind.form.y : 1.0;
  blade.factor = grass.motion.x * softness / (1.0 + grass.motion.y * (2.0 * unit(blade.state) - 1.0));
  return blade;
}
