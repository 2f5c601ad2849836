#include "engine/render/overlay_signals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/model/id_index.hpp"

namespace windloom {
namespace {

constexpr double kFinestStep = 0.04;         // s: shorter than any attack one sees
constexpr std::size_t kFewEntries = 4096;    // that every graph may have
constexpr std::size_t kEntriesPerArrow = 4;  // and beyond those
constexpr std::uint32_t kNoTrack = 0xffffffffu;
// The table begins with two entries of 0 and two of 1, for arrows that no signal reaches and for no signals at all.
constexpr float kSilent = 0.0f, kFull = 2.0f;
constexpr std::size_t kFixed = 4;

double passingTime(const WindGraph& graph, const GraphLinks& links, std::size_t arrow) {
  const glm::vec2 span = graph.points[links.to[arrow]].position - graph.points[links.from[arrow]].position;
  const float speed = std::max(graph.arrows[arrow].travelSpeed, 1e-3f);
  return static_cast<double>(glm::length(span) / speed);
}

double steadyFrom(const Signal& signal, double lastDelay) {
  if (signal.kind != SignalKind::Constant) return std::numeric_limits<double>::infinity();
  return static_cast<double>(signal.delay) + static_cast<double>(signal.attack) + lastDelay;
}

}  // namespace

std::vector<OverlaySignals::Track> OverlaySignals::makeTracks(const WindGraph& graph, const GraphLinks& links,
                                                              const GraphEvaluator& evaluator,
                                                              std::vector<std::uint32_t>& trackOfArrow) {
  std::vector<Track> tracks;
  const IdIndex points(graph.points);
  const IdIndex signals(graph.signals, [](const Signal& signal) { return signal.root; });
  std::vector<std::uint32_t> trackOfRoot(graph.points.size(), kNoTrack);
  for (std::size_t a = 0; a < graph.arrows.size(); ++a) {
    if (links.from[a] == GraphLinks::kNone) continue;
    const Arrival& arrival = evaluator.arrivals()[links.from[a]];
    const auto root = points.find(arrival.root);
    if (!root || !std::isfinite(arrival.time)) continue;
    std::uint32_t& track = trackOfRoot[*root];
    if (track == kNoTrack) {
      track = static_cast<std::uint32_t>(tracks.size());
      const auto signal = signals.find(arrival.root);
      tracks.push_back({.signal = signal ? graph.signals[*signal] : Signal{}, .firstDelay = arrival.time});
    }
    trackOfArrow[a] = track;
    tracks[track].firstDelay = std::min(tracks[track].firstDelay, arrival.time);
    tracks[track].lastDelay = std::max(tracks[track].lastDelay, arrival.time + passingTime(graph, links, a));
  }
  return tracks;
}

/// Gives each track its entries: fine ones where there is room.
void OverlaySignals::layOut(std::size_t arrows) {
  double whole = 0;
  for (const Track& track : m_tracks) whole += track.lastDelay - track.firstDelay;
  const auto room = static_cast<double>(std::max(kFewEntries, kEntriesPerArrow * arrows));
  const double step = std::max(kFinestStep, whole / room);
  std::size_t end = kFixed;
  for (Track& track : m_tracks) {
    track.step = step;
    track.begin = end;
    // One entry beyond the last stretch's end, so that reading between two never leaves the track.
    track.count = static_cast<std::size_t>(std::ceil((track.lastDelay - track.firstDelay) / step)) + 2;
    track.steadyFrom = steadyFrom(track.signal, track.lastDelay + 2 * step);
    end += track.count;
  }
  m_levels.assign(end, 0.0f);
  m_levels[2] = m_levels[3] = 1.0f;
}

void OverlaySignals::build(const WindGraph& graph, const GraphLinks& links, const GraphEvaluator* evaluator) {
  m_time = -1;
  m_tracks.clear();
  m_stretches.assign(graph.arrows.size(), {});
  const bool known = evaluator != nullptr && evaluator->arrivals().size() == graph.points.size();
  std::vector<std::uint32_t> trackOfArrow(graph.arrows.size(), kNoTrack);
  if (known) m_tracks = makeTracks(graph, links, *evaluator, trackOfArrow);
  layOut(graph.arrows.size());
  for (std::size_t a = 0; a < graph.arrows.size(); ++a) {
    if (trackOfArrow[a] == kNoTrack) {
      m_stretches[a] = {known ? kSilent : kFull, 0.0f};
      continue;
    }
    const Track& track = m_tracks[trackOfArrow[a]];
    const double delay = evaluator->arrivals()[links.from[a]].time - track.firstDelay;
    m_stretches[a] = {static_cast<float>(static_cast<double>(track.begin) + delay / track.step),
                      static_cast<float>(passingTime(graph, links, a) / track.step)};
  }
}

bool OverlaySignals::refresh(double time) {
  if (time == m_time) return false;
  bool changed = m_time < 0;
  m_time = time;
  for (Track& track : m_tracks) {
    const bool steady = time >= track.steadyFrom;
    if (steady && track.steady) continue;
    track.steady = steady;
    changed = true;
    for (std::size_t i = 0; i < track.count; ++i) {
      const double delay = track.firstDelay + static_cast<double>(i) * track.step;
      m_levels[track.begin + i] = signalAt(track.signal, time - delay);
    }
  }
  return changed;
}

}  // namespace windloom
