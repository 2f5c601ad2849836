#include "editor/core/draw_tool.hpp"

#include <algorithm>
#include <cmath>

#include "editor/core/graph_edits.hpp"
#include "editor/core/select_tool.hpp"
#include "editor/core/snapping.hpp"
#include "engine/core/text.hpp"
#include "engine/model/parameters.hpp"

namespace windloom::editor {
namespace {

constexpr float kMinDrawnM = 0.02f;
constexpr float kWheelFactor = 1.1f;

/// The point under the pixel, not `except`.
Id pointAt(const ToolContext& context, glm::vec2 pixel, Id except) {
  if (!context.settings.snap.points) return 0;
  PickOptions options = onlyPoints();
  options.ignore = except;
  options.radiusPx = context.settings.hitRadiusPx;
  // The committed project: during a drag the preview holds the very point that is drawn.
  const std::vector<Hit> hits = pick(context.document.committed(), context.view, context.ground, pixel, options);
  return hits.empty() ? 0 : hits.front().id;
}

DrawEnd atPoint(const Project& project, Id id) {
  return {id, findPoint(*project.graph, id)->position};
}

std::optional<DrawEnd> startAt(const ToolContext& context, const PointerEvent& pointer) {
  if (const Id id = pointAt(context, pointer.pixel, 0)) return atPoint(context.document.committed(), id);
  const auto place = context.groundAt(pointer.pixel);
  if (!place) return std::nullopt;
  return DrawEnd{0, snapToGrid(context.settings.snap, *place, pointer.modifiers)};
}

std::optional<DrawEnd> endAt(const ToolContext& context, const PointerEvent& pointer, const DrawEnd& start) {
  if (const Id id = pointAt(context, pointer.pixel, start.point)) return atPoint(context.document.committed(), id);
  const auto place = context.groundAt(pointer.pixel);
  if (!place) return std::nullopt;
  return DrawEnd{0, snapEnd(context.settings.snap, start.place, *place, pointer.modifiers)};
}

float scaled(std::string_view key, float value, float factor) {
  for (const Parameter<Arrow>& parameter : parametersOf<Arrow>()) {
    if (parameter.info.key != key) continue;
    return std::clamp(value * factor, static_cast<float>(parameter.info.min), static_cast<float>(parameter.info.max));
  }
  return value;
}

bool changeModel(ToolContext& context, float notches, Modifiers modifiers) {
  Arrow& model = context.settings.newArrow;
  const float factor = std::pow(kWheelFactor, notches);
  if (modifiers.ctrl || modifiers.alt) return false;
  if (modifiers.shift) {
    model.strength = scaled("strength", model.strength, factor);
  } else {
    model.radius = scaled("radius", model.radius, factor);
  }
  return true;
}

std::string modelText(const Arrow& model) {
  return "radius " + fixed(static_cast<double>(model.radius), 1) + " m, " +
         fixed(static_cast<double>(model.strength), 1) + (model.drive == Drive::Speed ? " m/s" : " m/s^2");
}

void describe(const ToolContext& context, const DrawEnd& from, const DrawEnd& to, glm::vec2 pixel,
              PreviewShapes& shapes) {
  if (to.point != 0) shapes.dots.push_back({context.ground.lift(to.place), ShapeRole::Snap});
  if (from.point != 0) shapes.dots.push_back({context.ground.lift(from.place), ShapeRole::Snap});
  const double length = static_cast<double>(glm::distance(from.place, to.place));
  shapes.labels.push_back(
      {pixel + glm::vec2(16.0f, 16.0f), fixed(length, 1) + " m, " + modelText(context.settings.newArrow)});
}

class DrawDrag : public Drag {
 public:
  explicit DrawDrag(DrawEnd start) : m_start(start) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    m_pixel = pointer.pixel;
    if (const auto end = endAt(context, pointer, m_start)) m_end = end;
    return make(context);
  }
  std::optional<Edit> end(ToolContext& context) override { return make(context); }
  void applied(ToolContext& context) override { context.selection.replace(m_arrow); }
  bool onWheel(ToolContext& context, float notches, Modifiers modifiers) override {
    return changeModel(context, notches, modifiers);
  }
  bool onKey(ToolContext& context, const KeyPress& press) override {
    if (press.key != Key::BracketLeft && press.key != Key::BracketRight) return false;
    return changeModel(context, press.key == Key::BracketRight ? 1.0f : -1.0f, press.modifiers);
  }
  void shapes(const ToolContext& context, PreviewShapes& shapes) const override {
    if (m_end) describe(context, m_start, *m_end, m_pixel, shapes);
  }
  [[nodiscard]] std::string hint(const ToolContext&) const override {
    return "Release to end the arrow, on a point to join it. Wheel: radius, Shift+wheel: strength, Esc cancels";
  }

 private:
  std::optional<Edit> make(const ToolContext& context) {
    if (!m_end) return std::nullopt;
    auto drawn = drawEdit(context.document.committed(), m_start, *m_end, context.settings.newArrow);
    if (!drawn) return std::nullopt;
    m_arrow = drawn->arrow;
    return std::move(drawn->edit);
  }

