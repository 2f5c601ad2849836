#pragma once
// A current OpenGL 4.5 core context: one made here without a window (command line, tests), or one that a
// window toolkit made (editor). All other objects of this room need one to be current in the calling
// thread, when they are made, used and destroyed.

#include <memory>
#include <string>

#include "engine/core/result.hpp"

namespace windloom::gpu {

struct ContextInfo {
  std::string vendor, renderer, version;  ///< as OpenGL reports them
  std::string platform;                   ///< "EGL device 0", "EGL surfaceless", "window"
  bool software = false;                  ///< llvmpipe, softpipe or SwiftShader: no GPU behind it
};

class Context {
 public:
  virtual ~Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

  /// Makes it current in the calling thread; nothing where the toolkit that owns it does that itself.
  virtual void makeCurrent() = 0;

  /// Whether the driver or the GPU was reset under it (told in the log, once). It stays lost: nothing that is drawn or
  /// computed with it has a meaning any more, and what was kept in it is gone. Cheap: once a frame is fine. Drivers
  /// that don't tell of resets always answer false.
  [[nodiscard]] bool lost();

  [[nodiscard]] const ContextInfo& info() const { return m_info; }

  /// How many errors and high-severity messages OpenGL reported since the start; each is in the log. In
  /// tests any is a failure.
  [[nodiscard]] long debugErrorCount() const { return m_debug->errors; }
  /// The last of them; empty: none.
  [[nodiscard]] const std::string& lastDebugError() const { return m_debug->last; }

 protected:
  Context() = default;
  /// Fills info() and installs the debug callback; the context must be current.
  void attach(std::string platform);

  /// What the debug callback writes to; it outlives moves of the context object.
  struct DebugLog {
    long errors = 0;
    std::string last;
  };

 private:
  ContextInfo m_info;
  std::unique_ptr<DebugLog> m_debug = std::make_unique<DebugLog>();
  bool m_lost = false;
};

enum class DebugMode {
  Normal,  ///< errors are reported where the driver does so at no cost
  Strict,  ///< a debug context: every error, at the call that made it (tests). $WINDLOOM_GL_DEBUG=1 asks for it too
};

/// Context::lost() of the context that this thread made current last, for who has no Context at hand.
bool gpuWasReset();

/// What to say then.
inline constexpr const char* kGpuLost = "the graphics driver or the GPU was reset: the OpenGL context is lost";

/// $WINDLOOM_GL_DEBUG is 1: whoever makes a context asks for a debug context.
bool strictAsked();

/// A context without a window, through EGL, made current. Tries every device of the device platform,
/// hardware first, then the surfaceless platform; $WINDLOOM_EGL_DEVICE=N takes device N of the driver's list
/// and no other. Fails with Machine, listing what was tried, what was found and what is needed.
Result<std::unique_ptr<Context>> createOffscreenContext(DebugMode mode = DebugMode::Normal);

/// Takes over the context that is current in this thread and stays owned by its toolkit. Fails with Machine
/// where it is older than OpenGL 4.5.
Result<std::unique_ptr<Context>> adoptCurrentContext();

}  // namespace windloom::gpu
