#pragma once
// Edits of whatever is selected, of any kind: transform, copy, flags, values, add, delete. Pure as those of
// engine/model/edit.hpp. Ids that don't exist are ignored; an edit without steps means there was nothing to do.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/edit.hpp"

namespace windloom::editor {

/// What a move takes along: points, obstacles, colliders, surfaces, rotors and probes of the ids, and both ends of
/// arrows; nothing locked.
std::vector<Id> movableIds(const Project& project, std::span<const Id> ids);
/// Positions scaled along x and z around `pivot`, then turned by `degrees` (from +X towards +Z); boxes and polygons
/// turn, all obstacles scale along (circles by the mean of both factors, boxes along their own axes), and so do
/// colliders with the ways that they move, surfaces and rotors. Factors must be above 0.
Edit transformEdit(const Project& project, std::span<const Id> ids, glm::vec2 pivot, float degrees, glm::vec2 scale);
inline Edit transformEdit(const Project& project, std::span<const Id> ids, glm::vec2 pivot, float degrees,
                          float scale) {
  return transformEdit(project, ids, pivot, degrees, glm::vec2(scale));
}
/// Mean position of what the ids move.
std::optional<glm::vec2> pivotOf(const Project& project, std::span<const Id> ids);

struct DuplicateResult {
  Edit edit;
  std::vector<Id> ids;  ///< the copies of `ids`, in their order
};
/// Copies moved by `offset`: arrows with their ends, points with the arrows between them, signals of copied roots.
DuplicateResult duplicateEdit(const Project& project, std::span<const Id> ids, glm::vec2 offset);
/// The same with everything of another project as the originals (paste).
DuplicateResult insertProjectEdit(const Project& project, const Project& pieces, glm::vec2 offset);
/// A project that holds only the ids (and the ends of arrows), for copying.
Project extract(const Project& project, std::span<const Id> ids);

/// Selected arrows, and those with both ends selected; where there are none, those that touch a selected point.
std::vector<Id> arrowsOf(const Project& project, std::span<const Id> ids);

enum class Flag { Hidden, Muted, Locked };
/// Sets the flag of arrowsOf, obstacles, colliders, rotors, surfaces and probes (can't be muted) and species (can only
/// be hidden).
Edit flagEdit(const Project& project, std::span<const Id> ids, Flag flag, bool on);
/// Whether all that could carry the flag do.
bool allFlagged(const Project& project, std::span<const Id> ids, Flag flag);
/// Clears the flag everywhere.
Edit clearFlagEdit(const Project& project, Flag flag);
/// Hides everything but species, the ids and what they are joined to by an arrow among them.
Edit isolateEdit(const Project& project, std::span<const Id> ids);

/// Strength of arrowsOf times `factor`, kept within its range; repeated steps merge.
Edit scaleStrengthEdit(const Project& project, std::span<const Id> ids, float factor);
/// Radius of arrowsOf, circles, colliders and rotors, sides of boxes, size of surfaces times `factor`.
Edit scaleRadiusEdit(const Project& project, std::span<const Id> ids, float factor);

Edit renameEdit(const Project& project, Id id, std::string name);
struct AddResult {
  Edit edit;
  Id id = 0;
};
AddResult addObstacleEdit(const Project& project, Obstacle obstacle);
AddResult addSpeciesEdit(const Project& project, Species species);
AddResult addColliderEdit(const Project& project, Collider collider);
AddResult addSurfaceEdit(const Project& project, Surface surface);
AddResult addRotorEdit(const Project& project, Rotor rotor);
/// The ids moved in their lists to just before the record `before`, 0: to the end; see Reorder.
Edit reorderEdit(const Project& project, std::span<const Id> ids, Id before);
AddResult addProbeEdit(const Project& project, Probe probe);
/// Erases the ids, the arrows at erased points, and the points that lose their last arrow by it.
Edit deleteEdit(const Project& project, std::span<const Id> ids);

}  // namespace windloom::editor