  DrawEnd m_start;
  std::optional<DrawEnd> m_end;
  Id m_arrow = 0;
  glm::vec2 m_pixel{0.0f};
};

}  // namespace

std::optional<DrawResult> drawEdit(const Project& project, const DrawEnd& from, const DrawEnd& to, const Arrow& model) {
  const bool samePoint = from.point != 0 && from.point == to.point;
  if (samePoint || glm::distance(from.place, to.place) < kMinDrawnM) return std::nullopt;
  if (from.point != 0 && to.point != 0) {
    ConnectResult made = connectEdit(project, from.point, to.point, model);
    return DrawResult{std::move(made.edit), made.arrow, to.point};
  }
  if (from.point != 0) {
    BranchResult made = branchEdit(project, from.point, to.place, model);
    return DrawResult{std::move(made.edit), made.arrow, made.point};
  }
  if (to.point != 0) {
    FeedResult made = feedEdit(project, from.place, to.point, model);
    return DrawResult{std::move(made.edit), made.arrow, to.point};
  }
  TreeResult made = treeEdit(project, from.place, to.place, model);
  return DrawResult{std::move(made.edit), made.arrow, made.end};
}

std::string DrawTool::hint(const ToolContext& context) const {
  if (m_chain) return "Click for the next point, on a point to join it; Enter or right click ends. Wheel: radius";
  return "Drag from root to end, or click point by point; start at a point to branch (" +
         modelText(context.settings.newArrow) + ")";
}

/// An undo may have taken the point that the chain goes on from.
void DrawTool::dropLostChain(const ToolContext& context) {
  if (m_chain && m_chain->point != 0 && !findPoint(*context.document.committed().graph, m_chain->point)) {
    m_chain.reset();
  }
}

void DrawTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  dropLostChain(context);
  if (!m_chain) {
    std::string message;
    const bool inserts = pointer.modifiers.ctrl && insertPointAt(context, pointer.pixel, message);
    if (!message.empty()) say(std::move(message));
    if (!inserts) m_chain = startAt(context, pointer);
    m_hover.reset();
    return;
  }
  const auto end = endAt(context, pointer, *m_chain);
  if (!end) return;
  const auto drawn = drawEdit(context.document.committed(), *m_chain, *end, context.settings.newArrow);
  if (!drawn) {
    // The same place again: a double click ends the chain.
    if (pointer.clicks > 1) m_chain.reset();
    return;
  }
  if (!commit(context, drawn->edit)) return;
  context.selection.replace(drawn->arrow);
  if (end->point != 0) {
    m_chain.reset();
  } else {
    m_chain = DrawEnd{drawn->end, end->place};
  }
  m_hover.reset();
}

std::unique_ptr<Drag> DrawTool::beginDrag(ToolContext& context, const PointerEvent& press) {
  dropLostChain(context);
  // In a chain a press that slips still sets the next point: where it is let go.
  const auto start = m_chain ? m_chain : startAt(context, press);
  m_chain.reset();
  m_hover.reset();
  if (!start) return nullptr;
  return std::make_unique<DrawDrag>(*start);
}

void DrawTool::onHover(ToolContext& context, const PointerEvent& pointer) {
  dropLostChain(context);
  m_pixel = pointer.pixel;
  m_hover = m_chain ? endAt(context, pointer, *m_chain) : std::nullopt;
}

bool DrawTool::onKey(ToolContext& context, const KeyPress& press) {
  // What is drawn next; where arrows are selected and nothing is under way the keys are theirs.
  const bool bracket = press.key == Key::BracketLeft || press.key == Key::BracketRight;
  if (bracket && (m_chain || context.selection.empty()))
    return changeModel(context, press.key == Key::BracketRight ? 1.0f : -1.0f, press.modifiers);
  const bool ends = press.key == Key::Enter || press.key == Key::NumpadEnter;
  if (!ends || !m_chain) return false;
  m_chain.reset();
  return true;
}

bool DrawTool::onWheel(ToolContext& context, float notches, Modifiers modifiers) {
  return m_chain && changeModel(context, notches, modifiers);
}

void DrawTool::shapes(const ToolContext& context, PreviewShapes& shapes) const {
  if (!m_chain) return;
  shapes.dots.push_back({context.ground.lift(m_chain->place), m_chain->point ? ShapeRole::Snap : ShapeRole::Preview});
  if (!m_hover) return;
  const bool legal = drawEdit(context.document.committed(), *m_chain, *m_hover, context.settings.newArrow).has_value();
  if (!legal) return;
  shapes.arrows.push_back({context.ground.lift(m_chain->place), context.ground.lift(m_hover->place),
                           context.settings.newArrow.radius, ShapeRole::Preview});
  describe(context, *m_chain, *m_hover, m_pixel, shapes);
}

}  // namespace windloom::editor
