// What the editor does where memory ends in the middle of a frame.

#include <imgui_internal.h>

#include <new>
#include <stdexcept>

#include "editor/app/app.hpp"
#include "engine/core/log.hpp"
#include "engine/core/memory_reserve.hpp"

namespace windloom::editor {
namespace {

// A frame that ended so may have been one large wish; one after the other means that nothing works any more.
constexpr int kMostTroubledFrames = 3;

}  // namespace

/// True where the frame ended well; else the work is safe, and the editor goes on or ends.
bool App::tryFrame() {
  try {
    frame();
    if (m_troubledFrames > 0) keepMemoryReserve();
    m_troubledFrames = 0;
    return true;
  } catch (const std::bad_alloc&) {
    memoryEnded();
  } catch (const std::length_error&) {
    memoryEnded();
  }
  return false;
}

/// The document is whole: an edit makes a new project first and then takes it over.
void App::memoryEnded() {
  const Status saved = m_autosave.writeNow(m_workspace.document);
  if (++m_troubledFrames >= kMostTroubledFrames) m_exit = 3;
  try {
    if (ImGui::GetCurrentContext()->WithinFrameScope) {
      ImGui::ErrorCheckEndFrameRecover(nullptr);
      ImGui::EndFrame();
    }
    m_workspace.document.endPreview();
    const std::string what =
        saved ? "There is not enough memory for that. Your work is safe."
              : "There is not enough memory, and the work can't be kept aside: " + saved.error().text() +
                    " Save the project now, or close others first.";
    logError(what);
    if (m_troubledFrames == 1) m_dialogs.showError(what);
  } catch (const std::bad_alloc&) {
    m_exit = 3;  // not even memory for a message; the work was kept aside above
  }
}

}  // namespace windloom::editor
