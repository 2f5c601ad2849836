#pragma once
// The wind of the GPU backend at a few places without waiting for the GPU: places that were asked for are
// sampled with the next frame and answered a few frames later.

#include <vector>

#include "engine/session/wind_sampler.hpp"

namespace windloom {

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
  explicit WindReadout(WindSampler sampler) : m_sampler(std::move(sampler)) {}

  WindSampler m_sampler;
  std::vector<glm::vec2> m_asked;
  WindSampler::Answer m_answer;  // the newest
};

}  // namespace windloom
