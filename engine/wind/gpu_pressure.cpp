// Multigrid as in docs/solver.md section 6, cut for few dispatches: one takes two levels down, one takes a level up
// with all its sweeps, and the small levels share one work-group.
#include "engine/wind/gpu_pressure.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "engine/wind/dense_inverse.hpp"
#include "engine/wind/gpu_levels.hpp"
#include "engine/wind/gpu_programs.hpp"

namespace windloom {
namespace {

constexpr std::size_t kBlockStride = 256;  // uniform ranges begin at multiples of this on every driver
static_assert(WIND_DOWN_INNER(WIND_FINE_REGION) % 2 == 0 && WIND_DOWN_INNER(WIND_COARSE_REGION) % 2 == 0,
              "cells of the level after the next don't straddle work-groups");
static_assert(WIND_HALO % 2 == 0, "the cells of a coarser one lie in the same region");
static_assert(WIND_STRIP % 2 == 0 && WIND_FINE_REGION * WIND_FINE_REGION / WIND_STRIP <= 1024,
              "whole coarse rows in a strip");

std::size_t commandOffset(std::size_t command) {
  return offsetof(shared::WindControl, groups) + command * 4 * sizeof(shared::uint);
}

int groupsAcross(int cells, int inner) {
  return (cells + inner - 1) / inner;
}

std::size_t sharedMemoryLimit() {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &limit);
  return static_cast<std::size_t>(limit);
}

Status make(gpu::Buffer& target, const char* label, std::size_t bytes, gpu::BufferUse use = gpu::BufferUse::Static,
            const void* data = nullptr) {
  Result<gpu::Buffer> made = gpu::Buffer::create(label, bytes, use, data);
  if (!made) return made.error();
  target = std::move(*made);
  return Done{};
}

/// The reading pass names the writer: every pass of the solve reads what the one before it wrote to storage buffers,
/// and those of the cycles after the first also their work-groups.
void afterLastPass(const gpu::Buffer* commands = nullptr) {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | (commands != nullptr ? GL_COMMAND_BARRIER_BIT : 0u));
}

/// Runs a pass on these work-groups, or on those that a buffer of commands says.
void dispatch(const gpu::Program& program, glm::ivec2 groups, const gpu::Buffer* commands, std::size_t command) {
  if (commands == nullptr) {
    program.dispatch(groups.x, groups.y);
  } else {
    program.dispatchIndirect(*commands, commandOffset(command));
  }
}

}  // namespace

Result<GpuPressure> GpuPressure::create(GpuFields& fields, gpu::ShaderLibrary& shaders) {
  GpuPressure pressure;
  pressure.m_shaders = &shaders;
  const std::size_t bytes = fields.grid.solid.size() * sizeof(float);
  for (gpu::Buffer* plane : {&pressure.m_phi, &pressure.m_predicted, &pressure.m_d, &pressure.m_flux}) {
    if (Status made = make(*plane, "wind pressure", bytes); !made) return made.error();
  }
  if (Status made = pressure.rebuild(fields); !made) return made.error();
  return pressure;
}

Status GpuPressure::rebuild(GpuFields& fields) {
  std::vector<PressureLevel> levels = buildPressureLevels(fields.grid, FinestLevel::SizeOnly);
  if (levels.size() == 1) {  // one cell: a second level like it keeps the passes the same
    levels = buildPressureLevels(fields.grid);
    levels.push_back(levels.front());
  }
  WL_REQUIRE(levels.size() <= WIND_MAX_LEVELS, "levels shrink by two");
  const std::size_t own = firstOfTail(levels, sharedMemoryLimit());
  m_levels.clear();
  m_levels.resize(own);
  for (std::size_t l = 1; l < own; ++l) {
    if (Status made = makeLevel(m_levels[l], levels[l]); !made) return made;
  }
  if (Status made = makeTail(levels, own); !made) return made;
  if (Status sent = sendLevels(levels, fields.grid); !sent) return sent;
  fields.block.ownLevels = static_cast<int>(own);
  fields.block.allLevels = static_cast<int>(levels.size());
  return loadPrograms();
}

Status GpuPressure::makeLevel(Level& level, const PressureLevel& source) {
  const std::vector<shared::uint> faces = packFaces(source);
  if (Status made = make(level.faces, "wind level faces", faces.size() * sizeof(shared::uint), gpu::BufferUse::Static,
                         faces.data());
      !made) {
    return made;
  }
  for (gpu::Buffer* buffer : {&level.flux, &level.d}) {
    if (Status made = make(*buffer, "wind level", cellCount(source) * sizeof(float)); !made) return made;
  }
  return Done{};
}

