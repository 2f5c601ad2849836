#include "editor/widgets/curve_editor.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/text.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/signal_curve.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {

namespace {

constexpr float kHitPx = 10, kNearCurvePx = 6, kDragPx = 3;
constexpr double kLeastTop = 1.25, kMostTop = 4.25;
constexpr double kSnapPx = 8;  // snapping steps are at least so wide

double greatestOf(const Signal& signal) {
  double greatest = 1;
  if (signal.kind == SignalKind::Curve)
    for (const SignalKey& key : signal.keys) greatest = std::max(greatest, double(key.value));
  return greatest;
}

double distance(ImVec2 a, ImVec2 b) {
  return std::hypot(double(a.x - b.x), double(a.y - b.y));
}

const char* handleName(SignalHandle handle) {
  constexpr const char* kNames[] = {"delay", "attack", "on", "release", "period", "depth", "rate"};
  return kNames[static_cast<std::size_t>(handle)];
}

bool isUpright(SignalHandle handle) {
  return handle == SignalHandle::Depth;
}

}  // namespace

/// How times and factors lie on the screen.
struct CurveEditor::View {
  ImVec2 min, max;
  const TimeAxis& axis;
  double top;
  ImDrawList& list;

  [[nodiscard]] float x(double time) const { return min.x + float(axis.part(time)) * (max.x - min.x); }
  // What lies at 0 can be seen and grabbed in full.
  [[nodiscard]] float zero() const { return max.y - scaled(7); }
  [[nodiscard]] float y(double factor) const { return zero() - float(factor / top) * (zero() - min.y); }
  [[nodiscard]] ImVec2 at(double time, double factor) const { return {x(time), y(factor)}; }
  [[nodiscard]] double time(float px) const { return axis.timeAt(double((px - min.x) / (max.x - min.x))); }
  [[nodiscard]] double factor(float py) const { return top * double((zero() - py) / (zero() - min.y)); }
  [[nodiscard]] double secondsOf(double pixels) const { return pixels * axis.seconds / double(max.x - min.x); }
  [[nodiscard]] double factorsOf(double pixels) const { return pixels * top / double(zero() - min.y); }
};

TimeAxis CurveEditor::frameOf(const Signal& signal) {
  const double delay = double(signal.delay);
  switch (signal.kind) {
    case SignalKind::Constant:
      break;
    case SignalKind::Pulse:
      return framed(0, delay + double(std::max(signal.period, signal.on + signal.release)));
    case SignalKind::Gusts:
      return framed(0, delay + double(signal.attack) + 8 / double(signal.rate));
    case SignalKind::Curve:
      if (signal.keys.empty()) break;
      return framed(0, delay + (signal.loop ? curvePeriod(signal) : double(signal.keys.back().time)));
  }
  return framed(0, delay + std::max(4.0, 4 * double(signal.attack)));
}

void CurveEditor::follow(const Workspace& workspace, Id root) {
  if (root != m_root) m_selected.clear();
  m_root = root;
  const std::size_t count = signalOf(workspace.document.project(), root).keys.size();
  std::erase_if(m_selected, [&](std::size_t key) { return key >= count; });
}

bool CurveEditor::selected(std::size_t key) const {
  return std::ranges::binary_search(m_selected, key);
}

void CurveEditor::drawGrid(const View& view) const {
  const Palette& palette = look().palette;
  view.list.AddRectFilled(view.min, view.max, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(2));
  const double step = std::max(0.25, tickStep(view.factorsOf(double(scaled(22)))));
  for (double value = 0; value <= view.top && value <= double(kMaxSignalKeyValue); value += step) {
    const float y = view.y(value);
    view.list.AddLine({view.min.x, y}, {view.max.x, y}, packed(palette.muted, value == 1 ? 0.5f : 0.22f));
    if (y - view.min.y < ImGui::GetFontSize()) continue;
    const std::string text = shortest(value) + "x";
    view.list.AddText(look().small, look().small->FontSize,
                      {view.min.x + scaled(3), y - look().small->FontSize - scaled(1)}, packed(palette.muted),
                      text.c_str());
  }
}

