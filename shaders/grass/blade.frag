#version 450 core
#include "shaders/include/scene_output.glsl"
in vec3 bladeColour;
#if SEGMENTS > 1
in vec2 bladePlace;
#endif

void main() {
  vec3 colour = bladeColour;
#if SEGMENTS > 3
  // The midrib: a fold that keeps a little darker on one side and lighter on the other.
  float fold = bladePlace.x * 3.0;
  colour *= 1.0 + 0.22 * fold * exp(-fold * fold) - 0.08 * exp(-fold * fold * 3.0);
#endif
  writeScene(colour);
}
