#include "shaders.hpp"

namespace game {

// All light is linear until toScreen. One low autumn sun, a blue sky, and haze that takes far things to the horizon.
const char* const kSharedShader = R"(#version 330 core
uniform mat4 viewProjection;
uniform vec3 eye;
uniform vec3 toSun;
uniform vec4 field;   // low corner and size of the wind field, m
uniform vec4 mask;    // low corner and size of what the shadow mask covers, m
uniform float time;   // s
uniform float scale;  // 1 on a field of 100 m
uniform sampler2D windMap;    // wind over the field, m/s
uniform sampler2D shadowMap;  // 1 where the sun doesn't reach the ground
uniform sampler2D meadowMap;  // colour of the grass, and a smooth noise
uniform sampler2D turfMap;    // strokes of grass from above
const vec3 kSun = vec3(2.5, 2.05, 1.5);
const vec3 kSkyLight = vec3(0.34, 0.42, 0.55);
const vec3 kBounce = vec3(0.13, 0.13, 0.06);  // from the meadow, to what faces down

vec3 horizonColour(vec3 direction) {
  float near = max(dot(direction, toSun), 0.0);
  return vec3(0.60, 0.66, 0.72) + vec3(0.46, 0.26, 0.04) * near * near;
}
vec3 hazed(vec3 colour, vec3 at) {
  vec3 way = at - eye;
  float far = length(way);
  return mix(horizonColour(way / far), colour, exp(-max(far - 40.0 * scale, 0.0) / (620.0 * scale)));
}
vec3 toScreen(vec3 c) {  // a film's shoulder, then the screen's curve
  c *= 0.85;
  c = c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
  return sqrt(clamp(c, 0.0, 1.0));
}
vec2 windAt(vec2 p) { return textureLod(windMap, (p - field.xy) / field.zw, 0.0).xy; }
float shadowAt(vec2 p) {  // two looks, for a soft edge
  vec2 at = (p - mask.xy) / mask.zw;
  vec2 d = vec2(0.00045, 0.0003);
  return 0.5 * (textureLod(shadowMap, at + d, 0.0).r + textureLod(shadowMap, at - d, 0.0).r);
}
// Colour of the meadow at a place: greens, drier patches, and the pale side of grass that the wind lays down.
vec3 meadowColour(vec2 p, float speed) {
  vec4 grass = textureLod(meadowMap, p / (160.0 * scale), 0.0);
  vec3 colour = grass.rgb * grass.rgb;
  float laid = smoothstep(1.5, 9.0, speed * (0.6 + 0.8 * grass.a));
  return mix(colour, colour * 1.3 + vec3(0.06, 0.062, 0.028), laid);
}
)";

const ShaderPair kSkyShader = {R"(
uniform mat4 toWorld;  // from the screen's corners to directions
out vec3 direction;
void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  direction = (toWorld * vec4(corner, 1.0, 1.0)).xyz;
  gl_Position = vec4(corner, 1.0, 1.0);
}
)",
                               R"(
in vec3 direction;
out vec4 result;
void main() {
  vec3 d = normalize(direction);
  float up = max(d.y, 0.0);
  float near = max(dot(d, toSun), 0.0);
  vec3 colour = mix(horizonColour(d), vec3(0.13, 0.29, 0.60), 1.0 - exp(-5.0 * up));
  vec2 over = d.xz / (up + 0.1) * 0.09 + time * 0.0004;
  float cloud = textureLod(meadowMap, over, 0.0).a * 0.62 + textureLod(meadowMap, over * 3.1 + 0.3, 0.0).a * 0.38;
  cloud = smoothstep(0.48, 0.70, cloud) * smoothstep(0.03, 0.10, d.y);
  colour = mix(colour, vec3(1.05, 0.99, 0.94) + near * near * vec3(0.4, 0.28, 0.1), cloud * 0.8);
  result = vec4(toScreen(colour), 1.0);
}
)"};

// Far hills lie at no distance, only in a direction.
const ShaderPair kHillShader = {R"(
layout(location = 0) in vec3 direction;
layout(location = 1) in vec4 paintAndHaze;
out vec3 colour;
void main() {
  vec3 haze = horizonColour(normalize(vec3(direction.x, 0.0, direction.z)));
  colour = toScreen(mix(paintAndHaze.rgb, haze, paintAndHaze.a));
  gl_Position = (viewProjection * vec4(eye + direction * 1000.0 * scale, 1.0)).xyww;  // as far away as can be
}
)",
                                R"(
in vec3 colour;
out vec4 result;
void main() { result = vec4(colour, 1.0); }
)"};

// The edge of a wood round the meadow.
const ShaderPair kWoodShader = {R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 paint;
out vec3 colour;
void main() {
  colour = toScreen(hazed(paint, place));
  gl_Position = viewProjection * vec4(place, 1.0);
}
)",
                                R"(
