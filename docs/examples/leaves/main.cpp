// A game in small: a meadow with leaves and flags in the wind of a .windpack or of the running editor. Nothing of
// Windloom is used but its runtime library; wind_source.cpp is the part to copy.

#include <epoxy/gl.h>
// GLFW must not bring another OpenGL header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

#include "options.hpp"
#include "scene.hpp"
#include "screenshot.hpp"
#include "wind_source.hpp"

namespace {

using namespace game;

constexpr float kStep = 1.0f / 60;     // s; leaves and flags move in steps of this, however fast frames are drawn
constexpr int kStepsUnattended = 2;    // a frame, where nobody watches and every run must be the same
constexpr double kLongestFrame = 0.1;  // s; after a longer one the world goes slower rather than ever further behind
constexpr int kLeaves = 800, kFlags = 9, kStreaks = 1800;
constexpr Quality kBest{1, 4}, kQuick{0.1f, 1};  // quick is for software renderers
constexpr float kFewestBlades = 0.03f;

class Game {
 public:
  explicit Game(const Options& options) : m_options(options) {}
  ~Game();
  Game(const Game&) = delete;
  Game& operator=(const Game&) = delete;

  /// The program's exit status.
  int run();

 private:
  bool openWindow();
  void listen();
  static Game& of(GLFWwindow* window) { return *static_cast<Game*>(glfwGetWindowUserPointer(window)); }
  void restart();
  void followWind(double now);
  void moveOn(double seconds);
  void suitQuality(double seconds);
  void updateTitle(double now);
  void say(const std::string& note);
  void onKey(int key);
  int finish();

  Options m_options;
  WindSource m_wind;
  GLFWwindow* m_window = nullptr;
  std::unique_ptr<Scene> m_scene;
  std::optional<World> m_world;
  std::optional<Camera> m_camera;
  Bounds m_ground;  // that world and scene were made for
  Quality m_quality = kQuick;
  std::string m_note;
  double m_noteUntil = 0, m_begin = 0, m_countedFrom = 0, m_fps = 0;
  double m_time = 0, m_owed = 0;  // s that the world has moved on; s that it still has to
  double m_pointerX = 0, m_pointerY = 0;
  int m_frames = 0, m_counted = 0;  // in all; since m_countedFrom
  bool m_paused = false, m_titleIsOld = true;
};

Game::~Game() {
  m_scene.reset();  // its OpenGL objects need the window's context
  if (m_window != nullptr) glfwDestroyWindow(m_window);
  glfwTerminate();
}

int Game::run() {
  if (!m_wind.open(m_options.file, m_options.liveName, m_options.live)) {
    std::fprintf(stderr, "windloom-leaves: %s\n", m_wind.problem().c_str());
    return 1;
  }
  if (!openWindow()) return 3;
  listen();
  restart();
  m_begin = glfwGetTime();
  double before = m_begin;
  while (glfwWindowShouldClose(m_window) == 0) {
    glfwPollEvents();
    const double now = glfwGetTime();
    followWind(now);
    const bool unattended = m_options.frames > 0;
    moveOn(unattended ? static_cast<double>(kStepsUnattended * kStep) : std::min(now - before, kLongestFrame));
    if (!unattended) suitQuality(now - before);
    before = now;
    int width = 0, height = 0;
    glfwGetFramebufferSize(m_window, &width, &height);
    ++m_frames;
    const bool last = unattended && m_frames >= m_options.frames;
    if (width > 0 && height > 0) {  // else the window is an icon
      m_scene->draw(m_wind, *m_world, *m_camera, m_time, last ? kBest : m_quality, width, height);
    }
    if (last) break;
    updateTitle(now);
    glfwSwapBuffers(m_window);
  }
  return finish();
}

bool Game::openWindow() {
  if (glfwInit() == 0) {
    std::fprintf(stderr, "windloom-leaves: there is no display to open a window on\n");
    return false;
  }
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  m_window = glfwCreateWindow(m_options.width, m_options.height, "Leaves", nullptr, nullptr);
  if (m_window == nullptr) {
    std::fprintf(stderr, "windloom-leaves: no window with OpenGL 3.3 could be opened\n");
    return false;
  }
  glfwMakeContextCurrent(m_window);
  glfwSwapInterval(m_options.frames > 0 ? 0 : 1);
  const std::string renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const bool software =
      renderer.find("llvmpipe") != std::string::npos || renderer.find("softpipe") != std::string::npos;
  m_quality = software ? kQuick : kBest;
  return true;
}

void Game::listen() {
  glfwSetWindowUserPointer(m_window, this);
  glfwSetKeyCallback(m_window, [](GLFWwindow* window, int key, int, int action, int) {
    if (action == GLFW_PRESS) of(window).onKey(key);
  });
  glfwSetCursorPosCallback(m_window, [](GLFWwindow* window, double x, double y) {
    Game& me = of(window);
    const auto dx = static_cast<float>(x - me.m_pointerX), dy = static_cast<float>(y - me.m_pointerY);
    if (glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT) == GLFW_PRESS) me.m_camera->orbit(-dx * 0.005f, dy * 0.005f);
    me.m_pointerX = x;
    me.m_pointerY = y;
  });
  glfwSetScrollCallback(
      m_window, [](GLFWwindow* window, double, double steps) { of(window).m_camera->zoom(static_cast<float>(steps)); });
}

