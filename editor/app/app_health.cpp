// How the program itself is doing, for window tests that run for long: what must not grow, and what must stay zero.

#include <algorithm>
#include <string>

#include "editor/app/app.hpp"
#include "engine/core/heap.hpp"
#include "engine/core/text.hpp"
#include "engine/gpu/memory.hpp"

namespace windloom::editor {

void App::giveMemoryBack() {
  m_trimAtS = 0;
  // A large project leaves holes between small blocks that stay: without this the process keeps what the largest one
  // took.
  giveHeapBack();
}

void App::tellHealth(double seconds) {
  UiMap& map = m_look.map;
  if (m_frames > 1) m_longestFrameS = std::max(m_longestFrameS, seconds);
  map.fact("health.longest frame", fixed(m_longestFrameS * 1000, 0));
  map.fact("health.opened", std::to_string(m_opened));
  map.fact("health.gl errors", std::to_string(m_live->context().debugErrorCount()));
  map.fact("health.gl last", m_live->context().lastDebugError());
  map.fact("health.gpu bytes", std::to_string(gpu::bytesInUse()));
  Session* session = m_live->session();
  map.fact("health.cells reset", session ? std::to_string(session->status().wind.nonFiniteCells) : "");
  // Walks through all free blocks: not in every frame.
  constexpr int kEvery = 30;
  if (m_frames % kEvery == 0) m_heapBytes = heapBytesInUse();
  map.fact("health.heap bytes", std::to_string(m_heapBytes));
  for (const auto& [label, bytes] : gpu::bytesByLabel()) map.fact("gpu." + label, std::to_string(bytes));
}

}  // namespace windloom::editor
