#include "engine/session/wind_watch.hpp"

#include <algorithm>

#include "engine/session/session.hpp"

namespace windloom {
namespace {

constexpr double kEveryS = 1.0 / 30;
constexpr int kSlots = 128;                    // requests on their way: what a slice of a seek does on a fast GPU
constexpr std::size_t kMostWaiting = 200'000;  // samples that nobody takes: a watch without a panel

}  // namespace

Result<WindWatch> WindWatch::create(gpu::ShaderLibrary& shaders) {
  Result<WindSampler> sampler = WindSampler::create("wind watch", shaders, kSlots);
  if (!sampler) return sampler.error();
  return WindWatch(std::move(*sampler));
}

void WindWatch::stepDone(Simulation& simulation) {
  const double time = simulation.time();
  if (m_places.empty() || (time >= m_last && time < m_last + kEveryS - 1e-6)) return;
  m_last = time;
  if (simulation.solver().backend() == Backend::Cpu) {
    if (m_samples.size() > kMostWaiting) m_samples.clear();
    for (const glm::vec2 place : m_places) m_samples.push_back({time, place, simulation.windAt(place)});
    return;
  }
  for (std::size_t begin = 0; begin < m_places.size(); begin += WindSampler::kMostPlaces) {
    const auto first = m_places.begin() + static_cast<std::ptrdiff_t>(begin);
    const std::size_t count = std::min(WindSampler::kMostPlaces, m_places.size() - begin);
    m_sampler.request({first, first + static_cast<std::ptrdiff_t>(count)}, simulation.solver().velocityTexture(),
                      simulation.solver().grid(), time);
  }
}

void WindWatch::timeJumped() {
  m_sampler.forget();
  m_last = -1;
}

std::vector<WindSample> WindWatch::take() {
  while (const auto answer = m_sampler.take()) {
    for (std::size_t i = 0; i < answer->places.size(); ++i)
      m_samples.push_back({answer->time, answer->places[i], answer->wind[i]});
  }
  return std::exchange(m_samples, {});
}

}  // namespace windloom
