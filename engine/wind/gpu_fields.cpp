#include "engine/wind/gpu_fields.hpp"

#include <cmath>
#include <cstring>
#include <string>

#include "engine/wind/gusts.hpp"

namespace windloom {
namespace {

/// What lies behind one side of a cell: a link to a neighbour, the ground, or nothing.
std::uint16_t sideOf(bool blocked, bool border, bool periodic, unsigned link, unsigned ground) {
  if (blocked) return 0;
  return static_cast<std::uint16_t>(border && !periodic ? ground : link);
}

/// Whether the node at the low corner of cell (i, k) touches a solid cell.
bool solidNode(const WindGrid& g, int i, int k) {
  const int low = i > 0           ? i - 1
                  : g.periodicX() ? g.width - 1
                                  : i,
            before = k > 0           ? k - 1
                     : g.periodicZ() ? g.height - 1
                                     : k;
  return g.solidAt(low, before) || g.solidAt(i, before) || g.solidAt(low, k) || g.solidAt(i, k);
}

std::uint16_t flagsOf(const WindGrid& g, int i, int k) {
  const unsigned node = solidNode(g, i, k) ? WIND_SOLID_NODE : 0;
  if (g.solidAt(i, k)) return static_cast<std::uint16_t>(WIND_SOLID | node);
  return static_cast<std::uint16_t>(
      node | sideOf(g.blockedX(i, k), i == 0, g.periodicX(), WIND_LINK_X_LOW, WIND_GROUND_X_LOW) |
      sideOf(g.blockedX(i + 1, k), i + 1 == g.width, g.periodicX(), WIND_LINK_X_HIGH, WIND_GROUND_X_HIGH) |
      sideOf(g.blockedZ(i, k), k == 0, g.periodicZ(), WIND_LINK_Z_LOW, WIND_GROUND_Z_LOW) |
      sideOf(g.blockedZ(i, k + 1), k + 1 == g.height, g.periodicZ(), WIND_LINK_Z_HIGH, WIND_GROUND_Z_HIGH));
}

constexpr float kRoom = 0.95f;  // rounding in the last gradient adds to the residual

int workGroups(int count, int size) {
  return (count + size - 1) / size;
}

/// Floats of the partial sums of the pass with the most work-groups times values.
std::size_t sumFloats(const WindGrid& grid) {
  const int cells =
      workGroups(grid.width, WIND_GROUP_X) * workGroups(grid.height, WIND_GROUP_Z * WIND_PROJECT_STRIP) * 5;
  constexpr int kSmallest = std::min(WIND_INNER(WIND_FINE_REGION), WIND_DOWN_INNER(WIND_FINE_REGION));
  const int regions = workGroups(grid.width, kSmallest) * workGroups(grid.height, kSmallest) * 4;
  return static_cast<std::size_t>(std::max(cells, regions));
}

/// The pass that joins cycles has the most.
Status checkStorageBuffers() {
  constexpr GLint kNeeded = 11;
  GLint blocks = 0, bindings = 0;
  glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
  if (blocks >= kNeeded && bindings > WIND_SSBO_FLAGS) return Done{};
  return makeError(ErrorKind::Machine, "this OpenGL driver has " + std::to_string(blocks) + " storage buffers in " +
                                           std::to_string(bindings) + " places for a compute shader; the wind on the " +
                                           "GPU needs " + std::to_string(kNeeded) + " in " +
                                           std::to_string(WIND_SSBO_FLAGS + 1) + ". Choose the CPU backend");
}

}  // namespace

int windBorderCode(Border border) {
  return border == Border::Open ? WIND_BORDER_OPEN : border == Border::Wall ? WIND_BORDER_WALL : WIND_BORDER_PERIODIC;
}

VelocityLayout::VelocityLayout(const WindGrid& grid)
    : stride((grid.width + 3 + 3) / 4 * 4),
      zFaces(stride * (grid.height + 3)),
      floats(2 * static_cast<std::size_t>(stride) * static_cast<std::size_t>(grid.height + 3)) {}

GpuFields::GpuFields(const WindSetup& setup) : grid(makeWindGrid(setup.field, setup.obstacles)), layout(grid) {}

Result<GpuFields> GpuFields::create(const WindSetup& setup) {
  if (Status enough = checkStorageBuffers(); !enough) return enough.error();
  GpuFields f(setup);
  const glm::ivec2 size(f.grid.width, f.grid.height);
  struct Wanted {
    gpu::Buffer* buffer;
    const char* label;
    std::size_t bytes;
    gpu::BufferUse use;
  };
  const std::size_t velocityBytes = f.layout.floats * sizeof(float);
  const Wanted buffers[] = {
      {&f.velocity, "wind velocity", velocityBytes, gpu::BufferUse::Static},
      {&f.carried, "wind carried", velocityBytes, gpu::BufferUse::Static},
      {&f.first, "wind first advection", velocityBytes, gpu::BufferUse::Static},
      {&f.moved, "wind moved", velocityBytes, gpu::BufferUse::Static},
      {&f.control, "wind control", sizeof(shared::WindControl), gpu::BufferUse::Dynamic},
      {&f.flags, "wind cell flags", (f.grid.solid.size() + 1) / 2 * sizeof(shared::uint), gpu::BufferUse::Dynamic},
      {&f.gustTable, "wind gust table", sizeof(glm::vec2) * WIND_GUST_TABLE * WIND_GUST_TABLE, gpu::BufferUse::Dynamic},
      {&f.sums, "wind sums", sumFloats(f.grid) * sizeof(float), gpu::BufferUse::Static},
      {&f.blockBuffer, "wind block", sizeof(shared::WindBlock), gpu::BufferUse::Dynamic}};
  for (const Wanted& wanted : buffers) {
    Result<gpu::Buffer> made = gpu::Buffer::create(wanted.label, wanted.bytes, wanted.use);
    if (!made) return made.error();
    *wanted.buffer = std::move(*made);
  }
  Result<gpu::Texture> cells = gpu::Texture::create2D("wind cell velocity", size, GL_RG32F);
  if (!cells) return cells.error();
  f.cells = std::move(*cells);
  f.applySettings(setup);
  f.uploadFlags();
  return f;
}

void GpuFields::uploadFlags() {
  std::vector<std::uint16_t> values((grid.solid.size() + 1) / 2 * 2, 0);
  for (int k = 0; k < grid.height; ++k) {
    for (int i = 0; i < grid.width; ++i) {
      values[static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(i)] =
          flagsOf(grid, i, k);
    }
  }
  flags.write(values.data(), values.size() * sizeof(std::uint16_t));
}

void GpuFields::applySettings(const WindSetup& setup) {
  const std::vector<std::uint8_t> old = grid.solid;
  grid.mapping = makeGridMapping(setup.field.centre, setup.field.size, setup.field.resolution);
  rasteriseSolids(grid, setup.obstacles);
  if (grid.solid != old) uploadFlags();
  if (!m_hasGusts || m_gustSeed != setup.solver.seed) {
    const std::vector<glm::vec2> table = makeGustTable(setup.solver.seed);
    gustTable.write(table.data(), table.size() * sizeof(glm::vec2));
    m_gustSeed = setup.solver.seed;
    m_hasGusts = true;
  }
  solver = setup.solver;
  ambient = setup.ambient;
  fillBlock(setup);
}

void GpuFields::fillBlock(const WindSetup& setup) {
  const float dt = setup.field.timeStep;
  glm::vec2 still = ambientVelocity(setup.ambient);
  if (const float speed = glm::length(still); speed > solver.maxSpeed) still *= solver.maxSpeed / speed;
  shared::WindBlock& b = block;
  b.width = grid.width;
  b.height = grid.height;
  b.stride = layout.stride;
  b.zFaces = layout.zFaces;
  b.hx = grid.hx;
  b.hz = grid.hz;
  b.perHx = 1 / grid.hx;
  b.perHz = 1 / grid.hz;
  b.minCorner = grid.mapping.minCorner;
  b.dt = dt;
  b.maxSpeed = solver.maxSpeed;
  b.ambient = still;
  b.gustAmplitude = gustAmplitude(ambient);
  b.gustPart = 1 - std::exp(-dt / WIND_GUST_RESPONSE);
  b.gusts = b.gustAmplitude > 0 ? WIND_GUST_LAYERS : 0;
  b.keep = 1 / (1 + solver.dissipation * dt);
  b.confinement = solver.confinement;
  b.tolerance = kRoom * solver.divergenceTolerance;
  b.perAir = 1 / static_cast<float>(std::max<std::size_t>(grid.airCells, 1));
  b.perCell = 1 / static_cast<float>(grid.solid.size());
  fillBorders(setup.noSlip);
  const double bx = double(solver.viscosity) * double(dt) / (double(grid.hx) * double(grid.hx));
  const double bz = double(solver.viscosity) * double(dt) / (double(grid.hz) * double(grid.hz));
  b.viscosityX = static_cast<float>(bx);
  b.viscosityZ = static_cast<float>(bz);
  b.viscosityInverse = static_cast<float>(1 / (1 + 2 * bx + 2 * bz));
}

void GpuFields::fillBorders(const std::optional<WallSpeeds>& noSlip) {
  block.xMin = windBorderCode(grid.xMin);
  block.xMax = windBorderCode(grid.xMax);
  block.zMin = windBorderCode(grid.zMin);
  block.zMax = windBorderCode(grid.zMax);
  const WallSpeeds walls = noSlip.value_or(WallSpeeds{});
  block.wallXMin = walls.xMin;
  block.wallXMax = walls.xMax;
  block.wallZMin = walls.zMin;
  block.wallZMax = walls.zMax;
  block.noSlip = noSlip ? 1 : 0;
}

void GpuFields::sendBlock() {
  if (m_hasSent && std::memcmp(&m_sent, &block, sizeof block) == 0) return;
  blockBuffer.write(&block, sizeof block);
  m_sent = block;
  m_hasSent = true;
}

void GpuFields::bindShared() const {
  blockBuffer.bindUniform(WIND_UBO_BLOCK);
  flags.bindStorage(WIND_SSBO_FLAGS);
  sums.bindStorage(WIND_SSBO_SUMS);
}

std::size_t GpuFields::memoryBytes() const {
  std::size_t sum = grid.solid.size() * sizeof(glm::vec2);
  for (const gpu::Buffer* b :
       {&velocity, &carried, &first, &moved, &control, &sums, &blockBuffer, &flags, &gustTable}) {
    sum += b->bytes();
  }
  return sum;
}

}  // namespace windloom
