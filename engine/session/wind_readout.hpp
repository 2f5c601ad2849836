#pragma once
// The wind of the GPU backend at a few places without waiting for the GPU: places that were asked for are
// sampled with the next frame and answered a few frames later.

#include <deque>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/shader_library.hpp"

namespace windloom {

/// The programs of this room.
std::span<const gpu::ProgramSpec> sessionPrograms();

class WindReadout {
 public:
  /// Fails with Machine.
  static Result<WindReadout> create(gpu::ShaderLibrary& shaders);

  /// The last answer for this place or for the nearest place within a few metres; `otherwise` before there is one.
  glm::vec2 ask(glm::vec2 world, glm::vec2 otherwise);

  /// Samples what was asked for since the last call from `texture`.
  void sample(unsigned texture, const GridMapping& grid);

  void forget();

 private:
  WindReadout() = default;
  struct Answer {
    glm::vec2 world, wind;
  };
  struct Request {
    long tag = 0;
    std::vector<glm::vec2> places;
  };
  void collect();

  static constexpr std::size_t kMostPlaces = 64;
  gpu::Program* m_program = nullptr;
  gpu::Buffer m_places;
  gpu::ReadbackRing m_ring;
  std::vector<glm::vec2> m_asked;
  std::deque<Request> m_inFlight;
  std::vector<Answer> m_answers;
  long m_tag = 0;
};

}  // namespace windloom
