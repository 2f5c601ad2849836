#version 450 core
// A solid as a stone block or drum: side, bevel and top, 32 sectors round.
#include "shaders/include/frame.glsl"
#include "shaders/include/solid_shape.glsl"

const int kSectors = 32;
const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);

out vec3 stoneWorld;
out vec3 stoneNormal;
flat out float stoneHeight;

// The outline of the unit circle or square at a sector.
vec2 outline(float sector, float shape) {
  float turn = sector / float(kSectors);
  if (shape == SOLID_CIRCLE) return vec2(cos(6.2831853 * turn), sin(6.2831853 * turn));
  float at = fract(turn) * 4.0;
  float t = fract(at) * 2.0 - 1.0;
  return at < 1.0 ? vec2(1.0, t) : at < 2.0 ? vec2(-t, 1.0) : at < 3.0 ? vec2(-1.0, -t) : vec2(t, -1.0);
}

vec2 outwards(float sector, float shape) {
  if (shape == SOLID_CIRCLE) return outline(sector, shape);
  float at = fract(sector / float(kSectors)) * 4.0;
  return at < 1.0 ? vec2(1.0, 0.0) : at < 2.0 ? vec2(0.0, 1.0) : at < 3.0 ? vec2(-1.0, 0.0) : vec2(0.0, -1.0);
}

void main() {
  Solid solid = solids[gl_InstanceID];
  if (solid.shape.w == SOLID_POLYGON) {  // drawn by terrain/solid_polygon.vert
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  int quad = gl_VertexID / 6;
  int corner = kCorners[gl_VertexID % 6];
  int strip = quad / kSectors;
  int row = strip + (corner >> 1);
  int quadSector = quad % kSectors;
  float sector = float(quadSector + (corner & 1));
  float bevel = min(0.12, 0.2 * min(solid.shape.z, min(solid.place.z, solid.place.w)));
  float inset = row < 2 ? 0.0 : row == 2 ? bevel : min(solid.place.z, solid.place.w);
  float y = row == 0 ? solid.level.x - 0.05 : row == 1 ? solid.level.y - bevel : solid.level.y;
  vec2 halfSize = row == 3 ? vec2(0.0) : solid.place.zw - inset;
  vec2 local = outline(sector, solid.shape.w) * halfSize;
  // A face of a box has one normal, also at its corners.
  vec2 out2 = outwards(solid.shape.w == SOLID_CIRCLE ? sector : float(quadSector) + 0.5, solid.shape.w);
  vec3 side = vec3(fromSolid(solid, out2), 0.0).xzy;
  stoneNormal = strip == 0 ? side : strip == 1 ? normalize(side + vec3(0.0, 1.0, 0.0)) : vec3(0.0, 1.0, 0.0);
  vec2 at = solid.place.xy + fromSolid(solid, local);
  stoneWorld = vec3(at.x, y, at.y);
  stoneHeight = solid.shape.z;
  gl_Position = frame.viewProjection * vec4(stoneWorld, 1.0);
}
