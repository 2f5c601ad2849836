#pragma once
// What every panel is given, made afresh each frame.

#include <string>

#include "editor/core/workspace.hpp"
#include "engine/session/session.hpp"

namespace windloom::editor {

/// How the last frames went.
struct FrameFacts {
  std::string gpu;     ///< name of the renderer
  double frameMs = 0;  ///< mean of recent frames, wall time
  double framesPerSecond = 0;
  float quality = 1;         ///< of the grass, 0..1
  bool fullQuality = false;  ///< the user asked for all of it
  std::string liveLink;      ///< what the live link does; empty while it is off
  bool liveLinkFailed = false;
};

struct PanelContext {
  Workspace& workspace;
  Session* session = nullptr;  ///< null: there is no live view (a shader that doesn't compile)
  FrameFacts facts;

  [[nodiscard]] const Project& project() const { return workspace.document.project(); }
};

}  // namespace windloom::editor
