#pragma once
// The one way a project changes. An edit swaps whole records in and out; applyEdit is pure, checks the
// result, and is the same for editor, command line and tests.

#include <span>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// Adds the record, or replaces the one with the same id (signals: the same root).
template <class T>
struct Put {
  T record;
};
/// Removes records of any kind by id. With a point go its arrows and its signal.
struct Erase {
  std::vector<Id> ids;
};
/// Removes the signal of a root, which then plays the default.
struct EraseSignal {
  Id root = 0;
};
/// Moves records in their list, so in the file: those of `ids` keep their order and come to stand just before the
/// record `before` of the same list, or at the list's end where it is 0. Ids of other lists and ids that don't exist
/// are ignored.
struct Reorder {
  std::vector<Id> ids;
  Id before = 0;
};
struct SetName {
  std::string name;
};
/// Replaces a whole settings part.
template <class T>
struct Set {
  T part;
};

using EditStep = std::variant<Put<Point>, Put<Arrow>, Put<Signal>, Put<Obstacle>, Put<Species>, Put<Collider>,
                              Put<Surface>, Put<Rotor>, Put<Probe>, Put<Camera>, Erase, Reorder, EraseSignal, SetName,
                              Set<FieldSettings>, Set<SolverSettings>, Set<AmbientWind>, Set<TerrainSettings>,
                              Set<GrassSettings>, Set<BezierSettings>, Set<ShellSettings>>;

struct Edit {
  std::string label;            ///< for the history: "Move point"
  std::vector<EditStep> steps;  ///< applied in order
  std::string mergeKey;         ///< edits with the same non-empty key that follow each other become one undo step
};

/// The project after the edit. Parts that no step names keep their pointers. Refused (BadInput, with
/// JSON pointers of the result) where the result would not be valid. What was read from a file (heights, meshes, maps)
/// stays with the file's name: a record or part that names another file comes without it.
Result<Project> applyEdit(const Project& project, const Edit& edit);

// Pure helpers that build edits; ids that don't exist are ignored unless stated.

/// Moves points, obstacles, colliders, surfaces, rotors and probes by `delta` m.
Edit moveEdit(const Project& project, std::span<const Id> ids, glm::vec2 delta);
/// A new point at `position`, joined by a new arrow from `from` with the drive of `model` (ids of model are ignored).
struct BranchResult {
  Edit edit;
  Id point = 0, arrow = 0;
};
BranchResult branchEdit(const Project& project, Id from, glm::vec2 position, const Arrow& model);
/// A root at `start` and an end point at `end` joined by an arrow.
struct TreeResult {
  Edit edit;
  Id root = 0, end = 0, arrow = 0;
};
TreeResult treeEdit(const Project& project, glm::vec2 start, glm::vec2 end, const Arrow& model);
Edit eraseEdit(std::vector<Id> ids);

}  // namespace windloom
