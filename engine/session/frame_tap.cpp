#include "engine/session/frame_tap.hpp"

#include <epoxy/gl.h>

#include <cstring>

#include "engine/core/contract.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/session/resample.hpp"

namespace windloom {
namespace {

constexpr gpu::ProgramSpec kPrograms[] = {{"wind/area filter", {"wind/area_filter.comp"}}};

/// What the program running on the processor has is there at once.
class ProcessorTap final : public FrameTap {
 public:
  ProcessorTap(Simulation& simulation, glm::ivec2 resolution) : m_simulation(simulation) {
    const glm::ivec2 full = simulation.solver().grid().resolution;
    if (resolution != full) m_resampler.emplace(full, resolution, wrapsOf(*simulation.project().field));
  }

  bool ask(int frame) override {
    if (m_asked) return false;
    m_asked = frame;
    if (m_resampler) m_resampler->apply(m_simulation.velocity(), m_resampled);
    return true;
  }

  std::optional<Frame> take(Wait) override {
    if (!m_asked) return std::nullopt;
    const Frame frame{*m_asked, m_resampler ? std::span<const glm::vec2>(m_resampled) : m_simulation.velocity()};
    m_asked.reset();
    return frame;
  }

 private:
  Simulation& m_simulation;
  std::optional<Resampler> m_resampler;
  std::vector<glm::vec2> m_resampled;
  std::optional<int> m_asked;
};

/// Weights of a Resampler as the shader reads them.
struct TapTables {
  std::vector<std::int32_t> taps;
  std::vector<float> weights;

  void add(const std::vector<Resampler::Tap>& axis) {
    for (const Resampler::Tap& tap : axis) {
      taps.push_back(tap.first);
      taps.push_back(static_cast<std::int32_t>(tap.weights.size()));
      taps.push_back(static_cast<std::int32_t>(weights.size()));
      weights.insert(weights.end(), tap.weights.begin(), tap.weights.end());
    }
  }
};

class GpuTap final : public FrameTap {
 public:
  static Result<std::unique_ptr<FrameTap>> create(Simulation& simulation, glm::ivec2 resolution) {
    auto tap = std::unique_ptr<GpuTap>(new GpuTap(simulation, resolution));
    Result<gpu::ReadbackRing> ring = gpu::ReadbackRing::create("recording", tap->bytes());
    if (!ring) return ring.error();
    tap->m_ring = std::move(*ring);
    if (resolution != simulation.solver().grid().resolution) {
      if (Status made = tap->makeFilter(); !made) return made.error();
    }
    return std::unique_ptr<FrameTap>(std::move(tap));
  }

  bool ask(int frame) override {
    const unsigned texture = m_simulation.solver().velocityTexture();
    if (m_program == nullptr) return m_ring.request(texture, GL_RG, GL_FLOAT, frame);
    // The solver wrote the texture as an image.
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    m_program->use();
    m_program->set("size", m_resolution);
    glBindTextureUnit(0, texture);
    m_cells.bindStorage(0);
    m_taps.bindStorage(1);
    m_weights.bindStorage(2);
    m_program->dispatchOver(m_resolution);
    return m_ring.request(m_cells, 0, bytes(), frame);
  }

  std::optional<Frame> take(Wait wait) override {
    const auto arrived =
        m_ring.takeOldest(wait == Wait::Yes ? gpu::ReadbackRing::Wait::Yes : gpu::ReadbackRing::Wait::No);
    if (!arrived) return std::nullopt;
    m_arrived.resize(bytes() / sizeof(glm::vec2));
    std::memcpy(m_arrived.data(), arrived->bytes.data(), arrived->bytes.size());
    return Frame{static_cast<int>(arrived->tag), m_arrived};
  }

  [[nodiscard]] bool lost() const override { return m_ring.failed(); }

 private:
  GpuTap(Simulation& simulation, glm::ivec2 resolution) : m_simulation(simulation), m_resolution(resolution) {}

  [[nodiscard]] std::size_t bytes() const {
    return static_cast<std::size_t>(m_resolution.x) * static_cast<std::size_t>(m_resolution.y) * sizeof(glm::vec2);
  }

  Status makeFilter() {
    const Resampler resampler(m_simulation.solver().grid().resolution, m_resolution,
                              wrapsOf(*m_simulation.project().field));
    TapTables tables;
    tables.add(resampler.columns());
    tables.add(resampler.rows());
    Result<gpu::Program*> program = m_simulation.shaders()->load(kPrograms[0]);
    if (!program) return program.error();
    m_program = *program;
    const auto keep = [](gpu::Buffer& buffer, Result<gpu::Buffer> made) -> Status {
      if (!made) return made.error();
      buffer = std::move(*made);
      return Done{};
    };
    if (Status kept = keep(m_taps, gpu::Buffer::create("recording taps", std::span<const std::int32_t>(tables.taps)));
        !kept)
      return kept;
    if (Status kept = keep(m_weights, gpu::Buffer::create("recording weights", std::span<const float>(tables.weights)));
        !kept)
      return kept;
    return keep(m_cells, gpu::Buffer::create("recording cells", bytes(), gpu::BufferUse::Static));
  }

  Simulation& m_simulation;
  glm::ivec2 m_resolution;
  gpu::ReadbackRing m_ring;
  gpu::Program* m_program = nullptr;  // null: at the simulation's own resolution
  gpu::Buffer m_cells, m_taps, m_weights;
  std::vector<glm::vec2> m_arrived;
};

}  // namespace

Result<std::unique_ptr<FrameTap>> makeFrameTap(Simulation& simulation, glm::ivec2 resolution) {
  // The card is known exactly on the processor only.
  const bool card = simulation.project().solver->source == WindSource::Card;
  if (simulation.solver().backend() == Backend::Gpu && !card) return GpuTap::create(simulation, resolution);
  return std::unique_ptr<FrameTap>(std::make_unique<ProcessorTap>(simulation, resolution));
}

std::span<const gpu::ProgramSpec> frameTapPrograms() {
  return kPrograms;
}

}  // namespace windloom
