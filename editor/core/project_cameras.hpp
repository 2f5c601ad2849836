#pragma once
// The project's cameras and the editor's view: looking through one, storing the view as one.

#include "editor/core/camera_control.hpp"
#include "editor/core/object_edits.hpp"

namespace windloom::editor {

/// The view of a project's camera. What it can't have (a roll, a target straight above) becomes the nearest that it
/// can.
EditorCamera lookThrough(const EditorCamera& view, const Camera& camera);
/// The camera that a project opens with: the one named "hero", else the first; null where it has none.
const Camera* openingCamera(const Project& project);
/// Adds the view as a camera with a name that no other has: "camera 1", ...
AddResult addCameraEdit(const Project& project, const EditorCamera& view);

}  // namespace windloom::editor