void Game::onKey(int key) {
  if (key == GLFW_KEY_SPACE) m_paused = !m_paused;
  if (key == GLFW_KEY_R) restart();
  if (key == GLFW_KEY_L) m_wind.toggleLive();
  if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(m_window, GLFW_TRUE);
}

/// A new world from the seed, at the time that was asked for.
void Game::restart() {
  m_wind.restart(m_options.time);
  m_ground = m_wind.bounds();
  m_world.emplace(
      World{Leaves(kLeaves, m_options.seed, m_wind), Flags(kFlags, m_wind), Streaks(kStreaks, m_options.seed, m_wind)});
  m_scene = std::make_unique<Scene>(m_wind, *m_world, m_options.seed);
  if (!m_camera) m_camera.emplace(m_wind.bounds());
  m_time = 0;
  m_owed = 0;
}

/// New wind is taken over where leaves and flags are; only wind over other ground needs another world.
void Game::followWind(double now) {
  m_wind.update(now);
  if (!(m_wind.bounds() == m_ground)) {
    m_camera.reset();
    restart();
  }
  const std::string note = m_wind.takeNote();
  if (!note.empty()) say(note);
}

void Game::moveOn(double seconds) {
  if (m_paused) return;
  m_owed += seconds;
  // A little less than a step is a step, too: else a frame of exactly two steps would now and then make one.
  for (; m_owed >= 0.99 * static_cast<double>(kStep); m_owed -= static_cast<double>(kStep)) {
    m_wind.advance(static_cast<double>(kStep));
    m_world->step(m_wind, kStep);
    m_time += static_cast<double>(kStep);
  }
}

/// Fewer blades where frames take long, more where there is time.
void Game::suitQuality(double seconds) {
  const float change = seconds > 1.0 / 20 ? 0.96f : seconds < 1.0 / 26 ? 1.02f : 1.0f;
  m_quality.blades = std::clamp(m_quality.blades * change, kFewestBlades, 1.0f);
}

void Game::say(const std::string& note) {
  std::fprintf(stderr, "windloom-leaves: %s\n", note.c_str());
  m_note = note;
  m_noteUntil = glfwGetTime() + 4;
  m_titleIsOld = true;
}

void Game::updateTitle(double now) {
  if (now >= m_countedFrom + 0.5) {
    m_fps = m_counted / (now - m_countedFrom);
    m_countedFrom = now;
    m_counted = 0;
    m_titleIsOld = true;
  }
  ++m_counted;
  if (!m_titleIsOld) return;
  m_titleIsOld = false;
  char title[512];
  std::snprintf(title, sizeof title, "Leaves | %s | %.0f fps | %.1f s%s", m_wind.name().c_str(), m_fps, m_wind.time(),
                m_paused ? " | paused" : "");
  std::string text = title;
  if (now < m_noteUntil) text += " | " + m_note;
  glfwSetWindowTitle(m_window, text.c_str());
}

int Game::finish() {
  const double seconds = glfwGetTime() - m_begin;
  if (!m_options.screenshot.empty()) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(m_window, &width, &height);
    if (!saveScreenshot(m_options.screenshot, width, height)) {
      std::fprintf(stderr, "windloom-leaves: %s can't be written\n", m_options.screenshot.c_str());
      return 3;
    }
  }
  if (m_options.print) {
    m_world->leaves.print();
    std::cout << "seconds " << m_time << "\nsource " << (m_wind.isLive() ? "live" : "file") << "\nreloads "
              << m_wind.reloads() << "\nlive fields " << m_wind.liveFields() << std::endl;
    std::fprintf(stderr, "windloom-leaves: %d frames, %.1f a second\n", m_frames, m_frames / seconds);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Options options = parseOptions(argc, argv);
  if (options.help) {
    std::fputs(helpText(), stdout);
    return 0;
  }
  if (!options.problem.empty()) {
    std::fprintf(stderr, "windloom-leaves: %s\n%s", options.problem.c_str(), helpText());
    return 2;
  }
  return Game(options).run();
}
