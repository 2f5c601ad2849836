#include "engine/session/wind_readout.hpp"

#include <algorithm>

namespace windloom {
namespace {

// An answer for a place this near stands in for one that isn't known yet: a moving cursor.
constexpr float kNearM = 4.0f;

}  // namespace

Result<WindReadout> WindReadout::create(gpu::ShaderLibrary& shaders) {
  Result<WindSampler> sampler = WindSampler::create("wind read-out", shaders, 4);
  if (!sampler) return sampler.error();
  return WindReadout(std::move(*sampler));
}

glm::vec2 WindReadout::ask(glm::vec2 world, glm::vec2 otherwise) {
  if (m_asked.size() < WindSampler::kMostPlaces && std::ranges::find(m_asked, world) == m_asked.end())
    m_asked.push_back(world);
  while (auto answer = m_sampler.take()) m_answer = std::move(*answer);
  float nearest = kNearM;
  for (std::size_t i = 0; i < m_answer.places.size(); ++i) {
    const float away = glm::distance(m_answer.places[i], world);
    if (away > nearest) continue;
    nearest = away;
    otherwise = m_answer.wind[i];
  }
  return otherwise;
}

void WindReadout::sample(unsigned texture, const GridMapping& grid) {
  if (texture == 0) return;
  m_sampler.request(std::move(m_asked), texture, grid, 0);
  m_asked.clear();
}

void WindReadout::forget() {
  m_sampler.forget();
  m_answer = {};
  m_asked.clear();
}

}  // namespace windloom
