#include "editor/panels/export_panel.hpp"

#include "editor/core/kept_files.hpp"
#include "editor/core/size_text.hpp"
#include "editor/panels/export_formats.hpp"
#include "editor/panels/export_rows.hpp"
#include "editor/widgets/icons.hpp"
#include "editor/widgets/number_field.hpp"
#include "editor/widgets/parameter_row.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"

namespace windloom::editor {
namespace {

bool section(const char* title) {
  ImGui::PushFont(look().strong);
  const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopFont();
  markItem(std::string("export/section/") + title);
  return open;
}

/// Two buttons share a row.
float halfWidth() {
  return (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
}

}  // namespace

void ExportPanel::readPreferences(const Preferences& preferences) {
  m_choices = exportChoices(preferences);
  m_share.read(preferences);
}

void ExportPanel::keepPreferences(Preferences& preferences) const {
  keepExportChoices(preferences, m_choices);
  m_share.keep(preferences);
}

std::string ExportPanel::folderFor(const PanelContext& context) const {
  const std::filesystem::path& path = context.workspace.document.path();
  if (std::string chosen = exportFolder(context.workspace.preferences, path.string()); !chosen.empty()) return chosen;
  if (path.empty() || !whyKept(path).empty()) return {};
  std::string stem = path.filename().string();
  stem = stem.substr(0, stem.find('.'));
  return (path.parent_path() / (stem + "-wind")).string();
}

void ExportPanel::drawFolderRow(PanelContext& context) {
  rowLabel("Folder", "Where the files go. Empty: a folder beside the project.");
  Preferences& preferences = context.workspace.preferences;
  const std::string project = context.workspace.document.path().string(), there = folderFor(context);
  const std::string hint = there.empty() ? std::string() : std::filesystem::path(there).filename().string();
  std::string folder = exportFolder(preferences, project);
  if (textField("export/folder", folder, hint.c_str())) keepExportFolder(preferences, project, folder);
  if (!there.empty() && ImGui::IsItemHovered()) wrappedTooltip(there);
}

void ExportPanel::drawSettings(PanelContext& context, const BakeHeader& header, const BakeRequest& request) {
  if (beginRows("export")) {
    drawPresetRow(m_choices);
    drawFolderRow(context);
    endRows();
  }
  if (section("Formats")) {
    drawFormats(m_choices, header, request);
    drawFormatWarnings(warningsOf(header, request));
    if (hasFullScale(request)) m_clipping.draw();
  }
  if (section("Recording") && beginRows("recording")) {
    drawRecordingRows(m_choices, context.project());
    endRows();
  }
  if (section("Contents") && beginRows("contents")) {
    drawContentRows(m_choices, request);
    endRows();
  }
}

void ExportPanel::drawLiveLink() {
  if (!section("Live link")) return;
  if (beginRows("live")) {
    rowLabel("Share", "A game on this machine sees the wind as it blows here, without files (windloom_live).");
    bool on = m_share.on();
    if (ImGui::Checkbox("##share", &on)) m_share.setOn(on);
    markItem("export/live");
    rowLabel("Name", "What the game asks for.");
    std::string name = m_share.name();
    if (textField("export/live_name", name)) m_share.setName(name);
    endRows();
  }
  const std::string state = m_share.state();
  if (state.empty()) return;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(m_share.failed() ? look().palette.error : look().palette.good, "%s", state.c_str());
  ImGui::PopTextWrapPos();
}

void ExportPanel::drawTotal(PanelContext& context, const BakeHeader& header, const BakeRequest& request) {
  const glm::ivec2 cells = header.grid.resolution;
  const ExportSize size = sizeOf(header, request);
  std::string text = std::to_string(header.frames) + " frames of " + std::to_string(cells.x) + " x " +
                     std::to_string(cells.y) + "\n" + sizeText(size);
  const std::string folder = folderFor(context);
  const std::optional<double> room = folder.empty() ? std::nullopt : m_freeSpace.of(folder);
  if (room) text += " of " + bytesText(*room) + " free";
  const bool tooMuch = room && size.bytes > *room;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(tooMuch ? look().palette.error : look().palette.muted, "%s", text.c_str());
  ImGui::PopTextWrapPos();
  markItem("export/total");
  drawWarningSign(warningsOf(header, request));
  look().map.fact("export.total", text);
}

void ExportPanel::drawProgress() {
  const ExportRun::Progress progress = m_run.progress();
  std::string text = progress.phase == BakePhase::Recording ? "recording " : "writing ";
  text += fixed(progress.part * 100, 0) + "%";
  if (progress.leftSeconds) text += ", about " + durationText(*progress.leftSeconds) + " left";
  ImGui::ProgressBar(float(progress.part), {-1, 0}, text.c_str());
  if (ImGui::IsItemHovered()) wrappedTooltip(progress.onGpu ? "Runs on the GPU." : "Runs on the processor.");
  markItem("export/progress");
  ImGui::BeginDisabled(progress.cancelling);
  if (ImGui::Button(progress.cancelling ? "Cancelling..." : "Cancel", {-1, 0})) {
    m_run.cancel();
    // Who cancels doesn't want it begun again by the next edit.
    m_last.reset();
    m_repeat.forget();
  }
  ImGui::EndDisabled();
  markItem("export/cancel");
}

void ExportPanel::drawOutcome(PanelContext& context) {
  if (!m_outcome) return;
  using Kind = ExportRun::Outcome::Kind;
  const Palette& palette = look().palette;
  const Kind kind = m_outcome->kind;
  ImGui::PushTextWrapPos(0);
  ImGui::TextColored(kind == Kind::Failed ? palette.error
                     : kind == Kind::Done ? palette.good
                                          : palette.muted,
                     "%s", m_outcome->text.c_str());
  ImGui::PopTextWrapPos();
  markItem("export/outcome");
  if (kind != Kind::Done) return;
  const float width = halfWidth();
  if (ImGui::Button("Open folder", {width, 0})) {
    if (const Status opened = m_opener.open(m_outcome->folder); !opened)
      context.workspace.say(MessageKind::Error, opened.error().text());
  }
  markItem("export/open");
  ImGui::SameLine();
  if (ImGui::Button("Copy path", {width, 0})) {
    context.workspace.writeClipboardText(m_outcome->folder.string());
    context.workspace.say(MessageKind::Info, "Copied " + m_outcome->folder.string());
  }
  markItem("export/copy");
}

void ExportPanel::drawRun(PanelContext& context, const BakeRequest& request) {
  if (running()) {
    drawProgress();
  } else {
    const bool ready = !request.formats.empty() && !folderFor(context).empty();
    ImGui::BeginDisabled(!ready);
    if (ImGui::Button("Export", {-1, 0})) start(context, request);
    ImGui::EndDisabled();
    markItem("export/start");
    if (!ready) {
      ImGui::PushTextWrapPos(0);
      ImGui::TextDisabled(request.formats.empty() ? "Choose at least one format."
                                                  : "Save the project first, in a folder of yours, or type a folder.");
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::Checkbox("Export again after changes", &m_choices.again);
  markItem("export/again");
  look().map.fact("export/again", m_choices.again ? "yes" : "no");
  if (ImGui::IsItemHovered())
    wrappedTooltip("The last export is done again 2 s after an edit, so that a game that follows the folder sees it.");
  if (!running()) drawOutcome(context);
}

void ExportPanel::draw(PanelContext& context) {
  m_drawnFrame = ImGui::GetFrameCount();
  const BakeRequest request = bakeRequest(m_choices, context.project());
  const BakeHeader header = headerOf(context.project(), request);
  // What starts it stays in sight, whatever is open above.
  ImGui::BeginChild("settings", {0, -m_footerHeight});
  ImGui::BeginDisabled(running());
  drawSettings(context, header, request);
  ImGui::EndDisabled();
  drawLiveLink();
  ImGui::EndChild();
  const float top = ImGui::GetCursorPosY();
  ImGui::Separator();
  drawTotal(context, header, request);
  drawRun(context, request);
  // Rounding must not make the panel around it scroll.
  m_footerHeight = ImGui::GetCursorPosY() - top + scaled(2);
  look().map.fact("export.running", running() ? "yes" : "no");
  look().map.fact("export.ended", std::to_string(m_ended));
  look().map.fact("export.outcome", m_outcome ? m_outcome->text : "");
}

void ExportPanel::start(PanelContext& context, BakeRequest request) {
  const Document& document = context.workspace.document;
  request.folder = folderFor(context);
  m_outcome.reset();
  ExportRun::Job job{document.committed(), std::move(request), {}};
  if (m_choices.ownWarmUp) job.warmUp = m_choices.warmUp;
  m_last = Last{job, document.path()};
  m_repeat.doneAt(document.editCount());
  m_run.start(std::move(job));
}

/// The last export once more, where the project changed and nothing else is under way.
void ExportPanel::repeat(PanelContext& context) {
  const Document& document = context.workspace.document;
  if (m_last && m_last->project != document.path()) {
    m_last.reset();
    m_repeat.forget();
  }
  if (!m_choices.again || !m_last || running() || document.previewing()) return;
  if (!m_repeat.due(document.editCount(), ImGui::GetTime())) return;
  m_outcome.reset();
  m_last->job.project = document.committed();
  m_run.start(m_last->job);
}

void ExportPanel::poll(PanelContext& context) {
  if (const auto problem = m_opener.poll()) context.workspace.say(MessageKind::Error, problem->text());
  if (auto outcome = m_run.poll()) {
    const bool failed = outcome->kind == ExportRun::Outcome::Kind::Failed;
    if (failed)
      logError(outcome->text);
    else
      logInfo(outcome->text);
    context.workspace.say(failed ? MessageKind::Error : MessageKind::Info, outcome->text);
    m_outcome = std::move(*outcome);
    ++m_ended;
  }
  repeat(context);
}

void ExportPanel::follow(PanelContext& context) {
  const double now = ImGui::GetTime();
  const glm::bvec2 wraps = wrapsOf(*context.project().field);
  m_share.update(context.session, {wraps.x, wraps.y}, now);
  look().map.fact("live", m_share.state());
  const bool shown = m_drawnFrame == ImGui::GetFrameCount();
  if (shown && context.session && hasFullScale(bakeRequest(m_choices, context.project())))
    m_clipping.sample(*context.session, now, m_choices.ownFullScale ? float(m_choices.fullScale) : 0.0f);
}

}  // namespace windloom::editor