in vec3 colour;
out vec4 result;
void main() { result = vec4(colour, 1.0); }
)"};

const ShaderPair kGroundShader = {R"(
layout(location = 0) in vec2 corner;
out vec3 at;
void main() {
  at = vec3(eye.x + corner.x * 4000.0 * scale, 0.0, eye.z + corner.y * 4000.0 * scale);
  gl_Position = viewProjection * vec4(at, 1.0);
}
)",
                                  R"(
in vec3 at;
out vec4 result;
void main() {
  float turf = texture(turfMap, at.xz / (13.0 * scale)).r;
  vec3 colour = meadowColour(at.xz, length(windAt(at.xz))) * (0.35 + 1.5 * turf);
  float lit = 1.0 - 0.8 * shadowAt(at.xz);
  colour *= kSun * toSun.y * lit + kSkyLight;
  result = vec4(toScreen(hazed(colour, at)), 1.0);
}
)"};

// A blade is a strip of five corners. It leans with the wind map where it stands: that is all a game's grass needs.
const ShaderPair kBladeShader = {R"(
layout(location = 0) in vec4 blade;  // x, z, height m, 0..1 at random
out vec3 colour;
void main() {
  float level = float(gl_VertexID / 2) * 0.5;
  vec3 root = vec3(blade.x, 0.0, blade.y);
  vec2 wind = windAt(blade.xy);
  float speed = length(wind);
  float sway = sin(time * (2.0 + 0.5 * speed) + blade.w * 40.0 + dot(blade.xy, vec2(0.7, 0.9)) / scale);
  vec2 own = vec2(cos(blade.w * 91.0), sin(blade.w * 91.0)) * 0.22;
  vec2 lean = own + wind * (0.105 + 0.02 * sway) / (1.0 + 0.055 * speed);
  float far = min(length(lean), 0.94);
  lean *= far / max(length(lean), 0.001);
  vec3 tip = vec3(lean.x, sqrt(1.0 - far * far), lean.y) * blade.z;
  vec3 at = root + mix(vec3(0.0, tip.y, 0.0) * level, tip, level) * level + vec3(0.0, tip.y * level * (1.0 - level) * 0.6, 0.0);
  float away = distance(eye, root);
  vec2 across = normalize(vec2(eye.z - root.z, root.x - eye.x));
  // Never much thinner than a pixel, else far grass glitters.
  float width = max(0.03 * scale, away * 0.0006) * (1.0 - level);
  at.xz += across * width * (gl_VertexID % 2 == 0 ? 1.0 : -1.0);
  vec3 base = meadowColour(blade.xy, speed);
  float lit = 1.0 - 0.8 * textureLod(shadowMap, (blade.xy - mask.xy) / mask.zw, 0.0).r;
  float through = pow(max(dot(normalize(at - eye), toSun), 0.0), 3.0);  // sun through the blade
  vec3 light = kSun * (0.38 + 0.35 * far + 0.8 * through) * lit + kSkyLight;
  colour = base * mix(0.6, 1.35 + 0.6 * blade.w, level) * light;
  colour = toScreen(hazed(colour, at));
  gl_Position = viewProjection * vec4(at, 1.0);
}
)",
                                 R"(
in vec3 colour;
out vec4 result;
void main() { result = vec4(colour, 1.0); }
)"};

const ShaderPair kLeafShader = {R"(
layout(location = 0) in vec3 corner;  // across, along the leaf, 1 at the rim
layout(location = 1) in vec4 placeAndSize;
layout(location = 2) in vec4 turn;
layout(location = 3) in vec4 colourAndCurl;
out vec3 at, normal, shape, paint;
vec3 turned(vec3 v) { return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v); }
void main() {
  float curl = colourAndCurl.w;
  // Folded up along the midrib, drooping at stem and tip.
  vec3 local = vec3(corner.x, curl * abs(corner.x) - 0.7 * curl * corner.y * corner.y, corner.y);
  vec3 up = vec3(-curl * sign(corner.x), 1.0, 1.4 * curl * corner.y);
  at = placeAndSize.xyz + turned(local * placeAndSize.w);
  normal = turned(normalize(up));
  shape = corner;
  paint = colourAndCurl.rgb;
  gl_Position = viewProjection * vec4(at, 1.0);
}
)",
                                R"(
