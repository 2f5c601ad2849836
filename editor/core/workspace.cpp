#include "editor/core/workspace.hpp"

#include <algorithm>

#include "editor/core/project_cameras.hpp"
#include "editor/core/refusal.hpp"

namespace windloom::editor {

Workspace::Workspace() {
  flow.onFailure = [this](const Error& error) { say(MessageKind::Error, error.text()); };
  flow.onDone = [this](const std::string& text) { say(MessageKind::Info, text); };
  flow.onReplaced = [this] {
    terrainLoad.cancel();
    assetLoad.cancel();
    followGround();
    selection.clear();
    strokes.clear();
    m_lookedThrough = 0;
    tools.clearHover();
    if (const Camera* opening = openingCamera(document.project())) {
      lookAs(opening->id);
    } else {
      frame({});
    }
  };
  flow.outsideFor = [this](const std::filesystem::path& path) { return preferences.outsideFor(path); };
  flow.onAllowOutside = [this](const std::filesystem::path& path) {
    preferences.setOutside(path, OutsideFiles::Allow);
  };
  flow.onFileUsed = [this](const std::filesystem::path& path) { preferences.usedFile(path); };
  followGround();
  registerCoreActions(*this);
}

ToolContext Workspace::context() {
  return {document, selection, toolSettings, view(), ground, &strokes, m_seconds, windSeconds};
}

bool Workspace::pointerPressed(const PointerEvent& pointer) {
  m_pointer = pointer.pixel;
  ToolContext tool = context();
  // The view can be turned between the clicks of a gesture, not during a drag.
  const bool turnsView = pointer.button == PointerButton::Middle && !tools.dragging();
  if (tools.busy() && pointer.button != PointerButton::Left && !turnsView) {
    tools.finish(tool);
    afterChange();
    return true;
  }
  // Alt+drag copies what it grabs and orbits elsewhere.
  const bool left = pointer.button == PointerButton::Left;
  const bool copies = left && pointer.modifiers.alt && tools.active().usesAlt() && !tool.hits(pointer.pixel).empty();
  if (!tools.dragging() && !copies && navigator.press(pointer)) return true;
  const bool used = tools.press(tool, pointer);
  afterChange();
  return used;
}

bool Workspace::pointerMoved(const PointerEvent& pointer) {
  m_pointer = pointer.pixel;
  if (navigator.move(camera, pointer, viewportSize, ground)) {
    keepEyeAboveGround();
    return true;
  }
  ToolContext tool = context();
  const bool used = tools.move(tool, pointer);
  takeToolMessage();
  return used;
}

bool Workspace::pointerReleased(const PointerEvent& pointer) {
  m_pointer = pointer.pixel;
  if (navigator.release(pointer)) return true;
  ToolContext tool = context();
  const bool used = tools.release(tool, pointer);
  afterChange();
  return used;
}

bool Workspace::wheel(float notches, const PointerEvent& pointer) {
  m_pointer = pointer.pixel;
  ToolContext tool = context();
  if (!navigator.active() && tools.wheel(tool, notches, pointer.modifiers)) return true;
  navigator.wheel(camera, notches, pointer.pixel, viewportSize, ground);
  keepEyeAboveGround();
  return true;
}

void Workspace::pointerLeft() {
  tools.clearHover();
}

bool Workspace::keyPressed(const KeyPress& press) {
  ToolContext tool = context();
  if (tools.busy() && tools.key(tool, press)) {
    afterChange();
    return true;
  }
  if (!press.modifiers.ctrl && navigator.key(press.key, true)) return true;
  if (!press.modifiers.ctrl && !press.modifiers.alt && tools.active().onKey(tool, press)) {
    afterChange();
    return true;
  }
  return actions.dispatch(press);
}

void Workspace::keyReleased(Key key) {
  navigator.key(key, false);
}

void Workspace::focusLost() {
  ToolContext tool = context();
  tools.cancel(tool);
  tools.clearHover();
  navigator.cancel();
}

void Workspace::tick(double seconds, Modifiers held) {
  takeTerrain();
  takeAsset();
  followGround();
  m_seconds += seconds;
  navigator.tick(camera, seconds, held);
  keepEyeAboveGround();
}

bool Workspace::mayLoadTerrain() {
  if (!document.path().empty()) return true;
  say(MessageKind::Warning, "Save the project first: its terrain lies beside it");
  return false;
}

bool Workspace::loadTerrain(const std::filesystem::path& file) {
  if (!mayLoadTerrain()) return false;
  terrainLoad.start(file, document.path());
  return true;
}

void Workspace::takeTerrain() {
  // Not into a drag: its end would come upon another project.
  if (tools.dragging()) return;
  const auto loaded = terrainLoad.poll();
  if (!loaded) return;
  if (!*loaded) {
    if (flow.onFailure) flow.onFailure(loaded->error());
    return;
  }
  const std::filesystem::path file = (**loaded)->file;
  if (!isStillBeside(file)) return;
  if (apply(terrainEdit(document.committed(), **loaded)))
    say(MessageKind::Info, "The ground is " + file.filename().string());
}

bool Workspace::mayLoadAsset() {
  if (!document.path().empty()) return true;
  say(MessageKind::Warning, "Save the project first: its files lie beside it");
  return false;
}

bool Workspace::loadAsset(AssetTarget target, const std::filesystem::path& file) {
  if (!mayLoadAsset()) return false;
  assetLoad.start(std::move(target), file, document.path());
  return true;
}

std::optional<std::filesystem::path> Workspace::ownFile(const std::string& name) {
  const Result<std::filesystem::path> file = findAsset(document.path(), name, document.outside());
  if (file) return *file;
  say(MessageKind::Warning, file.error().text());
  return std::nullopt;
}

void Workspace::takeAsset() {
  if (tools.dragging()) return;
  const auto loaded = assetLoad.poll();
  if (!loaded) return;
  if (!*loaded) {
    if (flow.onFailure) flow.onFailure(loaded->error());
    return;
  }
  const std::filesystem::path file = (*loaded)->file();
  if (!isStillBeside(file)) return;
  const AddResult result = assetEdit(document.committed(), **loaded);
  if (result.edit.steps.empty()) {
    say(MessageKind::Warning, "What " + file.filename().string() + " was chosen for is gone");
  } else if (apply(result.edit)) {
    if (result.id != 0) selection.replace(result.id);
    say(MessageKind::Info, "Read " + file.filename().string());
  }
}

/// A file that was brought into the project's folder; told where the project has gone elsewhere since.
bool Workspace::isStillBeside(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::exists(document.path().parent_path() / file, ignored)) return true;
  const std::string name = file.filename().string();
  say(MessageKind::Warning, "The project was saved into another folder meanwhile: choose " + name + " again");
  return false;
}

