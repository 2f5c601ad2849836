// What the editor does when the graphics fail: the work is written to the side file before anything else.

#include <string>
#include <utility>

#include "editor/app/app.hpp"
#include "engine/core/log.hpp"
#include "engine/gpu/memory_failure.hpp"

namespace windloom::editor {

void App::heedTrouble() {
  if (m_line.unattended()) return;
  if (m_live->lost()) return endWithoutGpu();
  const gpu::MemoryFailures failures = gpu::memoryFailures();
  if (failures.count == std::exchange(m_memoryFailures, failures.count)) return;
  // The last picture that could be made stays, and the document can be edited and saved as before.
  std::string told = failures.last;
  if (const Status kept = m_autosave.writeNow(m_workspace.document); !kept) told += "; " + kept.error().text();
  m_workspace.say(MessageKind::Error, told);
}

/// Everything on the GPU is gone, the interface as well: there is no window any more in which anything could be asked.
void App::endWithoutGpu() {
  const bool changed = m_workspace.document.dirty();
  m_lastWords = std::string("Windloom must end: ") + gpu::kGpuLost + ".";
  if (const Status kept = m_autosave.writeNow(m_workspace.document); !kept) {
    m_lastWords += " The work since the last save could not be kept: " + kept.error().text();
  } else if (changed) {
    m_lastWords += " The work since the last save is kept in " + m_autosave.sideFile().string() +
                   "; the next start of the editor offers it.";
  } else {
    m_lastWords += " Nothing was unsaved.";
  }
  logError(m_lastWords);
  m_exit = 3;
}

}  // namespace windloom::editor
