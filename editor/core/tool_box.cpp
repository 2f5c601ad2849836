#include "editor/core/tool_box.hpp"

#include <algorithm>

#include "editor/core/brush_tool.hpp"
#include "editor/core/draw_tool.hpp"
#include "editor/core/obstacle_tool.hpp"
#include "editor/core/place_tools.hpp"
#include "editor/core/refusal.hpp"
#include "editor/core/select_tool.hpp"
#include "editor/core/vortex_tool.hpp"

namespace windloom::editor {

ToolBox::ToolBox() {
  add(std::make_unique<SelectTool>(SelectKind::Select));
  add(std::make_unique<SelectTool>(SelectKind::Move));
  add(std::make_unique<SelectTool>(SelectKind::Rotate));
  add(std::make_unique<SelectTool>(SelectKind::Scale));
  add(std::make_unique<DrawTool>());
  add(std::make_unique<ObstacleTool>());
  add(std::make_unique<VortexTool>());
  add(std::make_unique<BrushTool>());
  add(std::make_unique<ProbeTool>());
  add(std::make_unique<DeleteTool>());
}

void ToolBox::add(std::unique_ptr<Tool> tool) {
  m_tools.push_back(std::move(tool));
}

bool ToolBox::activate(ToolContext& context, std::string_view id) {
  const auto found = std::find_if(m_tools.begin(), m_tools.end(), [&](const auto& tool) { return tool->id() == id; });
  if (found == m_tools.end()) return false;
  cancel(context);
  m_active = static_cast<std::size_t>(found - m_tools.begin());
  return true;
}

bool ToolBox::press(ToolContext& context, const PointerEvent& pointer) {
  if (pointer.button != PointerButton::Left) return finish(context);
  if (m_drag) {
    if (m_free) {
      updateDrag(context, pointer);
      endDrag(context);
    }
    return true;
  }
  m_pressed = true;
  m_press = m_last = pointer;
  m_press.seconds = context.seconds;
  return true;
}

bool ToolBox::move(ToolContext& context, const PointerEvent& pointer) {
  m_last.pixel = pointer.pixel;
  m_last.modifiers = pointer.modifiers;
  if (m_drag) {
    updateDrag(context, m_last);
    return true;
  }
  if (!m_pressed) {
    const std::vector<Hit> hits = context.hits(pointer.pixel);
    active().onHover(context, pointer);
    m_hovered = hits.empty() || active().overGrip() ? 0 : hits.front().id;
    return false;
  }
  if (glm::distance(m_press.pixel, pointer.pixel) <= kDragThresholdPx) return true;
  m_pressed = false;
  clearHover();
  m_drag = active().beginDrag(context, m_press);
  if (m_drag) updateDrag(context, m_last);
  return true;
}

bool ToolBox::release(ToolContext& context, const PointerEvent& pointer) {
  if (pointer.button != PointerButton::Left) return false;
  if (m_drag && !m_free) {
    m_last = pointer;
    updateDrag(context, pointer);
    endDrag(context);
    return true;
  }
  if (!m_pressed) return false;
  m_pressed = false;
  // The press is what was aimed at; the double click is counted there too.
  active().onClick(context, m_press);
  return true;
}

bool ToolBox::wheel(ToolContext& context, float notches, Modifiers modifiers) {
  if (!m_drag) return active().onWheel(context, notches, modifiers);
  if (m_drag->onWheel(context, notches, modifiers)) updateDrag(context, m_last);
  return true;
}

bool ToolBox::key(ToolContext& context, const KeyPress& press) {
  if (press.key == Key::Escape && !press.modifiers.any()) return cancel(context);
  if (!m_drag) return active().onKey(context, press);
  if (m_drag->onKey(context, press)) {
    updateDrag(context, m_last);
    if (m_drag && m_drag->finished()) endDrag(context);
  } else if (m_free && (press.key == Key::Enter || press.key == Key::NumpadEnter)) {
    endDrag(context);
  }
  // Nothing else happens to the project while something is being dragged.
  return true;
}

void ToolBox::startDrag(ToolContext& context, std::unique_ptr<Drag> drag, const PointerEvent& pointer) {
  cancel(context);
  m_drag = std::move(drag);
  m_free = true;
  m_last = pointer;
  m_hovered = 0;
  updateDrag(context, pointer);
}

bool ToolBox::cancel(ToolContext& context) {
  const bool wasBusy = busy();
  if (m_drag) cancelDrag(context);
  m_pressed = false;
  if (active().busy()) active().cancel(context);
  return wasBusy;
}

bool ToolBox::finish(ToolContext& context) {
  if (m_drag || !active().busy()) return cancel(context);
  m_pressed = false;
  active().finish(context);
  return true;
}

void ToolBox::clearHover() {
  m_hovered = 0;
  active().hoverEnded();
}

void ToolBox::updateDrag(ToolContext& context, const PointerEvent& pointer) {
  m_refused.clear();
  const std::optional<Edit> edit = m_drag->update(context, pointer);
  if (!edit) {
    context.document.endPreview();
    return;
  }
  const Status status = context.document.preview(*edit);
  if (!status) m_refused = refusalText(status.error());
}

void ToolBox::endDrag(ToolContext& context) {
  const std::unique_ptr<Drag> drag = std::move(m_drag);
  m_free = false;
  m_refused.clear();
  const std::optional<Edit> edit = drag->end(context);
  context.document.endPreview();
  if (!edit || edit->steps.empty()) return;
  const Status status = context.document.apply(*edit);
  if (status) {
    drag->applied(context);
  } else {
    m_message = refusalText(status.error());
  }
}

void ToolBox::cancelDrag(ToolContext& context) {
  const std::unique_ptr<Drag> drag = std::move(m_drag);
  m_free = false;
  m_refused.clear();
  context.document.endPreview();
  drag->cancel(context);
}

PreviewShapes ToolBox::shapes(const ToolContext& context) const {
  PreviewShapes shapes;
  if (m_drag) {
    m_drag->shapes(context, shapes);
  } else {
    active().shapes(context, shapes);
  }
  return shapes;
}

std::string ToolBox::hint(const ToolContext& context) const {
  if (!m_drag) return active().hint(context);
  return m_refused.empty() ? m_drag->hint(context) : "Not possible: " + m_refused;
}

std::string ToolBox::takeMessage() {
  std::string message = std::exchange(m_message, {});
  return message.empty() ? active().takeMessage() : message;
}

}  // namespace windloom::editor
