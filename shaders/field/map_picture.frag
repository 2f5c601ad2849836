#version 450 core
// A map that was drawn at a lower resolution, over the picture.
#include "shaders/include/frame.glsl"

layout(binding = RENDER_TEXTURE_MAP) uniform sampler2D mapPicture;
layout(location = 0) out vec4 colour;

void main() { colour = textureLod(mapPicture, gl_FragCoord.xy * frame.viewport.zw, 0.0); }
