#pragma once
// The fixed-function state of one pass, complete: apply() leaves nothing of the pass before. There is no
// state cache and nothing to restore.

#include <glm/glm.hpp>
#include <optional>

namespace windloom::gpu {

enum class Depth { Off, Test, TestAndWrite, Write };  ///< Write: every fragment passes
enum class DepthCompare { Less, LessEqual, Greater, GreaterEqual, Equal };
enum class Blend { Off, Alpha, Premultiplied, Additive };
enum class Cull { None, Back, Front };
enum class Colour { Write, Keep };
enum class Coverage { Off, FromAlpha };  ///< alpha to coverage, multisampled targets
enum class Srgb { Off, Encode };         ///< encode on writing to an sRGB target

struct PassState {
  unsigned framebuffer = 0;
  glm::ivec4 viewport{0, 0, 1, 1};    ///< x, y, width, height
  std::optional<glm::ivec4> scissor{};  ///< x, y, width, height
  Depth depth = Depth::Off;
  DepthCompare compare = DepthCompare::LessEqual;
  Blend blend = Blend::Off;
  Cull cull = Cull::None;             ///< front faces are counter-clockwise
  Colour colour = Colour::Write;
  Coverage coverage = Coverage::Off;
  Srgb srgb = Srgb::Off;
  glm::vec2 depthOffset{0.0f};        ///< polygon offset: factor, units
};

void apply(const PassState& state);

}  // namespace windloom::gpu
