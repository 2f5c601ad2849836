#include "engine/wind/gpu_transport.hpp"

#include <algorithm>
#include <utility>

#include "engine/wind/cpu_viscosity.hpp"
#include "engine/wind/gpu_programs.hpp"

namespace windloom {
namespace {

/// The reading pass names the writer: here always the pass before, through storage buffers.
void afterLastPass() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

glm::ivec2 facesOf(const GpuFields& fields) {
  return {fields.width() + 1, fields.height() + 1};
}

bool hasForces(const GpuFields& fields) {
  const shared::WindBlock& b = fields.block;
  return b.tileColumns > 0 || b.gusts > 0 || b.confinement > 0;
}

}  // namespace

Result<GpuTransport> GpuTransport::create(gpu::ShaderLibrary& shaders) {
  GpuTransport transport;
  const std::pair<const gpu::Program**, const char*> wanted[] = {
      {&transport.m_fill, "wind/fill"},
      {&transport.m_inflow, "wind/inflow"},
      {&transport.m_arrows, "wind/arrows"},
      {&transport.m_forces, "wind/forces"},
      {&transport.m_predict, "wind/predict"},
      {&transport.m_predictSettle, "wind/predict and settle"},
      {&transport.m_correct, "wind/correct"},
      {&transport.m_correctSettle, "wind/correct and settle"},
      {&transport.m_viscosityStart, "wind/viscosity start"},
      {&transport.m_viscosity, "wind/viscosity"},
      {&transport.m_viscositySettle, "wind/viscosity and settle"},
  };
  for (const auto& [program, name] : wanted) {
    const Result<gpu::Program*> loaded = shaders.load(windProgram(name));
    if (!loaded) return loaded.error();
    *program = *loaded;
  }
  return transport;
}

void GpuTransport::fill(const GpuFields& fields) const {
  afterLastPass();
  fields.bindShared();
  fields.carried.bindStorage(WIND_SSBO_CARRIED);
  fields.velocity.bindStorage(WIND_SSBO_RESULT);
  m_fill->dispatchOver(facesOf(fields));
  afterLastPass();
  findInflow(fields);
}

void GpuTransport::findInflow(const GpuFields& fields) const {
  const WindGrid& g = fields.grid;
  const glm::vec2 a = fields.block.ambient;
  const bool enters = (g.xMin == Border::Open && a.x > 0) || (g.xMax == Border::Open && a.x < 0) ||
                      (g.zMin == Border::Open && a.y > 0) || (g.zMax == Border::Open && a.y < 0);
  if (!enters) return;
  fields.velocity.bindStorage(WIND_SSBO_VELOCITY);
  m_inflow->dispatchOver({std::max(g.width, g.height) + 2, 4});
  afterLastPass();
}

void GpuTransport::force(const GpuFields& fields, const GpuArrows& arrows) const {
  // No barrier: the velocity was waited for after the last step, whose report may still run.
  arrows.bind();
  fields.velocity.bindStorage(WIND_SSBO_VELOCITY);
  fields.first.bindStorage(WIND_SSBO_ARROW_INCREMENTS);  // free until the advection
  fields.gustTable.bindStorage(WIND_SSBO_GUSTS);
  if (fields.block.busyTiles > 0) {
    const int side = fields.block.tileSide / WIND_TILE, blocks = fields.block.busyTiles * side * side;
    constexpr int kAcross = 32768;  // work-groups along an axis are limited
    m_arrows->dispatch(std::min(blocks, kAcross), (blocks + kAcross - 1) / kAcross);
    afterLastPass();
  }
  fields.carried.bindStorage(WIND_SSBO_CARRIED);
  fields.control.bindStorage(WIND_SSBO_CONTROL);
  constexpr int kAcross = WIND_FORCE_GROUP_X - 1, kAlong = WIND_FORCE_GROUP_Z - 1;
  m_forces->dispatch((fields.width() + 1 + kAcross - 1) / kAcross, (fields.height() + 1 + kAlong - 1) / kAlong);
}

void GpuTransport::advect(const GpuFields& fields, const gpu::Buffer& carried) const {
  const bool settle = fields.solver.viscosity <= 0;
  afterLastPass();  // carried by the forces, or velocity by the last step's projection
  fields.velocity.bindStorage(WIND_SSBO_VELOCITY);
  carried.bindStorage(WIND_SSBO_CARRIED);
  fields.control.bindStorage(WIND_SSBO_CONTROL);
  if (fields.solver.advection == Advection::SemiLagrangian) {
    fields.moved.bindStorage(WIND_SSBO_FIRST);
    (settle ? m_predictSettle : m_predict)->dispatchOver(facesOf(fields));
    return;
  }
  fields.first.bindStorage(WIND_SSBO_FIRST);
  m_predict->dispatchOver(facesOf(fields));
  afterLastPass();
  fields.moved.bindStorage(WIND_SSBO_RESULT);
  (settle ? m_correctSettle : m_correct)->dispatchOver(facesOf(fields));
}

const gpu::Buffer& GpuTransport::diffuse(const GpuFields& fields) const {
  const gpu::Buffer *previous = &fields.carried, *current = &fields.first;
  fields.moved.bindStorage(WIND_SSBO_CARRIED);  // the right-hand side
  afterLastPass();
  for (const gpu::Buffer* target : {previous, current}) {
    target->bindStorage(WIND_SSBO_RESULT);
    m_viscosityStart->dispatchOver(facesOf(fields));
  }
  const double diagonal = 1 + 2 * double(fields.block.viscosityX) + 2 * double(fields.block.viscosityZ);
  const double s = (diagonal - 1) / diagonal;
  const int sweeps = viscositySweeps(diagonal);
  double c = 1;
  for (int m = 1; m <= sweeps; ++m) {
    if (m == 2) c = 2 / (2 - s * s);
    if (m > 2) c = 1 / (1 - s * s * c / 4);
    const gpu::Program* program = m == sweeps ? m_viscositySettle : m_viscosity;
    afterLastPass();
    program->set("relaxation", static_cast<float>(c));
    current->bindStorage(WIND_SSBO_FIRST);
    previous->bindStorage(WIND_SSBO_RESULT);
    program->dispatchOver(facesOf(fields));
    std::swap(previous, current);
  }
  return *current;
}

const gpu::Buffer& GpuTransport::run(const GpuFields& fields, const GpuArrows& arrows, gpu::GpuTimer& timer) const {
  timer.stage("forces");
  const bool forced = hasForces(fields);
  if (forced) force(fields, arrows);
  timer.stage("advection");
  advect(fields, forced ? fields.carried : fields.velocity);
  if (fields.solver.viscosity <= 0) return fields.moved;
  timer.stage("viscosity");
  return diffuse(fields);
}

}  // namespace windloom
