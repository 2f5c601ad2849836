#pragma once
// What the scenes that draw share: meadows, cameras over them, a wind that needs no solver, and a target.

#include <vector>

#include "engine/cli/bench.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/io/picture_compare.hpp"
#include "engine/render/frame_renderer.hpp"

namespace windloom::cli {

struct BenchMeadow {
  std::string name;  ///< its blades, as "7 M"
  float metres;      ///< side of its field
  float density;     ///< blades per m^2
};

/// Up to 7 million blades stand on 100 m, as in the paper, more on 1 km.
BenchMeadow benchMeadowOf(int millions);

struct BenchShot {
  const char* name;
  ViewCamera camera;
};

/// Cameras over a meadow of `metres`: standing in it ("eye"), looking over it ("over"), from above with all of it in
/// sight ("top").
std::vector<BenchShot> benchShots(float metres);

/// Whirls of 25 m with up to 8 m/s, standing in for a solved wind where only the grass matters.
Result<gpu::Texture> benchWhirls(const GridMapping& grid);

/// An 8-bit target without depth, what a window is.
Result<gpu::Framebuffer> benchTarget(glm::ivec2 size);

/// As it is seen: red, green and blue of an 8-bit picture.
Image rgbOf(const gpu::Framebuffer& target);

/// Luma of a target of even size, averaged down to half its width and height.
FloatImage halfLuma(const gpu::Framebuffer& target);

/// A frame of a shot without overlays; project and wind must outlive it.
FrameInput benchFrame(const Project& project, const WindTexture& wind, const ViewCamera& camera,
                      const gpu::Framebuffer& target);

}  // namespace windloom::cli
