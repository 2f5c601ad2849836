#include "engine/session/wind_sampler.hpp"

#include <epoxy/gl.h>

#include <cstring>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

constexpr gpu::ProgramSpec kPrograms[] = {{"field/sample wind", {"field/sample_wind.comp"}}};

}  // namespace

std::span<const gpu::ProgramSpec> sessionPrograms() {
  return kPrograms;
}

Result<WindSampler> WindSampler::create(std::string_view label, gpu::ShaderLibrary& shaders, int slots) {
  WindSampler sampler;
  Result<gpu::Program*> program = shaders.load(kPrograms[0]);
  if (!program) return program.error();
  Result<gpu::Buffer> places = gpu::Buffer::create(label, kMostPlaces * sizeof(glm::vec4), gpu::BufferUse::Dynamic);
  if (!places) return places.error();
  Result<gpu::ReadbackRing> ring = gpu::ReadbackRing::create(label, kMostPlaces * sizeof(glm::vec4), slots);
  if (!ring) return ring.error();
  sampler.m_program = *program;
  sampler.m_places = std::move(*places);
  sampler.m_ring = std::move(*ring);
  return sampler;
}

bool WindSampler::request(std::vector<glm::vec2> places, unsigned texture, const GridMapping& grid, double time) {
  WL_REQUIRE(places.size() <= kMostPlaces, "more places than a request takes");
  if (places.empty() || texture == 0) return true;
  std::vector<glm::vec4> uv;
  for (const glm::vec2 world : places) uv.emplace_back(worldToUv(world, grid.minCorner, grid.size), 0.0f, 0.0f);
  // The last dispatch wrote this buffer.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  m_places.write(std::span<const glm::vec4>(uv));
  // The solver wrote the texture as an image.
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  m_program->use();
  m_program->set("count", static_cast<int>(uv.size()));
  glBindTextureUnit(0, texture);
  m_places.bindStorage(0);
  m_program->dispatch(1);
  if (!m_ring.request(m_places, 0, uv.size() * sizeof(glm::vec4), ++m_tag)) return false;
  m_inFlight.push_back({m_tag, time, std::move(places)});
  return true;
}

std::optional<WindSampler::Answer> WindSampler::take() {
  while (const auto arrived = m_ring.takeOldest(gpu::ReadbackRing::Wait::No)) {
    WL_REQUIRE(!m_inFlight.empty() && m_inFlight.front().tag == arrived->tag, "answers come in the order of requests");
    Request request = std::move(m_inFlight.front());
    m_inFlight.pop_front();
    if (request.tag < m_wanted) continue;
    Answer answer{request.time, std::move(request.places), {}};
    for (std::size_t i = 0; i < answer.places.size(); ++i) {
      glm::vec4 value(0.0f);
      std::memcpy(&value, arrived->bytes.data() + i * sizeof value, sizeof value);
      answer.wind.emplace_back(value.z, value.w);
    }
    return answer;
  }
  return std::nullopt;
}

}  // namespace windloom
