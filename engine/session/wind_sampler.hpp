#pragma once
// The wind at a few places of a texture on the GPU, without waiting: answers come a few frames later, in order.

#include <deque>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/shader_library.hpp"

namespace windloom {

/// The programs of this room.
std::span<const gpu::ProgramSpec> sessionPrograms();

class WindSampler {
 public:
  static constexpr std::size_t kMostPlaces = 64;  ///< in one request

  /// `slots` requests may be on their way. Fails with Machine.
  static Result<WindSampler> create(std::string_view label, gpu::ShaderLibrary& shaders, int slots);

  /// Asks for the wind at these places, at most kMostPlaces. Where too many are on their way nothing is asked and the
  /// answer is false. `time` comes back with the answer.
  bool request(std::vector<glm::vec2> places, unsigned texture, const GridMapping& grid, double time);

  struct Answer {
    double time = 0;
    std::vector<glm::vec2> places, wind;  ///< m; m/s
  };
  /// The oldest answer that has come and wasn't taken.
  std::optional<Answer> take();
  /// What is on its way will not be told.
  void forget() { m_wanted = m_tag + 1; }

 private:
  WindSampler() = default;
  struct Request {
    long tag = 0;
    double time = 0;
    std::vector<glm::vec2> places;
  };

  gpu::Program* m_program = nullptr;
  gpu::Buffer m_places;
  gpu::ReadbackRing m_ring;
  std::deque<Request> m_inFlight;
  long m_tag = 0, m_wanted = 0;
};

}  // namespace windloom
