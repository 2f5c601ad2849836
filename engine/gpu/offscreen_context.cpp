#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "engine/core/text.hpp"
#include "engine/gpu/bindings.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/context_info.hpp"

namespace windloom::gpu {
namespace {

/// A way to a display that might give a context.
struct Candidate {
  std::string platform;  // as ContextInfo::platform
  EGLenum kind = 0;
  void* native = nullptr;
  bool software = false;
};

class OffscreenContext final : public Context {
 public:
  OffscreenContext(EGLDisplay display, EGLContext context, std::string platform)
      : m_display(display), m_context(context) {
    attach(std::move(platform));
  }
  ~OffscreenContext() override {
    if (eglGetCurrentContext() == m_context) eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
  }
  void makeCurrent() override {
    if (eglGetCurrentContext() == m_context) return;
    forgetBindings();
    WL_REQUIRE(eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context),
               "an offscreen context can be current");
  }

 private:
  EGLDisplay m_display;
  EGLContext m_context;
};

bool hasExtension(const char* list, const char* name) {
  return list != nullptr && std::strstr(list, name) != nullptr;
}

std::vector<Candidate> deviceCandidates(const char* clientExtensions) {
  std::vector<Candidate> found;
  if (!hasExtension(clientExtensions, "EGL_EXT_platform_device")) return found;
  EGLDeviceEXT devices[32];
  EGLint count = 0;
  if (!eglQueryDevicesEXT(32, devices, &count)) return found;
  for (EGLint i = 0; i < count; ++i) {
    const char* extensions = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
    found.push_back({"EGL device " + std::to_string(i), EGL_PLATFORM_DEVICE_EXT, devices[i],
                     hasExtension(extensions, "EGL_MESA_device_software")});
  }
  return found;
}

std::vector<Candidate> candidates() {
  const char* clientExtensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Candidate> all = deviceCandidates(clientExtensions);
  if (const char* chosen = std::getenv("WINDLOOM_EGL_DEVICE")) {
    const std::string wanted = std::string("EGL device ") + chosen;
    std::erase_if(all, [&](const Candidate& c) { return c.platform != wanted; });
    return all;
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Candidate& a, const Candidate& b) { return !a.software && b.software; });
  if (hasExtension(clientExtensions, "EGL_MESA_platform_surfaceless")) {
    // Where a hardware device is broken this one may still give software rendering.
    all.push_back({"EGL surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, false});
  }
  return all;
}

Error refused(const Candidate& candidate, const std::string& why) {
  return makeError(ErrorKind::Machine, candidate.platform + ": " + why);
}

std::string eglErrorText() {
  return "EGL error " + std::to_string(eglGetError());
}

EGLContext createContext(EGLDisplay display, DebugMode mode) {
  const EGLint configWanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!eglChooseConfig(display, configWanted, &config, 1, &configs) || configs == 0) config = EGL_NO_CONFIG_KHR;
  std::vector<EGLint> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                4,
                                EGL_CONTEXT_MINOR_VERSION,
                                5,
                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                EGL_CONTEXT_OPENGL_DEBUG,
                                mode == DebugMode::Strict ? EGL_TRUE : EGL_FALSE,
                                EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                EGL_LOSE_CONTEXT_ON_RESET,
                                EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
  if (context != EGL_NO_CONTEXT) return context;
  // A driver that can't tell of resets.
  wanted.resize(8);
  wanted.push_back(EGL_NONE);
  return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
}

Result<std::unique_ptr<Context>> tryCandidate(const Candidate& candidate, DebugMode mode) {
  // The EXT name: libepoxy's plain one aborts before a display exists.
  const EGLDisplay display = eglGetPlatformDisplayEXT(candidate.kind, candidate.native, nullptr);
  if (display == EGL_NO_DISPLAY) return refused(candidate, "gives no display (" + eglErrorText() + ")");
  EGLint major = 0, minor = 0;
  if (!eglInitialize(display, &major, &minor))
    return refused(candidate, "can't be initialised (" + eglErrorText() + ")");
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  const char* version = eglQueryString(display, EGL_VERSION);
  const std::string found = std::string("EGL ") + (version == nullptr ? "?" : version);
  if (!hasExtension(extensions, "EGL_KHR_surfaceless_context")) {
    return refused(candidate, found + " without EGL_KHR_surfaceless_context");
  }
  if (!eglBindAPI(EGL_OPENGL_API)) return refused(candidate, found + " has no desktop OpenGL");
  const EGLContext context = createContext(display, mode);
  if (context == EGL_NO_CONTEXT)
    return refused(candidate, found + " gives no OpenGL 4.5 core context (" + eglErrorText() + ")");
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    eglDestroyContext(display, context);
    return refused(candidate, found + ", its context can't be made current (" + eglErrorText() + ")");
  }
  if (epoxy_gl_version() < 45) {
    const std::string got = describeVersion();
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    return refused(candidate, "found " + got);
  }
  if (mode == DebugMode::Strict) glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  return std::unique_ptr<Context>(std::make_unique<OffscreenContext>(display, context, candidate.platform));
}

}  // namespace

Result<std::unique_ptr<Context>> createOffscreenContext(DebugMode mode) {
  if (strictAsked()) mode = DebugMode::Strict;
  Error failure{ErrorKind::Machine, {}};
  for (const Candidate& candidate : candidates()) {
    Result<std::unique_ptr<Context>> made = tryCandidate(candidate, mode);
    if (made) return made;
    for (const Problem& problem : made.error().problems) failure.problems.push_back(problem);
  }
  std::string list;
  for (const Problem& problem : failure.problems) list += (list.empty() ? "" : "; ") + problem.message;
  const char* chosen = std::getenv("WINDLOOM_EGL_DEVICE");
  const std::string choice = chosen == nullptr ? "" : " (WINDLOOM_EGL_DEVICE=" + std::string(chosen) + ")";
  return makeError(ErrorKind::Machine, "no OpenGL 4.5 without a window here" + choice +
                                           "; tried: " + (list.empty() ? "no EGL device was found" : list));
}

}  // namespace windloom::gpu