Status GpuPressure::makeTail(std::span<const PressureLevel> levels, std::size_t first) {
  std::vector<shared::uint> faces;
  for (const PressureLevel& level : levels.subspan(first)) {
    const std::vector<shared::uint> own = packFaces(level);
    faces.insert(faces.end(), own.begin(), own.end());
  }
  const std::size_t bytes = cellCount(levels[first]) * sizeof(float);
  if (Status made = make(m_tail.faces, "wind tail faces", faces.size() * sizeof(shared::uint), gpu::BufferUse::Static,
                         faces.data());
      !made) {
    return made;
  }
  if (Status made = make(m_tail.flux, "wind tail flux", bytes); !made) return made;
  if (Status made = make(m_tail.d, "wind tail result", bytes); !made) return made;
  const std::vector<float> inverse = denseInverse(levels.back());
  if (Status made = make(m_lastInverse, "wind last inverse", inverse.size() * sizeof(float), gpu::BufferUse::Static,
                         inverse.data());
      !made) {
    return made;
  }
  const TailSize size = tailSize(levels, first);
  std::size_t widest = 0;
  for (const PressureLevel& level : levels.subspan(first)) widest = std::max(widest, cellCount(level));
  const std::size_t strides = (widest + WIND_TAIL_GROUP - 1) / WIND_TAIL_GROUP;
  m_tailDefines = "TAIL_CELLS=" + std::to_string(size.cells) + " TAIL_FIRST=" + std::to_string(size.first) +
                  " TAIL_NODES=" + std::to_string(std::max<std::size_t>(size.nodes, 1)) +
                  " TAIL_STRIDES=" + std::to_string(strides) + " TAIL_LAST=" + std::to_string(size.last);
  return Done{};
}

Status GpuPressure::sendLevels(std::span<const PressureLevel> levels, const WindGrid& grid) {
  std::vector<shared::WindLevel> blocks(WIND_MAX_LEVELS);
  const PressureLevel none;
  int cells = 0, faces = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    shared::WindLevel& b = blocks[l];
    const PressureLevel& next = l + 1 < levels.size() ? levels[l + 1] : none;
    const PressureLevel& afterNext = l + 2 < levels.size() ? levels[l + 2] : none;
    b.width = levels[l].width;
    b.height = levels[l].height;
    b.coarseWidth = next.width;
    b.coarseHeight = next.height;
    b.factorX = next.factorX;
    b.factorZ = next.factorZ;
    b.xMin = windBorderCode(grid.xMin);
    b.xMax = windBorderCode(grid.xMax);
    b.zMin = windBorderCode(grid.zMin);
    b.zMax = windBorderCode(grid.zMax);
    b.scaleX = levels[l].scale.x;
    b.scaleZ = levels[l].scale.y;
    b.coarseScaleX = next.scale.x;
    b.coarseScaleZ = next.scale.y;
    b.coarseFactorX = afterNext.factorX;
    b.coarseFactorZ = afterNext.factorZ;
    const int region = l == 0 ? WIND_FINE_REGION : WIND_COARSE_REGION;
    b.upGroupsX = groupsAcross(b.width, WIND_INNER(region));
    b.upGroupsZ = groupsAcross(b.height, WIND_INNER(region));
    b.downGroupsX = groupsAcross(b.coarseWidth, WIND_DOWN_INNER(region));
    b.downGroupsZ = groupsAcross(b.coarseHeight, WIND_DOWN_INNER(region));
    if (l < m_levels.size()) continue;
    b.cells = cells;
    b.faces = faces;
    cells += b.width * b.height;
    if (l > m_levels.size()) faces += (b.width + 1) * (b.height + 1);
  }
  if (Status made = findKinds(levels, grid, blocks); !made) return made;
  for (std::size_t l = 0; l + 1 < m_levels.size(); ++l) {
    const bool second = l > 0 && blocks[l - 1].pair != 0;
    blocks[l].pair = !second && makesPair(levels[l], levels[l + 1], grid) ? 1 : 0;
  }
  std::vector<char> spread(kBlockStride * m_levels.size());
  for (std::size_t l = 0; l < m_levels.size(); ++l) {
    m_levels[l].block = blocks[l];
    std::memcpy(&spread[l * kBlockStride], &blocks[l], sizeof blocks[l]);
  }
  if (Status made = make(m_levelBlocks, "wind level blocks", spread.size(), gpu::BufferUse::Static, spread.data());
      !made)
    return made;
  return make(m_allLevels, "wind levels", blocks.size() * sizeof blocks[0], gpu::BufferUse::Static, blocks.data());
}

