#pragma once
// The wind at places that are watched over time: a sample every few steps, on either backend.

#include <vector>

#include "engine/session/simulation.hpp"
#include "engine/session/wind_sampler.hpp"

namespace windloom {

struct WindSample;

class WindWatch {
 public:
  /// Fails with Machine.
  static Result<WindWatch> create(gpu::ShaderLibrary& shaders);

  void setPlaces(std::vector<glm::vec2> places) { m_places = std::move(places); }
  /// After each step.
  void stepDone(Simulation& simulation);
  /// Time has jumped: what is on its way belongs to before.
  void timeJumped();
  std::vector<WindSample> take();

 private:
  explicit WindWatch(WindSampler sampler) : m_sampler(std::move(sampler)) {}

  WindSampler m_sampler;
  std::vector<glm::vec2> m_places;
  std::vector<WindSample> m_samples;
  double m_last = -1;  // s: the newest sample
};

}  // namespace windloom
