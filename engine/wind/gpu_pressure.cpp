// Multigrid as in docs/solver.md section 6, cut for few dispatches: levels are coarsened by four, a dispatch does all
// sweeps of a level with what comes before and after them, and the small levels share one work-group.
#include "engine/wind/gpu_pressure.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>

#include "engine/wind/gpu_programs.hpp"

namespace windloom {
namespace {

constexpr std::size_t kBlockStride = 256;  // uniform ranges begin at multiples of this on every driver
constexpr CoarseningRule kCoarsening = WIND_GPU_COARSENING == 4 ? coarseningByFour : coarseningOf;
static_assert(WIND_INNER % WIND_GPU_COARSENING == 0, "coarse cells don't straddle work-groups");
static_assert(WIND_GPU_SWEEPS < WIND_HALO, "the residual after the sweeps needs one cell more");
static_assert(WIND_REGION % WIND_STRIP == 0 && WIND_REGION * WIND_STRIPS <= 1024, "a work-group of whole strips");

std::size_t commandOffset(std::size_t level) {
  return offsetof(shared::WindControl, groups) + level * 4 * sizeof(shared::uint);
}

std::size_t cellCount(const PressureLevel& level) {
  return static_cast<std::size_t>(level.width) * static_cast<std::size_t>(level.height);
}

int groupsAcross(int cells) {
  return (cells + WIND_INNER - 1) / WIND_INNER;
}

/// Conductances and shares of the low faces of each node, (width + 1) x (height + 1).
std::vector<glm::vec4> packFaces(const PressureLevel& level) {
  const std::size_t w = static_cast<std::size_t>(level.width), h = static_cast<std::size_t>(level.height);
  std::vector<glm::vec4> faces((w + 1) * (h + 1), glm::vec4(0));
  for (std::size_t k = 0; k <= h; ++k) {
    for (std::size_t i = 0; i <= w; ++i) {
      glm::vec4& node = faces[k * (w + 1) + i];
      if (k < h) node.x = level.cx[k * (w + 1) + i];
      if (k < h) node.z = level.shareX[k * (w + 1) + i];
      if (i < w) node.y = level.cz[k * w + i];
      if (i < w) node.w = level.shareZ[k * w + i];
    }
  }
  return faces;
}

/// Floats of shared memory the tail needs from level `first` on: d, right-hand sides, residuals.
struct TailSize {
  std::size_t cells = 0, rhs = 0, residuals = 0;
  [[nodiscard]] std::size_t bytes() const { return (cells + rhs + residuals) * sizeof(float); }
};
TailSize tailSize(std::span<const PressureLevel> levels, std::size_t first) {
  TailSize size;
  for (std::size_t l = first; l < levels.size(); ++l) {
    size.cells += cellCount(levels[l]);
    if (l > first) size.rhs += cellCount(levels[l]);
    size.residuals = std::max(size.residuals, cellCount(levels[l]));
  }
  size.rhs = std::max<std::size_t>(size.rhs, 1);
  return size;
}

/// The first level that the tail can take over.
std::size_t firstOfTail(std::span<const PressureLevel> levels) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &limit);
  for (std::size_t first = 1;; ++first) {
    const bool last = first + 1 == levels.size();
    if (last || (cellCount(levels[first]) <= WIND_TAIL_CELLS &&
                 tailSize(levels, first).bytes() <= static_cast<std::size_t>(limit))) {
      return first;
    }
  }
}

Status make(gpu::Buffer& target, const char* label, std::size_t bytes, gpu::BufferUse use = gpu::BufferUse::Static,
            const void* data = nullptr) {
  Result<gpu::Buffer> made = gpu::Buffer::create(label, bytes, use, data);
  if (!made) return made.error();
  target = std::move(*made);
  return Done{};
}

/// The reading pass names the writer: every pass of the solve reads what the one before it wrote to storage buffers.
void afterLastPass() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
}

}  // namespace

Result<GpuPressure> GpuPressure::create(GpuFields& fields, gpu::ShaderLibrary& shaders) {
  GpuPressure pressure;
  pressure.m_shaders = &shaders;
  const std::size_t bytes = fields.grid.solid.size() * sizeof(float);
  for (gpu::Buffer& plane : pressure.m_planes) {
    if (Status made = make(plane, "wind pressure", bytes); !made) return made.error();
  }
  if (Status made = make(pressure.m_flux, "wind flux", bytes); !made) return made.error();
  if (Status made = pressure.rebuild(fields); !made) return made.error();
  return pressure;
}

