#pragma once
// Edits of the signals that roots play, pure as those of engine/model/edit.hpp. A root without a signal plays the
// default; its first edit gives it one. Times of keys are seconds after the signal's delay.

#include <cstddef>
#include <span>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

/// Keys of a curve are at least so far apart, s.
inline constexpr float kLeastKeyGapS = 0.01f;

/// What the root plays: its signal, or the default with its id.
Signal signalOf(const Project& project, Id root);
Edit putSignalEdit(Signal signal, std::string label);

/// A key at this place, eased like the key before it; for a looped curve the time is taken into its period, for one
/// with a key there already that key is moved. Times and values out of range are brought into it. Not a curve: nothing.
struct AddKeyResult {
  Edit edit;
  std::size_t index = 0;  ///< of the key
};
AddKeyResult addKeyEdit(const Project& project, Id root, double time, double value);

/// Moves keys together as far as order, period and range of values let them. The two keys at the seam of a loop (0 s
/// and the period) keep one value.
Edit moveKeysEdit(const Project& project, Id root, std::span<const std::size_t> keys, double seconds, double value);
/// A typed place for one key. Fails with BadInput, saying what was expected, where it isn't between its neighbours.
Result<Edit> placeKeyEdit(const Project& project, Id root, std::size_t key, double time, double value);
Edit eraseKeysEdit(const Project& project, Id root, std::span<const std::size_t> keys);
Edit easeKeysEdit(const Project& project, Id root, std::span<const std::size_t> keys, Easing easing);

/// The course that a signal of any kind plays, as a curve with keys: a constant and a pulse that dies away within its
/// period exactly, gusts as a loop of about 16 of them.
Signal asCurve(const Signal& signal);
Edit convertToCurveEdit(const Project& project, Id root);

enum class SignalHandle { Delay, Attack, On, Release, Period, Depth, Rate };

/// A value of a signal that can be dragged where it shows in the course.
struct HandlePlace {
  SignalHandle handle;
  double time;    ///< s after the root began, delay included
  double factor;  ///< on the strength
};
/// The handles of a signal; those of a course that repeats lie in the round around `around` (s).
std::vector<HandlePlace> handlesOf(const Signal& signal, double around);
/// The signal with a handle at another place, within its range; `around` as when the drag began.
Signal withHandleAt(Signal signal, SignalHandle handle, double around, double time, double factor);
/// "Period 6 s", for tooltips.
std::string handleText(const Signal& signal, SignalHandle handle);

}  // namespace windloom::editor
