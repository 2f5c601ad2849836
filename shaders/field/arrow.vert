#version 450 core
// An arrow as a solid ridge lying on the tips of the grass: a shaft in segments that follow the ground, and a head.
// With a seam, its shape grown by that, which is drawn under the arrow.
#include "shaders/include/frame.glsl"
#include "shaders/include/overlay.glsl"
#include "shaders/include/arrow_shape.glsl"

layout(std430, binding = RENDER_SSBO_MARKS) readonly buffer Marks { OverlayMark marks[]; };
uniform vec2 lift;     // m over the ground, m that the depth leads
uniform int segments;  // of the shaft
uniform float seam;    // pixels; 0: the arrow itself
uniform float markedSeam;  // of hovered and selected arrows

out vec3 arrowNormal;
out vec2 arrowPlace;        // m along and share across (-1..1)
out float arrowLevel;       // place in the table of signal levels
flat out vec4 arrowLook;
flat out vec4 arrowSizes;   // half width m, travel speed m/s, first and last place in the table

// Two quads a segment, left and right of the ridge, counter-clockwise from above: segment's end, share across.
const ivec2 kShaft[12] = ivec2[12](ivec2(0, -1), ivec2(0, 0), ivec2(1, 0), ivec2(0, -1), ivec2(1, 0), ivec2(1, -1),
                                   ivec2(0, 0), ivec2(0, 1), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(1, 0));
// The head: neck ridge 0, barbs 1 and 2, tip 3, shaft's corners at the neck 4 and 5.
const int kHead[12] = int[12](1, 0, 3, 0, 2, 3, 4, 1, 0, 2, 5, 0);

void main() {
  OverlayMark mark = marks[gl_InstanceID];
  ArrowLine line = arrowLine(mark);
  float seamPixels = mark.look.w == MARK_NORMAL ? seam : markedSeam;
  float grown = seam > 0.0 ? metresFor(seamPixels * pixelUnit(), line.from + line.along * 0.5 * (line.start + line.end)) : 0.0;
  float neck = line.end - line.head;
  float s, reach, ridge = 0.0, across;
  int place = gl_VertexID - 12 * segments;
  if (place < 0) {
    ivec2 corner = kShaft[gl_VertexID % 12];
    float step0 = float(gl_VertexID / 12 + corner.x) / float(segments);
    s = mix(line.start - grown, neck, step0);
    across = float(corner.y);
    reach = across * (line.halfWidth + grown);
    ridge = corner.y == 0 ? 1.0 : 0.0;
  } else {
    int corner = kHead[place];
    float barb = 2.3 * line.halfWidth + 1.6 * grown;
    across = corner == 1 ? -1.0 : corner == 2 ? 1.0 : corner == 4 ? -1.0 : corner == 5 ? 1.0 : 0.0;
    reach = across * (corner == 1 || corner == 2 ? barb : line.halfWidth + grown);
    s = corner == 3 ? line.end + 2.2 * grown : corner == 1 || corner == 2 ? neck - 0.25 * line.head - grown : neck;
    ridge = corner == 0 ? 1.0 : 0.0;
    if (corner == 1 || corner == 2) across *= 2.3;
  }
  vec2 at = line.from + line.along * s + line.aside * reach;
  float rise = ARROW_RISE * (line.halfWidth + grown) * ridge;
  float side = place < 0 ? (gl_VertexID % 12 < 6 ? -1.0 : 1.0) : (place / 3 == 0 || place / 3 == 2 ? -1.0 : 1.0);
  arrowNormal = normalize(vec3(line.aside.x * side, 1.3, line.aside.y * side));
  arrowPlace = vec2(s, across);
  float whole = max(length(mark.place.zw - mark.place.xy), 1e-4);
  arrowLevel = mark.signal.x + mark.signal.y * clamp(s / whole, 0.0, 1.0);
  arrowLook = mark.look;
  arrowSizes = vec4(line.halfWidth, mark.more.w, mark.signal.x, mark.signal.x + mark.signal.y);
  gl_Position = clipWithLead(overGround(at, lift.x + rise), lift.y);
}
