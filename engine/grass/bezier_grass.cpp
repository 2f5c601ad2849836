#include "engine/grass/bezier_grass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <tuple>

#include "engine/core/log.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/grass/grass_programs.hpp"
#include "shaders/shared/bezier_cull.h"
#include "shaders/shared/bezier_pose.h"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

using shared::BezierBlock;
using shared::BezierCommands;
using shared::BezierDrawn;
using shared::BezierState;

// Records of blades to be drawn at most, 228 MB with their lists: a picture of 1920 x 1080 needs a tenth of it.
constexpr std::uint32_t kMostDrawn = 3'000'000;
// Blades of a meadow whose detail is reduced widen at most so far.
constexpr float kMostWidening = 4.0f;
// Blade heights in pixels from which strips of 7, 4 and 2 segments are drawn.
constexpr glm::vec3 kLevelPixels{110.0f, 28.0f, 9.0f};
struct StripShape {
  const char* program;
  int rows, columns;
};
constexpr std::array<StripShape, BEZIER_LISTS> kStrips{{{"grass/bezier near", 8, 3},
                                                        {"grass/bezier middle", 5, 2},
                                                        {"grass/bezier far", 3, 2},
                                                        {"grass/bezier farthest", 2, 2},
                                                        {"grass/bezier dandelion", 21, 2},
                                                        {"grass/bezier dandelion far", 9, 2}}};

/// The triangles of a chunk of strips; an index is 64 times the blade plus the vertex.
std::vector<std::uint16_t> stripIndices(int rows, int columns) {
  std::vector<std::uint16_t> indices;
  for (unsigned blade = 0; blade < BEZIER_CHUNK; ++blade) {
    const auto add = [&](int a, int b, int c) {
      for (const int vertex : {a, b, c}) indices.push_back(static_cast<std::uint16_t>(64u * blade + unsigned(vertex)));
    };
    for (int row = 0; row + 1 < rows; ++row) {
      for (int column = 0; column + 1 < columns; ++column) {
        const int low = row * columns + column, high = low + columns;
        add(low, low + 1, high);
        add(high, low + 1, high + 1);
      }
    }
  }
  return indices;
}

/// Whether blades grow alike in both: what placeBezier reads.
bool samePlacement(const Project& a, const Project& b) {
  const auto ground = [](const Project& p) {
    const FieldSettings& f = *p.field;
    return std::tie(f.centre, f.size, p.terrain->heights);
  };
  const auto surface = [](const Surface& s) {
    return std::tie(s.id, s.shape, s.position, s.lift, s.size, s.rotation, s.tilt, s.file, s.scale, s.density, s.height,
                    s.width, s.stiffness, s.bothSides, s.hidden, s.mesh);
  };
  const auto sameSurface = [&](const Surface& s, const Surface& t) { return surface(s) == surface(t); };
  const auto grass = [](const Project& p) {
    const GrassSettings& g = *p.grass;
    return std::tie(g.density, g.seed, g.height, g.heightVariation, g.width, g.stiffness, g.stiffnessVariation,
                    g.clumping, g.dryness, g.slopeAlign, g.slopeLimit, g.densityPixels, g.heightPixels);
  };
  const auto bezier = [](const Project& p) {
    const BezierSettings& z = *p.bezier;
    return std::tie(z.most, z.tufts, z.tuftSpacing, z.tuftRadius, z.form, z.dandelions);
  };
  return ground(a) == ground(b) && grass(a) == grass(b) && bezier(a) == bezier(b) &&
         (a.surfaces == b.surfaces || std::ranges::equal(*a.surfaces, *b.surfaces, sameSurface));
}

/// All blades at rest.
std::vector<BezierState> statesAtRest(const BezierMeadow& meadow) {
  std::vector<BezierState> states(meadow.blades.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BezierBlade& blade = meadow.blades[i];
    const glm::vec3 up = shared::octahedralVector(glm::unpackSnorm2x16(blade.up));
    states[i].tip = glm::vec4(up * glm::unpackHalf2x16(blade.sizes).x, 0.0f);
  }
  return states;
}

