#pragma once
// The inspector without its window: rows of parameters of whatever is selected, from the one description of
// each parameter, with values that may differ between the selected things.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/value_text.hpp"
#include "engine/core/result.hpp"
#include "engine/model/edit.hpp"
#include "engine/model/parameter.hpp"

namespace windloom::editor {

enum class InspectorKind {
  Field,
  Solver,
  Ambient,
  Terrain,
  Grass,
  Bezier,
  Shell,
  Point,
  Arrow,
  Signal,
  Obstacle,
  Species,
  Collider,
  Surface,
  Rotor,
  Probe,
  Camera
};

/// Whose parameters: a settings part (no ids), or records of one kind (Signal: ids of roots).
struct InspectorTarget {
  InspectorKind kind = InspectorKind::Field;
  std::vector<Id> ids = {};
};

struct InspectorRow {
  ParameterInfo info;
  ParameterValue value;  ///< of the first; what the widget shows where not mixed
  ParameterValue defaultValue;
  bool mixed = false;           ///< the targets differ
  bool mixedComponent[3] = {};  ///< which components differ, for vectors
  bool relevant = true;         ///< false: has no effect as things are (the response of a force); show dimmed
  bool editable = true;         ///< false for identities (an arrow's ends) that only tools change
};

struct InspectorSection {
  InspectorTarget target;
  std::string title;  ///< "3 arrows", "Arrow 11", "Signal of gate", "Field"
  std::vector<InspectorRow> rows;
};

/// Sections of a selection: points, signals of the selected roots (and of the roots that reach a selected
/// arrow), arrows, obstacles, species, colliders, surfaces, rotors, probes, cameras; only those that there are.
std::vector<InspectorSection> inspectSelection(const Project& project, std::span<const Id> ids);
/// The section of a target; ids that don't exist are left out.
InspectorSection inspect(const Project& project, const InspectorTarget& target);

/// Sets a parameter on all of the target. Edits of the same parameter and target have the same merge key, so
/// a slider drag is one step (call Document::seal when it is let go). Fails with BadInput where the value is
/// not legal. `key` as in ParameterInfo.
Result<Edit> setParameter(const Project& project, const InspectorTarget& target, std::string_view key,
                          const ParameterValue& value);
/// Sets one component (0 = x) of a vector parameter on all of the target.
Result<Edit> setComponent(const Project& project, const InspectorTarget& target, std::string_view key, int component,
                          double value);
/// Typed text: arithmetic with units for numbers, names for choices, "true"/"false" for switches.
Result<Edit> setFromText(const Project& project, const InspectorTarget& target, std::string_view key,
                         std::string_view text, int component = -1);
/// Back to the default.
Result<Edit> resetParameter(const Project& project, const InspectorTarget& target, std::string_view key);

}  // namespace windloom::editor
