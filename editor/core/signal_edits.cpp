#include "editor/core/signal_edits.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/text.hpp"
#include "engine/model/signal_curve.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {
namespace {

float latestKey(const Signal& signal) {
  return signal.loop ? std::min(signal.period, kMaxSignalKeyTimeS) : kMaxSignalKeyTimeS;
}

bool hasSeam(const Signal& signal) {
  return signal.loop && signal.keys.size() > 1 && signal.keys.front().time <= 0 &&
         signal.keys.back().time >= signal.period;
}

/// The keys of a seam have one value: that of the first one where it changed, else of the last one.
void tieSeam(Signal& signal, bool firstChanged) {
  if (!hasSeam(signal)) return;
  if (firstChanged) {
    signal.keys.back().value = signal.keys.front().value;
  } else {
    signal.keys.front().value = signal.keys.back().value;
  }
}

/// How far keys may move in time: not over their neighbours that stay.
std::pair<float, float> roomToMove(const Signal& signal, const std::vector<char>& moves) {
  float back = -kMaxSignalKeyTimeS, forth = kMaxSignalKeyTimeS;
  const std::size_t count = signal.keys.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!moves[i]) continue;
    const float time = signal.keys[i].time;
    if (i == 0) back = std::max(back, -time);
    if (i > 0 && !moves[i - 1]) back = std::max(back, signal.keys[i - 1].time + kLeastKeyGapS - time);
    if (i + 1 == count) forth = std::min(forth, latestKey(signal) - time);
    if (i + 1 < count && !moves[i + 1]) forth = std::min(forth, signal.keys[i + 1].time - kLeastKeyGapS - time);
  }
  return {std::min(back, 0.0f), std::max(forth, 0.0f)};
}

std::vector<char> flagsOf(const Signal& signal, std::span<const std::size_t> keys) {
  std::vector<char> flags(signal.keys.size(), 0);
  for (const std::size_t key : keys) {
    if (key < flags.size()) flags[key] = 1;
  }
  return flags;
}

std::string countedLabel(std::string label, std::size_t count) {
  if (count > 1) label.append(" ").append(std::to_string(count));
  return label.append(count > 1 ? " keys" : " key");
}

}  // namespace

Signal signalOf(const Project& project, Id root) {
  const Signal* own = findSignal(*project.graph, root);
  Signal signal = own ? *own : Signal{};
  signal.root = root;
  return signal;
}

Edit putSignalEdit(Signal signal, std::string label) {
  return {.label = std::move(label), .steps = {Put<Signal>{std::move(signal)}}, .mergeKey = {}};
}

AddKeyResult addKeyEdit(const Project& project, Id root, double time, double value) {
  Signal signal = signalOf(project, root);
  if (signal.kind != SignalKind::Curve || signal.keys.size() >= kMaxSignalKeys) return {};
  const double period = static_cast<double>(signal.period);
  if (signal.loop && time > period) time -= std::floor(time / period) * period;
  SignalKey key;
  key.time = std::clamp(static_cast<float>(time), 0.0f, latestKey(signal));
  key.value = std::clamp(static_cast<float>(value), 0.0f, kMaxSignalKeyValue);
  const auto near = std::ranges::find_if(
      signal.keys, [&](const SignalKey& other) { return std::abs(other.time - key.time) < kLeastKeyGapS; });
  const auto place =
      near != signal.keys.end() ? near : std::ranges::upper_bound(signal.keys, key.time, {}, &SignalKey::time);
  const auto index = static_cast<std::size_t>(place - signal.keys.begin());
  if (near != signal.keys.end()) {
    near->value = key.value;
  } else {
    if (!signal.keys.empty()) key.easing = signal.keys[index > 0 ? index - 1 : signal.keys.size() - 1].easing;
    signal.keys.insert(place, key);
  }
  tieSeam(signal, index == 0);
  return {putSignalEdit(std::move(signal), "Add key"), index};
}

