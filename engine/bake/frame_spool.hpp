#pragma once
// Recorded frames waiting to be written: needed where the fastest wind or the frames of a loop's seam are known only
// when the recording ends.

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom {

/// Keeps frames in memory up to a budget and behind it in a file that has no name and vanishes with the program.
class FrameSpool {
 public:
  /// `cells` values a frame. The file, if one is needed, lies in `folder`.
  FrameSpool(std::size_t cells, std::filesystem::path folder, std::uint64_t memoryBytes = 256ull << 20);
  ~FrameSpool();
  FrameSpool(const FrameSpool&) = delete;
  FrameSpool& operator=(const FrameSpool&) = delete;

  /// Appends a frame. Fails with Machine (disk full).
  Status add(std::span<const glm::vec2> frame);
  /// Frame `index`, counted from 0 in the order of add(); `out` is resized. Fails with Machine.
  Status read(int index, std::vector<glm::vec2>& out) const;

  [[nodiscard]] int frames() const { return m_frames; }

 private:
  Status openFile();

  std::size_t m_cells;
  std::filesystem::path m_folder;
  std::size_t m_framesInMemory;
  std::vector<std::vector<glm::vec2>> m_memory;
  int m_file = -1;
  int m_frames = 0;
};

}  // namespace windloom
