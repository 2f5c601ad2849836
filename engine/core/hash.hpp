#pragma once
// Seeded randomness without state: the same numbers on every machine, in C++ and in GLSL.
// Hash: PCG output permutation (Jarzynski & Olano, Hash Functions for GPU Rendering, JCGT 2020).

#include "shaders/shared/hash.h"

namespace windloom {
using shared::hashCombine;
using shared::hashToUnit;
using shared::pcgHash;
}  // namespace windloom
