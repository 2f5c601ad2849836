#include "editor/core/tool.hpp"

#include "editor/core/refusal.hpp"

namespace windloom::editor {

std::vector<Hit> ToolContext::hits(glm::vec2 pixel, PickOptions options) const {
  options.radiusPx = settings.hitRadiusPx;
  options.seconds = windSeconds;
  return pick(document.project(), view, ground, pixel, options);
}

bool Tool::commit(ToolContext& context, const Edit& edit) {
  const Status status = context.document.apply(edit);
  if (!status) say(refusalText(status.error()));
  return status.ok();
}

}  // namespace windloom::editor
