#pragma once
// Edits of how the wind graph is joined, pure as those of engine/model/edit.hpp. Ids that don't exist are
// ignored; an edit without steps means there was nothing to do.

#include <span>
#include <vector>

#include "editor/core/object_edits.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

/// An arrow between two points that exist.
struct ConnectResult {
  Edit edit;
  Id arrow = 0;
};
ConnectResult connectEdit(const Project& project, Id from, Id to, const Arrow& model);
/// A new root at `position` with an arrow to a point that exists: a flow that merges.
struct FeedResult {
  Edit edit;
  Id root = 0, arrow = 0;
};
FeedResult feedEdit(const Project& project, glm::vec2 position, Id to, const Arrow& model);

/// A new point on an arrow at `along` (kept within 0.05..0.95): the arrow ends there, a second one with its
/// values goes on. A swirl stays with the end it was around.
struct InsertResult {
  Edit edit;
  Id point = 0, arrow = 0;  ///< the new point, the new second arrow
};
InsertResult insertPointEdit(const Project& project, Id arrow, float along);

/// Merges the points of `ids` into the last of them at their mean place; arrows follow, those that would become
/// loops or doubles go. Nothing for fewer than two points.
Edit mergePointsEdit(const Project& project, std::span<const Id> ids);
/// Merges `gone` into `kept`, which stays where it is.
Edit mergeIntoEdit(const Project& project, Id gone, Id kept);

struct SplitResult {
  Edit edit;
  std::vector<Id> points;  ///< the new ones
};
/// Cuts the graph at the selected points: of the arrows that touch one, incoming ones first, the first keeps the
/// point and each other gets a copy of it at the same place. Selected arrows are cut off at their start.
SplitResult splitEdit(const Project& project, std::span<const Id> ids);

/// Takes points out of the flow: where a point has one arrow in and one out, the first goes on to the end of the
/// second; other points are erased with their arrows.
Edit dissolveEdit(const Project& project, std::span<const Id> ids);

/// Turns the arrows of `ids` (see arrowsOf) around. The signal of a root that is none any more goes to the roots
/// that took its place.
Edit reverseEdit(const Project& project, std::span<const Id> ids);
/// The first arrow that leads to each selected point comes from the last selected point instead.
Edit reparentEdit(const Project& project, std::span<const Id> ids);

}  // namespace windloom::editor
