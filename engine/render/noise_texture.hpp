#pragma once
// The tiling noise that grass, ground and sky share.

#include <cstdint>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/texture.hpp"

namespace windloom {

/// Texels of kNoiseSide x kNoiseSide RGBA, tiling in both directions: red coarse fractal noise, green another,
/// blue fine, alpha streaks. Each spans 0..255 with mean near 128. The same on every machine.
inline constexpr int kNoiseSide = 256;
std::vector<std::uint8_t> makeNoise();

/// The same as a texture with mipmaps. Fails with Machine.
Result<gpu::Texture> createNoiseTexture();

}  // namespace windloom