Status GpuPressure::rebuild(GpuFields& fields) {
  std::vector<PressureLevel> levels = buildPressureLevels(fields.grid, kCoarsening, FinestLevel::SizeOnly);
  if (levels.size() == 1) {  // one cell: a second level like it keeps the passes the same
    levels = buildPressureLevels(fields.grid);
    levels.push_back(levels.front());
  }
  WL_REQUIRE(levels.size() <= WIND_COMMAND_FIRST, "levels shrink by four");
  const std::size_t own = firstOfTail(levels);
  m_levels.clear();
  m_levels.resize(own);
  for (std::size_t l = 0; l < own; ++l) {
    m_levels[l].factor = {levels[l + 1].factorX, levels[l + 1].factorZ};
    if (l == 0) continue;
    if (Status made = makeLevel(m_levels[l], levels[l]); !made) return made;
  }
  if (Status made = makeTail(levels, own); !made) return made;
  if (Status sent = sendLevels(levels, fields.grid); !sent) return sent;
  fields.block.ownLevels = static_cast<int>(own);
  fields.block.allLevels = static_cast<int>(levels.size());
  return loadPrograms();
}

Status GpuPressure::makeLevel(Level& level, const PressureLevel& source) {
  const std::vector<glm::vec4> faces = packFaces(source);
  const std::size_t bytes = cellCount(source) * sizeof(float);
  if (Status made =
          make(level.faces, "wind level faces", faces.size() * sizeof(glm::vec4), gpu::BufferUse::Static, faces.data());
      !made) {
    return made;
  }
  if (Status made =
          make(level.inverse, "wind level diagonal", bytes, gpu::BufferUse::Static, source.inverseDiagonal.data());
      !made) {
    return made;
  }
  for (gpu::Buffer* buffer : {&level.flux, &level.down, &level.up}) {
    if (Status made = make(*buffer, "wind level", bytes); !made) return made;
  }
  return Done{};
}

Status GpuPressure::makeTail(std::span<const PressureLevel> levels, std::size_t first) {
  std::vector<glm::vec4> faces;
  std::vector<float> inverse;
  for (const PressureLevel& level : levels.subspan(first)) {
    const std::vector<glm::vec4> own = packFaces(level);
    faces.insert(faces.end(), own.begin(), own.end());
    inverse.insert(inverse.end(), level.inverseDiagonal.begin(), level.inverseDiagonal.end());
  }
  const std::size_t bytes = cellCount(levels[first]) * sizeof(float);
  if (Status made =
          make(m_tailFaces, "wind tail faces", faces.size() * sizeof(glm::vec4), gpu::BufferUse::Static, faces.data());
      !made) {
    return made;
  }
  if (Status made = make(m_tailInverse, "wind tail diagonals", inverse.size() * sizeof(float), gpu::BufferUse::Static,
                         inverse.data());
      !made) {
    return made;
  }
  if (Status made = make(m_tailFlux, "wind tail flux", bytes); !made) return made;
  if (Status made = make(m_tailUp, "wind tail result", bytes); !made) return made;
  const TailSize size = tailSize(levels, first);
  const std::size_t strides = (size.residuals + WIND_TAIL_GROUP - 1) / WIND_TAIL_GROUP;
  m_tailDefines = "TAIL_CELLS=" + std::to_string(size.cells) + " TAIL_RHS=" + std::to_string(size.rhs) +
                  " TAIL_RESIDUALS=" + std::to_string(size.residuals) + " TAIL_STRIDES=" + std::to_string(strides);
  return Done{};
}

