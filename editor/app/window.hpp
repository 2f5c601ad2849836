#pragma once
// The window: GLFW, its OpenGL context, Dear ImGui on top, and events in order.

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "editor/app/input_queue.hpp"
#include "editor/widgets/look.hpp"
#include "engine/core/result.hpp"

struct GLFWwindow;

namespace windloom::editor {

struct WindowOptions {
  int width = 1600, height = 900;  ///< window pixels
  bool maximised = false;
};

/// Passes a frame's events to Dear ImGui's GLFW backend. Call `before` ahead of ImGui_ImplGlfw_NewFrame and
/// `after` behind it, since that one overwrites the mouse with its state of now.
class InputFeeder {
 public:
  void before(GLFWwindow* window, const std::vector<InputEvent>& events);
  void after() const;

 private:
  double m_x = -1e9, m_y = -1e9;
  std::array<bool, 5> m_down{};
};

class Window {
 public:
  /// Fails with Machine: no display, or no OpenGL 4.5; the message says what was found and what is needed.
  static Result<std::unique_ptr<Window>> create(const WindowOptions& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for events no longer than `waitSeconds` (0: not at all), then begins an ImGui frame with them.
  /// `holdKeys`: keys and text wait for a later frame, because the field they are meant for isn't there yet.
  void beginFrame(double waitSeconds, bool holdKeys);
  /// Ends the ImGui frame; its drawing is painted by paint().
  void endFrame();
  /// Fills the window's framebuffer.
  void clear(glm::vec3 colour);
  /// Paints the ImGui frame over what is in the window's framebuffer.
  void paint();
  /// Shows the finished picture.
  void swap();

  /// Makes the font texture again after loadFonts; not within a frame.
  void remakeFonts();

  void setTitle(const std::string& title);
  void requestClose();
  /// The user, or requestClose, asked to close; keepOpen answers no.
  [[nodiscard]] bool closeRequested() const;
  void keepOpen();

  [[nodiscard]] glm::ivec2 size() const;             ///< window pixels
  [[nodiscard]] glm::ivec2 framebufferSize() const;  ///< pixels
  [[nodiscard]] bool minimised() const;
  [[nodiscard]] bool maximised() const;
  /// Pixels of the framebuffer per window pixel.
  [[nodiscard]] float pixelRatio() const;
  /// What the system wants 100% to be, e.g. 2 on a high-density screen.
  [[nodiscard]] float contentScale() const;

  /// Events of the current frame.
  [[nodiscard]] const std::vector<InputEvent>& events() const { return m_events; }
  /// Files dropped since the last call.
  std::vector<std::filesystem::path> takeDrops() { return std::exchange(m_drops, {}); }

  [[nodiscard]] std::string clipboard() const;
  void setClipboard(const std::string& text);

 private:
  explicit Window(GLFWwindow* window);
  void installCallbacks();

  GLFWwindow* m_window;
  InputQueue m_queue;
  InputFeeder m_feeder;
  std::vector<InputEvent> m_events;
  std::vector<std::filesystem::path> m_drops;
};

/// A small window with nothing but the message until it is closed, for when the editor's own can't be opened. Does
/// nothing where there is no display or no OpenGL 3.0.
void showTrouble(const std::string& message);

}  // namespace windloom::editor
