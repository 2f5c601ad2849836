#pragma once
// The wind graph at a moment: which arrows blow how strongly. Source: Choi & Sung 2024 (AGC: "forces
// are applied in sequence along the flow"), with travelling signals in place of its fixed sequence.

#include <limits>
#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/arrow_force.h"

namespace windloom {

using shared::ArrowForce;

/// When and from which root the signal reaches a point.
struct Arrival {
  double time = std::numeric_limits<double>::infinity();  ///< s after the root's onset; infinite: never
  Id root = 0;                                            ///< 0: never
};

/// A graph made ready for evaluation: arrival times and signals resolved once, O(arrows log arrows).
class GraphEvaluator {
 public:
  explicit GraphEvaluator(const WindGraph& graph);

  /// The arrows that blow at time t (s, >= 0), in the order of the graph; muted ones and those whose
  /// signal is zero are left out. A muted arrow still passes the signal on. `strength` and `swirl` have
  /// the signal's factor applied.
  [[nodiscard]] std::vector<ArrowForce> forcesAt(double t) const;

  /// The signal's factor on the arrow with this index in the graph at time t.
  [[nodiscard]] float factorAt(std::size_t arrowIndex, double t) const;

  /// Arrival of each point of the graph, by index.
  [[nodiscard]] const std::vector<Arrival>& arrivals() const { return m_arrivals; }

 private:
  struct Driven {
    ArrowForce full{};       // at factor 1
    std::size_t signal = 0;  // in m_signals: of the root that reaches it first
    double reached = 0;      // s: arrival at its start point
    bool blows = false;      // not muted and reached
  };
  std::vector<Signal> m_signals;  // the first is the default
  std::vector<Arrival> m_arrivals;
  std::vector<Driven> m_arrows;
};

/// A signal's factor at `t` seconds after its root began (before `delay`: 0). Continuous in time but where
/// a key holds its value until the next one; 0..1, for a curve up to kMaxSignalKeyValue. A curve without
/// keys is 1 throughout; one that loops also joins its last key to its first.
float signalAt(const Signal& signal, double t);

/// The ambient wind without gusts, m/s.
glm::vec2 ambientVelocity(const AmbientWind& ambient);

}  // namespace windloom
