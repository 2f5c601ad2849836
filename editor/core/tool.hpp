#pragma once
// Tools and drags. A tool answers clicks, keys and hovering; when the pointer is dragged it hands out a drag
// object, which turns pointer positions into one edit. ToolBox runs both.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "editor/core/brush_strokes.hpp"
#include "editor/core/camera_control.hpp"
#include "editor/core/document.hpp"
#include "editor/core/picking.hpp"
#include "editor/core/preview_shapes.hpp"
#include "editor/core/selection.hpp"
#include "editor/core/shortcut.hpp"

namespace windloom::editor {

enum class PointerButton { Left, Middle, Right };

struct PointerEvent {
  glm::vec2 pixel{0.0f};  ///< of the viewport, top left origin
  Modifiers modifiers;
  PointerButton button = PointerButton::Left;  ///< presses and releases only
  int clicks = 1;                              ///< 2 for a double click
  double seconds = 0;                          ///< by the clock of ToolContext; set by ToolBox
};

/// Snapping of new and moved things.
struct SnapSettings {
  bool grid = false;
  float gridM = 1.0f;
  bool angle = false;
  float angleDeg = 15.0f;
  bool points = true;  ///< ends of drawn arrows join points within the hit radius
};

/// What new things are made with; the last used values stay.
struct ToolSettings {
  Arrow newArrow;        ///< strength, radius, drive, where, ... ; ids are ignored
  Obstacle newObstacle;  ///< shape of drags (circle or box), height
  Probe newProbe;
  BrushSettings brush;
  float newSwirlMps = 6.0f;  ///< of new whirls; positive from +X towards +Z
  SnapSettings snap;
  float hitRadiusPx = kHitRadiusPx;  ///< times the interface scale
};

/// What tools work on. Made afresh for each event.
struct ToolContext {
  Document& document;
  Selection& selection;
  ToolSettings& settings;
  ViewMapping view;
  const Ground& ground;
  BrushStrokes* strokes = nullptr;  ///< where the brush leaves its strokes; null: nowhere
  double seconds = 0;               ///< a clock of real time, for the speed of the pointer
  double windSeconds = 0;           ///< the time that the view shows: where colliders are

  [[nodiscard]] std::optional<glm::vec2> groundAt(glm::vec2 pixel) const { return view.toGround(pixel, ground); }
  [[nodiscard]] std::vector<Hit> hits(glm::vec2 pixel, PickOptions options = {}) const;
};

/// A drag in progress. Its edits are relative to the committed project, so that update can be called any
/// number of times and cancel has nothing to undo. Destroying it without end is a cancel.
class Drag {
 public:
  virtual ~Drag() = default;
  /// The pointer moved: the edit that the drag would make now; nothing where it would change nothing.
  virtual std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) = 0;
  /// The button was let go at the last updated place, or Enter was pressed: the edit to make, if any.
  virtual std::optional<Edit> end(ToolContext& context) = 0;
  /// After the edit of `end` was applied (selects what was made).
  virtual void applied(ToolContext&) {}
  virtual void cancel(ToolContext&) {}
  /// True where the key meant something to the drag (axis lock, digits). The caller then updates again with
  /// the last pointer, or ends the drag where `finished` says so.
  virtual bool onKey(ToolContext&, const KeyPress&) { return false; }
  [[nodiscard]] virtual bool finished() const { return false; }
  virtual bool onWheel(ToolContext&, float /*notches*/, Modifiers) { return false; }
  virtual void shapes(const ToolContext&, PreviewShapes&) const {}
  [[nodiscard]] virtual std::string hint(const ToolContext&) const { return {}; }
};

enum class PointerShape { Arrow, Cross, Hand, Move };

class Tool {
 public:
  virtual ~Tool() = default;
  [[nodiscard]] virtual std::string id() const = 0;                              ///< "draw"; its action is "tool.draw"
  [[nodiscard]] virtual std::string label() const = 0;                           ///< "Draw tree"
  [[nodiscard]] virtual std::string hint(const ToolContext& context) const = 0;  ///< status bar line
  [[nodiscard]] virtual PointerShape pointerShape() const { return PointerShape::Arrow; }
  /// Whether Alt with a press on a handle is the tool's; elsewhere and otherwise it orbits.
  [[nodiscard]] virtual bool usesAlt() const { return false; }

  /// Pressed and let go without moving.
  virtual void onClick(ToolContext&, const PointerEvent&) {}
  /// The pointer left the press by more than the drag threshold. Null: this drag means nothing.
  virtual std::unique_ptr<Drag> beginDrag(ToolContext&, const PointerEvent& press) = 0;
  virtual void onHover(ToolContext&, const PointerEvent&) {}
  /// The pointer left the viewport, or a drag begins.
  virtual void hoverEnded() {}
  /// True where the pointer is on a handle of the tool's own, so that no object is meant.
  [[nodiscard]] virtual bool overGrip() const { return false; }
  virtual bool onKey(ToolContext&, const KeyPress&) { return false; }
  virtual bool onWheel(ToolContext&, float /*notches*/, Modifiers) { return false; }
  /// A gesture of several clicks is under way (keys go to the tool first, right click ends it).
  [[nodiscard]] virtual bool busy() const { return false; }
  /// Gives such a gesture up. What was committed stays.
  virtual void cancel(ToolContext&) {}
  /// Ends it with what there is: a right click.
  virtual void finish(ToolContext& context) { cancel(context); }
  virtual void shapes(const ToolContext&, PreviewShapes&) const {}

  /// A message for the status bar (a refused edit), taken once.
  std::string takeMessage() { return std::exchange(m_message, {}); }

 protected:
  /// Applies; a refusal becomes the message. True where it was applied.
  bool commit(ToolContext& context, const Edit& edit);
  void say(std::string message) { m_message = std::move(message); }

 private:
  std::string m_message;
};

}  // namespace windloom::editor
