#include "engine/session/wind_readout.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstring>

namespace windloom {
namespace {

constexpr gpu::ProgramSpec kPrograms[] = {{"field/sample wind", {"field/sample_wind.comp"}}};
// An answer for a place this near stands in for one that isn't known yet: a moving cursor.
constexpr float kNearM = 4.0f;

}  // namespace

std::span<const gpu::ProgramSpec> sessionPrograms() { return kPrograms; }

Result<WindReadout> WindReadout::create(gpu::ShaderLibrary& shaders) {
  WindReadout readout;
  Result<gpu::Program*> program = shaders.load(kPrograms[0]);
  if (!program) return program.error();
  Result<gpu::Buffer> places = gpu::Buffer::create("wind read-out", kMostPlaces * sizeof(glm::vec4), gpu::BufferUse::Dynamic);
  if (!places) return places.error();
  Result<gpu::ReadbackRing> ring = gpu::ReadbackRing::create("wind read-out", kMostPlaces * sizeof(glm::vec4));
  if (!ring) return ring.error();
  readout.m_program = *program;
  readout.m_places = std::move(*places);
  readout.m_ring = std::move(*ring);
  return readout;
}

glm::vec2 WindReadout::ask(glm::vec2 world, glm::vec2 otherwise) {
  if (m_asked.size() < kMostPlaces && std::ranges::find(m_asked, world) == m_asked.end()) m_asked.push_back(world);
  collect();
  float nearest = kNearM;
  for (const Answer& answer : m_answers) {
    const float away = glm::distance(answer.world, world);
    if (away > nearest) continue;
    nearest = away;
    otherwise = answer.wind;
  }
  return otherwise;
}

void WindReadout::collect() {
  const auto arrived = m_ring.poll();
  if (!arrived) return;
  while (!m_inFlight.empty() && m_inFlight.front().tag < arrived->tag) m_inFlight.pop_front();
  if (m_inFlight.empty() || m_inFlight.front().tag != arrived->tag) return;
  const std::vector<glm::vec2>& places = m_inFlight.front().places;
  m_answers.clear();
  for (std::size_t i = 0; i < places.size(); ++i) {
    glm::vec4 value(0.0f);
    std::memcpy(&value, arrived->bytes.data() + i * sizeof value, sizeof value);
    m_answers.push_back({places[i], {value.z, value.w}});
  }
  m_inFlight.pop_front();
}

void WindReadout::sample(unsigned texture, const GridMapping& grid) {
  if (m_asked.empty() || texture == 0) return;
  std::vector<glm::vec4> places;
  for (const glm::vec2 world : m_asked) places.emplace_back(worldToUv(world, grid.minCorner, grid.size), 0.0f, 0.0f);
  // The last dispatch wrote this buffer.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_places.write(std::span<const glm::vec4>(places));
  // The solver wrote the texture as an image.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  m_program->use();
  m_program->set("count", static_cast<int>(places.size()));
  glBindTextureUnit(0, texture);
  m_places.bindStorage(0);
  m_program->dispatch(1);
  if (m_ring.request(m_places, 0, places.size() * sizeof(glm::vec4), ++m_tag)) m_inFlight.push_back({m_tag, m_asked});
  m_asked.clear();
}

void WindReadout::forget() {
  m_answers.clear();
  m_inFlight.clear();
  m_asked.clear();
}

}  // namespace windloom
