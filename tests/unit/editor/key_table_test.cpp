// Every key and gesture of the editor that needs no window, by what it does: one row each, through the events that the
// window sends. Those of the window are in tests/ui/keys_test.py.
#include <algorithm>
#include <functional>

#include "editor_bench.hpp"

namespace windloom::editor {
namespace {

/// A tree root (-30, 0) - (-10, 0) - (10, 0), ids in `ids`: points 0..2, then both arrows.
struct Scene : Bench {
  std::vector<Id> points, arrows;
  Scene() {
    key("D");
    drag({-30, 0}, {-10, 0});
    drag({-10, 0}, {10, 0});
    key("Q");
    for (const Point& point : graph().points) points.push_back(point.id);
    for (const Arrow& one : graph().arrows) arrows.push_back(one.id);
    w.selection.clear();
  }
  void choose(std::vector<Id> ids) { w.selection.replace(std::move(ids)); }
  void pointer(PointerButton button, glm::vec2 from, glm::vec2 to, Modifiers held = {}) {
    PointerEvent event = at(from, held);
    event.button = button;
    const glm::vec2 end = pixel(to);
    w.pointerPressed(event);
    event.pixel = end;
    w.pointerMoved(event);
    w.pointerReleased(event);
  }
  [[nodiscard]] float yaw() const { return w.camera.yaw; }
};

struct Row {
  const char* name;
  std::function<bool(Scene&)> works;
};

bool near(glm::vec2 a, glm::vec2 b) {
  return glm::distance(a, b) < 0.05f;
}

const Row kViewRows[] = {
    {"MMB orbits",
     [](Scene& s) {
       const EditorCamera before = s.w.camera;
       s.pointer(PointerButton::Middle, {0, 0}, {10, 10});
       return s.w.camera.yaw != before.yaw && s.w.camera.target == before.target;
     }},
    {"Alt+LMB orbits",
     [](Scene& s) {
       const float before = s.yaw();
       s.pointer(PointerButton::Left, {0, 20}, {10, 30}, kAlt);
       return s.yaw() != before;
     }},
    {"Shift+MMB pans",
     [](Scene& s) {
       s.pointer(PointerButton::Middle, {0, 0}, {10, 5}, kShift);
       return near({s.w.camera.target.x, s.w.camera.target.z}, {-10, -5}) && s.yaw() == 0;
     }},
    {"Alt+MMB pans",
     [](Scene& s) {
       s.pointer(PointerButton::Middle, {0, 0}, {10, 5}, kAlt);
       return near({s.w.camera.target.x, s.w.camera.target.z}, {-10, -5});
     }},
    {"the wheel zooms to the cursor",
     [](Scene& s) {
       const glm::vec2 pixel = s.pixel({30, 20});
       const float before = s.w.camera.distance;
       s.w.wheel(2, s.at({30, 20}));
       return s.w.camera.distance < before && near(*s.w.context().groundAt(pixel), {30, 20});
     }},
    {"Alt+RMB zooms",
     [](Scene& s) {
       const float before = s.w.camera.distance;
       s.pointer(PointerButton::Right, {0, 0}, {10, 0}, kAlt);
       return s.w.camera.distance < before;
     }},
    {"RMB and WASD QE fly",
     [](Scene& s) {
       s.w.camera = EditorCamera{};
       for (const Key key : {Key::W, Key::A, Key::S, Key::D, Key::Q, Key::E}) {
         PointerEvent right;
         right.button = PointerButton::Right;
         s.w.pointerPressed(right);
         const glm::vec3 before = s.w.camera.position();
         s.w.keyPressed({key, {}, false});
         s.w.tick(0.1, {});
         const float slow = glm::distance(before, s.w.camera.position());
         s.w.tick(0.1, kShift);
         const float both = glm::distance(before, s.w.camera.position());
         s.w.pointerReleased(right);
         if (slow < 0.1f || both < 2.5f * slow) return false;
       }
       return s.w.tools.active().id() == "select";
     }},
    {"the wheel changes the speed of flying",
     [](Scene& s) {
       PointerEvent right;
       right.button = PointerButton::Right;
       s.w.pointerPressed(right);
       const float before = s.w.navigator.speedMps();
       s.w.wheel(1, right);
       return s.w.navigator.speedMps() > before;
     }},
    {"F frames the selection",
     [](Scene& s) {
       s.choose({s.points[2]});
       s.key("F");
       return near({s.w.camera.target.x, s.w.camera.target.z}, {10, 0});
     }},
    {"Shift+F frames all",
     [](Scene& s) {
       s.choose({s.points[2]});
       s.key("Shift+F");
       return near({s.w.camera.target.x, s.w.camera.target.z}, {-10, 0});
     }},
    {"Home frames all",
     [](Scene& s) {
       s.key("Home");
       return near({s.w.camera.target.x, s.w.camera.target.z}, {-10, 0});
     }},
    {"Numpad 7 looks from the top",
     [](Scene& s) {
       s.w.camera = EditorCamera{};
       s.key("Numpad 7");
       return s.w.camera.orthographic && s.w.camera.pitch == 90;
     }},
    {"Numpad 1 looks from the front",
     [](Scene& s) {
       s.key("Numpad 1");
       return s.w.camera.orthographic && s.w.camera.pitch == 0 && s.yaw() == 0;
     }},
    {"Numpad 3 looks from the side",
     [](Scene& s) {
       s.key("Numpad 3");
       return s.w.camera.pitch == 0 && s.yaw() == 90;
     }},
    {"Numpad 5 switches perspective",
     [](Scene& s) {
       s.key("Numpad 5");
       return !s.w.camera.orthographic;
     }},
};

const Row kSelectRows[] = {
    {"a click selects",
     [](Scene& s) {
       s.click({-10, 0});
       return s.w.selection.ids().size() == 1 && s.w.selection.contains(s.points[1]);
     }},
    {"Shift+click adds",
     [](Scene& s) {
       s.click({-10, 0});
       s.click({10, 0}, kShift);
       return s.w.selection.size() == 2;
     }},
    {"Ctrl+click toggles",
     [](Scene& s) {
       s.click({-10, 0});
       s.click({-10, 0}, kCtrl);
       return s.w.selection.empty();
     }},
    {"repeated clicks cycle through what overlaps",
     [](Scene& s) {
       s.click({-10, 0});
       const Id first = s.w.selection.active();
       s.click({-10, 0});
       return s.w.selection.active() != first && s.w.selection.size() == 1;
     }},
    {"a drag on empty ground selects a box",
     [](Scene& s) {
       s.drag({-40, -10}, {0, 10});
       return s.w.selection.size() == 3 && s.w.selection.contains(s.arrows[0]);
     }},
    {"Shift adds a box",
     [](Scene& s) {
       s.choose({s.points[2]});
       s.drag({-40, -10}, {0, 10}, kShift);
       return s.w.selection.size() == 4;
     }},
    {"Ctrl toggles a box",
     [](Scene& s) {
       s.choose({s.points[0]});
       s.drag({-40, -10}, {-20, 10}, kCtrl);
       return s.w.selection.empty();
     }},
    {"Esc cancels a box",
     [](Scene& s) {
       s.choose({s.points[2]});
       s.press({-40, -10});
       s.move({0, 10});
       s.key("Esc");
       s.release({0, 10});
       return s.w.selection.size() == 1;
     }},
    {"A selects all",
     [](Scene& s) {
       s.key("A");
       return s.w.selection.size() == 5;
     }},
    {"Alt+A selects nothing",
     [](Scene& s) {
       s.key("A");
       s.key("Alt+A");
       return s.w.selection.empty();
     }},
    {"Esc selects nothing",
     [](Scene& s) {
       s.key("A");
       s.key("Esc");
       return s.w.selection.empty();
     }},
};

const Row kTransformRows[] = {
    {"Q W E R choose the tools",
     [](Scene& s) {
       const std::pair<const char*, const char*> tools[] = {
           {"W", "move"}, {"E", "rotate"}, {"R", "scale"}, {"Q", "select"}};
       return std::ranges::all_of(tools, [&](const auto& tool) {
         s.key(tool.first);
         return s.w.tools.active().id() == tool.second;
       });
     }},
    {"a drag moves",
     [](Scene& s) {
       s.drag({10, 0}, {15, 8});
       return near(s.place(s.points[2]), {15, 8}) && s.steps() == 3;
     }},
    {"W: a drag beside it moves the selection",
     [](Scene& s) {
       s.key("W");
       s.choose({s.points[2]});
       s.drag({30, 30}, {35, 28});
       return near(s.place(s.points[2]), {15, -2});
     }},
    {"X locks a move",
     [](Scene& s) {
       s.press({10, 0});
       s.move({15, 8});
       s.key("X");
       s.release({15, 8});
       return near(s.place(s.points[2]), {15, 0});
     }},
    {"Z locks a move, a second time frees it",
     [](Scene& s) {
       s.press({10, 0});
       s.move({15, 8});
       s.key("Z");
       s.key("Z");
       s.key("Z");
       s.release({15, 8});
       return near(s.place(s.points[2]), {10, 8});
     }},
    {"a typed number and Enter set the way",
     [](Scene& s) {
       s.press({10, 0});
       s.move({12, 0});
       s.key("X");
       s.type("-2.5");
       s.key("Enter");
       s.release({12, 0});
       return near(s.place(s.points[2]), {7.5f, 0}) && s.steps() == 3;
     }},
    {"E: a typed angle turns",
     [](Scene& s) {
       s.key("E");
       s.choose({s.arrows[1]});
       s.press({20, 20});
       s.move({20, 22});
       s.type("90");
       s.key("Enter");
       s.release({20, 22});
       return near(s.place(s.points[1]), {0, -10}) && near(s.place(s.points[2]), {0, 10});
     }},
    {"R: a typed factor scales, X locks",
     [](Scene& s) {
       s.key("R");
       s.choose({s.arrows[1]});
       s.press({20, 20});
       s.move({20, 22});
       s.key("X");
       s.type("2");
       s.key("Enter");
       s.release({20, 22});
       return near(s.place(s.points[1]), {-20, 0}) && near(s.place(s.points[2]), {20, 0});
     }},
    {"Esc cancels a move",
     [](Scene& s) {
       s.press({10, 0});
       s.move({15, 8});
       s.key("Esc");
       s.release({15, 8});
       return near(s.place(s.points[2]), {10, 0}) && s.steps() == 2;
     }},
    {"RMB cancels a move",
     [](Scene& s) {
       s.press({10, 0});
       s.move({15, 8});
       s.rightClick({15, 8});
       s.release({15, 8});
       return near(s.place(s.points[2]), {10, 0}) && s.steps() == 2 && !s.w.navigator.active();
     }},
    {"focus loss cancels a move",
     [](Scene& s) {
       s.press({10, 0});
       s.move({15, 8});
       s.w.focusLost();
       s.release({15, 8});
       return near(s.place(s.points[2]), {10, 0}) && s.steps() == 2;
     }},
    {"a change of tool cancels a move",
     [](Scene& s) {
       s.press({10, 0});
       s.move({15, 8});
       s.w.activateTool("draw");
       s.release({15, 8});
       return near(s.place(s.points[2]), {10, 0}) && s.steps() == 2;
     }},
};

const Row kDrawRows[] = {
    {"D: press, drag, release draws a tree",
     [](Scene& s) {
       s.key("D");
       s.drag({-20, 20}, {0, 20});
       return s.graph().arrows.size() == 3 && s.graph().points.size() == 5;
     }},
    {"starting near a point branches",
     [](Scene& s) {
       s.key("D");
       s.drag({-10.5f, 0.4f}, {0, 20});
       return s.graph().points.size() == 4 && s.graph().arrows.back().from == s.points[1];
     }},
    {"ending on a point merges the flow into it",
     [](Scene& s) {
       s.key("D");
       s.drag({0, 20}, {10.5f, 0.3f});
       return s.graph().points.size() == 4 && s.graph().arrows.back().to == s.points[2];
     }},
    {"a ring can be closed",
     [](Scene& s) {
       s.key("D");
       s.drag({10, 0}, {-30.4f, 0.3f});
       const Arrow& last = s.graph().arrows.back();
       return s.graph().points.size() == 3 && last.from == s.points[2] && last.to == s.points[0];
     }},
    {"click, click, click goes on, Enter ends",
     [](Scene& s) {
       s.key("D");
       for (const float x : {-20.0f, -10.0f, 0.0f}) s.click({x, 20});
       const bool busy = s.w.tools.busy();
       s.key("Enter");
       return busy && !s.w.tools.busy() && s.graph().arrows.size() == 4;
     }},
    {"RMB ends a chain",
     [](Scene& s) {
       s.key("D");
       s.click({-20, 20});
       s.click({0, 20});
       s.rightClick({10, 20});
       return !s.w.tools.busy() && s.graph().arrows.size() == 3 && !s.w.navigator.active();
     }},
    {"the wheel while drawing changes the radius",
     [](Scene& s) {
       s.key("D");
       s.press({-20, 20});
       s.move({0, 20});
       const float before = s.w.toolSettings.newArrow.radius, distance = s.w.camera.distance;
       s.w.wheel(2, s.at({0, 20}));
       s.release({0, 20});
       return s.graph().arrows.back().radius > before && s.w.camera.distance == distance;
     }},
    {"Shift+wheel while drawing changes the strength",
     [](Scene& s) {
       s.key("D");
       s.press({-20, 20});
       s.move({0, 20});
       const float before = s.w.toolSettings.newArrow.strength;
       s.w.wheel(2, s.at({0, 20}, kShift));
       s.release({0, 20});
       return s.graph().arrows.back().strength > before;
     }},
    {"Shift+E extrudes to the cursor",
     [](Scene& s) {
       s.choose({s.points[2]});
       s.hover({20, 12});
       s.key("Shift+E");
       const Arrow& last = s.graph().arrows.back();
       return last.from == s.points[2] && near(s.place(last.to), {20, 12}) && s.w.selection.active() == last.to;
     }},
    {"Ctrl+click on an arrow inserts a point",
     [](Scene& s) {
       s.click({0, 0}, kCtrl);
       return s.graph().points.size() == 4 && s.graph().arrows.size() == 3 &&
              near(s.place(s.graph().points.back().id), {0, 0});
     }},
    {"Ctrl+J merges",
     [](Scene& s) {
       s.key("D");
       s.drag({-10, 20}, {9, 5});
       const Id end = s.graph().arrows.back().to;
       s.choose({s.points[2], end});
       s.key("Ctrl+J");
       return s.graph().points.size() == 4 && s.graph().arrows.size() == 3;
     }},
    {"Y splits",
     [](Scene& s) {
       s.choose({s.points[1]});
       s.key("Y");
       return s.graph().points.size() == 4 && findRoots(s.graph()).size() == 2;
     }},
    {"Ctrl+R reverses",
     [](Scene& s) {
       s.choose({s.arrows[1]});
       s.key("Ctrl+R");
       return s.arrow(s.arrows[1]).from == s.points[2] && s.arrow(s.arrows[1]).to == s.points[1];
     }},
    {"Ctrl+P reparents to the last selected",
     [](Scene& s) {
       s.choose({s.points[2], s.points[0]});
       s.key("Ctrl+P");
       return std::ranges::any_of(
           s.graph().arrows, [&](const Arrow& arrow) { return arrow.from == s.points[0] && arrow.to == s.points[2]; });
     }},
    {"O draws an obstacle",
     [](Scene& s) {
       s.key("O");
       s.drag({20, 20}, {24, 23});
       return s.project().obstacles->size() == 1 && s.project().obstacles->front().radius > 4.9f;
     }},
    {"O and clicks draw a polygon",
     [](Scene& s) {
       s.key("O");
       for (const glm::vec2 corner : {glm::vec2(20, 20), glm::vec2(30, 20), glm::vec2(30, 30)}) s.click(corner);
       s.key("Enter");
       return s.project().obstacles->front().shape == ObstacleShape::Polygon;
     }},
    {"V draws a vortex",
     [](Scene& s) {
       s.key("V");
       s.drag({20, 20}, {24, 23});
       return s.graph().arrows.back().swirl != 0;
     }},
    {"P sets a probe",
     [](Scene& s) {
       s.key("P");
       s.click({20, 20});
       return s.project().probes->size() == 1;
     }},
    {"B combs the wind",
     [](Scene& s) {
       s.key("B");
       s.press({20, 20});
       s.w.tick(0.1, {});
       s.move({24, 20});
       s.release({24, 20});
       return !s.w.strokes.empty() && s.steps() == 2;
     }},
};

const Row kChangeRows[] = {
    {"] widens",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       const float before = s.arrow(s.arrows[0]).radius;
       s.key("]");
       s.key("]");
       return s.arrow(s.arrows[0]).radius > before && s.steps() == 3;
     }},
    {"[ narrows",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       const float before = s.arrow(s.arrows[0]).radius;
       s.key("[");
       return s.arrow(s.arrows[0]).radius < before;
     }},
    {"Shift+] strengthens",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       const float before = s.arrow(s.arrows[0]).strength;
       s.key("Shift+]");
       return s.arrow(s.arrows[0]).strength > before && s.arrow(s.arrows[1]).strength == before;
     }},
    {"Shift+[ weakens",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       const float before = s.arrow(s.arrows[0]).strength;
       s.key("Shift+[");
       return s.arrow(s.arrows[0]).strength < before;
     }},
    {"[ ] set what the draw tool draws next",
     [](Scene& s) {
       s.key("D");
       const float before = s.w.toolSettings.newArrow.radius;
       s.key("]");
       return s.w.toolSettings.newArrow.radius > before && s.steps() == 2;
     }},
    {"Ctrl+D duplicates",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       s.key("Ctrl+D");
       return s.graph().arrows.size() == 3 && s.graph().points.size() == 5 && !s.w.selection.contains(s.arrows[0]);
     }},
    {"Alt+drag duplicates",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       s.drag({-20, 0}, {-20, 12}, kAlt);
       return s.graph().arrows.size() == 3 && near(s.place(s.points[0]), {-30, 0});
     }},
    {"Shift+D duplicates and follows the pointer until a click",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       s.hover({-20, 0});
       s.key("Shift+D");
       s.hover({-20, 12});
       s.press({-20, 12});
       s.release({-20, 12});
       return s.graph().arrows.size() == 3 && near(s.place(s.arrow(s.w.selection.active()).from), {-30, 12});
     }},
    {"Del deletes",
     [](Scene& s) {
       s.choose({s.arrows[1]});
       s.key("Del");
       return s.graph().arrows.size() == 1 && s.graph().points.size() == 2 && s.w.selection.empty();
     }},
    {"X deletes",
     [](Scene& s) {
       s.choose({s.points[1]});
       s.key("X");
       return s.graph().arrows.empty();
     }},
    {"Ctrl+C and Ctrl+V copy as JSON text",
     [](Scene& s) {
       std::string mailed;
       s.w.writeClipboard = [&](const std::string& text) { mailed = text; };
       s.choose({s.arrows[0]});
       s.key("Ctrl+C");
       s.w.readClipboard = [&] { return mailed; };
       s.hover({0, 30});
       s.key("Ctrl+V");
       return mailed.starts_with("{") && s.graph().arrows.size() == 3 &&
              near(s.place(s.graph().arrows.back().from), {-10, 30});
     }},
    {"Ctrl+Z undoes, Ctrl+Shift+Z and Ctrl+Y redo",
     [](Scene& s) {
       s.key("Ctrl+Z");
       const bool undone = s.graph().arrows.size() == 1;
       s.key("Ctrl+Shift+Z");
       const bool redone = s.graph().arrows.size() == 2;
       s.key("Ctrl+Z");
       s.key("Ctrl+Y");
       return undone && redone && s.graph().arrows.size() == 2;
     }},
    {"M mutes",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       s.key("M");
       const bool muted = s.arrow(s.arrows[0]).muted;
       s.key("M");
       return muted && !s.arrow(s.arrows[0]).muted;
     }},
    {"H hides, Alt+H shows",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       s.key("H");
       const bool hidden = s.arrow(s.arrows[0]).hidden;
       s.key("Alt+H");
       return hidden && !s.arrow(s.arrows[0]).hidden;
     }},
    {"Numpad / isolates, and shows all again",
     [](Scene& s) {
       s.choose({s.arrows[0]});
       s.key("Numpad /");
       const bool alone = s.arrow(s.arrows[1]).hidden && !s.arrow(s.arrows[0]).hidden;
       s.key("Numpad /");
       return alone && !s.arrow(s.arrows[1]).hidden;
     }},
    {"Ctrl+N asks before it throws changes away",
     [](Scene& s) {
       s.key("Ctrl+N");
       return s.graph().arrows.size() == 2;
     }},
};

void walk(std::span<const Row> rows) {
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    Scene scene;
    EXPECT_TRUE(row.works(scene)) << row.name << ": " << scene.w.message().text;
  }
}

TEST(KeyTable, View) {
  walk(kViewRows);
}
TEST(KeyTable, Select) {
  walk(kSelectRows);
}
TEST(KeyTable, Transform) {
  walk(kTransformRows);
}
TEST(KeyTable, Draw) {
  walk(kDrawRows);
}
TEST(KeyTable, Change) {
  walk(kChangeRows);
}

}  // namespace
}  // namespace windloom::editor
