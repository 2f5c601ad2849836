#version 450 core
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"

flat in float outlineState;
uniform float visible;
layout(location = 0) out vec4 colour;

void main() {
  float alpha = visible * (outlineState == MARK_NORMAL ? 0.35 : 0.95);
  colour = vec4(markColour(vec3(0.92, 0.94, 0.97), outlineState) * alpha, alpha);
}
