#include "editor/core/probe_traces.hpp"

#include <algorithm>
#include <cmath>

namespace windloom::editor {
namespace {

constexpr double kSameTimeS = 1e-6;
constexpr float kStillMps = 0.02f;

}  // namespace

void ProbeTraces::follow(std::span<const Probe> probes) {
  std::map<Id, Trace> kept;
  for (const Probe& probe : probes) {
    const auto old = m_traces.find(probe.id);
    Trace& trace = kept[probe.id];
    if (old != m_traces.end() && old->second.place == probe.position) trace = std::move(old->second);
    trace.place = probe.position;
  }
  m_traces = std::move(kept);
}

void ProbeTraces::add(double time, glm::vec2 place, glm::vec2 wind) {
  for (auto& [id, trace] : m_traces) {
    if (trace.place != place) continue;
    auto& samples = trace.samples;
    while (!samples.empty() && samples.back().time >= time - kSameTimeS) samples.pop_back();
    samples.push_back({time, wind});
    if (samples.size() > kMostSamples) samples.pop_front();
  }
}

void ProbeTraces::cutAfter(double now) {
  for (auto& [id, trace] : m_traces) {
    while (!trace.samples.empty() && trace.samples.back().time > now + kSameTimeS) trace.samples.pop_back();
  }
}

void ProbeTraces::clear() {
  for (auto& [id, trace] : m_traces) trace.samples.clear();
}

const std::deque<TraceSample>& ProbeTraces::samples(Id probe) const {
  static const std::deque<TraceSample> kNone;
  const auto found = m_traces.find(probe);
  return found == m_traces.end() ? kNone : found->second.samples;
}

std::optional<glm::vec2> ProbeTraces::at(Id probe, double time) const {
  const std::deque<TraceSample>& all = samples(probe);
  const auto after = std::ranges::lower_bound(all, time - kSameTimeS, {}, &TraceSample::time);
  if (after == all.end()) return std::nullopt;
  if (std::abs(after->time - time) <= kSameTimeS) return after->wind;
  if (after == all.begin()) return std::nullopt;
  const TraceSample &a = *(after - 1), &b = *after;
  if (b.time - a.time > kGapS) return std::nullopt;
  return glm::mix(a.wind, b.wind, static_cast<float>((time - a.time) / (b.time - a.time)));
}

std::optional<float> headingDeg(glm::vec2 wind) {
  if (glm::length(wind) < kStillMps) return std::nullopt;
  const float degrees = glm::degrees(std::atan2(wind.y, wind.x));
  return degrees < 0 ? degrees + 360.0f : degrees;
}

}  // namespace windloom::editor