in vec3 at, normal, shape, paint;
out vec4 result;
void main() {
  vec3 view = normalize(eye - at);
  vec3 n = normalize(normal);
  float facing = dot(n, view) < 0.0 ? -1.0 : 1.0;
  float sun = dot(n, toSun) * facing;
  float vein = smoothstep(0.022, 0.0, abs(shape.x));
  vein = max(vein, 0.55 * smoothstep(0.10, 0.0, abs(fract(shape.y * 7.0 - abs(shape.x) * 6.0) - 0.5)) * (1.0 - shape.z));
  vec3 colour = mix(paint, paint * vec3(0.62, 0.42, 0.45), smoothstep(0.55, 1.0, shape.z) * 0.75);
  colour = mix(colour, paint * 0.7 + vec3(0.16, 0.10, 0.03), vein * 0.6);
  vec3 light = kSun * max(sun, 0.0) * 0.85 + mix(kBounce, kSkyLight, 0.5 + 0.5 * n.y * facing);
  vec3 glow = kSun * max(-sun, 0.0) * 0.6 * (0.5 + 0.5 * colour / max(max(colour.r, colour.g), 0.05));  // through the leaf
  float shine = pow(max(dot(reflect(-toSun, n * facing), view), 0.0), 18.0) * 0.16;
  result = vec4(toScreen(hazed(colour * (light + glow) + kSun * shine, at)), 1.0);
}
)"};

const ShaderPair kClothShader = {R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normalIn;
layout(location = 2) in vec2 partIn;  // 0..1 from the pole, from the top
layout(location = 3) in vec3 colourIn;
layout(location = 4) in vec3 stripeIn;
out vec3 at, normal, colour, stripe;
out vec2 part;
void main() {
  at = place;
  normal = normalIn;
  colour = colourIn;
  stripe = stripeIn;
  part = partIn;
  gl_Position = viewProjection * vec4(at, 1.0);
}
)",
                                 R"(
in vec3 at, normal, colour, stripe;
in vec2 part;
out vec4 result;
void main() {
  vec3 view = normalize(eye - at);
  vec3 n = normalize(normal);
  n *= dot(n, view) < 0.0 ? -1.0 : 1.0;
  vec2 soft = fwidth(part) * 0.75 + 0.001;
  float band = smoothstep(0.16 + soft.y, 0.16, abs(part.y - 0.5));
  float disc = length((part - vec2(0.36, 0.5)) * vec2(1.63, 1.0));
  float round = smoothstep(0.30 + 2.0 * soft.y, 0.30, disc);
  float inner = smoothstep(0.21 + 2.0 * soft.y, 0.21, disc);
  vec3 paint = mix(mix(mix(colour, stripe, band), stripe, round), colour, inner);
  paint *= 1.0 - 0.35 * smoothstep(0.025, 0.015, part.x);  // the hem at the pole
  float sun = dot(n, toSun);
  vec3 light = kSun * (max(sun, 0.0) + 0.42 * max(-sun, 0.0)) + mix(kBounce, kSkyLight, 0.5 + 0.5 * n.y);
  result = vec4(toScreen(hazed(paint * light * 0.9, at)), 1.0);
}
)"};

const ShaderPair kPoleShader = {R"(
layout(location = 0) in vec4 corner;    // x, 0..1 of the height, z; 1 in w on the knob
layout(location = 1) in vec3 normalIn;
layout(location = 2) in vec4 pole;      // foot, height
out vec3 at, normal;
out float knob;
void main() {
  at = pole.xyz + vec3(corner.x * scale, corner.y * pole.w, corner.z * scale);
  if (corner.w > 0.5) at.y = pole.y + pole.w + (corner.y - 1.0) * scale;
  normal = normalIn;
  knob = corner.w;
  gl_Position = viewProjection * vec4(at, 1.0);
}
)",
                                R"(
in vec3 at, normal;
in float knob;
out vec4 result;
void main() {
  vec3 n = normalize(normal);
  vec3 view = normalize(eye - at);
  vec3 paint = mix(vec3(0.52, 0.48, 0.42), vec3(0.85, 0.55, 0.12), knob);
  float shine = pow(max(dot(reflect(-toSun, n), view), 0.0), 24.0) * (0.15 + 0.8 * knob);
  vec3 light = kSun * max(dot(n, toSun), 0.0) + mix(kBounce, kSkyLight, 0.5 + 0.5 * n.y);
  result = vec4(toScreen(hazed(paint * light + kSun * shine, at)), 1.0);
}
)"};

const ShaderPair kStreakShader = {R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 ahead;
layout(location = 2) in vec3 sideWidthOpacity;
out float side, opacity;
void main() {
  vec3 across = normalize(cross(ahead, eye - place));
  float away = distance(eye, place);
  float width = max(sideWidthOpacity.y, away * 0.0009);
  vec3 at = place + across * sideWidthOpacity.x * width;
  side = sideWidthOpacity.x;
  opacity = sideWidthOpacity.z * exp(-away / (400.0 * scale));
  gl_Position = viewProjection * vec4(at, 1.0);
}
)",
                                  R"(
in float side, opacity;
out vec4 result;
void main() { result = vec4(1.0, 0.99, 0.94, opacity * 0.62 * (1.0 - side * side)); }
)"};

const char* const kShadowFragment = R"(
out vec4 result;
void main() { result = vec4(1.0); }
)";

}  // namespace game
