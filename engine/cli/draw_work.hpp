#pragma once
// What the GPU was asked to draw, counted by its own queries.

#include <functional>

namespace windloom::cli {

struct DrawWork {
  long long triangles = 0;  ///< or other primitives
  long long fragments = 0;  ///< invocations of fragment shaders; 0 where the driver has no count of them
};

/// Of the commands of `draw`; waits for them. An OpenGL context must be current.
DrawWork drawWork(const std::function<void()>& draw);

}  // namespace windloom::cli