/// Looks at every region of every pass: plain ones are swept without a look at what lies around each cell.
Status GpuPressure::findKinds(std::span<const PressureLevel> levels, const WindGrid& grid,
                              std::vector<shared::WindLevel>& blocks) {
  std::vector<shared::uint> kinds;
  for (std::size_t l = 0; l < m_levels.size(); ++l) {
    shared::WindLevel& b = blocks[l];
    const PlainCells plain = l == 0 ? PlainCells(grid) : PlainCells(levels[l], packFaces(levels[l]));
    const int region = l == 0 ? WIND_FINE_REGION : WIND_COARSE_REGION;
    const glm::ivec2 factor(b.factorX, b.factorZ);
    const auto add = [&](const RegionTiling& tiling) {
      const std::vector<shared::uint> own = kindsOf(plain, tiling);
      kinds.insert(kinds.end(), own.begin(), own.end());
      return static_cast<int>(kinds.size() - own.size());
    };
    b.downKinds = add({WIND_DOWN_INNER(region) * factor, factor + 2, {b.downGroupsX, b.downGroupsZ}, region});
    b.upKinds = add({glm::ivec2(WIND_INNER(region)), glm::ivec2(WIND_HALO), {b.upGroupsX, b.upGroupsZ}, region});
    // A plain strip is corrected in pairs of rows and columns.
    if (factor != glm::ivec2(2)) std::fill(kinds.begin() + b.upKinds, kinds.end(), 0u);
  }
  return make(m_kinds, "wind region kinds", kinds.size() * sizeof(shared::uint), gpu::BufferUse::Static, kinds.data());
}

Status GpuPressure::loadPrograms() {
  Error failure{ErrorKind::Machine, {}};
  const auto load = [&](const gpu::ProgramSpec& spec, std::string_view more = {}) -> const gpu::Program* {
    const Result<gpu::Program*> program = m_shaders->load(spec, more);
    if (program) return *program;
    failure.problems.insert(failure.problems.end(), program.error().problems.begin(), program.error().problems.end());
    return nullptr;
  };
  m_first = load(windProgram("wind/pressure first"));
  m_again = load(windProgram("wind/pressure again"));
  m_down = load(windProgram("wind/pressure down"));
  m_up = load(windProgram("wind/pressure up"));
  m_top = load(windProgram("wind/pressure top"));
  gpu::ProgramSpec tail = windProgram("wind/pressure tail");
  tail.defines = m_tailDefines;
  m_runTail = load(tail);
  tail = windProgram("wind/pressure tail start");
  const std::string defines = "START " + m_tailDefines;
  tail.defines = defines;
  m_startTail = load(tail);
  m_start = load(windProgram("wind/start"));
  m_endCycle = load(windProgram("wind/end of cycle"));
  m_report = load(windProgram("wind/report"));
  m_adopt = load(windProgram("wind/adopt"));
  m_jacobiFirst = load(windProgram("wind/jacobi first"));
  m_jacobi = load(windProgram("wind/jacobi"));
  m_project = load(windProgram("wind/project"));
  m_projectJacobi = load(windProgram("wind/project jacobi"));
  if (!failure.problems.empty()) return failure;
  return Done{};
}

const gpu::Buffer& GpuPressure::fluxOf(std::size_t level) const {
  return level == 0 ? m_flux : at(level).flux;
}
const gpu::Buffer& GpuPressure::resultOf(std::size_t level) const {
  return level == 0 ? m_d : at(level).d;
}
const GpuPressure::Level& GpuPressure::at(std::size_t level) const {
  return level < m_levels.size() ? m_levels[level] : m_tail;
}

void GpuPressure::bindLevel(std::size_t level) const {
  m_levelBlocks.bindUniformRange(WIND_UBO_LEVEL, level * kBlockStride, sizeof(shared::WindLevel));
  fluxOf(level).bindStorage(WIND_SSBO_FLUX);
  m_kinds.bindStorage(WIND_SSBO_KINDS);
  if (level > 0) at(level).faces.bindStorage(WIND_SSBO_FACES);
  at(level + 1).faces.bindStorage(WIND_SSBO_COARSE_FACES);
}

