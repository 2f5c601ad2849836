#version 450 core
in vec3 bladeColour;
#if SEGMENTS > 1
in vec3 bladePlace;
#endif
layout(location = 0) out vec4 sceneColour;

void main() {
  vec3 colour = bladeColour;
#if SEGMENTS > 3
  // The midrib: a fold that keeps a little darker on one side and lighter on the other.
  float fold = bladePlace.x * 3.0;
  colour *= 1.0 + bladePlace.z * (0.14 * fold * exp(-fold * fold) - 0.05 * exp(-fold * fold * 3.0));
#endif
  sceneColour = vec4(colour, 1.0);
}