BezierBlock makeBlock(const Project& project, const BezierFrame& frame, std::uint32_t patches, std::uint32_t kept,
                      std::uint32_t room) {
  const BezierSettings& settings = *project.bezier;
  const auto runs = [&](bool test) { return test && frame.culling ? 1.0f : 0.0f; };
  const bool byDistance = frame.tests.distance && frame.thinning;
  BezierBlock block{};
  block.shape = {std::min(settings.tip, 0.99f), settings.fold, settings.widthLeast, settings.widthSpan};
  block.cull = {settings.orientationLimit, settings.reach, static_cast<float>(settings.distanceLevels),
                BEZIER_THIN_PIXELS};
  block.tests = {runs(frame.tests.orientation), runs(frame.tests.frustum), runs(byDistance),
                 runs(frame.tests.occlusion)};
  block.patches = {static_cast<float>(patches), static_cast<float>(kept),
                   std::min(static_cast<float>(BEZIER_PATCH) / static_cast<float>(kept), kMostWidening),
                   frame.culling ? 1.0f : 0.0f};
  block.levels = {kLevelPixels, BEZIER_FIRST_PIXELS};
  const float view = frame.view == GrassView::Patches    ? BEZIER_VIEW_PATCHES
                     : frame.view == GrassView::Culled   ? BEZIER_VIEW_CULLED
                     : frame.view == GrassView::Strength ? BEZIER_VIEW_STRENGTH
                                                         : BEZIER_VIEW_NORMAL;
  block.view = {view, static_cast<float>(room), frame.quick ? 0.0f : BEZIER_FIRST_PART, 0.0f};
  return block;
}

/// What the counts and commands begin a frame with.
BezierCommands startingCommands() {
  BezierCommands commands{};
  commands.groupsNear[1] = commands.groupsNear[2] = commands.groupsFar[1] = commands.groupsFar[2] = 1;
  for (std::size_t list = 0; list < BEZIER_LISTS; ++list) {
    const StripShape& shape = kStrips[list];
    commands.draws[5 * list] = static_cast<std::uint32_t>(stripIndices(shape.rows, shape.columns).size());
  }
  return commands;
}

template <class T>
Status fill(gpu::Buffer& buffer, std::string_view label, const std::vector<T>& values) {
  Result<gpu::Buffer> made = gpu::Buffer::create(label, std::span<const T>(values));
  if (!made) return made.error();
  buffer = std::move(*made);
  return Done{};
}

Status reserve(gpu::Buffer& buffer, std::string_view label, std::size_t bytes) {
  Result<gpu::Buffer> made = gpu::Buffer::create(label, bytes, gpu::BufferUse::Static);
  if (!made) return made.error();
  buffer = std::move(*made);
  return Done{};
}

}  // namespace

Result<BezierGrass> BezierGrass::create(gpu::ShaderLibrary& shaders) {
  BezierGrass grass;
  grass.m_shaders = &shaders;
  if (Status made = grass.makePrograms(); !made) return made.error();
  if (Status made = grass.makeStrips(); !made) return made.error();
  const BezierCommands start = startingCommands();
  Result<gpu::Buffer> settings = gpu::Buffer::create("bezier settings", sizeof(BezierBlock), gpu::BufferUse::Dynamic);
  if (!settings) return settings.error();
  Result<gpu::Buffer> starting = gpu::Buffer::create("bezier start", sizeof start, gpu::BufferUse::Static, &start);
  if (!starting) return starting.error();
  Result<gpu::Buffer> commands = gpu::Buffer::create("bezier commands", sizeof start, gpu::BufferUse::Static);
  if (!commands) return commands.error();
  Result<gpu::ReadbackRing> read = gpu::ReadbackRing::create("bezier counts", sizeof(BezierCommands));
  if (!read) return read.error();
  grass.m_settings = std::move(*settings);
  grass.m_start = std::move(*starting);
  grass.m_commands = std::move(*commands);
  grass.m_read = std::move(*read);
  return grass;
}

Status BezierGrass::makePrograms() {
  if (Status loaded = m_cull.load(*m_shaders, "grass/bezier cull"); !loaded) return loaded;
  const std::pair<std::string_view, gpu::Program**> programs[] = {{"grass/bezier patches", &m_patchCull},
                                                                  {"grass/bezier list", &m_patchList},
                                                                  {"grass/bezier next round", &m_nextRound}};
  for (const auto& [name, slot] : programs) {
    Result<gpu::Program*> program = m_shaders->load(grassProgram(name));
    if (!program) return program.error();
    *slot = *program;
  }
  for (std::size_t list = 0; list < BEZIER_LISTS; ++list) {
    const gpu::ProgramSpec& spec = grassProgram(kStrips[list].program);
    Result<gpu::Program*> program = m_shaders->load(spec);
    if (!program) return program.error();
    Result<gpu::Program*> plain = m_shaders->load(spec, "PLAIN");
    if (!plain) return plain.error();
    m_strips[list].program = *program;
    m_strips[list].plain = *plain;
  }
  return Done{};
}

Status BezierGrass::makeStrips() {
  for (std::size_t list = 0; list < BEZIER_LISTS; ++list) {
    Strip& strip = m_strips[list];
    if (Status made = fill(strip.indices, "bezier strips", stripIndices(kStrips[list].rows, kStrips[list].columns));
        !made)
      return made;
    strip.array = gpu::VertexArray::create("bezier");
    strip.array.indexBuffer(strip.indices);
  }
  return Done{};
}

