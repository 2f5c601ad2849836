#include "editor/panels/solver_panel.hpp"

#include <cstdio>
#include <string>

#include "editor/widgets/look.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

namespace {

/// Three digits whatever the size: divergences span many orders of magnitude.
std::string threeDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

void row(const std::string& name, const std::string& value, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(value.c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  look().map.fact("solver." + name, value);
}

void windRows(const SessionStatus& status) {
  const WindDiagnostics& wind = status.wind;
  row("residual",
      wind.divergenceBefore > 0 ? threeDigits(wind.divergenceAfter / wind.divergenceBefore * 100) + "%" : "-",
      "Part of the divergence that the pressure solve left");
  row("divergence before", threeDigits(wind.divergenceBefore) + " 1/s",
      "RMS over the air cells, before the projection");
  row("divergence after", threeDigits(wind.divergenceAfter) + " 1/s", "RMS over the air cells, after the projection");
  row("worst cell before", threeDigits(wind.maxDivergenceBefore) + " 1/s", "Largest divergence of a cell before it");
  row("worst cell after", threeDigits(wind.maxDivergenceAfter) + " 1/s", "Largest divergence of a cell that was left");
  row("cycles", std::to_string(wind.cycles), "Multigrid cycles, or sweeps of the Jacobi scheme, of the step");
  row("kinetic energy", threeDigits(wind.kineticEnergy) + " m^2/s^2", "Half the mean of the squared speed");
  row("fastest air", fixed(wind.maxSpeed, 2) + " m/s", "Fastest cell of the field");
  row("CFL", fixed(wind.cfl, 2) + " cells a step", "How many cells the fastest air crosses in a step");
  std::string broken = std::to_string(wind.nonFiniteCells);
  if (wind.nonFiniteCells > 0)
    broken +=
        " (first at " + std::to_string(wind.firstNonFinite.x) + ", " + std::to_string(wind.firstNonFinite.y) + ")";
  row("cells reset", broken, "Cells that were not finite and were set back since the wind started");
}

void timeRows(const SessionStatus& status) {
  row("step", fixed(status.stepMs, 2) + " ms", "Median of recent steps");
  for (const auto& [stage, ms] : status.wind.stageMs)
    row("  " + stage, fixed(ms, 2) + " ms", "Time of this stage in the last step");
  row("speed of time", fixed(status.timeScale, 2) + " x", "Simulated seconds per second while playing");
}

}  // namespace

void drawSolverPanel(PanelContext& context) {
  if (!context.session) {
    ImGui::TextDisabled("There is no live wind; the log says why.");
    return;
  }
  const SessionStatus& status = context.session->status();
  ImGui::BeginChild("solver");
  if (ImGui::BeginTable("numbers", 2, ImGuiTableFlags_SizingFixedFit)) {
    windRows(status);
    timeRows(status);
    ImGui::EndTable();
  }
  ImGui::EndChild();
}

}  // namespace windloom::editor
