#pragma once
// Everything the editor is without its window: the app owns one, feeds it events and draws what it says.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "editor/core/actions.hpp"
#include "editor/core/asset_load.hpp"
#include "editor/core/camera_control.hpp"
#include "editor/core/document.hpp"
#include "editor/core/document_flow.hpp"
#include "editor/core/navigation.hpp"
#include "editor/core/preferences.hpp"
#include "editor/core/selection.hpp"
#include "editor/core/terrain_load.hpp"
#include "editor/core/tool_box.hpp"

namespace windloom::editor {

enum class MessageKind { Info, Warning, Error };
struct Message {
  MessageKind kind = MessageKind::Info;
  std::string text;
};

class Workspace {
 public:
  Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  Document document;
  Selection selection;
  EditorCamera camera;
  Navigator navigator;
  ToolBox tools;
  ToolSettings toolSettings;
  BrushStrokes strokes;  ///< of the wind brush; the app gives them to the session and ages them by its time
  ActionTable actions;   ///< core actions are in it; the app adds its own
  DocumentFlow flow{document};
  Preferences preferences;
  Ground ground;  ///< follows the document's terrain and the height of its grass
  TerrainLoad terrainLoad;
  AssetLoad assetLoad;
  double windSeconds = 0;                   ///< the time that the view shows; the app keeps it up to date
  glm::vec2 viewportSize{1280.0f, 720.0f};  ///< pixels; the app keeps it up to date

  /// The system's clipboard; the app sets both. Without them copy and paste stay inside the editor.
  std::function<void(const std::string&)> writeClipboard;
  std::function<std::string()> readClipboard;

  // Events of the viewport, in its pixels. Each is true where it was used. Give the viewport only what no panel
  // or text field has taken.
  bool pointerPressed(const PointerEvent& pointer);
  bool pointerMoved(const PointerEvent& pointer);  ///< with or without a button
  bool pointerReleased(const PointerEvent& pointer);
  bool wheel(float notches, const PointerEvent& pointer);
  void pointerLeft();  ///< no hover any more
  /// Drag and tool first, then flying, then the actions' shortcuts. Never call it while a text field has the focus.
  bool keyPressed(const KeyPress& press);
  void keyReleased(Key key);
  void focusLost();
  /// Once a frame: flying, the files that were read meanwhile, and the clock that the brush measures speeds by.
  void tick(double seconds, Modifiers held);

  /// The one way panels change the project: applies, tells refusals in the status line. True where applied.
  bool apply(const Edit& edit);
  bool apply(const Result<Edit>& edit);
  /// Begins to read a terrain file; it becomes the ground as one step, "Set terrain", or an error is told and all stays
  /// as it was. False where the project has to be saved first, which is told.
  bool loadTerrain(const std::filesystem::path& file);
  bool mayLoadTerrain();
  /// The same for the file of a species, a collider, a surface or a map of the grass, see assetEdit. A new record is
  /// selected.
  bool loadAsset(AssetTarget target, const std::filesystem::path& file);
  bool mayLoadAsset();
  /// Where a file lies that the project names; nothing where it may not be read, which is told.
  std::optional<std::filesystem::path> ownFile(const std::string& name);
  void undo();
  void redo();
  void jumpTo(std::size_t historyEntry);
  void activateTool(std::string_view id);

  void say(MessageKind kind, std::string text);
  [[nodiscard]] const Message& message() const { return m_message; }
  /// Grows with each message, so that the status bar can fade it.
  [[nodiscard]] std::uint64_t messageNumber() const { return m_messageNumber; }

  [[nodiscard]] ToolContext context();
  [[nodiscard]] ViewMapping view() const { return ViewMapping(camera, viewportSize); }
  /// Where the pointer was last in the viewport.
  [[nodiscard]] glm::vec2 pointer() const { return m_pointer; }
  /// Shows the ids, or everything that the project has and else its field.
  void frame(std::span<const Id> ids);
  /// The view of a camera of the project; nothing for other ids.
  void lookAs(Id id);
  /// The camera last looked through, 0: none.
  [[nodiscard]] Id lookedThrough() const { return m_lookedThrough; }

  /// Through the callbacks, or within the editor where there are none.
  /// `folder`: of the project that it was copied from; empty: it has no file yet.
  void writeClipboardText(const std::string& text, std::filesystem::path folder = {});
  [[nodiscard]] std::string clipboardText() const;
  /// The folder that this text was copied from by this editor; empty where it comes from elsewhere.
  [[nodiscard]] std::filesystem::path copiedFrom(const std::string& text) const;

 private:
  void takeTerrain();
  void takeAsset();
  bool isStillBeside(const std::filesystem::path& file);
  void followGround();
  void keepEyeAboveGround();
  void takeToolMessage();
  void afterChange();

  Message m_message;
  std::uint64_t m_messageNumber = 0;
  glm::vec2 m_pointer{0.0f};
  double m_seconds = 0;  // of real time, counted by tick
  std::string m_clipboard;
  std::filesystem::path m_clipboardFolder;
  Id m_lookedThrough = 0;
};

/// A place on the ground in the middle of the view, beside the colliders, surfaces and rotors that stand there.
glm::vec2 freePlace(Workspace& workspace, float reachM);

/// Adds file, edit, select, add, graph, tool and view actions to workspace.actions. The constructor calls it. Ids:
/// file.new file.open file.save file.save_as file.outside
/// file.quit; edit.undo edit.redo edit.copy edit.cut edit.paste
/// edit.duplicate edit.duplicate_move edit.delete; select.all select.none select.invert select.linked;
/// add.collider add.rotor add.moebius add.torus add.sphere add.hare add.tall_grass add.daisies add.poppies add.spikes;
/// graph.extrude
/// graph.merge graph.split graph.dissolve graph.reverse graph.reparent graph.mute graph.hide graph.show_all
/// graph.isolate graph.lock graph.unlock_all graph.strength_up graph.strength_down graph.radius_up graph.radius_down;
/// tool.select tool.move tool.rotate tool.scale tool.draw tool.obstacle tool.vortex tool.brush tool.probe tool.delete
/// tool.cancel;
/// view.frame view.frame_all view.top view.front view.side view.orthographic view.camera_next view.camera_store;
/// grass.instanced grass.bezier grass.shell grass.none; snap.grid snap.angle snap.points.
void registerCoreActions(Workspace& workspace);

}  // namespace windloom::editor
