#include "editor/panels/export_panel.hpp"

#include <algorithm>
#include <cmath>

#include "editor/widgets/icons.hpp"
#include "editor/widgets/number_field.hpp"
#include "editor/widgets/parameter_row.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {

namespace {

std::string bytesText(double bytes) {
  static constexpr const char* kUnits[] = {"bytes", "kB", "MB", "GB", "TB"};
  std::size_t unit = 0;
  while (bytes >= 1000 && unit + 1 < std::size(kUnits)) {
    bytes /= 1000;
    ++unit;
  }
  return fixed(bytes, unit == 0 || bytes >= 100 ? 0 : 1) + " " + kUnits[unit];
}

std::string secondsText(double seconds) {
  if (seconds < 90) return fixed(std::ceil(seconds), 0) + " s";
  return fixed(seconds / 60, 0) + " min";
}

void label(const char* text, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
}

void number(const char* name, double& value, double fallback, const NumberFormat& format) {
  const NumberEdit edit = numberField(name, value, false, format);
  if (edit.changed) value = std::clamp(edit.value, format.min, format.max);
  if (edit.reset) value = fallback;
}

}  // namespace

ExportPanel::ExportPanel() {
  // What games read: a picture for shaders and the pack of our runtime.
  for (const char* name : {"png", "windpack"})
    if (writerKindNamed(name)) m_formats.insert(name);
}

ExportPanel::~ExportPanel() {
  m_cancel = true;
  if (m_worker.joinable()) m_worker.join();
}

std::string ExportPanel::folderFor(const PanelContext& context) const {
  if (!m_folder.empty()) return m_folder;
  const std::filesystem::path& path = context.workspace.document.path();
  if (path.empty()) return {};
  std::string stem = path.filename().string();
  stem = stem.substr(0, stem.find('.'));
  return (path.parent_path() / (stem + "-wind")).string();
}

BakeRequest ExportPanel::request(const Project& project) const {
  BakeRequest request;
  for (const WriterKind& kind : writerKinds())
    if (m_formats.contains(kind.name)) request.formats.push_back(&kind);
  request.plan.from = m_from;
  request.plan.fps = m_fps;
  request.plan.frames = std::clamp(int(std::lround(m_seconds * m_fps)), 1, kMaxBakeFrames);
  request.loop = m_loop;
  if (m_loop) request.plan.crossfade = crossfadeFor(request.plan.frames);
  if (!m_fullResolution && m_resolution != project.field->resolution) request.resolution = m_resolution;
  request.preset = m_preset;
  return request;
}

void ExportPanel::drawFormats() {
  for (const WriterKind& kind : writerKinds()) {
    const std::string name(kind.name);
    bool on = m_formats.contains(name);
    if (ImGui::Checkbox(name.c_str(), &on)) {
      if (on)
        m_formats.insert(name);
      else
        m_formats.erase(name);
    }
    markItem("export/format/" + name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(kind.help).c_str());
  }
}

void ExportPanel::drawSettings(PanelContext& context) {
  if (!beginRows("export")) return;
  label("Folder", "Where the files go. Empty: a folder beside the project.");
  textField("export/folder", m_folder, folderFor(context).c_str());
  label("For", "Axes, units and row order of the game engine.");
  if (ImGui::BeginCombo("##preset", std::string(rulesOf(m_preset).name).c_str())) {
    for (const PresetRules& rules : presets()) {
      if (ImGui::Selectable(std::string(rules.name).c_str(), rules.preset == m_preset)) m_preset = rules.preset;
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(rules.help).c_str());
    }
    ImGui::EndCombo();
  }
  markItem("export/preset");
  label("Formats", "Every format is written from the same recording.");
  ImGui::BeginGroup();
  drawFormats();
  ImGui::EndGroup();
  label("From", "Time of the first frame; the wind has blown that long before it.");
  number("export/from", m_from, 2, {"s", 0, 3600, 0.5, false});
  label("Length", "Length of the recording.");
  number("export/seconds", m_seconds, 4, {"s", 0, 3600, 0.5, false});
  label("Frames a second", "The game blends between frames: 10 to 15 are enough for wind.");
  number("export/fps", m_fps, 15, {"1/s", 0.1, 240, 1, false});
  label("Loop", "Blends the end into the beginning, so that it can play for ever.");
  ImGui::Checkbox("##loop", &m_loop);
  label("Project's grid",
        "Off: the frames are resampled to the resolution below; the wind itself always runs on the project's grid.");
  ImGui::Checkbox("##full", &m_fullResolution);
  if (!m_fullResolution) {
    label("Resolution", "Cells of a written frame.");
    const float width = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemInnerSpacing.x) / 2;
    for (int i = 0; i < 2; ++i) {
      if (i > 0) ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
      double side = double(m_resolution[i]);
      ImGui::SetNextItemWidth(width);
      number(i == 0 ? "export/width" : "export/height", side, 256, {"", 8, 4096, 8, true});
      m_resolution[i] = int(side);
    }
  }
  endRows();
}

