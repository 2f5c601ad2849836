#include "engine/grass/bezier_physics.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/log.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/grass/grass_programs.hpp"
#include "engine/model/collider_motion.hpp"
#include "engine/model/evaluate.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

using shared::BezierClock;
using shared::BezierWork;

constexpr std::size_t kMostMovers = std::size_t{BEZIER_RUN} * BEZIER_RUNS;
// Steps of what the frame's own don't give: the way of a jump in time, and frames longer than it.
constexpr double kLongStepS = 3.0 * double{kBezierStepS};
constexpr double kLeastMemoryS = 1.0, kMostMemoryS = 10.0;

/// Two commands without groups yet: of patches that nothing touches, and of the others.
constexpr std::uint32_t kNoGroups[8] = {0, 1, 1, 0, 0, 1, 1, 0};
constexpr std::size_t kTouchedGroups = 4 * sizeof(std::uint32_t);

struct Wave {
  double turn, length, speed, strength;  // rad from the ambient wind; parts of the settings'
};
// Lengths without a common multiple, so that crests never meet in a pattern that shows.
constexpr Wave kWaves[BEZIER_WAVES] = {
    {0.0, 1.0, 1.0, 0.45}, {0.35, 0.618, 0.85, 0.25}, {-0.5, 0.414, 0.7, 0.18}, {0.15, 1.73, 1.2, 0.12}};

/// s after which nothing is left of what hit a blade.
double memoryOf(const BezierSettings& bezier) {
  const double fades = double{BEZIER_STRENGTH_MOST} / std::max(double{bezier.collisionFade}, 1e-3);
  return std::clamp(fades + 2.0 / std::max(double{bezier.recovery}, 1e-3), kLeastMemoryS, kMostMemoryS);
}

void addWaves(BezierPhysicsBlock& block, const Project& project, double seconds) {
  const BezierSettings& bezier = *project.bezier;
  const double ambient = double{project.ambient->direction} * std::numbers::pi / 180.0;
  for (std::size_t i = 0; i < BEZIER_WAVES; ++i) {
    const Wave& wave = kWaves[i];
    const double length = std::max(wave.length * double{bezier.waveLength}, 1e-3);
    const double turns = seconds * wave.speed * double{bezier.waveSpeed} / length;
    const double angle = ambient + wave.turn;
    block.waves[i] = glm::vec4(glm::dvec4(std::cos(angle) / length, std::sin(angle) / length, turns - std::floor(turns),
                                          wave.strength * double{bezier.waveStrength}));
  }
}

/// Moving ones first, and neighbours beside each other, so that the boxes around BEZIER_RUN of them are small.
void gather(std::vector<BezierMover>& movers) {
  constexpr float kCellM = 0.5f;
  const auto cell = [](const BezierMover& mover) {
    const glm::ivec3 at(glm::floor(glm::vec3(mover.laterA) / kCellM));
    std::uint32_t code = 0;  // a Morton code that repeats every 512 m
    for (int bit = 0; bit < 10; ++bit) {
      for (int axis = 0; axis < 3; ++axis)
        code |= (static_cast<std::uint32_t>(at[axis]) >> bit & 1u) << (3 * bit + axis);
    }
    return code;
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  for (std::size_t i = 0; i < movers.size(); ++i) {
    const std::uint64_t still = movers[i].b.w > 0.5f ? 0 : 1;
    order.emplace_back(still << 32 | cell(movers[i]), static_cast<std::uint32_t>(i));
  }
  std::ranges::sort(order);
  std::vector<BezierMover> gathered;
  gathered.reserve(movers.size());
  for (const auto& [key, index] : order) gathered.push_back(movers[index]);
  movers.swap(gathered);
}

BezierRun boxOf(std::span<const BezierMover> movers) {
  glm::vec3 low(1e30f), high(-1e30f);
  for (const BezierMover& mover : movers) {
    for (const glm::vec4& end : {mover.a, mover.b, mover.laterA, mover.laterB}) {
      low = glm::min(low, glm::vec3(end) - mover.a.w);
      high = glm::max(high, glm::vec3(end) + mover.a.w);
    }
  }
  return {glm::vec4(low, 0.0f), glm::vec4(high, 0.0f)};
}

}  // namespace

