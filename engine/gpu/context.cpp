#include "engine/gpu/context.hpp"

#include <epoxy/gl.h>

#include <cstdlib>
#include <string_view>

#include "engine/core/log.hpp"
#include "engine/gpu/bindings.hpp"
#include "engine/gpu/context_info.hpp"

namespace windloom::gpu {
namespace {

std::string glText(GLenum what) {
  const auto* text = reinterpret_cast<const char*>(glGetString(what));
  return text == nullptr ? "unknown" : text;
}

/// Of the context that is current in this thread.
thread_local bool resetSeen = false;

class AdoptedContext final : public Context {
 public:
  AdoptedContext() { attach("window"); }
  void makeCurrent() override {}
};

}  // namespace

bool strictAsked() {
  const char* asked = std::getenv("WINDLOOM_GL_DEBUG");
  return asked != nullptr && std::string_view(asked) == "1";
}

bool isSoftwareRenderer(std::string_view renderer) {
  for (const std::string_view name : {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer", "swrast"}) {
    if (renderer.find(name) != std::string_view::npos) return true;
  }
  return false;
}

std::string describeVersion() {
  return glText(GL_RENDERER) + ", OpenGL " + glText(GL_VERSION);
}

bool gpuWasReset() {
  // A driver may tell of it only once.
  if (!resetSeen) resetSeen = glGetGraphicsResetStatus() != GL_NO_ERROR;
  return resetSeen;
}

bool Context::lost() {
  if (m_lost || !gpuWasReset()) return m_lost;
  m_lost = true;
  logError(std::string("OpenGL: ") + kGpuLost);
  return true;
}

// The callback's last argument is the context's DebugLog: the heap object stays where it is.
void Context::attach(std::string platform) {
  forgetBindings();
  resetSeen = false;
  m_info = {glText(GL_VENDOR), glText(GL_RENDERER), glText(GL_VERSION), std::move(platform), false};
  m_info.software = isSoftwareRenderer(m_info.renderer);
  glEnable(GL_DEBUG_OUTPUT);
  // The shader compiler's messages come back as a Result from ShaderLibrary.
  const auto report = [](GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* message,
                         const void* user) {
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    auto* log = static_cast<DebugLog*>(const_cast<void*>(user));
    log->last = length >= 0 ? std::string(message, static_cast<std::size_t>(length)) : std::string(message);
    ++log->errors;
    logError("OpenGL: " + log->last);
  };
  glDebugMessageCallback(report, m_debug.get());
  glDebugMessageControl(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_PUSH_GROUP, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  glDebugMessageControl(GL_DEBUG_SOURCE_APPLICATION, GL_DEBUG_TYPE_POP_GROUP, GL_DONT_CARE, 0, nullptr, GL_FALSE);
}

Result<std::unique_ptr<Context>> adoptCurrentContext() {
  if (epoxy_gl_version() < 45 || !epoxy_is_desktop_gl()) {
    return makeError(ErrorKind::Machine, "found " + describeVersion() + "; OpenGL 4.5 is needed");
  }
  if (strictAsked()) glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  return std::unique_ptr<Context>(std::make_unique<AdoptedContext>());
}

}  // namespace windloom::gpu
