#pragma once
// A number with its unit: drag to change it, Ctrl fine, Shift coarse, click or double click to type (arithmetic
// allowed), right click to reset. Several things at once show "mixed", and an edit sets all.

#include <string>
#include <string_view>

#include "editor/widgets/look.hpp"

namespace windloom::editor {

struct NumberFormat {
  std::string_view unit;
  double min = 0, max = 0, step = 1;  ///< as in ParameterInfo
  bool whole = false;                 ///< integers only
};

struct NumberEdit {
  bool changed = false;   ///< `value` is new
  bool finished = false;  ///< a drag was let go: what comes next is another undo step
  bool reset = false;     ///< asks for the default
  double value = 0;
  std::string problem;  ///< what was wrong with the typed text
};

/// `value` is of the first thing where they are mixed. `name` goes to the UI map and must be unique on the screen.
/// Typed values may be outside the range (who owns the value says what is wrong); dragged ones never are. Takes
/// the width of the next item.
NumberEdit numberField(const char* name, double value, bool mixed, const NumberFormat& format);

/// The value as fields show it: no more digits than its step is worth, no trailing zeros.
std::string displayNumber(double value, double step, bool whole);

/// One line of text. The new text once it is entered: with Enter, Tab or a click elsewhere; Esc leaves the old.
bool textField(const char* name, std::string& value, const char* hint = "");

/// A field is waiting for its first key: keys must not go elsewhere.
bool typingPending();

}  // namespace windloom::editor