void ExportPanel::drawSize(const PanelContext& context) {
  const Project& project = context.project();
  const BakeRequest wanted = request(project);
  const glm::ivec2 resolution = wanted.resolution.value_or(project.field->resolution);
  double bytes = 0;
  for (const WriterKind* kind : wanted.formats) bytes += double(kind->bytes(headerOf(project, wanted)));
  const int recorded = wanted.plan.frames + wanted.plan.crossfade;
  const double steps = (m_from + recorded / m_fps) / double(project.field->timeStep);
  ImGui::Spacing();
  ImGui::PushTextWrapPos(0);
  ImGui::TextDisabled("%d frames of %d x %d, at most %s; %s solver steps on %d x %d", wanted.plan.frames, resolution.x,
                      resolution.y, bytesText(bytes).c_str(), fixed(steps, 0).c_str(), project.field->resolution.x,
                      project.field->resolution.y);
  ImGui::PopTextWrapPos();
}

void ExportPanel::start(PanelContext& context) {
  BakeRequest wanted = request(context.workspace.document.committed());
  wanted.folder = folderFor(context);
  if (m_worker.joinable()) m_worker.join();
  m_cancel = m_ended = false;
  m_running = true;
  m_part = 0;
  m_phase = BakePhase::Recording;
  m_startedAt = std::chrono::steady_clock::now();
  m_outcome = {};
  m_worker = std::thread([this, project = context.workspace.document.committed(), wanted] { run(project, wanted); });
}

/// The worker: the project is a value, so edits meanwhile don't reach it.
void ExportPanel::run(const Project& project, const BakeRequest& wanted) {
  SimulationOptions options;
  options.backend = Backend::Cpu;
  // One core stays with the window.
  options.threads = std::max(1, int(std::thread::hardware_concurrency()) - 1);
  const auto finished = [&]() -> Result<BakeReport> {
    auto simulation = Simulation::create(project, options);
    if (!simulation) return simulation.error();
    return bake(**simulation, wanted, [this](const BakeProgress& progress) {
      m_phase = progress.phase;
      m_part = progress.part;
      return !m_cancel;
    });
  }();
  Outcome outcome;
  if (!finished)
    outcome = {true, finished.error().text()};
  else if (finished->cancelled)
    outcome = {false, "Export cancelled; nothing was written."};
  else
    outcome = {false, "Exported " + std::to_string(finished->files.size()) + " files, " +
                          bytesText(double(finished->bytes)) + ", to " + wanted.folder.string()};
  {
    const std::lock_guard lock(m_mutex);
    m_outcome = std::move(outcome);
  }
  m_ended = true;
}

void ExportPanel::poll(PanelContext& context) {
  if (!m_ended) return;
  m_worker.join();
  m_running = m_ended = false;
  const std::lock_guard lock(m_mutex);
  if (m_outcome.failed)
    logError(m_outcome.text);
  else
    logInfo(m_outcome.text);
  context.workspace.say(m_outcome.failed ? MessageKind::Error : MessageKind::Info, m_outcome.text);
}

void ExportPanel::drawProgress() {
  const double part = m_part,
               elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - m_startedAt).count();
  const bool recording = m_phase == BakePhase::Recording;
  std::string text = std::string(recording ? "recording " : "writing ") + fixed(part * 100, 0) + "%";
  // The estimate is for the recording: it takes nearly all of the time.
  if (recording && part > 0.02) text += ", about " + secondsText(elapsed * (1 - part) / part) + " left";
  ImGui::ProgressBar(float(part), {-1, 0}, text.c_str());
  markItem("export/progress");
  ImGui::BeginDisabled(m_cancel);
  if (ImGui::Button("Cancel", {-1, 0})) m_cancel = true;
  ImGui::EndDisabled();
  markItem("export/cancel");
}

void ExportPanel::draw(PanelContext& context) {
  ImGui::BeginDisabled(m_running);
  drawSettings(context);
  drawSize(context);
  ImGui::EndDisabled();
  ImGui::Spacing();
  if (m_running) return drawProgress();
  const bool ready = !m_formats.empty() && !folderFor(context).empty();
  ImGui::BeginDisabled(!ready);
  if (ImGui::Button("Export", {-1, 0})) start(context);
  ImGui::EndDisabled();
  markItem("export/start");
  ImGui::PushTextWrapPos(0);
  if (m_formats.empty()) ImGui::TextDisabled("Choose at least one format.");
  if (folderFor(context).empty()) ImGui::TextDisabled("Save the project first, or type a folder.");
  if (!m_outcome.text.empty())
    ImGui::TextColored(m_outcome.failed ? look().palette.error : look().palette.good, "%s", m_outcome.text.c_str());
  ImGui::PopTextWrapPos();
}

}  // namespace windloom::editor
