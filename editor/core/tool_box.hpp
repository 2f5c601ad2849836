#pragma once
// Holds the tools, one of them active, and runs clicks and drags: click against drag by a threshold, live
// preview, one undo step at the end, cancel.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/tool.hpp"

namespace windloom::editor {

inline constexpr float kDragThresholdPx = 3.0f;

class ToolBox {
 public:
  /// With the core tools: select, move, rotate, scale, draw, obstacle, vortex, brush, probe, delete.
  ToolBox();

  void add(std::unique_ptr<Tool> tool);
  [[nodiscard]] const std::vector<std::unique_ptr<Tool>>& tools() const { return m_tools; }
  [[nodiscard]] Tool& active() { return *m_tools[m_active]; }
  [[nodiscard]] const Tool& active() const { return *m_tools[m_active]; }
  /// Cancels what is under way and changes the tool. False: no such tool.
  bool activate(ToolContext& context, std::string_view id);

  // Events; each is true where it was used. Only the left button reaches tools; the right one pressed
  // during a gesture cancels a drag or ends a chain, and is then used up.
  bool press(ToolContext& context, const PointerEvent& pointer);
  bool move(ToolContext& context, const PointerEvent& pointer);
  bool release(ToolContext& context, const PointerEvent& pointer);
  bool wheel(ToolContext& context, float notches, Modifiers modifiers);
  bool key(ToolContext& context, const KeyPress& press);
  /// Begins a drag that follows the pointer without a button (started by a key): a left click or Enter ends it.
  void startDrag(ToolContext& context, std::unique_ptr<Drag> drag, const PointerEvent& pointer);
  /// Focus loss, tool change, Esc. True where something was under way.
  bool cancel(ToolContext& context);
  /// A right click: cancels a drag, ends a gesture of several clicks with what there is.
  bool finish(ToolContext& context);

  /// A button is held, or a gesture of several clicks is under way.
  [[nodiscard]] bool busy() const { return m_pressed || m_drag || active().busy(); }
  [[nodiscard]] bool dragging() const { return m_drag != nullptr; }

  /// What lies under the pointer, 0: nothing. For the hover highlight.
  [[nodiscard]] Id hovered() const { return m_hovered; }
  void clearHover();

  [[nodiscard]] PreviewShapes shapes(const ToolContext& context) const;
  [[nodiscard]] std::string hint(const ToolContext& context) const;
  /// A message for the status bar, taken once; empty where there is none.
  std::string takeMessage();

 private:
  void updateDrag(ToolContext& context, const PointerEvent& pointer);
  void endDrag(ToolContext& context);
  void cancelDrag(ToolContext& context);

  std::vector<std::unique_ptr<Tool>> m_tools;
  std::size_t m_active = 0;
  std::unique_ptr<Drag> m_drag;
  bool m_pressed = false;
  bool m_free = false;    // the drag follows the pointer without a button
  std::string m_refused;  // why the drag's last preview was not legal
  PointerEvent m_press, m_last;
  Id m_hovered = 0;
  std::string m_message;
};

}  // namespace windloom::editor
