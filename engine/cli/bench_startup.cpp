#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <epoxy/gl.h>

#include "engine/cli/bench.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/core/file.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/io/project_json.hpp"
#include "engine/session/session.hpp"

extern char** environ;

namespace windloom::cli {
namespace {

/// Starts this program with one argument and waits for it.
bool runSelf(const char* argument) {
  char name[] = "windloom", word[64] = "";
  std::snprintf(word, sizeof word, "%s", argument);
  char* arguments[] = {name, word, nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawn(&child, "/proc/self/exe", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  return failed == 0 && ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

BenchRow row(const char* what, const Measured& m) {
  return {{"what", what}, {"ms", m.median}, {"runs", m.runs}};
}

/// Session and first picture of the meadow, OpenGL being there already.
Status firstPicture(const BenchSetup& setup, const Project& project, glm::ivec2 size, double& sessionMs,
                    double& frameMs) {
  Result<std::unique_ptr<Session>> session = makeError(ErrorKind::Machine, "not begun");
  gpu::ShaderLibrary shaders(setup.shaders->folder());  // an empty one: every program is compiled again
  sessionMs = wallMs([&] {
    SessionOptions options;
    options.context = setup.context;
    options.shaders = &shaders;
    session = Session::create(project, options);
  });
  if (!session) return session.error();
  gpu::FramebufferOptions options;
  options.colour = GL_RGBA8;
  const Result<gpu::Framebuffer> target = gpu::Framebuffer::create("bench picture", size, options);
  if (!target) return target.error();
  frameMs = wallMs([&] {
    Session::View view;
    view.size = size;
    view.framebuffer = target->name();
    (*session)->draw(view);
    glFinish();
  });
  return Done{};
}

}  // namespace

Result<std::vector<BenchRow>> benchStartup(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  std::vector<BenchRow> rows;
  bool ran = true;
  rows.push_back(row("start the program and end it", measure({1, 3, 10, setup.capSeconds}, [&] {
                       return wallMs([&] { ran = ran && runSelf("--version"); });
                     })));
  if (!ran) return makeError(ErrorKind::Machine, "the program can't start itself again");
  const Result<std::filesystem::path> projects = findDataFolder("projects");
  if (!projects) return projects.error();
  Result<LoadedProject> meadow = loadProject(*projects / "meadow" / "meadow.wind.json");
  if (!meadow) return meadow.error();
  rows.push_back(row("read the meadow", measure({1, 3, 10, setup.capSeconds}, [&] {
                       return wallMs([&] { meadow = loadProject(*projects / "meadow" / "meadow.wind.json"); });
                     })));
  if (setup.context == nullptr) return rows;
  const glm::ivec2 size = quick ? glm::ivec2(64, 36) : glm::ivec2(1280, 720);
  double sessionMs = 0, frameMs = 0;
  if (Status drawn = firstPicture(setup, meadow->project, size, sessionMs, frameMs); !drawn) return drawn.error();
  rows.push_back(row("compile shaders, make the session", {sessionMs, sessionMs, 1}));
  rows.push_back(row("first picture", {frameMs, frameMs, 1}));
  setup.context->makeCurrent();
  return rows;
}

}  // namespace windloom::cli
