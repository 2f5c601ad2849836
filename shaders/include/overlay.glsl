// What the overlay passes share. They draw in picture colours (sRGB), premultiplied, over the scene's depth.
#include "shaders/shared/overlay_mark.h"
#include "shaders/shared/speed_colour.h"

// The accent colours of hovered and selected things; the same as the editor's.
const vec3 kHoverColour = vec3(1.0, 0.93, 0.74);
const vec3 kSelectColour = vec3(1.0, 0.62, 0.12);

vec3 markColour(vec3 own, float state) {
  return state == MARK_SELECTED ? mix(own, kSelectColour, 0.85) : state == MARK_HOVERED ? mix(own, kHoverColour, 0.6) : own;
}

// m that a mark must measure to cover `pixels` at a place.
float metresFor(float pixels, vec2 world) { return pixels / max(pixelsPerMetre(vec3(world.x, 0.0, world.y)), 1e-3); }
