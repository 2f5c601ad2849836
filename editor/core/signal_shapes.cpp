// Other kinds of signals: their course as keys, and the handles on it.
#include <algorithm>
#include <array>
#include <cmath>

#include "editor/core/signal_edits.hpp"
#include "engine/core/text.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/parameters.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {
namespace {

constexpr int kPulseSamples = 32;       // of a pulse that no four keys can tell
constexpr double kGusts = 16;           // in the loop that gusts become
constexpr double kSamplesInGust = 6;    // the faster octave of the noise has about four lattice points in a gust
constexpr double kSeamPart = 0.1;       // of the loop, in which its end becomes its beginning
constexpr float kLeastAttackS = 0.01f;  // the shortest there is: the keys say how the wind sets in

/// Four keys tell a pulse that is over before the next one: the smooth course between 0 and 1 is the pulse's own.
bool isPlainPulse(const Signal& signal) {
  return signal.on - signal.attack >= kLeastKeyGapS && signal.on + signal.release <= signal.period &&
         signal.on + signal.release <= kMaxSignalKeyTimeS;
}

void bakePulse(const Signal& signal, Signal& curve) {
  curve.attack = kLeastAttackS;
  if (isPlainPulse(signal)) {
    curve.keys = {{0, 0, Easing::Smooth}, {signal.attack, 1}, {signal.on, 1, Easing::Smooth}};
    const float end = signal.on + signal.release;
    curve.keys.push_back({end, 0});
    return;
  }
  Signal steady = signal;
  steady.delay = 0;
  const double period = static_cast<double>(signal.period);
  const double begun =
      std::ceil((static_cast<double>(signal.on) + static_cast<double>(signal.release)) / period + 1) * period;
  for (int i = 0; i <= kPulseSamples; ++i) {
    const double t = period * i / kPulseSamples;
    curve.keys.push_back({static_cast<float>(t), signalAt(steady, begun + t), Easing::Smooth});
  }
  curve.keys.back() = {signal.period, curve.keys.front().value, Easing::Smooth};
}

void bakeGusts(const Signal& signal, Signal& curve) {
  const double rate = static_cast<double>(signal.rate);
  const double length = std::min(kGusts / rate, static_cast<double>(kMaxSignalKeyTimeS));
  const int count = static_cast<int>(std::clamp(length * rate * kSamplesInGust, 8.0, 192.0));
  Signal free = signal;  // without onset: the curve has its own
  free.delay = 0;
  free.attack = kLeastAttackS;
  const double skip = 1;
  const float first = signalAt(free, skip);
  for (int i = 0; i < count; ++i) {
    const double t = length * i / count;
    const double seam = std::clamp((t / length - (1 - kSeamPart)) / kSeamPart, 0.0, 1.0);
    const float value = static_cast<float>(std::lerp(double(signalAt(free, skip + t)), double(first), seam));
    curve.keys.push_back({static_cast<float>(t), value, Easing::Smooth});
  }
  curve.period = static_cast<float>(length);
}

double roundStart(const Signal& signal, double around) {
  const double delay = static_cast<double>(signal.delay), period = static_cast<double>(signal.period);
  return delay + std::max(0.0, std::floor((around - delay) / period)) * period;
}

/// Where gusts show their depth and rate: after the onset, or around.
double gustStart(const Signal& signal, double around) {
  return std::max(static_cast<double>(signal.delay) + static_cast<double>(signal.attack), around);
}

float limited(std::string_view key, double value) {
  for (const Parameter<Signal>& parameter : parametersOf<Signal>()) {
    if (parameter.info.key == key) return static_cast<float>(std::clamp(value, parameter.info.min, parameter.info.max));
  }
  return static_cast<float>(value);
}

struct HandleName {
  std::string_view key;
  float Signal::*member;
};
constexpr std::array<HandleName, 7> kHandles{{{"delay", &Signal::delay},
                                              {"attack", &Signal::attack},
                                              {"on", &Signal::on},
                                              {"release", &Signal::release},
                                              {"period", &Signal::period},
                                              {"depth", &Signal::depth},
                                              {"rate", &Signal::rate}}};

}  // namespace