/// The level's way down, and the next one's where they make a pair; the level that comes after.
std::size_t GpuPressure::goDown(std::size_t level, const gpu::Program& program, const gpu::Buffer* commands) {
  const shared::WindLevel& block = m_levels[level].block;
  afterLastPass(commands);
  bindLevel(level);
  m_d.bindStorage(WIND_SSBO_D_IN);  // the last cycle's, which the next one begins with on level 0
  fluxOf(level + 1).bindStorage(WIND_SSBO_COARSE);
  if (block.pair != 0) fluxOf(level + 2).bindStorage(WIND_SSBO_COARSER);
  dispatch(program, {block.downGroupsX, block.downGroupsZ}, commands, WIND_COMMAND_DOWN + level);
  return level + (block.pair != 0 ? 2 : 1);
}

void GpuPressure::goUp(std::size_t level, const gpu::Buffer* commands) {
  const shared::WindLevel& block = m_levels[level].block;
  afterLastPass(commands);
  bindLevel(level);
  resultOf(level).bindStorage(WIND_SSBO_D_OUT);
  resultOf(level + 1).bindStorage(WIND_SSBO_COARSE);
  dispatch(level == 0 ? *m_top : *m_up, {block.upGroupsX, block.upGroupsZ}, commands, WIND_COMMAND_UP + level);
}

void GpuPressure::runTail(const gpu::Program& program, const gpu::Buffer* commands) {
  afterLastPass(commands);
  m_tail.faces.bindStorage(WIND_SSBO_FACES);
  m_tail.flux.bindStorage(WIND_SSBO_FLUX);
  m_tail.d.bindStorage(WIND_SSBO_D_OUT);
  m_lastInverse.bindStorage(WIND_SSBO_DENSE);
  dispatch(program, {1, 1}, commands, WIND_COMMAND_TAIL);
}

/// Adds up what `groups` work-groups of the last pass delivered.
void GpuPressure::addUp(const gpu::Program& program, glm::ivec2 groups, const gpu::Buffer* commands) const {
  afterLastPass(commands);
  program.set("sumGroups", groups.x * groups.y);
  dispatch(program, {1, 1}, commands, WIND_COMMAND_TAIL);
}

/// The flux pass; where the expected pressure may be of no use, also the look whether it is, and the pass without it.
std::size_t GpuPressure::findFlux(const GpuFields& fields) {
  m_predicted.bindStorage(WIND_SSBO_PREDICTED);
  const std::size_t next = goDown(0, *m_first, nullptr);
  const shared::WindLevel& level = m_levels[0].block;
  const glm::ivec2 groups(level.downGroupsX, level.downGroupsZ);
  if (fields.block.mayDrop == 0) {
    m_startTail->set("sumGroups", groups.x * groups.y);
    return next;
  }
  addUp(*m_start, groups, nullptr);
  afterLastPass(&fields.control);
  m_first->dispatchIndirect(fields.control, commandOffset(WIND_COMMAND_FIRST));
  addUp(*m_start, groups, nullptr);
  return next;
}

/// From the flux to `cycles` V-cycles. The first one always runs: a dispatch whose work-groups the GPU must look up
/// takes longer.
void GpuPressure::recordCycles(const GpuFields& fields, int cycles) {
  const shared::WindLevel& finest = m_levels[0].block;
  const gpu::Program& firstTail = fields.block.mayDrop == 0 ? *m_startTail : *m_runTail;
  std::size_t next = findFlux(fields);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const gpu::Buffer* commands = cycle > 0 ? &fields.control : nullptr;
    if (cycle > 0) next = goDown(0, *m_again, commands);
    while (next < m_levels.size()) next = goDown(next, *m_down, commands);
    runTail(cycle > 0 ? *m_runTail : firstTail, commands);
    m_top->set("cycle", cycle);
    for (std::size_t l = m_levels.size(); l-- > 0;) goUp(l, commands);
    addUp(*m_endCycle, {finest.upGroupsX, finest.upGroupsZ}, commands);
  }
}

void GpuPressure::solveMultigrid(const GpuFields& fields, SolveStart start, int cycles) {
  if (start == SolveStart::Cold) {
    recordCycles(fields, 1);
    afterLastPass();
    m_d.bindStorage(WIND_SSBO_D_IN);
    m_predicted.bindStorage(WIND_SSBO_PREDICTED);
    m_adopt->dispatchOver({fields.width(), fields.height()});
  }
  recordCycles(fields, cycles);
}

