#include "editor/widgets/parameter_row.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/look.hpp"
#include "editor/widgets/number_field.hpp"

namespace windloom::editor {

namespace {

float toSrgb(float linear) {
  return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float toLinear(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

NumberFormat formatOf(const ParameterInfo& info, bool whole) {
  return {info.unit, info.min, info.max, info.step, whole};
}

std::optional<RowChange> changeOf(const NumberEdit& edit, RowChange::Kind kind) {
  RowChange change;
  change.kind = kind;
  change.number = edit.value;
  change.finished = edit.finished;
  if (edit.reset) change.kind = RowChange::Kind::Reset;
  if (!edit.problem.empty()) {
    change.kind = RowChange::Kind::Problem;
    change.problem = edit.problem;
  }
  if (edit.changed || edit.finished || edit.reset || !edit.problem.empty()) return change;
  return std::nullopt;
}

RowChange valueChange(ParameterValue value) {
  RowChange change;
  change.value = std::move(value);
  return change;
}

std::optional<RowChange> numberRow(const InspectorRow& row, const std::string& name) {
  const bool whole = row.info.type == ParameterType::Integer;
  const double shown = whole ? double(std::get<int>(row.value)) : double(std::get<float>(row.value));
  const NumberEdit edit = numberField(name.c_str(), shown, row.mixed, formatOf(row.info, whole));
  std::optional<RowChange> change = changeOf(edit, RowChange::Kind::Value);
  if (change && change->kind == RowChange::Kind::Value) {
    // A drag let go without a last change still ends its undo step: it says the value again.
    const double next = edit.changed ? edit.value : shown;
    change->value =
        whole ? ParameterValue(int(std::clamp(next, -2147483648.0, 2147483647.0))) : ParameterValue(float(next));
  }
  return change;
}

std::optional<RowChange> vectorRow(const InspectorRow& row, const std::string& name) {
  const bool whole = row.info.type == ParameterType::Integer2;
  const int count = row.info.type == ParameterType::Real3 ? 3 : 2;
  double values[3] = {};
  for (int i = 0; i < count; ++i)
    values[i] = whole        ? double(std::get<glm::ivec2>(row.value)[i])
                : count == 3 ? double(std::get<glm::vec3>(row.value)[i])
                             : double(std::get<glm::vec2>(row.value)[i]);
  std::optional<RowChange> result;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap * float(count - 1)) / float(count);
  static constexpr const char* kNames[] = {"/x", "/z", "/w"};
  for (int i = 0; i < count; ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(width);
    const NumberEdit edit =
        numberField((name + kNames[i]).c_str(), values[i], row.mixedComponent[i], formatOf(row.info, whole));
    if (auto change = changeOf(edit, RowChange::Kind::Component)) {
      change->component = i;
      if (!edit.changed) change->number = values[i];
      result = change;
    }
  }
  return result;
}

std::optional<RowChange> choiceRow(const InspectorRow& row, const std::string& name) {
  const int current = std::get<int>(row.value);
  const std::string shown = row.mixed ? "mixed" : std::string(row.info.choices[std::size_t(current)]);
  std::optional<RowChange> change;
  const bool open = ImGui::BeginCombo(("##" + name).c_str(), shown.c_str());
  markItem(name);
  if (open) {
    for (std::size_t i = 0; i < row.info.choices.size(); ++i) {
      const std::string choice(row.info.choices[i]);
      if (ImGui::Selectable(choice.c_str(), !row.mixed && int(i) == current)) change = valueChange(int(i));
      markItem(name + "/" + choice);
    }
    ImGui::EndCombo();
  }
  return change;
}

std::optional<RowChange> switchRow(const InspectorRow& row, const std::string& name) {
  bool on = std::get<bool>(row.value);
  ImGui::PushItemFlag(ImGuiItemFlags_MixedValue, row.mixed);
  const bool pressed = ImGui::Checkbox(("##" + name).c_str(), &on);
  ImGui::PopItemFlag();
  markItem(name);
  if (!pressed) return std::nullopt;
  return valueChange(row.mixed || on);
}

/// Colours are kept linear and picked as they look.
std::optional<RowChange> colourRow(const InspectorRow& row, const std::string& name) {
  const glm::vec3 linear = std::get<glm::vec3>(row.value);
  float srgb[3] = {toSrgb(linear.x), toSrgb(linear.y), toSrgb(linear.z)};
  const bool edited = ImGui::ColorEdit3(("##" + name).c_str(), srgb,
                                        ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_PickerHueWheel);
  const bool finished = ImGui::IsItemDeactivatedAfterEdit();
  markItem(name);
  if (!edited && !finished) return std::nullopt;
  RowChange change = valueChange(edited ? glm::vec3(toLinear(srgb[0]), toLinear(srgb[1]), toLinear(srgb[2])) : linear);
  change.finished = finished;
  return change;
}

std::optional<RowChange> textRow(const InspectorRow& row, const std::string& name) {
  std::string text = row.mixed ? std::string() : std::get<std::string>(row.value);
  if (!textField(name.c_str(), text, row.mixed ? "mixed" : "")) return std::nullopt;
  return valueChange(text);
}

std::optional<RowChange> valueWidget(const InspectorRow& row, const std::string& name) {
  switch (row.info.type) {
    case ParameterType::Real:
    case ParameterType::Integer:
      return numberRow(row, name);
    case ParameterType::Real2:
    case ParameterType::Integer2:
      return vectorRow(row, name);
    case ParameterType::Real3:
      return row.info.label.find("olour") != std::string_view::npos ? colourRow(row, name) : vectorRow(row, name);
    case ParameterType::Choice:
      return choiceRow(row, name);
    case ParameterType::Switch:
      return switchRow(row, name);
    case ParameterType::Text:
      return textRow(row, name);
    case ParameterType::Id:
      break;
  }
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", row.mixed ? "mixed" : toText(row.info, row.value).c_str());
  return std::nullopt;
}

void rowHelp(const InspectorRow& row) {
  if (!ImGui::IsItemHovered() || row.info.help.empty()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(320));
  ImGui::TextUnformatted(row.info.help.data(), row.info.help.data() + row.info.help.size());
  ImGui::PopTextWrapPos();
  const std::string fallback = toText(row.info, row.defaultValue);
  if (row.editable && !fallback.empty()) ImGui::TextDisabled("Default: %s. Right click resets.", fallback.c_str());
  ImGui::EndTooltip();
}

}  // namespace

bool beginRows(const char* name) {
  if (!ImGui::BeginTable(name, 2, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_NoSavedSettings)) return false;
  ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch, 0.42f);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 0.58f);
  return true;
}

void endRows() {
  ImGui::EndTable();
}

void wrappedTooltip(std::string_view text) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(320));
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void rowLabel(const char* label, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  if (help[0] != 0 && ImGui::IsItemHovered()) wrappedTooltip(help);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
}

std::optional<RowChange> parameterRow(const InspectorRow& row, std::string_view prefix) {
  const std::string name = std::string(prefix) + "/" + std::string(row.info.key);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * (row.relevant ? 1.0f : 0.5f));
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(row.info.label.data(), row.info.label.data() + row.info.label.size());
  rowHelp(row);
  const bool labelReset = row.editable && ImGui::IsItemClicked(ImGuiMouseButton_Right);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  ImGui::BeginDisabled(!row.editable);
  std::optional<RowChange> change = valueWidget(row, name);
  const bool widgetReset = row.editable && ImGui::IsItemClicked(ImGuiMouseButton_Right);
  ImGui::EndDisabled();
  ImGui::PopStyleVar();
  if (labelReset || widgetReset) {
    change.emplace();
    change->kind = RowChange::Kind::Reset;
  }
  return change;
}

}  // namespace windloom::editor