BezierPhysicsBlock makeBezierPhysicsBlock(const Project& project, double seconds) {
  const BezierSettings& bezier = *project.bezier;
  BezierPhysicsBlock block{};
  const float size = glm::length(bezier.gravityDirection);
  const glm::vec3 direction = size > 0.0f ? bezier.gravityDirection / size : glm::vec3(0.0f, -1.0f, 0.0f);
  block.gravity = glm::vec4(direction * (bezier.gravity * (1.0f - bezier.centreBlend)), bezier.frontGravity);
  block.centre = glm::vec4(bezier.gravityCentre, bezier.centreGravity * bezier.centreBlend);
  block.motion = {bezier.recovery, bezier.windStrength, bezier.collisionStrength, bezier.collisionFade};
  block.wind = {bezier.wind != BezierWind::Waves ? 1.0f : 0.0f, bezier.wind != BezierWind::Field ? 1.0f : 0.0f,
                project.grass->flutter, 0.0f};
  addWaves(block, project, seconds);
  return block;
}

std::vector<BezierMover> bezierMovers(std::span<const ColliderPrimitive> begin,
                                      std::span<const ColliderPrimitive> end) {
  constexpr float kStillM = 1e-6f;
  const bool move = begin.size() == end.size();
  std::vector<BezierMover> movers(end.size());
  for (std::size_t i = 0; i < end.size(); ++i) {
    const ColliderPrimitive& from = move ? begin[i] : end[i];
    movers[i] = {from.a, from.b, end[i].a, end[i].b};
    const float way = std::max(glm::length(glm::vec3(end[i].a - from.a)), glm::length(glm::vec3(end[i].b - from.b)));
    movers[i].b.w = way > kStillM ? 1.0f : 0.0f;
  }
  gather(movers);
  return movers;
}

float bezierTouchParts(std::span<const BezierMover> movers, float seconds) {
  constexpr float kThinM = 0.05f;  // thinner ones are parts of something
  float parts = std::max(std::ceil(seconds / BEZIER_TOUCH_STEP_S - 0.01f), 1.0f);
  for (const BezierMover& mover : movers) {
    const float way =
        std::max(glm::length(glm::vec3(mover.laterA - mover.a)), glm::length(glm::vec3(mover.laterB - mover.b)));
    parts = std::max(parts, std::ceil(way / (0.7f * std::max(mover.a.w, kThinM))));
  }
  return std::min(parts, BEZIER_PARTS_MOST);
}

Result<BezierPhysics> BezierPhysics::create(gpu::ShaderLibrary& shaders) {
  using gpu::Buffer;
  BezierPhysics physics;
  Result<gpu::Program*> wake = shaders.load(grassProgram("grass/bezier wake"));
  if (!wake) return wake.error();
  if (Status loaded = physics.m_step.load(shaders, "grass/bezier step"); !loaded) return loaded.error();
  if (Status loaded = physics.m_stepTouched.load(shaders, "grass/bezier step touched"); !loaded) return loaded.error();
  physics.m_wake = *wake;
  Result<Buffer> block = Buffer::create("bezier physics", sizeof(BezierPhysicsBlock), gpu::BufferUse::Dynamic);
  if (!block) return block.error();
  Result<Buffer> commands = Buffer::create("bezier physics commands", sizeof kNoGroups, gpu::BufferUse::Dynamic);
  if (!commands) return commands.error();
  const std::size_t bytes = BEZIER_RUNS * sizeof(BezierRun) + 16 * sizeof(BezierMover);
  Result<Buffer> movers = Buffer::create("bezier movers", bytes, gpu::BufferUse::Dynamic);
  if (!movers) return movers.error();
  physics.m_block = std::move(*block);
  physics.m_commands = std::move(*commands);
  physics.m_movers = std::move(*movers);
  return physics;
}

Status BezierPhysics::configure(const BezierStore& store) {
  const std::size_t patches = std::max<std::size_t>(store.patchCount, 1);
  Result<gpu::Buffer> clocks =
      gpu::Buffer::create("bezier clocks", patches * sizeof(BezierClock), gpu::BufferUse::Static);
  if (!clocks) return clocks.error();
  Result<gpu::Buffer> list =
      gpu::Buffer::create("bezier patches to step", patches * sizeof(BezierWork), gpu::BufferUse::Static);
  if (!list) return list.error();
  m_clocks = std::move(*clocks);
  m_list = std::move(*list);
  m_clock.forget();
  return Done{};
}