Status GpuPressure::sendLevels(std::span<const PressureLevel> levels, const WindGrid& grid) {
  std::vector<shared::WindLevel> blocks(WIND_MAX_LEVELS);
  int cells = 0, rhs = 0, faces = 0;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    shared::WindLevel& b = blocks[l];
    const PressureLevel* next = l + 1 < levels.size() ? &levels[l + 1] : nullptr;
    b.width = levels[l].width;
    b.height = levels[l].height;
    b.coarseWidth = next ? next->width : 0;
    b.coarseHeight = next ? next->height : 0;
    b.factorX = next ? next->factorX : 1;
    b.factorZ = next ? next->factorZ : 1;
    b.xMin = windBorderCode(grid.xMin);
    b.xMax = windBorderCode(grid.xMax);
    b.zMin = windBorderCode(grid.zMin);
    b.zMax = windBorderCode(grid.zMax);
    b.groupsX = groupsAcross(b.width);
    b.groupsZ = groupsAcross(b.height);
    if (l < m_levels.size()) continue;
    b.cells = cells;
    b.faces = faces;
    b.rhs = l == m_levels.size() ? -1 : rhs;
    cells += b.width * b.height;
    faces += (b.width + 1) * (b.height + 1);
    if (b.rhs >= 0) rhs += b.width * b.height;
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

Status GpuPressure::loadPrograms() {
  Error failure{ErrorKind::Machine, {}};
  const auto load = [&](const gpu::ProgramSpec& spec, std::string_view more = {}) -> const gpu::Program* {
    const Result<gpu::Program*> program = m_shaders->load(spec, more);
    if (program) return *program;
    failure.problems.insert(failure.problems.end(), program.error().problems.begin(), program.error().problems.end());
    return nullptr;
  };
  for (std::size_t l = 0; l < m_levels.size(); ++l) {
    Level& level = m_levels[l];
    level.downward = load(pressureProgram(l == 0 ? "again" : "down", level.factor));
    level.upward = load(pressureProgram(l == 0 ? "top" : "up", level.factor));
  }
  m_first = load(pressureProgram("first", m_levels[0].factor));
  gpu::ProgramSpec tail = windProgram("wind/pressure tail");
  tail.defines = m_tailDefines;
  m_tail = load(tail);
  m_jacobiFirst = load(windProgram("wind/jacobi first"));
  m_jacobi = load(windProgram("wind/jacobi"));
  m_project = load(windProgram("wind/project"));
  m_projectJacobi = load(windProgram("wind/project jacobi"));
  if (!failure.problems.empty()) return failure;
  return Done{};
}

const gpu::Buffer& GpuPressure::fluxOf(std::size_t level) const {
  return level == 0 ? m_flux : level == m_levels.size() ? m_tailFlux : m_levels[level].flux;
}
const gpu::Buffer& GpuPressure::downOf(std::size_t level) const {
  return level == 0 ? m_planes[m_down] : m_levels[level].down;
}
const gpu::Buffer& GpuPressure::upOf(std::size_t level) const {
  return level == 0 ? m_planes[m_up] : level == m_levels.size() ? m_tailUp : m_levels[level].up;
}
const gpu::Buffer& GpuPressure::facesOf(std::size_t level) const {
  return level == m_levels.size() ? m_tailFaces : m_levels[level].faces;
}

void GpuPressure::bindLevel(std::size_t level) const {
  m_levelBlocks.bindUniformRange(WIND_UBO_LEVEL, level * kBlockStride, sizeof(shared::WindLevel));
  fluxOf(level).bindStorage(WIND_SSBO_FLUX);
  if (level == 0) return;
  m_levels[level].faces.bindStorage(WIND_SSBO_FACES);
  m_levels[level].inverse.bindStorage(WIND_SSBO_INVERSE);
}

void GpuPressure::goDown(std::size_t level, const gpu::Program& program, const gpu::Buffer* control) {
  afterLastPass();
  bindLevel(level);
  upOf(level).bindStorage(WIND_SSBO_D_IN);  // level 0 after the first cycle; others begin from 0
  downOf(level).bindStorage(WIND_SSBO_D_OUT);
  fluxOf(level + 1).bindStorage(WIND_SSBO_COARSE);
  const shared::WindLevel& block = m_levels[level].block;
  if (control == nullptr) {
    program.dispatch(block.groupsX, block.groupsZ);
  } else {
    program.dispatchIndirect(*control, commandOffset(level));
  }
}

void GpuPressure::goUp(std::size_t level, const gpu::Buffer& control) {
  afterLastPass();
  bindLevel(level);
  downOf(level).bindStorage(WIND_SSBO_D_IN);
  upOf(level).bindStorage(WIND_SSBO_D_OUT);
  upOf(level + 1).bindStorage(WIND_SSBO_COARSE);
  facesOf(level + 1).bindStorage(WIND_SSBO_COARSE_FACES);
  m_levels[level].upward->dispatchIndirect(control, commandOffset(level));
}

void GpuPressure::runTail(const gpu::Buffer& control) {
  afterLastPass();
  m_tailFaces.bindStorage(WIND_SSBO_FACES);
  m_tailInverse.bindStorage(WIND_SSBO_INVERSE);
  m_tailFlux.bindStorage(WIND_SSBO_FLUX);
  m_tailUp.bindStorage(WIND_SSBO_D_OUT);
  m_tail->dispatchIndirect(control, commandOffset(WIND_COMMAND_TAIL));
}

void GpuPressure::solveMultigrid(const GpuFields& fields, int cycles) {
  startWith(*m_first, fields.control);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    if (cycle > 0) goDown(0, *m_levels[0].downward, &fields.control);
    for (std::size_t l = 1; l < m_levels.size(); ++l) goDown(l, *m_levels[l].downward, &fields.control);
    runTail(fields.control);
    for (std::size_t l = m_levels.size(); l-- > 0;) goUp(l, fields.control);
  }
}

