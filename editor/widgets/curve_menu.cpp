// The menu of a right click on a curve.
#include "editor/widgets/curve_editor.hpp"
#include "editor/widgets/number_field.hpp"
#include "engine/model/signal_curve.hpp"
#include "engine/model/validate.hpp"

namespace windloom::editor {

void CurveEditor::drawMenu(Workspace& workspace) {
  if (!ImGui::BeginPopup("curve/menu")) return;
  const Project& project = workspace.document.committed();
  const Signal signal = signalOf(project, m_root);
  ++m_gesture;
  if (!m_selected.empty()) {
    drawKeyMenu(workspace, signal);
  } else if (signal.kind == SignalKind::Curve) {
    if (ImGui::MenuItem("Add key here")) {
      AddKeyResult added = addKeyEdit(project, m_root, double(m_menuAt.x - signal.delay), double(m_menuAt.y));
      if (!added.edit.steps.empty()) apply(workspace, std::move(added.edit));
    }
    if (ImGui::MenuItem("Select all keys", "A", false, !signal.keys.empty()))
      for (std::size_t k = 0; k < signal.keys.size(); ++k) m_selected.push_back(k);
  } else if (ImGui::MenuItem("Convert to curve")) {
    apply(workspace, convertToCurveEdit(project, m_root));
  }
  ImGui::EndPopup();
}

void CurveEditor::drawKeyMenu(Workspace& workspace, const Signal& signal) {
  const Project& project = workspace.document.committed();
  constexpr const char* kLabels[] = {"Straight to the next key", "Smooth to the next key", "Hold until the next key"};
  for (std::size_t e = 0; e < kEasings.size(); ++e) {
    bool all = true;
    for (const std::size_t key : m_selected) all = all && signal.keys[key].easing == static_cast<Easing>(e);
    if (ImGui::MenuItem(kLabels[e], nullptr, all)) {
      Edit edit = easeKeysEdit(project, m_root, m_selected, static_cast<Easing>(e));
      if (!edit.steps.empty()) apply(workspace, std::move(edit));
    }
    markItem("curve/menu/" + std::string(kEasings[e]));
  }
  ImGui::Separator();
  if (m_selected.size() == 1) {
    const SignalKey& key = signal.keys[m_selected.front()];
    const auto field = [&](const char* label, const char* name, double value, const NumberFormat& format) {
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted(label);
      ImGui::SameLine(scaled(60));
      ImGui::SetNextItemWidth(scaled(110));
      return numberField(name, value, false, format);
    };
    const NumberEdit time = field("Time", "curve/menu/time", double(key.time), {"s", 0, kMaxSignalKeyTimeS, 0.05});
    const NumberEdit value = field("Value", "curve/menu/value", double(key.value), {"", 0, kMaxSignalKeyValue, 0.02});
    for (const std::string& problem : {time.problem, value.problem})
      if (!problem.empty()) workspace.say(MessageKind::Error, problem);
    if (time.changed || value.changed) {
      Result<Edit> edit =
          placeKeyEdit(project, m_root, m_selected.front(), time.changed ? time.value : double(key.time),
                       value.changed ? value.value : double(key.value));
      if (edit) edit->mergeKey = "curve:typed";
      workspace.apply(edit);
    }
    if (time.finished || value.finished) workspace.document.seal();
    ImGui::Separator();
  }
  if (ImGui::MenuItem(m_selected.size() == 1 ? "Delete key" : "Delete keys", "Del")) {
    apply(workspace, eraseKeysEdit(project, m_root, m_selected));
    m_selected.clear();
  }
}

}  // namespace windloom::editor
