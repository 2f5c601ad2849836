#pragma once
// Edits of the wind graph and the things beside it, pure as those of engine/model/edit.hpp. Ids that don't
// exist are ignored; an edit without steps means there was nothing to do.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/edit.hpp"

namespace windloom::editor {

/// An arrow between two points that exist.
struct ConnectResult {
  Edit edit;
  Id arrow = 0;
};
ConnectResult connectEdit(const Project& project, Id from, Id to, const Arrow& model);

/// A new point on an arrow at `along` (0..1): the arrow ends there, a second one with its values goes on.
struct InsertResult {
  Edit edit;
  Id point = 0, arrow = 0;  ///< the new point, the new second arrow
};
InsertResult insertPointEdit(const Project& project, Id arrow, float along);

/// Moves points, obstacles and probes; for arrows both their ends.
std::vector<Id> movableIds(const Project& project, std::span<const Id> ids);
/// Positions turned by `degrees` (from +X towards +Z) and scaled around `pivot`; boxes turn, circles and boxes
/// scale along. A scale of 0 is left out by the caller.
Edit transformEdit(const Project& project, std::span<const Id> ids, glm::vec2 pivot, float degrees, float scale);
/// Mean position of what the ids move.
std::optional<glm::vec2> pivotOf(const Project& project, std::span<const Id> ids);

/// Merges the points into the last of `ids` at their mean place; arrows follow, those that would become loops
/// or doubles go.
Edit mergePointsEdit(const Project& project, std::span<const Id> ids);
/// Merges `gone` into `kept`, which stays where it is.
Edit mergeIntoEdit(const Project& project, Id gone, Id kept);

/// Cuts the tree at the points: each arrow after the first that touches a point gets its own copy of it.
/// Selected arrows are cut off at their start.
struct SplitResult {
  Edit edit;
  std::vector<Id> points;  ///< the new ones
};
SplitResult splitEdit(const Project& project, std::span<const Id> ids);

/// Turns the arrows of `ids` (see arrowsOf) around; signals go along where a root moved to the other end.
Edit reverseEdit(const Project& project, std::span<const Id> ids);
/// The arrow that leads to each selected point comes from the last selected point instead.
Edit reparentEdit(const Project& project, std::span<const Id> ids);

/// Copies moved by `offset`: arrows with their ends, points with the arrows between them, signals of copied roots.
struct DuplicateResult {
  Edit edit;
  std::vector<Id> ids;  ///< the copies of `ids`, in their order
};
DuplicateResult duplicateEdit(const Project& project, std::span<const Id> ids, glm::vec2 offset);
/// The same with the originals taken from another project (paste).
DuplicateResult insertProjectEdit(const Project& project, const Project& pieces, glm::vec2 offset);
/// A project that holds only the ids (and the ends of arrows), for copying.
Project extract(const Project& project, std::span<const Id> ids);

/// Selected arrows, and those with both ends selected; where there are none, those that touch a selected point.
std::vector<Id> arrowsOf(const Project& project, std::span<const Id> ids);

enum class Flag { Hidden, Muted, Locked };
/// Sets the flag of arrowsOf, obstacles and probes (probes can't be muted).
Edit flagEdit(const Project& project, std::span<const Id> ids, Flag flag, bool on);
/// Whether all that could carry the flag do.
bool allFlagged(const Project& project, std::span<const Id> ids, Flag flag);
/// Clears the flag everywhere.
Edit clearFlagEdit(const Project& project, Flag flag);
/// Hides everything but the ids.
Edit isolateEdit(const Project& project, std::span<const Id> ids);

/// Strength of arrowsOf times `factor`, kept within its range; repeated steps merge.
Edit scaleStrengthEdit(const Project& project, std::span<const Id> ids, float factor);
/// Radius of arrowsOf and of circles times `factor`.
Edit scaleRadiusEdit(const Project& project, std::span<const Id> ids, float factor);

Edit renameEdit(const Project& project, Id id, std::string name);
struct AddResult {
  Edit edit;
  Id id = 0;
};
AddResult addObstacleEdit(const Project& project, Obstacle obstacle);
AddResult addProbeEdit(const Project& project, Probe probe);
/// Erases the ids and points that only they touched (deleting an arrow takes its lone ends along).
Edit deleteEdit(const Project& project, std::span<const Id> ids);

}  // namespace windloom::editor
