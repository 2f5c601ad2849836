// Choi & Sung, "Real-Time Wind Simulation and Grass Rendering" 2024 (CWD-Sim), arrow-guided wind flow
// control: forces are applied in sequence along the tree, root first. Deviation: where the paper
// steps through the arrows one by one, the root's signal here travels along them at a speed, so that
// merging flows and rings have a meaning too.
#include "engine/model/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "engine/core/contract.hpp"
#include "engine/core/hash.hpp"
#include "engine/model/graph_links.hpp"
#include "engine/model/signal_curve.hpp"

namespace windloom {
namespace {

double smooth(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

struct PulseTimes {
  double period, on, attack, release;
};

/// One pulse `t` seconds after its onset, before smoothing: up in `attack`, down in `release` from
/// wherever the rise had come to.
double pulseLevel(const PulseTimes& pulse, double t) {
  if (t <= 0) return 0;
  const double rise = std::min(1.0, std::min(t, pulse.on) / pulse.attack);
  return t <= pulse.on ? rise : std::max(0.0, rise - (t - pulse.on) / pulse.release);
}

/// Pulses may overlap; the strongest counts. While one is on, the oldest such has risen furthest; of
/// those that fade, the youngest is left with most.
double pulseTrain(const PulseTimes& pulse, double t) {
  const double youngest = std::floor(t / pulse.period);
  const double fading = std::floor((t - pulse.on) / pulse.period);  // the youngest that fades
  const double oldestOn = std::clamp(fading + 1, 0.0, youngest);
  double level = pulseLevel(pulse, t - oldestOn * pulse.period);
  if (fading >= 0) level = std::max(level, pulseLevel(pulse, t - fading * pulse.period));
  return smooth(level);
}

double latticeValue(std::uint32_t seed, double cell) {
  const auto index = static_cast<std::uint32_t>(static_cast<std::int64_t>(cell));
  return static_cast<double>(hashToUnit(hashCombine(seed, index)));
}

/// Value noise in [0, 1] with one full swing about every 1/rate seconds; the second octave keeps two
/// gusts from looking alike.
double gustNoise(const Signal& signal, double t) {
  double sum = 0;
  double weight = 0.7;
  double frequency = 2.0 * static_cast<double>(signal.rate);
  for (std::uint32_t octave = 0; octave < 2; ++octave) {
    const std::uint32_t seed = hashCombine(static_cast<std::uint32_t>(signal.seed), octave);
    const double place = t * frequency;
    const double cell = std::floor(place);
    sum += weight * std::lerp(latticeValue(seed, cell), latticeValue(seed, cell + 1), smooth(place - cell));
    weight = 0.3;
    frequency *= 2.17;
  }
  return sum;
}

/// Dijkstra over travel times. Candidates are settled in the order of (time, arrow id), so equal times
/// go to the lowest arrow id, and a ring ends by itself: its start is settled already.
std::vector<Arrival> findArrivals(const WindGraph& graph, const GraphLinks& links) {
  std::vector<Arrival> arrivals(graph.points.size());
  using Candidate = std::tuple<double, Id, std::uint32_t, Id>;  // time, arrow id, point index, root
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open;
  for (const std::uint32_t i : rootIndices(graph, links)) open.emplace(0.0, 0u, i, graph.points[i].id);
  while (!open.empty()) {
    const auto [time, arrowId, point, root] = open.top();
    open.pop();
    if (arrivals[point].root != 0) continue;
    arrivals[point] = {time, root};
    for (const std::uint32_t a : links.outgoing(point)) {
      if (arrivals[links.to[a]].root != 0) continue;
      const Arrow& arrow = graph.arrows[a];
      const glm::dvec2 way = glm::dvec2(graph.points[links.to[a]].position) - glm::dvec2(graph.points[point].position);
      open.emplace(time + glm::length(way) / static_cast<double>(arrow.travelSpeed), arrow.id, links.to[a], root);
    }
  }
  return arrivals;
}

ArrowForce forceAtFullSignal(const Arrow& arrow, glm::vec2 from, glm::vec2 to) {
  ArrowForce force{};
  const float length = glm::length(to - from);
  force.from = arrow.where == Where::End ? to : from;
  force.to = to;
  force.direction = length > 0 ? (to - from) / length : glm::vec2(0);
  force.radius = arrow.radius;
  force.strength = arrow.strength;
  force.response = arrow.response;
  force.swirl = arrow.swirl;
  force.drive = arrow.drive == Drive::Force ? ARROW_DRIVE_FORCE : ARROW_DRIVE_SPEED;
  force.factor = 1;
  return force;
}

}  // namespace

float signalAt(const Signal& signal, double t) {
  t -= static_cast<double>(signal.delay);
  if (t <= 0) return 0;
  const double onset = smooth(t / static_cast<double>(signal.attack));
  switch (signal.kind) {
    case SignalKind::Constant:
      return static_cast<float>(onset);
    case SignalKind::Pulse:
      return static_cast<float>(pulseTrain({signal.period, signal.on, signal.attack, signal.release}, t));
    case SignalKind::Gusts:
      return static_cast<float>(onset * (1.0 - static_cast<double>(signal.depth) * gustNoise(signal, t)));
    case SignalKind::Curve:
      return static_cast<float>(onset * curveAt(signal, t));
  }
  return 0;
}

GraphEvaluator::GraphEvaluator(const WindGraph& graph) {
  const GraphLinks links(graph);
  m_arrivals = findArrivals(graph, links);
  m_signals.reserve(graph.signals.size() + 1);
  m_signals.emplace_back();
  std::unordered_map<Id, std::size_t> signalOf;
  for (const Signal& signal : graph.signals) {
    signalOf.emplace(signal.root, m_signals.size());
    m_signals.push_back(signal);
  }
  m_arrows.resize(graph.arrows.size());
  for (std::size_t a = 0; a < graph.arrows.size(); ++a) {
    if (links.from[a] == GraphLinks::kNone) continue;
    const Arrival& arrival = m_arrivals[links.from[a]];
    const auto signal = signalOf.find(arrival.root);
    Driven& driven = m_arrows[a];
    driven.full =
        forceAtFullSignal(graph.arrows[a], graph.points[links.from[a]].position, graph.points[links.to[a]].position);
    if (signal != signalOf.end()) driven.signal = signal->second;
    driven.reached = arrival.time;
    driven.blows = !graph.arrows[a].muted && arrival.root != 0 && driven.full.direction != glm::vec2(0);
  }
}

std::vector<ArrowForce> GraphEvaluator::forcesAt(double t) const {
  std::vector<ArrowForce> forces;
  forces.reserve(m_arrows.size());
  for (std::size_t a = 0; a < m_arrows.size(); ++a) {
    const float factor = m_arrows[a].blows ? factorAt(a, t) : 0.0f;
    if (factor <= 0) continue;
    ArrowForce force = m_arrows[a].full;
    force.strength *= factor;
    force.swirl *= factor;
    force.factor = factor;
    forces.push_back(force);
  }
  return forces;
}

float GraphEvaluator::factorAt(std::size_t arrowIndex, double t) const {
  WL_REQUIRE(arrowIndex < m_arrows.size(), "an arrow of the evaluated graph");
  const Driven& arrow = m_arrows[arrowIndex];
  return std::isfinite(arrow.reached) ? signalAt(m_signals[arrow.signal], t - arrow.reached) : 0.0f;
}

glm::vec2 ambientVelocity(const AmbientWind& ambient) {
  const double angle = static_cast<double>(ambient.direction) * std::numbers::pi / 180.0;
  return {static_cast<float>(std::cos(angle)) * ambient.speed, static_cast<float>(std::sin(angle)) * ambient.speed};
}

}  // namespace windloom
