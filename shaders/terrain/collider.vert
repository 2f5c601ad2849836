#version 450 core
// A collider: its mesh (MESH), or a sphere or capsule of SECTORS by RINGS made here, its axis along x.
#include "shaders/include/frame.glsl"

uniform mat4 world;  // from its own metres

#ifdef MESH
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 colour;
out vec2 objectUv;
out vec4 objectColour;
#else
uniform vec2 shape;  // radius and length, m; length 0: a sphere
const int kSectors = 64;  // as in engine/render/collider_pass.cpp
const int kRings = 32;    // even; one more where the halves of a capsule are joined
const int kCorners[6] = int[6](0, 1, 2, 2, 1, 3);
#endif

out vec3 objectWorld;
out vec3 objectNormal;
out vec3 objectOwn;  // in its own metres; of a shoe: on the capsule that it lies in

#ifndef MESH
vec3 onSphere(float along, float around) { return vec3(-cos(along), sin(along) * vec2(cos(around), sin(around))); }

vec3 onCapsule(float along, float around, bool front) {
  return onSphere(along, around) * shape.x + vec3(front ? 0.5 * shape.y : -0.5 * shape.y, 0.0, 0.0);
}

// A shoe within the capsule: its sole flat, low at the toes, narrow in the middle.
vec3 shoeFrom(vec3 own) {
  float part = (own.x + 0.5 * shape.y + shape.x) / (shape.y + 2.0 * shape.x);  // 0 heel .. 1 toe
  float ring = max(length(own.yz), 1e-6);
  float up = own.y / ring;
  up = up > 0.0 ? up * mix(1.0, 0.52, smoothstep(0.30, 0.75, part)) : -0.82 * pow(-up, 0.45);
  float waist = (part - 0.42) / 0.16;
  return vec3(own.x, ring * up, own.z * 0.93 * (1.0 - 0.13 * exp(-waist * waist)));
}
#endif

void main() {
#ifdef MESH
  vec3 own = position;
  vec3 ownNormal = normal;
  objectOwn = own;
  objectUv = uv;
  objectColour = colour;
#else
  int quad = gl_VertexID / 6;
  int corner = kCorners[gl_VertexID % 6];
  int row = quad / kSectors + (corner >> 1);
  float around = 6.2831853 * float(quad % kSectors + (corner & 1)) / float(kSectors);
  bool front = row > kRings / 2;
  float along = 3.14159265 * float(front ? row - 1 : row) / float(kRings);
  objectOwn = onCapsule(along, around, front);
  vec3 own = objectOwn;
  vec3 ownNormal = onSphere(along, around);
  if (shape.y > 0.0) {
    own = shoeFrom(objectOwn);
    float safe = clamp(along, 0.02, 3.12);
    vec3 here = shoeFrom(onCapsule(safe, around, front));
    vec3 beside = shoeFrom(onCapsule(safe, around + 0.01, front)) - here;
    vec3 onwards = shoeFrom(onCapsule(safe, around, front) + vec3(0.01 * shape.x * sin(safe), 0.01 * shape.x * cos(safe) * vec2(cos(around), sin(around)))) - here;
    ownNormal = normalize(cross(onwards, beside));
    if (dot(ownNormal, onSphere(safe, around)) < 0.0) ownNormal = -ownNormal;
  }
#endif
  objectNormal = mat3(world) * ownNormal;
  objectWorld = (world * vec4(own, 1.0)).xyz;
  gl_Position = frame.viewProjection * vec4(objectWorld, 1.0);
}