/// The first pass, and a second time for steps in which the last one's pressure is of no use.
void GpuPressure::startWith(const gpu::Program& first, const gpu::Buffer& control) {
  goDown(0, first, nullptr);
  afterLastPass();
  first.dispatchIndirect(control, commandOffset(WIND_COMMAND_FIRST));
}

void GpuPressure::solveJacobi(const GpuFields& fields, int sweeps) {
  int left = std::max(sweeps, 1);
  for (bool first = true; left > 0; first = false) {
    const gpu::Program& program = first ? *m_jacobiFirst : *m_jacobi;
    const int now = std::min(left, WIND_HALO);
    program.set("sweepCount", now);
    if (first) {
      startWith(program, fields.control);
    } else {
      goDown(0, program, nullptr);
    }
    std::swap(m_down, m_up);  // what was written is what the next one reads
    left -= now;
  }
}

void GpuPressure::solve(const GpuFields& fields, const gpu::Buffer& star, int cycles) {
  m_allLevels.bindUniform(WIND_UBO_LEVELS);
  star.bindStorage(WIND_SSBO_VELOCITY);
  m_planes[m_phi].bindStorage(WIND_SSBO_PHI);
  fields.control.bindStorage(WIND_SSBO_CONTROL);
  bindScratch(fields, star);
  if (fields.solver.pressure == Pressure::Jacobi) {
    solveJacobi(fields, fields.solver.jacobiSweeps);
  } else {
    solveMultigrid(fields, cycles);
  }
}

void GpuPressure::bindScratch(const GpuFields& fields, const gpu::Buffer& star) {
  // Nothing needs the velocity of the last step any more, nor what only the advection used: each has room for two
  // planes.
  const gpu::Buffer* free[] = {&fields.carried, &fields.first, &fields.moved};
  const auto end =
      std::remove_if(std::begin(free), std::end(free), [&](const gpu::Buffer* b) { return b->name() == star.name(); });
  WL_REQUIRE(end - std::begin(free) == 2, "q* lies in one of the buffers of the advection");
  free[0]->bindStorage(WIND_SSBO_JOINED);
  free[1]->bindStorage(WIND_SSBO_APPLIED);
  fields.velocity.bindStorage(WIND_SSBO_LAST_APPLIED);
}

void GpuPressure::project(const GpuFields& fields, const gpu::Buffer& star, const gpu::Buffer& result) {
  afterLastPass();  // d by the solve
  bindScratch(fields, star);
  star.bindStorage(WIND_SSBO_VELOCITY);
  result.bindStorage(WIND_SSBO_RESULT);
  m_planes[m_phi].bindStorage(WIND_SSBO_PHI);
  m_planes[m_up].bindStorage(WIND_SSBO_D_IN);
  m_planes[m_down].bindStorage(WIND_SSBO_D_OUT);
  fields.control.bindStorage(WIND_SSBO_CONTROL);
  fields.cells.bindImage(WIND_IMAGE_CELLS, GL_WRITE_ONLY);
  const gpu::Program* program = fields.solver.pressure == Pressure::Jacobi ? m_projectJacobi : m_project;
  program->dispatchOver({fields.width(), fields.height()});
  std::swap(m_phi, m_down);  // phi + d was written there
}

std::size_t GpuPressure::memoryBytes() const {
  std::size_t sum = m_flux.bytes() + m_levelBlocks.bytes() + m_allLevels.bytes() + m_tailFaces.bytes() +
                    m_tailInverse.bytes() + m_tailFlux.bytes() + m_tailUp.bytes();
  for (const gpu::Buffer& plane : m_planes) sum += plane.bytes();
  for (const Level& level : m_levels) {
    for (const gpu::Buffer* b : {&level.faces, &level.inverse, &level.flux, &level.down, &level.up}) sum += b->bytes();
  }
  return sum;
}

}  // namespace windloom
