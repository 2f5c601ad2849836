// Hashes shared by C++ and GLSL (see engine/core/hash.hpp).
#ifndef WINDLOOM_SHARED_HASH_H
#define WINDLOOM_SHARED_HASH_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

WL_FUNCTION uint pcgHash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

WL_FUNCTION uint hashCombine(uint a, uint b) { return pcgHash(a ^ (b + 0x9e3779b9u + (a << 6u) + (a >> 2u))); }

/// In [0, 1), 24 bits.
WL_FUNCTION float hashToUnit(uint hash) { return float(hash >> 8u) * (1.0f / 16777216.0f); }

WL_SHARED_END
#endif