void GpuPressure::solveJacobi(const GpuFields& fields, const gpu::Buffer& spare, int sweeps) {
  // The result must end up in m_d; rounds of sweeps take turns between it and a buffer that is free.
  const int rounds = std::max((sweeps + WIND_HALO - 1) / WIND_HALO, 1);
  const glm::ivec2 groups(m_levels[0].block.upGroupsX, m_levels[0].block.upGroupsZ);
  bindLevel(0);
  for (int round = 0; round < rounds; ++round) {
    const gpu::Program& program = round == 0 ? *m_jacobiFirst : *m_jacobi;
    const bool last = (rounds - 1 - round) % 2 == 0;
    program.set("sweepCount", std::clamp(sweeps - round * WIND_HALO, 1, WIND_HALO));
    afterLastPass();
    (last ? spare : m_d).bindStorage(WIND_SSBO_D_IN);
    (last ? m_d : spare).bindStorage(WIND_SSBO_D_OUT);
    program.dispatch(groups.x, groups.y);
    if (round > 0) continue;
    addUp(*m_start, groups, nullptr);
    afterLastPass(&fields.control);
    program.dispatchIndirect(fields.control, commandOffset(WIND_COMMAND_FIRST));
    addUp(*m_start, groups, nullptr);
  }
}

void GpuPressure::solve(const GpuFields& fields, const gpu::Buffer& star, SolveStart start, int cycles) {
  m_allLevels.bindUniform(WIND_UBO_LEVELS);
  star.bindStorage(WIND_SSBO_VELOCITY);
  m_predicted.bindStorage(WIND_SSBO_PREDICTED);
  m_phi.bindStorage(WIND_SSBO_PHI);
  fields.control.bindStorage(WIND_SSBO_CONTROL);
  const gpu::Buffer& spare = bindScratch(fields, star);
  if (fields.solver.pressure == Pressure::Jacobi) {
    solveJacobi(fields, spare, fields.solver.jacobiSweeps);
  } else {
    solveMultigrid(fields, start, cycles);
  }
}

const gpu::Buffer& GpuPressure::bindScratch(const GpuFields& fields, const gpu::Buffer& star) {
  // Nothing needs the velocity of the last step any more, nor what only the advection used: each has room for two
  // planes.
  const gpu::Buffer* free[] = {&fields.carried, &fields.first, &fields.moved};
  const auto end =
      std::remove_if(std::begin(free), std::end(free), [&](const gpu::Buffer* b) { return b->name() == star.name(); });
  WL_REQUIRE(end - std::begin(free) == 2, "q* lies in one of the buffers of the advection");
  free[0]->bindStorage(WIND_SSBO_JOINED);
  free[1]->bindStorage(WIND_SSBO_APPLIED);
  fields.velocity.bindStorage(WIND_SSBO_LAST_APPLIED);
  return *free[0];
}

void GpuPressure::project(const GpuFields& fields, const gpu::Buffer& star, const gpu::Buffer& result) {
  afterLastPass();  // d by the solve
  bindScratch(fields, star);
  star.bindStorage(WIND_SSBO_VELOCITY);
  result.bindStorage(WIND_SSBO_RESULT);
  m_predicted.bindStorage(WIND_SSBO_PREDICTED);
  m_phi.bindStorage(WIND_SSBO_PHI);
  m_d.bindStorage(WIND_SSBO_D_IN);
  m_flux.bindStorage(WIND_SSBO_D_OUT);  // no longer needed: takes what the next step's pressure is expected to be
  fields.control.bindStorage(WIND_SSBO_CONTROL);
  fields.cells.bindImage(WIND_IMAGE_CELLS, GL_WRITE_ONLY);
  const gpu::Program* program = fields.solver.pressure == Pressure::Jacobi ? m_projectJacobi : m_project;
  const glm::ivec2 groups(
      (fields.width() + WIND_GROUP_X - 1) / WIND_GROUP_X,
      (fields.height() + WIND_GROUP_Z * WIND_PROJECT_STRIP - 1) / (WIND_GROUP_Z * WIND_PROJECT_STRIP));
  program->dispatch(groups.x, groups.y);
  addUp(*m_report, groups, nullptr);
  std::swap(m_predicted, m_flux);
}

std::size_t GpuPressure::memoryBytes() const {
  std::size_t sum = m_levelBlocks.bytes() + m_allLevels.bytes() + m_lastInverse.bytes() + m_kinds.bytes();
  for (const gpu::Buffer* b : {&m_phi, &m_predicted, &m_d, &m_flux, &m_tail.faces, &m_tail.flux, &m_tail.d})
    sum += b->bytes();
  for (const Level& level : m_levels) {
    for (const gpu::Buffer* b : {&level.faces, &level.flux, &level.d}) sum += b->bytes();
  }
  return sum;
}

}  // namespace windloom