std::span<const BezierMover> BezierPhysics::upload(std::span<const BezierMover> movers) {
  if (movers.size() > kMostMovers) {
    if (!m_warned) {
      logWarning("only " + std::to_string(kMostMovers) + " of " + std::to_string(movers.size()) +
                 " spheres and capsules touch the grass");
    }
    m_warned = true;
    movers = movers.first(kMostMovers);
  }
  constexpr std::size_t kHead = BEZIER_RUNS * sizeof(BezierRun);
  if (m_movers.bytes() < kHead + movers.size_bytes()) {
    Result<gpu::Buffer> made =
        gpu::Buffer::create("bezier movers", kHead + 2 * movers.size_bytes(), gpu::BufferUse::Dynamic);
    if (!made) {
      logError(made.error().text());
      return {};
    }
    m_movers = std::move(*made);
  }
  std::vector<BezierRun> runs;
  for (std::size_t i = 0; i < movers.size(); i += BEZIER_RUN) {
    runs.push_back(boxOf(movers.subspan(i, std::min<std::size_t>(BEZIER_RUN, movers.size() - i))));
  }
  m_movers.write(std::span<const BezierRun>(runs));
  m_movers.write(movers, kHead);
  return movers;
}

void BezierPhysics::step(const BezierStore& store, const Step& step, std::span<const BezierMover> movers) {
  movers = upload(movers);
  // The step before this one read and wrote what is written and read now; the culling wrote what is seen.
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  m_commands.write(kNoGroups, sizeof kNoGroups);
  const auto moverCount = static_cast<unsigned>(movers.size());
  m_movers.bindStorage(RENDER_SSBO_BEZIER_PRIMITIVES);
  store.patches->bindStorage(RENDER_SSBO_BEZIER_PATCHES);
  m_list.bindStorage(RENDER_SSBO_BEZIER_LIST);

  m_clocks.bindStorage(RENDER_SSBO_BEZIER_CLOCKS);
  store.seen->bindStorage(RENDER_SSBO_BEZIER_SEEN);
  m_commands.bindStorage(RENDER_SSBO_BEZIER_COMMANDS);
  m_wake->set("patchCount", store.patchCount);
  m_wake->set("kept", store.kept);
  m_wake->set("moverCount", moverCount);
  m_wake->set("stepSeconds", step.seconds);
  m_wake->set("jumped", step.jumped ? 1 : 0);
  m_wake->set("looksOn", step.looksOn ? 1 : 0);
  m_wake->dispatchOver({static_cast<int>(store.patchCount), 1});

  // The step reads the list and its length.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  store.blades->bindStorage(RENDER_SSBO_BEZIER_BLADES);
  store.states->bindStorage(RENDER_SSBO_BEZIER_STATES);
  const gpu::Program& quiet = m_step.forBlades(store.kept);
  const gpu::Program& touched = m_stepTouched.forBlades(store.kept);
  for (const gpu::Program* program : {&quiet, &touched}) {
    program->set("kept", store.kept);
    program->set("stepSeconds", step.seconds);
  }
  quiet.dispatchIndirect(m_commands, 0);
  if (movers.empty()) return;
  touched.set("patchCount", store.patchCount);
  touched.set("moverCount", moverCount);
  touched.set("touchParts", bezierTouchParts(movers, step.seconds));
  touched.dispatchIndirect(m_commands, kTouchedGroups);
}

bool BezierPhysics::edited(const Project& project) {
  const bool same = project.bezier == m_project.bezier && project.grass == m_project.grass &&
                    project.ambient == m_project.ambient && project.graph == m_project.graph &&
                    project.obstacles == m_project.obstacles && project.colliders == m_project.colliders &&
                    project.rotors == m_project.rotors;
  m_project = project;
  return !same;
}

void BezierPhysics::advance(const Project& project, const BezierStore& store, double seconds, bool quick) {
  if (store.patchCount == 0) return;
  const gpu::DebugGroup group("bezier: physics");
  // While time stands an edit shows at once what it would have done; while it runs, it just goes on.
  if (edited(project) && m_clock.standsAt(seconds)) m_clock.forget();
  const BezierPhysicsBlock block = makeBezierPhysicsBlock(project, seconds);
  m_block.write(&block, sizeof block);
  m_block.bindUniform(RENDER_UBO_BEZIER_PHYSICS);

  const TouchSteps steps =
      m_clock.advance(seconds, kLongStepS, quick ? RunUp::Quick : RunUp::Full, memoryOf(*project.bezier));
  // Without colliders a jump is only a fresh start.
  if (steps.count == 0 || (steps.fromRest && project.colliders->empty())) {
    step(store, {0.0f, steps.fromRest, true}, {});
    return;
  }
  std::vector<ColliderPrimitive> before = colliderPrimitives(project, steps.start);
  for (int i = 1; i <= steps.count; ++i) {
    std::vector<ColliderPrimitive> after = colliderPrimitives(project, steps.start + i * double{steps.seconds});
    const bool last = i == steps.count;
    step(store, {steps.seconds, steps.fromRest && i == 1, last}, bezierMovers(before, after));
    before = std::move(after);
  }
}

}  // namespace windloom