void CurveEditor::drawCourse(const View& view, const Signal& signal) const {
  const Palette& palette = look().palette;
  std::vector<ImVec2> line;
  const float step = scaled(1.5f);
  for (float x = view.min.x; x <= view.max.x; x += step) {
    const double time = view.time(x);
    if (time >= 0) line.push_back({x, view.y(double(signalAt(signal, time)))});
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    view.list.AddRectFilled({line[i].x, std::min(line[i].y, view.zero())}, {line[i + 1].x, view.zero()},
                            packed(palette.accent, 0.18f));
  view.list.AddPolyline(line.data(), int(line.size()), packed(palette.accent), ImDrawFlags_None, scaled(2));
}

void CurveEditor::drawKeys(const View& view, const Signal& signal) {
  m_shown.clear();
  if (signal.kind != SignalKind::Curve) return;
  const Palette& palette = look().palette;
  const double period = curvePeriod(signal), delay = double(signal.delay);
  const double first = period > 0 ? std::max(0.0, std::floor((view.axis.from - delay) / period)) : 0;
  const double most = view.secondsOf(double(scaled(4)));  // rounds narrower than this are no places to click
  for (double round = first; round == first || (period > most && delay + round * period <= view.axis.to()); ++round) {
    for (std::size_t k = 0; k < signal.keys.size(); ++k) {
      const ImVec2 at = view.at(delay + round * period + double(signal.keys[k].time), double(signal.keys[k].value));
      const float size = scaled(selected(k) ? 5.5f : 4.5f);
      if (at.x < view.min.x - size || at.x > view.max.x + size) continue;
      m_shown.push_back({k, at});
      const float alpha = round == first ? 1.0f : 0.55f;
      const ImU32 fill = packed(selected(k) ? palette.warning : palette.text, alpha);
      if (signal.keys[k].easing == Easing::Smooth)
        view.list.AddCircleFilled(at, size, fill);
      else if (signal.keys[k].easing == Easing::Hold)
        view.list.AddRectFilled({at.x - size, at.y - size}, {at.x + size, at.y + size}, fill);
      else
        view.list.AddQuadFilled({at.x - size, at.y}, {at.x, at.y - size}, {at.x + size, at.y}, {at.x, at.y + size},
                                fill);
      if (round == first)
        look().map.rectangle("curve/key/" + std::to_string(k), {at.x - size, at.y - size}, {at.x + size, at.y + size});
    }
    if (period <= 0) break;
  }
}

void CurveEditor::drawHandles(const View& view, const Signal& signal) const {
  const Palette& palette = look().palette;
  for (const HandlePlace& place : handlesOf(signal, m_around)) {
    const ImVec2 at = view.at(place.time, place.factor);
    if (at.x < view.min.x - 1 || at.x > view.max.x + 1) continue;
    const float size = scaled(4);
    const bool grabbed = m_drag == Drag::Handle && m_handle == place.handle;
    const ImU32 colour = packed(grabbed ? palette.warning : palette.text);
    if (isUpright(place.handle))
      view.list.AddLine({at.x - scaled(14), at.y}, {at.x + scaled(14), at.y}, packed(palette.text, 0.5f));
    else
      view.list.AddLine({at.x, view.y(0)}, {at.x, view.y(1)}, packed(palette.text, 0.35f));
    view.list.AddCircleFilled(at, size, packed(palette.panel));
    view.list.AddCircle(at, size, colour, 0, scaled(2));
    look().map.rectangle(std::string("curve/handle/") + handleName(place.handle), {at.x - size, at.y - size},
                         {at.x + size, at.y + size});
  }
}

void CurveEditor::draw(Workspace& workspace, Id root, ImVec2 min, ImVec2 max, const TimeAxis& axis) {
  follow(workspace, root);
  const Signal signal = signalOf(workspace.document.project(), root);
  if (m_drag == Drag::None) {
    m_top = std::clamp(greatestOf(signal) * 1.25, kLeastTop, kMostTop);
    m_around = std::max(axis.from, 0.0);
  }
  ImGui::SetCursorScreenPos(min);
  ImGui::InvisibleButton("curve", {max.x - min.x, max.y - min.y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  look().map.rectangle("curve/area", min, max);
  m_hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(min, max, true);
  const View view{min, max, axis, m_top, list};
  drawGrid(view);
  drawCourse(view, signal);
  drawHandles(view, signal);
  drawKeys(view, signal);
  takeMouse(workspace, view);
  if (m_drag == Drag::Box && m_moved) {
    const ImVec2 to = ImGui::GetIO().MousePos;
    list.AddRectFilled(m_pressedAt, to, packed(look().palette.accent, 0.2f));
    list.AddRect(m_pressedAt, to, packed(look().palette.accent));
  }
  list.PopClipRect();
  drawMenu(workspace);
  look().map.fact("curve.keys", std::to_string(signal.keys.size()));
  look().map.fact("curve.selected", std::to_string(m_selected.size()));
}

std::optional<CurveEditor::Shown> CurveEditor::keyNear(ImVec2 at) const {
  std::optional<Shown> best;
  double least = double(scaled(kHitPx));
  for (const Shown& shown : m_shown) {
    // A selected key wins where several lie together.
    const double away = distance(shown.at, at) - (selected(shown.key) ? 1 : 0);
    if (away > least) continue;
    least = away;
    best = shown;
  }
  return best;
}

void CurveEditor::takeMouse(Workspace& workspace, const View& view) {
  const Signal signal = signalOf(workspace.document.project(), m_root);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  if (m_hovered && m_drag == Drag::None) {
    if (const auto shown = keyNear(mouse)) {
      const SignalKey& key = signal.keys[shown->key];
      ImGui::SetTooltip("%s s   %sx   %s", fixed(double(key.time + signal.delay), 2).c_str(),
                        fixed(double(key.value), 2).c_str(), std::string(kEasings[std::size_t(key.easing)]).c_str());
    } else {
      for (const HandlePlace& place : handlesOf(signal, m_around))
        if (distance(view.at(place.time, place.factor), mouse) < double(scaled(kHitPx)))
          ImGui::SetTooltip("%s", handleText(signal, place.handle).c_str());
    }
  }
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
    if (m_drag != Drag::None) return cancel(workspace);
    m_menuAt = {float(view.time(mouse.x)), float(view.factor(mouse.y))};
    if (const auto shown = keyNear(mouse)) {
      if (!selected(shown->key)) m_selected = {shown->key};
      ImGui::OpenPopup("curve/menu");
    } else {
      m_selected.clear();
      ImGui::OpenPopup("curve/menu");
    }
    return;
  }
  if (ImGui::IsItemClicked(ImGuiMouseButton_Left)) press(workspace, view, signal);
  if (m_drag == Drag::None) return;
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return dragTo(workspace, view);
  letGo(workspace, view);
}

void CurveEditor::press(Workspace& workspace, const View& view, const Signal& signal) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  m_pressedAt = mouse;
  m_moved = false;
  ++m_gesture;
  if (const auto shown = keyNear(mouse)) return pressKey(shown->key);
  const HandlePlace* nearest = nullptr;
  double least = double(scaled(kHitPx));
  const std::vector<HandlePlace> handles = handlesOf(signal, m_around);
  for (const HandlePlace& place : handles) {
    const double away = distance(view.at(place.time, place.factor), mouse);
    if (away > least) continue;
    least = away;
    nearest = &place;
  }
  if (nearest) {
    m_drag = Drag::Handle;
    m_handle = nearest->handle;
    m_grabTime = nearest->time;
    m_grabValue = nearest->factor;
    return;
  }
  const double curve = double(signalAt(signal, view.time(mouse.x)));
  const bool onCurve = std::abs(double(view.y(curve) - mouse.y)) < double(scaled(kNearCurvePx));
  const bool add = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || onCurve;
  if (add && addKey(workspace, view, mouse)) return;
  m_drag = Drag::Box;
  if (!ImGui::GetIO().KeyShift && !ImGui::GetIO().KeyCtrl) m_selected.clear();
}

void CurveEditor::pressKey(std::size_t key) {
  const ImGuiIO& io = ImGui::GetIO();
  m_drag = Drag::Keys;
  m_grabbed = key;
  if (io.KeyCtrl && !io.KeyShift && selected(key)) {
    std::erase(m_selected, key);
    m_drag = Drag::Ended;
  } else if (!selected(key)) {
    if (!io.KeyShift && !io.KeyCtrl) m_selected.clear();
    m_selected.insert(std::ranges::upper_bound(m_selected, key), key);
  }
}

bool CurveEditor::addKey(Workspace& workspace, const View& view, ImVec2 at) {
  const double delay = double(signalOf(workspace.document.committed(), m_root).delay);
  AddKeyResult added = addKeyEdit(workspace.document.committed(), m_root, view.time(at.x) - delay, view.factor(at.y));
  if (added.edit.steps.empty()) return false;
  apply(workspace, std::move(added.edit));
  m_selected = {added.index};
  m_grabbed = added.index;
  m_drag = Drag::Keys;
  return true;
}

void CurveEditor::apply(Workspace& workspace, Edit edit) {
  edit.mergeKey = "curve:" + std::to_string(m_gesture);
  workspace.apply(edit);
}

void CurveEditor::dragTo(Workspace& workspace, const View& view) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  m_moved = m_moved || distance(mouse, m_pressedAt) > double(scaled(kDragPx));
  if (!m_moved) return;
  if (m_drag == Drag::Keys) dragKeys(workspace, view);
  if (m_drag != Drag::Handle) return;
  double time = m_grabTime + view.secondsOf(double(mouse.x - m_pressedAt.x));
  if (workspace.toolSettings.snap.grid != ImGui::GetIO().KeyCtrl) {
    const double step = tickStep(view.secondsOf(double(scaled(float(kSnapPx)))));
    time = std::round(time / step) * step;
  }
  const double factor = m_grabValue - view.factorsOf(double(mouse.y - m_pressedAt.y));
  const Signal base = signalOf(workspace.document.committed(), m_root);
  const Status shown = workspace.document.preview(
      putSignalEdit(withHandleAt(base, m_handle, m_around, time, factor), "Set " + std::string(handleName(m_handle))));
  if (!shown) cancel(workspace);
  ImGui::SetTooltip("%s", handleText(signalOf(workspace.document.project(), m_root), m_handle).c_str());
}

