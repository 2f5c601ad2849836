#include "engine/wind/plain_scheme.hpp"

#include <algorithm>
#include <cmath>

namespace windloom {
namespace {

constexpr gpu::ProgramSpec kPrograms[] = {
    {"wind/plain force", {"wind/plain_force.comp"}},     {"wind/plain curl", {"wind/plain_curl.comp"}},
    {"wind/plain confine", {"wind/plain_confine.comp"}}, {"wind/plain divergence", {"wind/plain_divergence.comp"}},
    {"wind/plain sweep", {"wind/plain_sweep.comp"}},     {"wind/plain subtract", {"wind/plain_subtract.comp"}},
    {"wind/plain advect", {"wind/plain_advect.comp"}},
};

}  // namespace

std::span<const gpu::ProgramSpec> plainPrograms() {
  return kPrograms;
}

Result<PlainScheme> PlainScheme::create(gpu::ShaderLibrary& shaders, glm::ivec2 cells) {
  PlainScheme scheme;
  scheme.m_cells = cells;
  for (std::size_t n = 0; n < kPasses; ++n) {
    const Result<gpu::Program*> program = shaders.load(kPrograms[n]);
    if (!program) return program.error();
    scheme.m_programs[n] = *program;
  }
  const std::pair<gpu::Texture*, GLenum> wanted[] = {
      {&scheme.m_velocity[0], GL_RG32F}, {&scheme.m_velocity[1], GL_RG32F}, {&scheme.m_pressure[0], GL_R32F},
      {&scheme.m_pressure[1], GL_R32F},  {&scheme.m_curl, GL_R32F},         {&scheme.m_divergence, GL_R32F}};
  for (const auto& [texture, format] : wanted) {
    Result<gpu::Texture> made = gpu::Texture::create2D("plain scheme", cells, format, {.filter = gpu::Filter::Linear});
    if (!made) return made.error();
    *texture = std::move(*made);
    texture->clear();
  }
  return scheme;
}

void PlainScheme::run(Pass pass, std::initializer_list<const gpu::Texture*> inputs, const gpu::Texture& output) const {
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // inputs by the passes before
  unsigned unit = 0;
  for (const gpu::Texture* input : inputs) input->bind(unit++);
  output.bindImage(0, GL_WRITE_ONLY);
  m_programs[pass]->set("dt", m_dt);
  m_programs[pass]->dispatchOver(m_cells);
}

/// From the divergence to the pressure in m_pressure[0].
void PlainScheme::solve() {
  static_assert(kSweeps % 2 == 0, "an even number of sweeps ends where it began");
  for (int n = 0; n < kSweeps; ++n) run(Sweep, {&m_pressure[n % 2], &m_divergence}, m_pressure[1 - n % 2]);
}

/// Forces and confinement, then the divergence of the result.
void PlainScheme::transport(float dt) {
  m_dt = dt;
  run(Force, {&m_velocity[m_at]}, m_velocity[1 - m_at]);
  m_at = 1 - m_at;
  run(Curl, {&m_velocity[m_at]}, m_curl);
  run(Confine, {&m_velocity[m_at], &m_curl}, m_velocity[1 - m_at]);
  m_at = 1 - m_at;
  run(Divergence, {&m_velocity[m_at]}, m_divergence);
}

void PlainScheme::subtract() {
  run(Subtract, {&m_velocity[m_at], &m_pressure[0]}, m_velocity[1 - m_at]);
  m_at = 1 - m_at;
}

void PlainScheme::advect() {
  run(Advect, {&m_velocity[m_at]}, m_velocity[1 - m_at]);
  m_at = 1 - m_at;
}

void PlainScheme::step(float dt) {
  transport(dt);
  solve();
  subtract();
  advect();
}

std::pair<double, double> PlainScheme::measureStep(float dt) {
  transport(dt);
  const double before = rootMeanSquare(m_divergence);
  solve();
  subtract();
  run(Divergence, {&m_velocity[m_at]}, m_divergence);
  const double after = rootMeanSquare(m_divergence);
  advect();
  return {before, after};
}

void PlainScheme::setVelocity(std::span<const glm::vec2> cells) {
  WL_REQUIRE(cells.size() == static_cast<std::size_t>(m_cells.x) * static_cast<std::size_t>(m_cells.y),
             "a velocity for each cell");
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  m_velocity[m_at].upload(GL_RG, GL_FLOAT, cells.data());
  m_pressure[0].clear();
}

double PlainScheme::rootMeanSquare(const gpu::Texture& texture) const {
  std::vector<float> values(static_cast<std::size_t>(m_cells.x) * static_cast<std::size_t>(m_cells.y));
  texture.read(GL_RED, GL_FLOAT, values.data(), values.size() * sizeof(float));
  double sum = 0;
  for (const float value : values) sum += double(value) * double(value);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

std::pair<double, double> PlainScheme::measureProjection() {
  m_pressure[0].clear();
  run(Divergence, {&m_velocity[m_at]}, m_divergence);
  const double before = rootMeanSquare(m_divergence);
  solve();
  subtract();
  run(Divergence, {&m_velocity[m_at]}, m_divergence);
  m_at = 1 - m_at;
  return {before, rootMeanSquare(m_divergence)};
}

std::size_t PlainScheme::memoryBytes() const {
  return static_cast<std::size_t>(m_cells.x) * static_cast<std::size_t>(m_cells.y) * (2 * 8 + 4 * 4);
}

void plainJacobiSweep(ThreadPool& pool, int width, int height, std::span<const float> p,
                      std::span<const float> divergence, std::span<float> next) {
  const auto w = static_cast<std::size_t>(width);
  const std::vector<float> outside(w, 0.0f);
  constexpr int kRows = 64;
  pool.parallelFor((height + kRows - 1) / kRows, [&](int chunk) {
    const int end = std::min(height, (chunk + 1) * kRows);
    for (int k = chunk * kRows; k < end; ++k) {
      const float* own = p.data() + static_cast<std::size_t>(k) * w;
      const float* low = k > 0 ? own - w : outside.data();
      const float* high = k < height - 1 ? own + w : outside.data();
      const float* d = divergence.data() + static_cast<std::size_t>(k) * w;
      float* out = next.data() + static_cast<std::size_t>(k) * w;
      out[0] = 0.25f * ((w > 1 ? own[1] : 0.0f) + low[0] + high[0] - d[0]);
      for (std::size_t i = 1; i + 1 < w; ++i) out[i] = 0.25f * (own[i - 1] + own[i + 1] + low[i] + high[i] - d[i]);
      if (w > 1) out[w - 1] = 0.25f * (own[w - 2] + low[w - 1] + high[w - 1] - d[w - 1]);
    }
  });
}

}  // namespace windloom
