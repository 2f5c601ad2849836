#pragma once
// Time spent on the GPU, by stage, from timestamp queries in a ring: never waits, so the numbers are of a
// frame a few frames ago.

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/gpu/handle.hpp"

namespace windloom::gpu {

class GpuTimer {
 public:
  /// Keeps `ring` frames in flight; a frame that finds its slot unread is not measured.
  explicit GpuTimer(int ring = 8);

  /// Frames don't nest; every stage lies in one.
  void beginFrame();
  /// Ends the stage before, if any, and begins this one.
  void stage(std::string_view name);
  void endFrame();

  /// Takes in what has finished. Milliseconds by stage, in order, of the newest finished frame; empty: none yet.
  const std::vector<std::pair<std::string, double>>& stages();
  /// From beginFrame to endFrame of that frame, ms.
  double totalMs();
  /// As stages(), but waits for every frame begun: benchmarks and tests.
  void finish();

 private:
  struct Slot {
    std::vector<Handle<QueryKind>> queries;  // one more than stages: the frame's end
    std::vector<std::string> names;
    std::size_t used = 0;
    bool pending = false;
  };
  enum class Wait { No, Yes };
  void stamp(Slot& slot);
  void collect(Wait wait);

  std::vector<Slot> m_slots;
  std::size_t m_next = 0, m_oldest = 0;
  Slot* m_open = nullptr;
  std::vector<std::pair<std::string, double>> m_stages;
  double m_totalMs = 0;
};

}  // namespace windloom::gpu