Signal asCurve(const Signal& signal) {
  Signal curve = signal;
  curve.kind = SignalKind::Curve;
  curve.loop = true;
  curve.keys.clear();
  switch (signal.kind) {
    case SignalKind::Pulse:
      bakePulse(signal, curve);
      break;
    case SignalKind::Gusts:
      bakeGusts(signal, curve);
      break;
    case SignalKind::Constant:
    case SignalKind::Curve:
      curve.keys = {{0, 1}, {signal.period, 1}};
      break;
  }
  return curve;
}

std::vector<HandlePlace> handlesOf(const Signal& signal, double around) {
  const double delay = double(signal.delay), attack = double(signal.attack);
  std::vector<HandlePlace> places{{SignalHandle::Delay, delay, 0}};
  if (signal.kind == SignalKind::Pulse) {
    const double start = roundStart(signal, around), on = double(signal.on);
    places.push_back({SignalHandle::Attack, start + std::min(attack, on), std::min(1.0, on / attack)});
    places.push_back({SignalHandle::On, start + on, std::min(1.0, on / attack)});
    places.push_back({SignalHandle::Release, start + on + double(signal.release), 0});
    places.push_back({SignalHandle::Period, start + double(signal.period), 1});
    return places;
  }
  places.push_back({SignalHandle::Attack, delay + attack, 1});
  if (signal.kind == SignalKind::Gusts) {
    const double start = gustStart(signal, around), gust = 1 / double(signal.rate);
    places.push_back({SignalHandle::Depth, start + gust / 2, 1 - double(signal.depth)});
    places.push_back({SignalHandle::Rate, start + gust, 1});
  }
  if (signal.kind == SignalKind::Curve && signal.loop)
    places.push_back({SignalHandle::Period, roundStart(signal, around) + double(signal.period), 0});
  return places;
}

Signal withHandleAt(Signal signal, SignalHandle handle, double around, double time, double factor) {
  const double delay = double(signal.delay);
  const double start = signal.kind == SignalKind::Pulse ? roundStart(signal, around) : delay;
  double value = 0;
  switch (handle) {
    case SignalHandle::Delay:
      value = time;
      break;
    case SignalHandle::Attack:
    case SignalHandle::On:
      value = time - start;
      break;
    case SignalHandle::Release:
      value = time - start - double(signal.on);
      break;
    case SignalHandle::Period:
      value = std::max(time - roundStart(signal, around),
                       signal.keys.empty() || signal.kind != SignalKind::Curve ? 0.0 : double(signal.keys.back().time));
      break;
    case SignalHandle::Depth:
      value = 1 - factor;
      break;
    case SignalHandle::Rate:
      value = 1 / std::max(1e-3, time - gustStart(signal, around));
      break;
  }
  const HandleName& name = kHandles[static_cast<std::size_t>(handle)];
  signal.*name.member = limited(name.key, value);
  if (signal.loop && signal.keys.size() > 1 && signal.keys.front().time <= 0 &&
      signal.keys.back().time >= signal.period)
    signal.keys.back().value = signal.keys.front().value;
  return signal;
}

std::string handleText(const Signal& signal, SignalHandle handle) {
  const HandleName& name = kHandles[static_cast<std::size_t>(handle)];
  for (const Parameter<Signal>& parameter : parametersOf<Signal>()) {
    if (parameter.info.key != name.key) continue;
    const std::string unit(parameter.info.unit);
    return std::string(parameter.info.label) + " " + fixed(double(signal.*name.member), 2) +
           (unit.empty() ? "" : " " + unit);
  }
  return {};
}

}  // namespace windloom::editor
