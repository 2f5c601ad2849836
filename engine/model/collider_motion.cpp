// Fritsch & Carlson, "Monotone piecewise cubic interpolation", 1980, for each component of the offset. Slopes are held
// in the paper's box (0..3 times both neighbouring secants), which needs the neighbours of a key only: a place is found
// without solving for the whole way. An open end has slope 0, as the collider rests before and after.
#include "engine/model/collider_motion.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>

namespace windloom {
namespace {

constexpr float kSameM = 1e-5f;        // offsets closer than this are one
constexpr float kTurnPart = 0.35f;     // of the way to the next key: what a paused thing takes to turn into its motion
constexpr int kRollSteps = 16;         // of a way between two keys; 24 keys round a circle: 0.02 mm off a metre
constexpr float kLeastUpright = 0.5f;  // of the ground's normal: steeper ground lifts a sphere no further

/// A place on the way: between key `first` and the next.
struct Moment {
  std::size_t first = 0;
  float part = 0;     // 0..1
  double rounds = 0;  // whole rounds before this one
};

float secondsAfter(const Collider& collider, std::size_t key) {
  return std::max(collider.keys[key + 1].time - collider.keys[key].time, 1e-6f);
}

bool seamless(const Collider& collider) {
  return collider.loop && collider.keys.size() > 2 &&
         glm::distance(collider.keys.front().offset, collider.keys.back().offset) < kSameM;
}

/// None where it rests before its first or after its last key.
std::optional<Moment> momentAt(const Collider& collider, double seconds) {
  const std::vector<ColliderKey>& keys = collider.keys;
  if (keys.size() < 2 || seconds <= double(keys.front().time)) return std::nullopt;
  const double round = double(keys.back().time) - double(keys.front().time);
  if (round <= 0.0 || (!collider.loop && seconds >= double(keys.back().time))) return std::nullopt;
  Moment moment;
  double since = seconds - double(keys.front().time);
  if (collider.loop) {
    moment.rounds = std::floor(since / round);
    since -= moment.rounds * round;
  }
  const double at = double(keys.front().time) + since;
  const auto next = std::upper_bound(keys.begin() + 1, keys.end() - 1, at,
                                     [](double time, const ColliderKey& key) { return time < double(key.time); });
  moment.first = static_cast<std::size_t>(next - keys.begin()) - 1;
  const double part = (at - double(keys[moment.first].time)) / double(secondsAfter(collider, moment.first));
  moment.part = static_cast<float>(std::clamp(part, 0.0, 1.0));
  return moment;
}

/// m/s on the straight line from a key to the next.
glm::vec3 secant(const Collider& collider, std::size_t key) {
  return (collider.keys[key + 1].offset - collider.keys[key].offset) / secondsAfter(collider, key);
}

glm::vec3 slopeAt(const Collider& collider, std::size_t key) {
  const std::size_t last = collider.keys.size() - 1;
  const bool end = key == 0 || key == last;
  if (end && !seamless(collider)) return glm::vec3(0.0f);
  const std::size_t before = key == 0 ? last - 1 : key - 1, after = key == last ? 0 : key;
  const glm::vec3 in = secant(collider, before), out = secant(collider, after);
  const float inSeconds = secondsAfter(collider, before), outSeconds = secondsAfter(collider, after);
  const glm::vec3 mean = (in * outSeconds + out * inSeconds) / (inSeconds + outSeconds);
  glm::vec3 slope(0.0f);
  for (int c = 0; c < 3; ++c) {
    if (in[c] * out[c] <= 0.0f) continue;  // a rest or a turning point: flat
    const float most = 3.0f * std::min(std::abs(in[c]), std::abs(out[c]));
    slope[c] = std::clamp(mean[c], -most, most);
  }
  return slope;
}

glm::vec3 offsetAt(const Collider& collider, const Moment& moment) {
  const float u = moment.part, v = 1.0f - u, h = secondsAfter(collider, moment.first);
  const glm::vec3 from = collider.keys[moment.first].offset, to = collider.keys[moment.first + 1].offset;
  return from * (v * v * (1.0f + 2.0f * u)) + to * (u * u * (3.0f - 2.0f * u)) +
         (slopeAt(collider, moment.first) * (u * v * v) - slopeAt(collider, moment.first + 1) * (u * u * v)) * h;
}

glm::vec3 velocityAt(const Collider& collider, const Moment& moment) {
  const float u = moment.part, v = 1.0f - u;
  return secant(collider, moment.first) * (6.0f * u * v) + slopeAt(collider, moment.first) * (v * (1.0f - 3.0f * u)) +
         slopeAt(collider, moment.first + 1) * (u * (3.0f * u - 2.0f));
}

glm::vec2 across(const glm::vec3& v) {
  return {v.x, v.z};
}

bool pauses(const Collider& collider, std::size_t key) {
  return glm::length(across(collider.keys[key + 1].offset - collider.keys[key].offset)) < kSameM;
}

/// Direction of motion; at a key where it stands still, that just beside the key.
float courseAt(const Collider& collider, Moment moment) {
  moment.part = std::clamp(moment.part, 1e-3f, 1.0f - 1e-3f);
  glm::vec2 way = across(velocityAt(collider, moment));
  // Between two keys it may stand for an instant.
  if (glm::length(way) < 1e-6f) way = across(secant(collider, moment.first));
  return std::atan2(way.y, way.x);
}

/// What it points at where it stands still at a key: the direction that it came in.
float restHeading(const Collider& collider, std::size_t key) {
  const std::size_t ways = collider.keys.size() - 1;
  std::size_t looks = seamless(collider) ? ways : key;
  for (std::size_t way = key; looks > 0; --looks) {
    way = way == 0 ? ways - 1 : way - 1;
    if (!pauses(collider, way)) return courseAt(collider, {.first = way, .part = 1.0f});
  }
  return glm::radians(collider.rotation);
}

float groundUnder(const HeightField* ground, glm::vec2 place) {
  return ground != nullptr ? heightAt(*ground, place) : 0.0f;
}

/// From the first key to a moment of the first round.
glm::quat rolledTo(const Collider& collider, const HeightField* ground, const Moment& moment) {
  glm::quat turned(1.0f, 0.0f, 0.0f, 0.0f);
  glm::vec2 here = across(collider.keys.front().offset) + collider.position;
  float height = groundUnder(ground, here);
  const auto rollTo = [&](const Moment& to) {
    const glm::vec2 next = across(offsetAt(collider, to)) + collider.position;
    const float nextHeight = groundUnder(ground, next);
    const glm::vec2 way = next - here;
    const float level = glm::length(way);
    if (level > 1e-7f) {
      // Up x way: forwards is over the top.
      const glm::vec3 axis = glm::vec3(way.y, 0.0f, -way.x) / level;
      const float distance = std::sqrt(level * level + (nextHeight - height) * (nextHeight - height));
      turned = glm::normalize(glm::angleAxis(distance / std::max(collider.radius, 1e-3f), axis) * turned);
    }
    here = next;
    height = nextHeight;
  };
  for (std::size_t way = 0; way <= moment.first; ++way) {
    if (pauses(collider, way)) continue;
    const float whole = way < moment.first ? 1.0f : moment.part;
    const int steps = static_cast<int>(whole * kRollSteps);
    for (int i = 1; i <= steps; ++i) rollTo({.first = way, .part = float(i) / kRollSteps});
    if (float(steps) < whole * kRollSteps) rollTo({.first = way, .part = whole});
  }
  return turned;
}

glm::quat rolled(const Collider& collider, const HeightField* ground, double seconds) {
  const glm::quat none(1.0f, 0.0f, 0.0f, 0.0f);
  if (collider.keys.size() < 2) return none;
  const Moment end{.first = collider.keys.size() - 2, .part = 1.0f};
  const std::optional<Moment> moment = momentAt(collider, seconds);
  if (!moment) {
    const bool after = seconds > double(collider.keys.front().time);
    return after ? rolledTo(collider, ground, end) : none;
  }
  const glm::quat now = rolledTo(collider, ground, *moment);
  if (moment->rounds < 1.0 || !seamless(collider)) return now;
  // What a round turns it by, so many times.
  const glm::quat round = rolledTo(collider, ground, end);
  const double angle = std::fmod(double(glm::angle(round)) * moment->rounds, 2.0 * 3.14159265358979323846);
  return now * glm::angleAxis(static_cast<float>(angle), glm::axis(round));
}

/// From its own metres to the world's directions.
glm::mat4 turnedBy(float heading) {
  return glm::rotate(glm::mat4(1.0f), -heading, glm::vec3(0.0f, 1.0f, 0.0f));
}

glm::vec3 along(float heading) {
  return {std::cos(heading), 0.0f, std::sin(heading)};
}

/// How high over `place` the centre (of a mesh: its origin) stands.
float standing(const Collider& collider, const HeightField* ground, glm::vec2 place, float heading) {
  if (collider.shape == ColliderShape::Sphere) {
    // On a slope a ball touches the ground beside the place below it.
    const float upright = ground != nullptr ? std::max(normalAt(*ground, place).y, kLeastUpright) : 1.0f;
    return groundUnder(ground, place) + collider.radius / upright;
  }
  if (collider.shape == ColliderShape::Mesh) {
    return groundUnder(ground, place) - (collider.mesh ? collider.mesh->low.y * collider.scale : 0.0f);
  }
  const glm::vec2 end = across(along(heading)) * (0.5f * collider.length);
  const float ends = std::max(groundUnder(ground, place + end), groundUnder(ground, place - end));
  return std::max(groundUnder(ground, place), ends) + collider.radius;
}

void addMesh(const Collider& collider, const glm::mat4& world, std::vector<ColliderPrimitive>& list) {
  if (!collider.mesh) return;
  for (const glm::vec4& sphere : collider.mesh->spheres) {
    const glm::vec3 centre(world * glm::vec4(glm::vec3(sphere), 1.0f));
    list.push_back({glm::vec4(centre, sphere.w * collider.scale), glm::vec4(centre, 0.0f)});
  }
}

void addPrimitives(const Collider& collider, const HeightField* ground, double seconds,
                   std::vector<ColliderPrimitive>& list) {
  if (collider.muted) return;
  const ColliderPose pose = colliderPose(collider, ground, seconds);
  if (collider.shape == ColliderShape::Mesh) return addMesh(collider, pose.world, list);
  const bool capsule = collider.shape == ColliderShape::Capsule;
  const glm::vec3 end = capsule ? glm::vec3(pose.world[0]) * (0.5f * collider.length) : glm::vec3(0.0f);
  list.push_back({glm::vec4(pose.centre - end, collider.radius), glm::vec4(pose.centre + end, 0.0f)});
}

}  // namespace

glm::vec3 colliderOffset(const Collider& collider, double seconds) {
  if (collider.keys.empty()) return glm::vec3(0.0f);
  if (const std::optional<Moment> moment = momentAt(collider, seconds)) return offsetAt(collider, *moment);
  return seconds <= double(collider.keys.front().time) ? collider.keys.front().offset : collider.keys.back().offset;
}

glm::vec3 colliderVelocity(const Collider& collider, double seconds) {
  const std::optional<Moment> moment = momentAt(collider, seconds);
  return moment ? velocityAt(collider, *moment) : glm::vec3(0.0f);
}

float colliderHeading(const Collider& collider, double seconds) {
  if (collider.keys.size() < 2) return glm::radians(collider.rotation);
  const std::optional<Moment> moment = momentAt(collider, seconds);
  if (!moment)
    return restHeading(collider, seconds <= double(collider.keys.front().time) ? 0 : collider.keys.size() - 1);
  const bool pausing = pauses(collider, moment->first);
  if (pausing) return restHeading(collider, moment->first);
  const float course = courseAt(collider, *moment);
  if (glm::length(across(slopeAt(collider, moment->first))) > 1e-6f || moment->part >= kTurnPart) return course;
  const float before = restHeading(collider, moment->first);
  const float t = moment->part / kTurnPart;
  return before + std::remainder(course - before, 6.2831853f) * t * t * (3.0f - 2.0f * t);
}

ColliderPose colliderPose(const Collider& collider, const HeightField* ground, double seconds) {
  const glm::vec3 offset = colliderOffset(collider, seconds);
  const glm::vec2 place = collider.position + across(offset);
  const float heading = collider.shape == ColliderShape::Sphere && collider.roll ? glm::radians(collider.rotation)
                                                                                 : colliderHeading(collider, seconds);
  ColliderPose pose;
  pose.centre = {place.x, standing(collider, ground, place, heading) + collider.lift + offset.y, place.y};
  pose.world = glm::translate(glm::mat4(1.0f), pose.centre);
  switch (collider.shape) {
    case ColliderShape::Sphere:
      if (collider.roll) pose.world *= glm::mat4_cast(rolled(collider, ground, seconds));
      pose.world *= turnedBy(heading);
      break;
    case ColliderShape::Capsule:
      pose.world *= turnedBy(heading);
      break;
    case ColliderShape::Mesh:
      pose.world *= turnedBy(heading - glm::radians(90.0f));
      pose.world = glm::scale(pose.world, glm::vec3(collider.scale));
      break;
  }
  return pose;
}

std::vector<ColliderPrimitive> colliderPrimitives(const Collider& collider, const HeightField* ground, double seconds) {
  std::vector<ColliderPrimitive> list;
  addPrimitives(collider, ground, seconds, list);
  return list;
}

std::vector<ColliderPrimitive> colliderPrimitives(const Project& project, double seconds) {
  std::vector<ColliderPrimitive> list;
  for (const Collider& collider : *project.colliders) {
    addPrimitives(collider, project.terrain->heights.get(), seconds, list);
  }
  return list;
}

}  // namespace windloom
