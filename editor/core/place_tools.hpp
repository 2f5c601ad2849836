#pragma once
// Tools that set down or take away single things: probes, delete.

#include "editor/core/tool.hpp"

namespace windloom::editor {

/// Click sets a probe down; a drag sets it down where it ends.
class ProbeTool : public Tool {
 public:
  [[nodiscard]] std::string id() const override { return "probe"; }
  [[nodiscard]] std::string label() const override { return "Probe"; }
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override { return PointerShape::Cross; }
  void onClick(ToolContext& context, const PointerEvent& pointer) override;
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;
};

/// Click deletes; a drag deletes all that it sweeps over, as one step.
class DeleteTool : public Tool {
 public:
  [[nodiscard]] std::string id() const override { return "delete"; }
  [[nodiscard]] std::string label() const override { return "Delete"; }
  [[nodiscard]] std::string hint(const ToolContext& context) const override;
  [[nodiscard]] PointerShape pointerShape() const override { return PointerShape::Cross; }
  void onClick(ToolContext& context, const PointerEvent& pointer) override;
  std::unique_ptr<Drag> beginDrag(ToolContext& context, const PointerEvent& press) override;
};

}  // namespace windloom::editor