Status BezierGrass::configure(const Project& project, Placement placement) {
  const bool current = m_any && samePlacement(project, m_placed);
  if (!current && m_job == nullptr)
    m_job = std::make_shared<MadeBeside<BezierMeadow>>(project, "the grass's blades", placeBezier);
  if (m_job == nullptr) return Done{};
  if (placement == Placement::Later && !m_job->ready()) return Done{};
  // One that was begun for other settings is still shown on the way, so that a slider shows what it does.
  const auto done = std::move(m_job);
  m_job = nullptr;
  m_placed = done->project;  // even if it fails: it would fail again
  m_any = true;
  if (Status adopted = adopt(done->take()); !adopted) return adopted;
  return samePlacement(project, m_placed) ? Status(Done{}) : configure(project, placement);
}

Status BezierGrass::adopt(const Result<BezierMeadow>& placed) {
  if (!placed) return placed.error();
  const BezierMeadow& meadow = *placed;
  if (meadow.patches.empty()) {
    m_patchCount = 0;
    m_bladeCount = 0;
    ++m_generation;
    return Done{};
  }
  gpu::Buffer blades, states, patches, drawn, lists, seen;
  if (Status made = fill(blades, "bezier blades", meadow.blades); !made) return made;
  if (Status made = fill(states, "bezier states", statesAtRest(meadow)); !made) return made;
  if (Status made = fill(patches, "bezier patches", meadow.patches); !made) return made;
  const std::size_t room = std::min<std::size_t>(meadow.blades.size(), kMostDrawn);
  if (Status made = reserve(drawn, "bezier drawn", room * sizeof(BezierDrawn)); !made) return made;
  if (Status made = reserve(lists, "bezier lists", room * BEZIER_LISTS * sizeof(std::uint32_t)); !made) return made;
  if (Status made = reserve(seen, "bezier seen", 3 * meadow.patches.size() * sizeof(std::uint32_t)); !made) return made;
  m_drawn = std::move(drawn);
  m_lists = std::move(lists);
  m_seen = std::move(seen);
  m_blades = std::move(blades);
  m_states = std::move(states);
  m_patches = std::move(patches);
  m_room = static_cast<std::uint32_t>(room);
  m_patchCount = static_cast<std::uint32_t>(meadow.patches.size());
  m_bladeCount = meadow.count;
  ++m_generation;
  return Done{};
}

Status BezierGrass::bindSettings(const Project& project, const BezierFrame& frame) {
  const float part = std::clamp(frame.detail, 0.02f, 1.0f);
  m_kept = std::clamp(static_cast<std::uint32_t>(std::lround(part * BEZIER_PATCH)), 8u, BEZIER_PATCH);
  m_plain = frame.quick;
  m_wireframe = frame.view == GrassView::Wireframe;
  const BezierBlock block = makeBlock(project, frame, m_patchCount, m_kept, m_room);
  m_settings.write(&block, sizeof block);
  m_settings.bindUniform(RENDER_UBO_BEZIER);
  return Done{};
}

void BezierGrass::findSeen() {
  if (m_patchCount == 0) return;
  const gpu::DebugGroup group("bezier: patches");
  // The last frame counted in the commands, and its draws read them and the lists.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  glCopyNamedBufferSubData(m_start.name(), m_commands.name(), 0, 0, sizeof(BezierCommands));
  m_commands.bindStorage(RENDER_SSBO_BEZIER_COMMANDS);
  m_patches.bindStorage(RENDER_SSBO_BEZIER_PATCHES);
  m_seen.bindStorage(RENDER_SSBO_BEZIER_SEEN);
  m_patchCull->use();
  const auto groups = static_cast<int>((m_patchCount + BEZIER_CULL_GROUP - 1u) / BEZIER_CULL_GROUP);
  m_patchCull->dispatch(groups);
  // bezier_list reads what bezier_patches found and counted.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  m_patchList->use();
  m_patchList->dispatch(groups);
}

BezierStore BezierGrass::store() const {
  return {&m_blades, &m_states, &m_patches, &m_seen, m_patchCount, m_kept};
}

