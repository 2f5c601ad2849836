#pragma once
// The writing side of the live link: the wind as it blows now, in shared memory, for a game on the same machine. The
// reading side is windloom_live of engine/runtime; engine/runtime/live_format.h has the bytes.

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/core/result.hpp"
#include "engine/session/resample.hpp"

namespace windloom {

/// Where the field repeats.
struct LiveEdges {
  bool periodicX = false, periodicZ = false;
};

class LiveLink {
 public:
  /// Makes the shared memory object "/NAME" (POSIX shm_open), over one that a program left behind when it ended.
  /// Another program that still writes to it is told by the message. `name` has 1 to 64 bytes and no slash. Fails with
  /// BadInput (name) and Machine.
  static Result<std::unique_ptr<LiveLink>> create(const std::string& name);
  /// Marks the field as ended and removes the name; games that hold it keep the last field.
  ~LiveLink();
  LiveLink(const LiveLink&) = delete;
  LiveLink& operator=(const LiveLink&) = delete;

  /// Publishes a field of `time` s in the project: the grid's cells in m/s, rows z ascending. More than kMaxSide cells
  /// a side are averaged down. Never waits for a reader. Costs one pass over the cells.
  void publish(const GridMapping& grid, std::span<const glm::vec2> cells, double time, LiveEdges edges = {});

  static constexpr int kMaxSide = 512;  ///< cells

  [[nodiscard]] long long published() const { return m_published; }

 private:
  LiveLink() = default;
  void writeCells(std::uint32_t* to, std::span<const glm::vec2> cells);

  std::string m_path;  ///< "/NAME"
  int m_object = -1;   ///< holds the lock
  std::byte* m_memory = nullptr;
  std::optional<Resampler> m_resampler;
  glm::ivec2 m_resampled{0};  ///< the resolution that m_resampler takes
  std::vector<glm::vec2> m_small;
  std::vector<std::uint32_t> m_halves;
  float m_fastest = 0;
  long long m_published = 0;
};

}  // namespace windloom
