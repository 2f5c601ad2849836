#pragma once
// Names a stretch of OpenGL calls for debuggers and captures (RenderDoc, Nsight).

#include <epoxy/gl.h>

namespace windloom::gpu {

class DebugGroup {
 public:
  explicit DebugGroup(const char* name) { glPushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name); }
  ~DebugGroup() { glPopDebugGroup(); }
  DebugGroup(const DebugGroup&) = delete;
  DebugGroup& operator=(const DebugGroup&) = delete;
};

}  // namespace windloom::gpu