/// False where the machine refuses; then nothing hides anything.
bool BezierGrass::reduceDepth(const gpu::Texture& depth) {
  const glm::ivec2 size(depth.size());
  const glm::ivec2 half = (size + 1) / 2;
  if (glm::ivec2(m_nearDepth.size()) != half || m_nearDepth.name() == 0) {
    Result<gpu::Texture> made =
        gpu::Texture::create2D("bezier near depth", half, GL_R32F, {.filter = gpu::Filter::Nearest});
    if (!made) return false;
    m_nearDepth = std::move(*made);
  }
  GLint samples = 0;
  glGetTextureLevelParameteriv(depth.name(), 0, GL_TEXTURE_SAMPLES, &samples);
  const std::string define = samples > 1 ? "SAMPLES=" + std::to_string(samples) : "";
  Result<gpu::Program*> reduce = m_shaders->load(grassProgram("grass/bezier depth"), define);
  if (!reduce) {
    logError(reduce.error().text());
    return false;
  }
  (*reduce)->use();
  (*reduce)->set("size", size);
  depth.bind(RENDER_TEXTURE_MAP);
  m_nearDepth.bindImage(RENDER_IMAGE_NEAR_DEPTH, GL_WRITE_ONLY);
  (*reduce)->dispatchOver(half);
  return true;
}

void BezierGrass::cull(Round round, const gpu::Texture& depth) {
  if (m_patchCount == 0) return;
  const gpu::DebugGroup group(round == Round::First ? "bezier: cull first" : "bezier: cull rest");
  m_commands.bindStorage(RENDER_SSBO_BEZIER_COMMANDS);
  if (round == Round::Rest) {
    // The draws of the first round read what begins the second.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    m_nextRound->use();
    m_nextRound->dispatch(1);
    m_hides = reduceDepth(depth);
    m_nearDepth.bind(RENDER_TEXTURE_NEAR_DEPTH);
  }
  // It reads patches of bezier_patches, states of the physics, and in the second round the depth just reduced.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  m_blades.bindStorage(RENDER_SSBO_BEZIER_BLADES);
  m_states.bindStorage(RENDER_SSBO_BEZIER_STATES);
  m_patches.bindStorage(RENDER_SSBO_BEZIER_PATCHES);
  m_seen.bindStorage(RENDER_SSBO_BEZIER_SEEN);
  m_lists.bindStorage(RENDER_SSBO_BEZIER_LIST);
  m_drawn.bindStorage(RENDER_SSBO_BEZIER_DRAWN);
  const gpu::Program& program = m_cull.forBlades(m_kept);
  program.use();
  program.set("hides", round == Round::Rest && m_hides ? 1u : 0u);
  program.set("round", round == Round::First ? 0u : 1u);
  const std::size_t groups =
      round == Round::First ? offsetof(BezierCommands, groupsNear) : offsetof(BezierCommands, groupsFar);
  program.dispatchIndirect(m_commands, groups);
}

void BezierGrass::draw(Round round, const gpu::PassState& state) {
  if (m_patchCount == 0) return;
  const gpu::DebugGroup group(round == Round::First ? "bezier: draw first" : "bezier: draw rest");
  // The draws read records, lists and counts of the culling.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  gpu::apply(state);
  m_lists.bindStorage(RENDER_SSBO_BEZIER_LIST);
  m_drawn.bindStorage(RENDER_SSBO_BEZIER_DRAWN);
  m_commands.bindStorage(RENDER_SSBO_BEZIER_COMMANDS);
  if (m_wireframe) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, m_commands.name());
  for (std::size_t list = 0; list < BEZIER_LISTS; ++list) {
    const Strip& strip = m_strips[list];
    (m_plain ? strip.plain : strip.program)->use();
    strip.array.bind();
    const std::size_t offset = offsetof(BezierCommands, draws) + list * 5 * sizeof(std::uint32_t);
    glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(offset));
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  if (m_wireframe) glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  if (round == Round::Rest) m_read.request(m_commands, 0, sizeof(BezierCommands), 0);
}

const BezierCounts& BezierGrass::counts() {
  if (m_patchCount == 0) m_counts = {};
  if (const auto arrived = m_patchCount > 0 ? m_read.poll() : std::nullopt) {
    BezierCommands commands{};
    std::memcpy(&commands, arrived->bytes.data(), sizeof commands);
    const auto count = [&](std::uint32_t which) { return static_cast<long long>(commands.counts[which]); };
    m_counts.patchesSeen = count(BEZIER_COUNT_PATCHES);
    m_counts.inPatches = count(BEZIER_COUNT_IN_PATCHES);
    m_counts.orientation = count(BEZIER_COUNT_ORIENTATION);
    m_counts.frustum = count(BEZIER_COUNT_FRUSTUM);
    m_counts.distance = count(BEZIER_COUNT_DISTANCE);
    m_counts.occlusion = count(BEZIER_COUNT_OCCLUSION);
    m_counts.buried = count(BEZIER_COUNT_BURIED);
    m_counts.drawn = count(BEZIER_COUNT_DRAWN);
  }
  m_counts.blades = m_bladeCount;
  m_counts.patches = m_patchCount;
  return m_counts;
}

}  // namespace windloom
