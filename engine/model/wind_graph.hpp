#pragma once
// The arrow graph (AGC, Choi & Sung 2024, section on arrow-guided wind flow control): points joined
// by arrows into lines, trees, merging flows and rings. An arrow drives the air along itself with the
// signal of the root it is reached from, delayed by the time the signal takes to travel there.

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace windloom {

using Id = std::uint32_t;

struct Point {
  Id id = 0;
  std::string name;
  glm::vec2 position{0.0f, 0.0f};  ///< (x, z), m
  bool root = false;               ///< marks the root of a ring; other roots are found by having no incoming arrow
  std::string extra;

  bool operator==(const Point&) const = default;
};

enum class Drive {
  Speed,  ///< air is drawn towards `strength` m/s along the arrow with time constant `response`
  Force,  ///< air is accelerated by `strength` m/s^2 along the arrow (the paper's)
};
enum class Where {
  Along,  ///< a capsule of `radius` around the whole arrow
  End,    ///< a disc of `radius` around the end point (the paper's)
};

struct Arrow {
  Id id = 0;
  std::string name;
  Id from = 0, to = 0;
  Drive drive = Drive::Speed;
  Where where = Where::Along;
  float strength = 8.0f;      ///< m/s (Speed) or m/s^2 (Force)
  float radius = 4.0f;        ///< m; the Gaussian fall-off has sigma = radius / 2 and is cut at radius
  float response = 0.25f;     ///< s; Speed only
  float swirl = 0.0f;         ///< m/s around the end point, positive from +X towards +Z, greatest at half the radius
  float travelSpeed = 10.0f;  ///< m/s at which the signal passes along this arrow
  bool hidden = false, muted = false, locked = false;
  std::string extra;

  bool operator==(const Arrow&) const = default;
};

enum class SignalKind { Constant, Pulse, Gusts, Curve };

/// How a curve goes on from a key to the next one.
enum class Easing {
  Linear,  ///< a straight line
  Smooth,  ///< a monotone cubic: no kink, and never beyond the two keys
  Hold,    ///< the key's value, until the next key's jumps in
};

struct SignalKey {
  float time = 0.0f;   ///< s after the start, ascending
  float value = 0.0f;  ///< factor on the strength, 0..4
  Easing easing = Easing::Linear;

  bool operator==(const SignalKey&) const = default;
};

/// What a root plays: a factor on the strength of its arrows over time.
struct Signal {
  Id root = 0;
  SignalKind kind = SignalKind::Constant;
  float delay = 0.0f;           ///< s before the first onset
  float attack = 0.4f;          ///< s from 0 to full; all kinds start with it
  float release = 1.0f;         ///< s from full to 0; Pulse
  float period = 6.0f;          ///< s from onset to onset; Pulse. For Curve: repeat after so many s when `loop`
  float on = 2.5f;              ///< s from onset to the begin of the release; Pulse
  float depth = 0.6f;           ///< how far gusts drop below full, 0..1; Gusts
  float rate = 0.5f;            ///< gusts per second; Gusts
  int seed = 1;                 ///< Gusts
  bool loop = true;             ///< Curve
  std::vector<SignalKey> keys;  ///< Curve; see Easing for what lies between them
  std::string extra;

  bool operator==(const Signal&) const = default;
};

struct WindGraph {
  std::vector<Point> points;
  std::vector<Arrow> arrows;
  std::vector<Signal> signals;  ///< at most one for a root; a root without one plays Constant
  std::string extra;
};

/// The point or arrow with this id, or null.
const Point* findPoint(const WindGraph& graph, Id id);
const Arrow* findArrow(const WindGraph& graph, Id id);
/// The signal of a root, or null where it plays the default.
const Signal* findSignal(const WindGraph& graph, Id root);

/// Roots: points without incoming arrows but with an outgoing one, points marked `root`, and for each
/// ring that no root reaches its lowest point id. Ascending ids.
std::vector<Id> findRoots(const WindGraph& graph);

}  // namespace windloom
