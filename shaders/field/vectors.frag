#version 450 core
in vec3 vectorColour;
in vec2 vectorPlace;
in float vectorAlpha;
layout(location = 0) out vec4 colour;

void main() {
  // Lighter along the middle, so that vectors read on any ground.
  vec3 shown = mix(vectorColour, vec3(1.0), 0.38 * (1.0 - abs(vectorPlace.y)));
  colour = vec4(shown * vectorAlpha, vectorAlpha);
}