void CurveEditor::dragKeys(Workspace& workspace, const View& view) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Signal base = signalOf(workspace.document.committed(), m_root);
  if (m_grabbed >= base.keys.size()) return cancel(workspace);
  const SignalKey& key = base.keys[m_grabbed];
  double time = double(key.time) + view.secondsOf(double(mouse.x - m_pressedAt.x));
  double value = double(key.value) - view.factorsOf(double(mouse.y - m_pressedAt.y));
  if (workspace.toolSettings.snap.grid != ImGui::GetIO().KeyCtrl) {
    const double step = tickStep(view.secondsOf(double(scaled(float(kSnapPx)))));
    time = std::round(time / step) * step;
    const double valueStep = tickStep(view.factorsOf(double(scaled(float(kSnapPx)))));
    value = std::round(value / valueStep) * valueStep;
  }
  const Edit edit = moveKeysEdit(workspace.document.committed(), m_root, m_selected, time - double(key.time),
                                 value - double(key.value));
  if (const Status shown = workspace.document.preview(edit); !shown) return cancel(workspace);
  const Signal now = signalOf(workspace.document.project(), m_root);
  ImGui::SetTooltip("%s s   %sx", fixed(double(now.keys[m_grabbed].time + now.delay), 2).c_str(),
                    fixed(double(now.keys[m_grabbed].value), 2).c_str());
}

