// Whatever a person does, in whatever order: the project stays valid, undo leads back to the start, and a
// cancelled gesture leaves no trace.
#include <random>

#include "editor_bench.hpp"
#include "engine/io/project_json.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {
namespace {

class Fidget {
 public:
  explicit Fidget(unsigned seed) : m_random(seed) {}

  void act() {
    switch (pick(12)) {
      case 0:
      case 1:
        b.press(place(), held());
        break;
      case 2:
      case 3:
      case 4:
        b.move(place(), held());
        break;
      case 5:
      case 6:
        b.release(place(), held());
        break;
      case 7:
        b.drag(place(), place(), held());
        break;
      case 8:
        b.rightClick(place());
        break;
      case 9:
        b.w.wheel(static_cast<float>(pick(5)) - 2.0f, b.at(place(), held()));
        break;
      default:
        b.key(kKeys[pick(std::size(kKeys))]);
        break;
    }
    b.w.tick(0.016, {});
    // Fixed again, so that all places stay on the screen.
    b.w.camera = lookAlong(EditorCamera{}, ViewDirection::Top);
    b.w.camera.distance = 50.0f / std::tan(glm::radians(22.5f));
  }

  Bench b;

 private:
  static constexpr const char* kKeys[] = {
      "Q",      "B",      "Backspace", "W",      "E",        "R",      "D",       "D",      "D",       "O",
      "V",      "P",      "X",         "Z",      "Del",      "Enter",  "Esc",     "3",      ".",       "-",
      "Ctrl+Z", "Ctrl+Y", "Ctrl+J",    "Y",      "Ctrl+R",   "Ctrl+P", "Shift+E", "Ctrl+D", "Shift+D", "M",
      "H",      "Alt+H",  "A",         "Alt+A",  "Ctrl+L",   "Ctrl+I", "[",       "]",      "Shift+[", "Shift+]",
      "C",      "Ctrl+C", "Ctrl+V",    "Ctrl+X", "Numpad /", "F",      "Ctrl+Del"};

  std::size_t pick(std::size_t count) { return m_random() % count; }
  /// Few enough places that gestures meet what is there already.
  glm::vec2 place() {
    return {5.0f * (static_cast<float>(pick(13)) - 6.0f), 5.0f * (static_cast<float>(pick(13)) - 6.0f)};
  }
  Modifiers held() {
    const std::size_t which = pick(8);
    return {which == 0, which == 1, which == 2};
  }
  std::mt19937 m_random;
};

}  // namespace

TEST(RandomGestures, LeaveAValidProjectAndAHistoryThatLeadsBack) {
  std::size_t steps = 0;
  for (unsigned seed = 1; seed <= 25; ++seed) {
    Fidget fidget(seed);
    Workspace& w = fidget.b.w;
    const Project start = w.document.committed();
    for (int i = 0; i < 400; ++i) {
      fidget.act();
      ASSERT_TRUE(validate(w.document.project()).empty()) << "seed " << seed << " act " << i;
      for (const Id id : w.selection.ids()) {
        ASSERT_TRUE(kindOf(w.document.project(), id).has_value() || w.document.previewing()) << seed << " " << i;
      }
      // Copies of copies double; beyond this they only cost time.
      if (w.document.project().graph->points.size() > 300) break;
    }
    w.focusLost();
    EXPECT_FALSE(w.tools.busy());
    EXPECT_FALSE(w.document.previewing());
    const std::string text = writeProject(w.document.project());
    const auto again = parseProject(text, "again");
    ASSERT_TRUE(again) << again.error().text();
    steps += w.document.history().position();
    while (w.document.history().canUndo()) w.undo();
    EXPECT_TRUE(w.document.project().sameAs(start));
    while (w.document.history().canRedo()) w.redo();
    EXPECT_TRUE(validate(w.document.project()).empty());
  }
  EXPECT_GT(steps, 100u);
}

}  // namespace windloom::editor