void Workspace::followGround() {
  ground.height = document.project().terrain->heights;
  ground.over = markHeight(*document.project().grass);
}

/// Hills would hide everything from below.
void Workspace::keepEyeAboveGround() {
  if (!ground.height || camera.orthographic) return;
  constexpr float kLeastM = 0.3f;
  const glm::vec3 eye = camera.position();
  camera.target.y += std::max(0.0f, ground.at({eye.x, eye.z}) + kLeastM - eye.y);
}

bool Workspace::apply(const Edit& edit) {
  ToolContext tool = context();
  if (tools.dragging()) tools.cancel(tool);
  const Status status = document.apply(edit);
  if (!status) say(MessageKind::Warning, refusalText(status.error()));
  afterChange();
  return status.ok();
}

bool Workspace::apply(const Result<Edit>& edit) {
  if (edit) return apply(*edit);
  say(MessageKind::Warning, refusalText(edit.error()));
  return false;
}

void Workspace::undo() {
  ToolContext tool = context();
  tools.cancel(tool);
  const std::string label = document.undoLabel();
  if (document.undo()) say(MessageKind::Info, label);
  afterChange();
}

void Workspace::redo() {
  ToolContext tool = context();
  tools.cancel(tool);
  const std::string label = document.redoLabel();
  if (document.redo()) say(MessageKind::Info, label);
  afterChange();
}

void Workspace::jumpTo(std::size_t historyEntry) {
  ToolContext tool = context();
  tools.cancel(tool);
  document.jump(historyEntry);
  afterChange();
}

void Workspace::activateTool(std::string_view id) {
  ToolContext tool = context();
  tools.activate(tool, id);
}

void Workspace::say(MessageKind kind, std::string text) {
  m_message = {kind, std::move(text)};
  ++m_messageNumber;
}

void Workspace::writeClipboardText(const std::string& text, std::filesystem::path folder) {
  m_clipboard = text;
  m_clipboardFolder = std::move(folder);
  if (writeClipboard) writeClipboard(text);
}

std::string Workspace::clipboardText() const {
  return readClipboard ? readClipboard() : m_clipboard;
}

std::filesystem::path Workspace::copiedFrom(const std::string& text) const {
  return text == m_clipboard ? m_clipboardFolder : std::filesystem::path();
}

void Workspace::lookAs(Id id) {
  const Camera* seen = findCamera(document.project(), id);
  if (!seen) return;
  camera = lookThrough(camera, *seen);
  m_lookedThrough = id;
}

void Workspace::frame(std::span<const Id> ids) {
  const Project& project = document.project();
  std::optional<GroundBounds> bounds = boundsOf(project, ids);
  if (!bounds) {
    std::vector<Id> all = selectableIds(project);
    bounds = boundsOf(project, all);
  }
  if (!bounds) {
    const FieldSettings& field = *project.field;
    bounds = GroundBounds{field.centre - 0.5f * field.size, field.centre + 0.5f * field.size};
  }
  // A single point has no extent; some of its surroundings make it readable.
  const glm::vec2 margin = glm::max(glm::vec2(0.0f), 0.5f * (glm::vec2(8.0f) - (bounds->high - bounds->low)));
  camera = frameBounds(camera, bounds->low - margin, bounds->high + margin, viewportSize, ground);
  keepEyeAboveGround();
}

void Workspace::takeToolMessage() {
  std::string message = tools.takeMessage();
  if (!message.empty()) say(MessageKind::Warning, std::move(message));
}

void Workspace::afterChange() {
  followGround();
  takeToolMessage();
  selection.repair(document.project());
}

}  // namespace windloom::editor
