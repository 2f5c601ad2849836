#include "editor/core/place_tools.hpp"

#include <algorithm>

#include "editor/core/object_edits.hpp"
#include "editor/core/snapping.hpp"

namespace windloom::editor {
namespace {

class ProbeDrag : public Drag {
 public:
  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    if (const auto place = context.groundAt(pointer.pixel)) {
      m_place = snapToGrid(context.settings.snap, *place, pointer.modifiers);
    }
    return make(context);
  }
  std::optional<Edit> end(ToolContext& context) override { return make(context); }
  void applied(ToolContext& context) override { context.selection.replace(m_id); }
  [[nodiscard]] std::string hint(const ToolContext&) const override { return "Release to set the probe down"; }

 private:
  std::optional<Edit> make(const ToolContext& context) {
    if (!m_place) return std::nullopt;
    Probe probe = context.settings.newProbe;
    probe.position = *m_place;
    AddResult added = addProbeEdit(context.document.committed(), std::move(probe));
    m_id = added.id;
    return std::move(added.edit);
  }

  std::optional<glm::vec2> m_place;
  Id m_id = 0;
};

class DeleteDrag : public Drag {
 public:
  explicit DeleteDrag(glm::vec2 pressed) : m_last(pressed) {}

  std::optional<Edit> update(ToolContext& context, const PointerEvent& pointer) override {
    // A fast sweep must not jump over a handle.
    const float step = std::max(1.0f, 0.5f * context.settings.hitRadiusPx);
    const int steps = std::clamp(static_cast<int>(glm::distance(m_last, pointer.pixel) / step) + 1, 1, 200);
    for (int i = 0; i <= steps; ++i) {
      const glm::vec2 pixel = glm::mix(m_last, pointer.pixel, static_cast<float>(i) / static_cast<float>(steps));
      for (const Hit& hit : context.hits(pixel)) {
        if (hit.inside || std::find(m_ids.begin(), m_ids.end(), hit.id) != m_ids.end()) continue;
        m_ids.push_back(hit.id);
        break;
      }
    }
    m_last = pointer.pixel;
    return end(context);
  }
  std::optional<Edit> end(ToolContext& context) override {
    if (m_ids.empty()) return std::nullopt;
    return deleteEdit(context.document.committed(), m_ids);
  }
  void applied(ToolContext& context) override { context.selection.repair(context.document.project()); }
  [[nodiscard]] std::string hint(const ToolContext&) const override { return "Sweep over what to delete, Esc cancels"; }

 private:
  glm::vec2 m_last;
  std::vector<Id> m_ids;
};

}  // namespace

std::string ProbeTool::hint(const ToolContext&) const {
  return "Click where the wind is to be watched";
}

void ProbeTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  ProbeDrag drag;
  const auto edit = drag.update(context, pointer);
  if (edit && commit(context, *edit)) drag.applied(context);
}

std::unique_ptr<Drag> ProbeTool::beginDrag(ToolContext&, const PointerEvent&) {
  return std::make_unique<ProbeDrag>();
}

std::string DeleteTool::hint(const ToolContext&) const {
  return "Click deletes, a drag deletes all that it sweeps over";
}

void DeleteTool::onClick(ToolContext& context, const PointerEvent& pointer) {
  const std::vector<Hit> hits = context.hits(pointer.pixel);
  if (hits.empty()) return;
  commit(context, deleteEdit(context.document.committed(), std::span(&hits.front().id, 1)));
  context.selection.repair(context.document.project());
}

std::unique_ptr<Drag> DeleteTool::beginDrag(ToolContext&, const PointerEvent& press) {
  return std::make_unique<DeleteDrag>(press.pixel);
}

}  // namespace windloom::editor