void CurveEditor::letGo(Workspace& workspace, const View& view) {
  if (m_drag == Drag::Box && m_moved) selectBox(view);
  const bool changed = (m_drag == Drag::Keys || m_drag == Drag::Handle) && m_moved && workspace.document.previewing();
  if (m_drag == Drag::Keys && !m_moved && !ImGui::GetIO().KeyShift && !ImGui::GetIO().KeyCtrl)
    m_selected = {m_grabbed};  // a click on one of several
  const std::string label = m_drag == Drag::Handle   ? "Set " + std::string(handleName(m_handle))
                            : m_selected.size() == 1 ? "Move key"
                                                     : "Move " + std::to_string(m_selected.size()) + " keys";
  m_drag = Drag::None;
  if (!changed) return;
  const Signal signal = signalOf(workspace.document.project(), m_root);
  workspace.document.endPreview();
  apply(workspace, putSignalEdit(signal, label));
  workspace.document.seal();
}

void CurveEditor::selectBox(const View&) {
  const ImVec2 to = ImGui::GetIO().MousePos;
  const float left = std::min(m_pressedAt.x, to.x), right = std::max(m_pressedAt.x, to.x);
  const float top = std::min(m_pressedAt.y, to.y), bottom = std::max(m_pressedAt.y, to.y);
  for (const Shown& shown : m_shown) {
    const bool inside = shown.at.x >= left && shown.at.x <= right && shown.at.y >= top && shown.at.y <= bottom;
    if (inside && !selected(shown.key)) m_selected.insert(std::ranges::upper_bound(m_selected, shown.key), shown.key);
  }
}

void CurveEditor::cancel(Workspace& workspace) {
  if (m_drag == Drag::Keys || m_drag == Drag::Handle) workspace.document.endPreview();
  if (m_drag != Drag::None) m_drag = ImGui::IsMouseDown(ImGuiMouseButton_Left) ? Drag::Ended : Drag::None;
}

bool CurveEditor::keyPressed(const KeyPress& press, Workspace& workspace) {
  if (press.key == Key::Escape && dragging()) {
    cancel(workspace);
    return true;
  }
  // Nothing but playing may come between a drag and its keys: Del would take the tree whose curve this is.
  if (dragging()) return press.key != Key::Space;
  if (!m_hovered || press.modifiers.any()) return false;
  const Signal signal = signalOf(workspace.document.committed(), m_root);
  if (signal.kind != SignalKind::Curve) return false;
  if (press.key == Key::Delete || press.key == Key::X) {
    if (m_selected.empty()) return true;  // one Del too many must not reach the tree either
    ++m_gesture;
    apply(workspace, eraseKeysEdit(workspace.document.committed(), m_root, m_selected));
    m_selected.clear();
    return true;
  }
  if (press.key == Key::A) {
    m_selected.clear();
    for (std::size_t k = 0; k < signal.keys.size(); ++k) m_selected.push_back(k);
    return true;
  }
  if (press.key != Key::Escape || m_selected.empty()) return false;
  m_selected.clear();
  return true;
}

}  // namespace windloom::editor
