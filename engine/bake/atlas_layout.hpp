#pragma once
// How the frames of a recording lie in one picture: row-major, left to right, top to bottom.

#include <glm/glm.hpp>
#include <optional>

namespace windloom {

/// Pixels: what every current GPU takes.
inline constexpr int kMaxAtlasSide = 16384;

/// Columns and rows of tiles for `frames` pictures of `tile` pixels, so that no side is over the limit; nothing where
/// there is no such grid. The picture is as near to a square as can be; a grid without empty tiles is preferred to
/// others where its longer side is at most twice the shorter one, since engines that cut an atlas into slices take
/// empty tiles for frames, too.
std::optional<glm::ivec2> atlasTiles(int frames, glm::ivec2 tile);

}  // namespace windloom
