#version 450 core
// Between the two rounds of drawing: the lists go on behind what the first has drawn.
#include "shaders/include/frame.glsl"
#include "shaders/include/bezier_work.glsl"

layout(local_size_x = 8) in;

void main() {
  uint list = gl_LocalInvocationIndex;
  if (list >= BEZIER_LISTS) return;
  commands.ends[list] = min(commands.ends[list], uint(bezier.view.y));
  commands.starts[list] = commands.ends[list];
  commands.draws[list * 5u + 1u] = 0u;
}
