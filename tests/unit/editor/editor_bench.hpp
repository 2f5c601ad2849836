#pragma once
// A workspace without a window that tests drive as a person would: places on the ground are turned into pixels of
// a 1000 x 1000 viewport that looks straight down, 10 pixels a metre.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "editor/core/workspace.hpp"

namespace windloom::editor {

struct Bench {
  Workspace w;

  Bench() {
    w.viewportSize = {1000.0f, 1000.0f};
    w.camera = lookAlong(EditorCamera{}, ViewDirection::Top);
    w.camera.distance = 50.0f / std::tan(glm::radians(22.5f));  // 100 m over the height
  }

  [[nodiscard]] glm::vec2 pixel(glm::vec2 ground) const { return *w.view().groundToScreen(ground, w.ground); }
  [[nodiscard]] PointerEvent at(glm::vec2 ground, Modifiers held = {}) const {
    PointerEvent pointer;
    pointer.pixel = pixel(ground);
    pointer.modifiers = held;
    return pointer;
  }
  void hover(glm::vec2 to) { w.pointerMoved(at(to)); }
  void press(glm::vec2 place, Modifiers held = {}) { w.pointerPressed(at(place, held)); }
  void move(glm::vec2 to, Modifiers held = {}) { w.pointerMoved(at(to, held)); }
  void release(glm::vec2 to, Modifiers held = {}) { w.pointerReleased(at(to, held)); }
  void click(glm::vec2 place, Modifiers held = {}) {
    hover(place);
    press(place, held);
    release(place, held);
  }
  void drag(glm::vec2 from, glm::vec2 to, Modifiers held = {}) {
    hover(from);
    press(from, held);
    for (int i = 1; i <= 4; ++i) move(glm::mix(from, to, 0.25f * static_cast<float>(i)), held);
    release(to, held);
  }
  void rightClick(glm::vec2 place) {
    PointerEvent pointer = at(place);
    pointer.button = PointerButton::Right;
    w.pointerPressed(pointer);
    w.pointerReleased(pointer);
  }
  /// "Ctrl+Z": the key goes down and up. True where something used it.
  bool key(const char* text) {
    const auto shortcut = parseShortcut(text);
    EXPECT_TRUE(shortcut.has_value()) << text;
    if (!shortcut) return false;
    const bool used = w.keyPressed({shortcut->key, shortcut->modifiers, false});
    w.keyReleased(shortcut->key);
    return used;
  }
  void type(const char* digits) {
    for (const char* c = digits; *c; ++c) key(std::string(1, *c).c_str());
  }
  /// Draws an arrow and gives its id.
  Id draw(glm::vec2 from, glm::vec2 to) {
    key("D");
    drag(from, to);
    return w.selection.active();
  }

  [[nodiscard]] const Project& project() const { return w.document.project(); }
  [[nodiscard]] const WindGraph& graph() const { return *project().graph; }
  [[nodiscard]] const Arrow& arrow(Id id) const { return *findArrow(graph(), id); }
  [[nodiscard]] glm::vec2 place(Id point) const { return findPoint(graph(), point)->position; }
  [[nodiscard]] std::size_t steps() const { return w.document.history().position(); }
};

inline void expectNear(glm::vec2 a, glm::vec2 b, float tolerance = 2e-3f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
}

inline constexpr Modifiers kCtrl{true, false, false}, kShift{false, true, false}, kAlt{false, false, true};

/// A fresh folder for a test's files, removed with it.
class TempFolder {
 public:
  TempFolder() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    m_path = std::filesystem::path(testing::TempDir()) /
             (std::string("windloom_") + info->test_suite_name() + "_" + info->name());
    std::filesystem::remove_all(m_path);
    std::filesystem::create_directories(m_path);
  }
  ~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return m_path / name; }
  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

 private:
  std::filesystem::path m_path;
};

}  // namespace windloom::editor
