#version 450 core
in vec3 bladeColour;
layout(location = 0) out vec4 sceneColour;

void main() { sceneColour = vec4(bladeColour, 1.0); }
