#pragma once
// One row of an inspector: label, value widget for the parameter's type, help on hovering.

#include <optional>
#include <string>
#include <string_view>

#include "editor/core/inspector.hpp"

namespace windloom::editor {

/// What the user did to a row.
struct RowChange {
  enum class Kind { Value, Component, Reset, Problem };
  Kind kind = Kind::Value;
  ParameterValue value;  ///< Value
  int component = 0;     ///< Component
  double number = 0;     ///< Component
  bool finished = true;  ///< a drag was let go, or the value was entered at once
  std::string problem;   ///< Problem: what was wrong with the typed text
};

/// Draws the row into a two-column table (beginRows). `prefix` makes the names in the UI map unique:
/// "inspector/arrow" gives "inspector/arrow/strength".
std::optional<RowChange> parameterRow(const InspectorRow& row, std::string_view prefix);

/// Begins a row that is no parameter of the project: the label, help on hovering; the value widget comes next and takes
/// the whole width.
void rowLabel(const char* label, const char* help);

/// A tooltip with line breaks where it is long; while the item is hovered.
void wrappedTooltip(std::string_view text);

/// The table that rows are drawn in; endRows only where it gave true.
bool beginRows(const char* name);
void endRows();

}  // namespace windloom::editor
