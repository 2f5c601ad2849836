#include "editor/viewport/viewport.hpp"

#include <algorithm>
#include <cmath>

#include "editor/viewport/handles.hpp"
#include "editor/widgets/look.hpp"

namespace windloom::editor {

namespace {

constexpr ImGuiMouseButton kButtons[] = {ImGuiMouseButton_Left, ImGuiMouseButton_Right, ImGuiMouseButton_Middle};

PointerButton buttonOf(ImGuiMouseButton button) {
  if (button == ImGuiMouseButton_Left) return PointerButton::Left;
  return button == ImGuiMouseButton_Right ? PointerButton::Right : PointerButton::Middle;
}

Modifiers heldModifiers() {
  const ImGuiIO& io = ImGui::GetIO();
  return {.ctrl = io.KeyCtrl, .shift = io.KeyShift, .alt = io.KeyAlt};
}

ImGuiMouseCursor cursorOf(PointerShape shape) {
  switch (shape) {
    case PointerShape::Hand:
      return ImGuiMouseCursor_Hand;
    case PointerShape::Move:
      return ImGuiMouseCursor_ResizeAll;
    case PointerShape::Arrow:
    case PointerShape::Cross:
      break;
  }
  return ImGuiMouseCursor_Arrow;
}

/// ImGui has no cross cursor: lines through the pointer, open in the middle.
void drawCross(ImVec2 at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float far = scaled(11), near = scaled(4);
  for (const ImVec2 way : {ImVec2(1, 0), ImVec2(-1, 0), ImVec2(0, 1), ImVec2(0, -1)}) {
    const ImVec2 a{at.x + way.x * near, at.y + way.y * near}, b{at.x + way.x * far, at.y + way.y * far};
    list.AddLine(a, b, IM_COL32(0, 0, 0, 160), scaled(3));
    list.AddLine(a, b, IM_COL32_WHITE, scaled(1.25f));
  }
}

}  // namespace

void Viewport::passMouse(Workspace& workspace) {
  const ImGuiIO& io = ImGui::GetIO();
  PointerEvent pointer;
  pointer.pixel = {io.MousePos.x - m_area.min.x, io.MousePos.y - m_area.min.y};
  pointer.modifiers = heldModifiers();
  const bool moved = io.MousePos.x != m_lastMouse.x || io.MousePos.y != m_lastMouse.y;
  if ((m_hovered || m_captured != 0) && moved) workspace.pointerMoved(pointer);
  m_lastMouse = io.MousePos;

  for (const ImGuiMouseButton button : kButtons) {
    pointer.button = buttonOf(button);
    const unsigned bit = 1u << button;
    if (m_hovered && io.MouseClicked[button]) {
      pointer.clicks = std::max(1, int(io.MouseClickedCount[button]));
      m_captured |= bit;
      workspace.pointerPressed(pointer);
    }
    if (io.MouseReleased[button] && (m_captured & bit) != 0) {
      m_captured &= ~bit;
      workspace.pointerReleased(pointer);
    }
  }
  if (m_hovered && io.MouseWheel != 0) workspace.wheel(io.MouseWheel, pointer);
}

void Viewport::drawOver(Workspace& workspace, bool hasScene) {
  drawHandles(m_area, workspace, !hasScene || !overlays.arrows);
  scaleBar(m_area, workspace);
  const bool overAxes = axisSign(m_area, workspace);
  const bool overLegend = colourLegends(m_area, overlays);
  m_overInstrument = overAxes || overLegend;
  drawPreview(m_area, workspace, workspace.tools.shapes(workspace.context()));
  // Only over an empty field: anything drawn may lie under the hint, with its handles.
  const Project& project = workspace.document.project();
  const bool empty = project.graph->points.empty() && project.obstacles->empty() && project.colliders->empty() &&
                     project.surfaces->empty() && project.rotors->empty() && project.probes->empty();
  if (empty && !workspace.tools.busy()) firstTreeHint(m_area);
}

void Viewport::draw(Workspace& workspace, bool hasScene) {
  m_area.min = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size{std::max(1.0f, std::floor(room.x)), std::max(1.0f, std::floor(room.y))};
  m_area.max = {m_area.min.x + size.x, m_area.min.y + size.y};
  workspace.viewportSize = {size.x, size.y};
  look().map.rectangle("viewport", m_area.min, m_area.max);

  ImGui::InvisibleButton(
      "viewport", size,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  ImGui::SetItemAllowOverlap();
  const bool was = m_hovered;
  m_hovered = ImGui::IsItemHovered() && !m_overInstrument;
  passMouse(workspace);
  if (was && !m_hovered && m_captured == 0) workspace.pointerLeft();

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(m_area.min, m_area.max, true);
  drawOver(workspace, hasScene);
  if (m_hovered && !workspace.navigator.active()) {
    const PointerShape shape = workspace.tools.active().pointerShape();
    ImGui::SetMouseCursor(shape == PointerShape::Cross ? ImGuiMouseCursor_None : cursorOf(shape));
    if (shape == PointerShape::Cross) drawCross(ImGui::GetIO().MousePos);
  }
  list.PopClipRect();
}

bool Viewport::updatePicture(Session& session, const Workspace& workspace, float pixelRatio, float detail) {
  SceneRequest request;
  request.camera = workspace.camera;
  request.size =
      glm::ivec2(glm::round(glm::vec2(m_area.max.x - m_area.min.x, m_area.max.y - m_area.min.y) * pixelRatio));
  request.revision = workspace.document.revision();
  request.overlays = overlays;
  request.grassView = grassView;
  request.bezierCulling = bezierCulling;
  const auto ids = workspace.selection.ids();
  request.selected.assign(ids.begin(), ids.end());
  request.hovered = workspace.tools.hovered();
  request.detail = detail;
  return m_picture.update(session, request);
}

void Viewport::copyPicture(glm::ivec2 framebufferSize, float pixelRatio) const {
  m_picture.copyToWindow(
      {int(std::lround(m_area.min.x * pixelRatio)), framebufferSize.y - int(std::lround(m_area.max.y * pixelRatio))});
}

}  // namespace windloom::editor