Edit moveKeysEdit(const Project& project, Id root, std::span<const std::size_t> keys, double seconds, double value) {
  Signal signal = signalOf(project, root);
  const std::vector<char> moves = flagsOf(signal, keys);
  const auto count = static_cast<std::size_t>(std::ranges::count(moves, 1));
  if (count == 0) return {};
  const auto [back, forth] = roomToMove(signal, moves);
  float low = kMaxSignalKeyValue, high = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i]) continue;
    low = std::min(low, signal.keys[i].value);
    high = std::max(high, signal.keys[i].value);
  }
  const float dt = std::clamp(static_cast<float>(seconds), back, forth);
  const float dv = std::clamp(static_cast<float>(value), -low, kMaxSignalKeyValue - high);
  for (std::size_t i = 0; i < moves.size(); ++i) {
    if (!moves[i]) continue;
    signal.keys[i].time = std::clamp(signal.keys[i].time + dt, 0.0f, latestKey(signal));
    signal.keys[i].value = std::clamp(signal.keys[i].value + dv, 0.0f, kMaxSignalKeyValue);
  }
  tieSeam(signal, moves.front() != 0);
  return putSignalEdit(std::move(signal), countedLabel("Move", count));
}

Result<Edit> placeKeyEdit(const Project& project, Id root, std::size_t key, double time, double value) {
  Signal signal = signalOf(project, root);
  if (key >= signal.keys.size()) return makeError(ErrorKind::BadInput, "there is no such key");
  if (!std::isfinite(time) || !std::isfinite(value))
    return makeError(ErrorKind::BadInput, "expected numbers for time and value");
  const float least = key == 0 ? 0.0f : signal.keys[key - 1].time + kLeastKeyGapS;
  const float most = key + 1 == signal.keys.size() ? latestKey(signal) : signal.keys[key + 1].time - kLeastKeyGapS;
  const float tolerance = 1e-5f * (1 + most);
  if (!(time >= double(least - tolerance) && time <= double(most + tolerance)))
    return makeError(ErrorKind::BadInput, "found " + shortest(time) + " s, expected a time from " + shortest(least) +
                                              " to " + shortest(most) + " s, between the keys beside it");
  if (!(value >= 0 && value <= double(kMaxSignalKeyValue)))
    return makeError(ErrorKind::BadInput,
                     "found " + shortest(value) + ", expected a factor from 0 to " + shortest(kMaxSignalKeyValue));
  signal.keys[key].time = std::clamp(static_cast<float>(time), least, most);
  signal.keys[key].value = static_cast<float>(value);
  tieSeam(signal, key == 0);
  return putSignalEdit(std::move(signal), "Set key");
}

Edit eraseKeysEdit(const Project& project, Id root, std::span<const std::size_t> keys) {
  Signal signal = signalOf(project, root);
  const std::vector<char> goes = flagsOf(signal, keys);
  std::vector<SignalKey> kept;
  for (std::size_t i = 0; i < goes.size(); ++i) {
    if (!goes[i]) kept.push_back(signal.keys[i]);
  }
  const std::size_t count = signal.keys.size() - kept.size();
  if (count == 0) return {};
  signal.keys = std::move(kept);
  return putSignalEdit(std::move(signal), countedLabel("Delete", count));
}

Edit easeKeysEdit(const Project& project, Id root, std::span<const std::size_t> keys, Easing easing) {
  Signal signal = signalOf(project, root);
  const std::vector<char> eased = flagsOf(signal, keys);
  bool changed = false;
  for (std::size_t i = 0; i < eased.size(); ++i) {
    if (!eased[i] || signal.keys[i].easing == easing) continue;
    signal.keys[i].easing = easing;
    changed = true;
  }
  if (!changed) return {};
  return putSignalEdit(std::move(signal), "Ease " + std::string(kEasings[static_cast<std::size_t>(easing)]));
}

Edit convertToCurveEdit(const Project& project, Id root) {
  const Signal signal = signalOf(project, root);
  if (signal.kind == SignalKind::Curve && !signal.keys.empty()) return {};
  return putSignalEdit(asCurve(signal), "Convert to curve");
}

}  // namespace windloom::editor
