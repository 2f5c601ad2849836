#include "engine/grass/shell_grass.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "engine/gpu/debug_group.hpp"
#include "engine/grass/grass_layout.hpp"
#include "engine/grass/grass_programs.hpp"
#include "shaders/shared/render_bindings.h"

namespace windloom {
namespace {

using shared::ShellBlock;
using shared::ShellInstance;

// Intensities in the table of offsets: straight lines between them are off by 2e-5 of a blade.
constexpr int kIntensities = 129;
// A software renderer draws so many shells at most, and looks between two of them so often.
constexpr int kQuickShells = 4, kQuickSteps = 6, kFullSteps = 48;
// Fewer shells are drawn where they are off by no more than this, pixels.
constexpr float kErrorPixels = 0.75f;
// Tiles whose shells are drawn together, layer by layer: what the upper ones hide is known by the time the lower ones
// are drawn, which it isn't yet where they follow at once.
constexpr std::size_t kTilesTogether = 48;
// Blades lower than this on the screen have become the ground's shading (kFadePixels of grass_layout.cpp).
constexpr float kFadePixels = 2.2f;
// Blades per m^2 of the texture for the sake of surfaces, at most.
constexpr float kDensest = 2000.0f;
constexpr float kEverywhere = 1e9f;  // m
constexpr float kLuma[3] = {0.2126f, 0.7152f, 0.0722f};

std::vector<std::uint16_t> latticeIndices(int quads) {
  std::vector<std::uint16_t> indices;
  const int side = quads + 1;
  for (int z = 0; z < quads; ++z) {
    for (int x = 0; x < quads; ++x) {
      const int a = z * side + x, b = a + 1, c = a + side, d = c + 1;
      for (const int index : {a, c, b, b, c, d}) indices.push_back(static_cast<std::uint16_t>(index));
    }
  }
  return indices;
}

float sizeOn(const Surface& surface, const GrassSettings& grass) {
  return surface.height / std::max(grass.height, 1e-4f);
}

/// Blades per m^2 that the texture has: enough for the ground and, made smaller, for every surface.
float textureDensity(const Project& project) {
  float density = project.grass->density;
  for (const Surface& surface : *project.surfaces) {
    const float size = sizeOn(surface, *project.grass);
    if (!surface.hidden) density = std::max(density, std::min(surface.density * size * size, kDensest));
  }
  return density;
}

ShellTexture textureOf(const Project& project) {
  GrassSettings grass = *project.grass;
  grass.density = textureDensity(project);
  return project.shell->pixels ? shellTextureOf(*project.shell->pixels, grass, *project.shell)
                               : makeShellTexture(grass, *project.shell, *project.species);
}

/// Whether the texture is the same in both.
bool sameTexture(const Project& a, const Project& b) {
  const auto grass = [](const Project& p) {
    const GrassSettings& g = *p.grass;
    return std::tie(g.seed, g.height, g.heightVariation, g.width, g.clumping, g.baseColour, g.tipColour, g.dryColour,
                    g.dryness);
  };
  const auto shell = [](const Project& p) {
    const ShellSettings& s = *p.shell;
    return std::tie(s.tile, s.texels, s.fullness, s.thickness, s.taper, s.heightCurve, s.pixels);
  };
  return grass(a) == grass(b) && shell(a) == shell(b) && textureDensity(a) == textureDensity(b) &&
         (a.species == b.species || *a.species == *b.species);
}

bool sameBending(const ShellSettings& a, const ShellSettings& b) {
  return std::tie(a.shells, a.method, a.stiffnessCurve, a.overBend) ==
         std::tie(b.shells, b.method, b.stiffnessCurve, b.overBend);
}

int segmentsOf(const ShellSettings& shell) {
  return shell.method == ShellMethod::Plain ? std::max(shell.shells, 1) : SHELL_SEGMENTS;
}

template <class Upload>
Result<gpu::Texture> levelledTexture(const char* label, const ShellTexture& made, GLenum format, Upload texels) {
  const int levels = static_cast<int>(made.levels.size());
  Result<gpu::Texture> texture =
      gpu::Texture::create2D(label, glm::ivec2(made.levels.front().side), format,
                             {.levels = levels, .filter = gpu::Filter::Trilinear, .wrap = gpu::Wrap::Repeat});
  if (!texture) return texture;
  for (int level = 0; level < levels; ++level) {
    texture->upload(GL_RGBA, GL_UNSIGNED_BYTE, texels(made.levels[static_cast<std::size_t>(level)]), level);
  }
  return texture;
}

std::uint32_t packedEnds(int below, int own, int above) {
  return static_cast<std::uint32_t>(below) | static_cast<std::uint32_t>(own) << 8 |
         static_cast<std::uint32_t>(above) << 16;
}

}  // namespace

Result<ShellGrass> ShellGrass::create(gpu::ShaderLibrary& shaders) {
  ShellGrass grass;
  grass.m_shaders = &shaders;
  Result<gpu::Buffer> settings = gpu::Buffer::create("shell settings", sizeof(ShellBlock), gpu::BufferUse::Dynamic);
  if (!settings) return settings.error();
  grass.m_settings = std::move(*settings);
  const int quads[] = {SHELL_TILE_SIDE, SHELL_TILE_SIDE_QUICK};
  for (std::size_t i = 0; i < grass.m_indices.size(); ++i) {
    Result<gpu::Buffer> indices =
        gpu::Buffer::create("shell lattice", std::span<const std::uint16_t>(latticeIndices(quads[i])));
    if (!indices) return indices.error();
    grass.m_indices[i] = std::move(*indices);
    grass.m_lattices[i] = gpu::VertexArray::create("shells");
    grass.m_lattices[i].indexBuffer(grass.m_indices[i]);
  }
  return grass;
}

Status ShellGrass::configure(const Project& project, Placement placement) {
  const bool current = m_any && sameTexture(project, m_made);
  if (!current && m_job == nullptr) {
    m_job = std::make_shared<MadeBeside<ShellTexture>>(
        project, "the texture of the shell grass",
        [](const Project& from, const std::atomic<bool>*) { return textureOf(from); });
  }
  if (m_job == nullptr) return Done{};
  if (placement == Placement::Later && !m_job->ready()) return Done{};
  // One that was begun for other settings is still shown on the way, so that a slider shows what it does.
  const auto done = std::move(m_job);
  m_job = nullptr;
  m_made = done->project;  // even if it fails: it would fail again
  m_any = true;
  if (Status made = makeTexture(done->take()); !made) return made;
  return sameTexture(project, m_made) ? Status(Done{}) : configure(project, placement);
}

Status ShellGrass::makeTexture(const Result<ShellTexture>& made) {
  if (!made) return made.error();
  Result<gpu::Texture> form =
      levelledTexture("shell form", *made, GL_RGBA8, [](const ShellLevel& level) { return level.form.data(); });
  if (!form) return form.error();
  Result<gpu::Texture> colour = levelledTexture("shell colour", *made, GL_SRGB8_ALPHA8,
                                                [](const ShellLevel& level) { return level.colour.data(); });
  if (!colour) return colour.error();
  m_form = std::move(*form);
  m_colour = std::move(*colour);
  m_texture = *made;
  m_texture.levels.clear();
  int covers = kShellCovers;
  while (covers > 1 && m_texture.cover[static_cast<std::size_t>(covers) - 1] <= 0) --covers;
  m_highest = static_cast<float>(covers) / kShellCovers;
  m_bent = false;  // where shells stand follows from what reaches them
  return Done{};
}

Status ShellGrass::makeBending(const ShellSettings& shell) {
  if (m_bent && sameBending(shell, m_bending)) return Done{};
  const int segments = segmentsOf(shell);
  const float limit = std::max(shell.overBend, 1.0f);
  const std::vector<glm::vec2> table = shellOffsetTable(segments, kIntensities, limit, shell.stiffnessCurve);
  Result<gpu::Texture> offsets =
      gpu::Texture::create2D("shell offsets", {segments + 1, kIntensities}, GL_RG32F, {.filter = gpu::Filter::Nearest});
  if (!offsets) return offsets.error();
  offsets->upload(GL_RG, GL_FLOAT, table.data());
  m_offsets = std::move(*offsets);
  m_levels.clear();
  if (shell.method == ShellMethod::Plain) {
    m_levels.push_back({evenShells(segments, segments, limit, shell.stiffnessCurve)});
  } else {
    std::vector<int> among;
    for (int shells = std::clamp(shell.shells, 1, SHELL_SEGMENTS); shells >= 1; shells /= 2) {
      m_levels.push_back({placeShells(segments, shells, limit, shell.stiffnessCurve, m_texture.cover, among)});
      among = m_levels.back().placing.ends;
    }
  }
  for (Level& level : m_levels) {
    const std::vector<int>& ends = level.placing.ends;
    level.count = ends.size();
    if (shell.method == ShellMethod::Plain) continue;
    // The shell above the highest blade still shows it.
    while (level.count > 1 && static_cast<float>(ends[level.count - 2]) >= m_highest * static_cast<float>(segments))
      --level.count;
  }
  m_bending = shell;
  m_bent = true;
  return Done{};
}

/// From where each level does.
void ShellGrass::spreadLevels(const shared::FrameBlock& view, const ShellFrame& frame) {
  for (std::size_t i = 0; i < m_levels.size(); ++i) {
    const bool first = i == 0 || (frame.quick && static_cast<int>(m_levels[i - 1].placing.ends.size()) > kQuickShells);
    const float pixels = m_texture.tallestM * m_levels[i].placing.error * view.pixelScale.x;
    const float from = pixels * std::clamp(frame.detail, 0.05f, 1.0f) / kErrorPixels;
    const bool parallel = view.cameraPosition.w > 0.5f;
    m_levels[i].from = first ? 0.0f : !parallel ? from : from > 1.0f ? kEverywhere : 0.0f;
  }
}

/// The shell with this index of a tile's.
void ShellGrass::addShell(const ShellTile& tile, std::size_t at, std::size_t i) {
  const std::vector<int>& ends = m_levels[at].placing.ends;
  int below = i == 0 ? 0 : ends[i - 1];
  // Behind this tile there are fewer shells: a ray that leaves it may meet none of them before the next one that both
  // have.
  if (at + 1 < m_levels.size() && tile.farthest >= m_levels[at + 1].from) {
    const std::vector<int>& coarser = m_levels[at + 1].placing.ends;
    const auto next = std::ranges::lower_bound(coarser, ends[i]);
    below = next == coarser.begin() ? 0 : *std::prev(next);
  }
  const int above = i + 1 < ends.size() ? ends[i + 1] : ends[i];
  m_list.push_back({tile.low.x, tile.low.y, tile.side, packedEnds(below, ends[i], above)});
}

std::size_t ShellGrass::levelOf(const ShellTile& tile) const {
  std::size_t level = m_levels.size() - 1;
  while (level > 0 && m_levels[level].from > tile.nearest) --level;
  while (level + 1 < m_levels.size() && m_levels[level + 1].from <= 0) ++level;
  return level;
}

/// Near groups of tiles first, and of a group the uppermost shells first.
void ShellGrass::listFilled(const std::vector<ShellTile>& tiles) {
  for (std::size_t first = 0; first < tiles.size(); first += kTilesTogether) {
    const std::size_t last = std::min(first + kTilesTogether, tiles.size());
    const std::size_t most = m_levels[levelOf(tiles[first])].count;
    for (std::size_t down = 1; down <= most; ++down) {
      for (std::size_t at = first; at < last; ++at) {
        const std::size_t level = levelOf(tiles[at]);
        if (down <= m_levels[level].count) addShell(tiles[at], level, m_levels[level].count - down);
      }
    }
  }
  for (const ShellTile& tile : tiles) {
    const Level& level = m_levels[levelOf(tile)];
    if (m_counts.nearShells == 0) m_counts.nearShells = static_cast<int>(level.count);
    m_counts.skippedLayers += static_cast<int>(level.placing.ends.size() - level.count);
  }
}

void ShellGrass::listTiles(const std::vector<ShellTile>& tiles) {
  m_list.clear();
  m_counts = {};
  m_counts.tiles = static_cast<int>(tiles.size());
  m_counts.error = m_levels.front().placing.error;
  if (m_shell->method == ShellMethod::Plain) {
    const std::vector<int>& ends = m_levels.front().placing.ends;
    for (const int end : ends) {  // from the ground up
      for (const ShellTile& tile : tiles)
        m_list.push_back({tile.low.x, tile.low.y, tile.side, packedEnds(end - 1, end, end)});
    }
    m_counts.nearShells = static_cast<int>(ends.size());
  } else {
    listFilled(tiles);
  }
  m_groundInstances = static_cast<int>(m_list.size());
  m_counts.layers = m_groundInstances;
}

Status ShellGrass::uploadInstances() {
  // After the ground's: for surfaces, each level's shells from above to below, then the same for the backs.
  for (const Level& level : m_levels) {
    for (const float front : {1.0f, -1.0f}) {
      for (std::size_t i = level.count; i-- > 0;) {
        const std::vector<int>& ends = level.placing.ends;
        m_list.push_back(
            {front, 0, 1, packedEnds(i == 0 ? 0 : ends[i - 1], ends[i], i + 1 < ends.size() ? ends[i + 1] : ends[i])});
      }
    }
  }
  const std::size_t bytes = m_list.size() * sizeof(ShellInstance);
  if (m_instances.name() == 0 || m_instances.bytes() < bytes) {
    Result<gpu::Buffer> made = gpu::Buffer::create("shell instances", 2 * bytes, gpu::BufferUse::Dynamic);
    if (!made) return made.error();
    m_instances = std::move(*made);
  }
  m_instances.write(std::span<const ShellInstance>(m_list));
  return Done{};
}

Status ShellGrass::prepare(const Project& project, const ShellFrame& frame, const shared::FrameBlock& view) {
  m_groundInstances = 0;
  m_counts = {};
  m_frame = frame;
  m_shell = project.shell;
  m_grass = project.grass;
  m_ready = false;
  if (m_form.name() == 0) return Done{};
  const ShellSettings& shell = *project.shell;
  const GrassSettings& grass = *project.grass;
  if (Status made = makeBending(shell); !made) return made;
  if (project.field != m_maskField || grass.densityPixels != m_maskMap) {
    const FieldSettings& field = *project.field;
    m_mask = GrowthMask(grass.densityPixels.get(), field.centre - 0.5f * field.size, field.size);
    m_maskField = project.field;
    m_maskMap = grass.densityPixels;
  }
  const FieldSettings& field = *project.field;
  m_area = static_cast<double>(field.size.x) * static_cast<double>(field.size.y);
  spreadLevels(view, frame);
  const bool fades = frame.thinning && shell.method == ShellMethod::Filled;
  const float fade = fades ? kFadePixels : 0.0f;
  // Blades of the margin and of tufts are up to half as high again.
  const ShellGround ground{field.centre - 0.5f * field.size - kMeadowMarginM,
                           field.centre + 0.5f * field.size + kMeadowMarginM, project.terrain->heights.get(),
                           1.5f * m_texture.tallestM * (grass.heightPixels ? 2.0f : 1.0f)};
  const float pixels = ground.tallest * view.pixelScale.x;  // where projection is parallel, else times m
  const bool parallel = view.cameraPosition.w > 0.5f;
  const float farthest = fade <= 0 ? kEverywhere : !parallel ? pixels / fade : pixels < fade ? 0.0f : kEverywhere;
  std::vector<ShellTile> tiles = selectShellTiles(ground, view, farthest);
  std::erase_if(tiles, [&](const ShellTile& tile) { return !m_mask.grows(tile.low, tile.low + tile.side); });
  if (shownDensity(grass) <= 0) tiles.clear();
  listTiles(tiles);
  if (Status sent = uploadInstances(); !sent) return sent;

  const glm::vec3 luma(kLuma[0], kLuma[1], kLuma[2]);
  const float scale = parallel ? shellParallelDistance(view) : 0.0f;
  const bool own = shell.pixels != nullptr;
  const float bright = std::max(glm::dot(grass.tipColour, luma), 1e-3f);
  const float rootBright = std::max(glm::dot(grass.baseColour, luma), 1e-3f);
  // No fewer than ranks tell apart.
  const float groundPart = std::max(grass.density / std::max(textureDensity(m_made), 1e-4f), 2.0f / 255.0f);
  ShellBlock block{};
  block.size = {m_texture.tallestM, 1.0f / m_texture.tileM, static_cast<float>(m_form.size().x) / m_texture.tileM,
                static_cast<float>(m_form.levels() - 1)};
  block.bend = {grass.windFactor * shell.windStrength / std::max(grass.stiffness, 1e-3f),
                std::max(shell.overBend, 1.0f), shell.lean, grass.flutter};
  const bool source = shell.wind != ShellWind::Field;
  block.source = {shell.source, source ? shell.sourceStrength : 0.0f, shell.sourcePeriod};
  block.rings = {shell.sourceStep, shell.sourceDelay, shell.wind != ShellWind::Source ? 1.0f : 0.0f,
                 shell.stiffnessCurve};
  block.table = {static_cast<float>(segmentsOf(shell)), static_cast<float>(kIntensities), m_texture.heightCurve,
                 frame.thinning ? 0.0f : 1.0f};
  block.look = {static_cast<float>(frame.quick ? kQuickSteps : kFullSteps), fade, static_cast<float>(frame.samples),
                scale};
  // The hue of the root; how dark it is stands in the texture.
  block.root = {own ? glm::vec3(1.0f) : grass.baseColour / rootBright * bright / glm::max(grass.tipColour, 1e-3f),
                own ? 1.0f : groundPart};
  m_groundPart = block.root.w;
  block.mean = glm::vec4(m_texture.meanColour, 0.0f);
  m_settings.write(&block, sizeof block);
  m_settings.bindUniform(RENDER_UBO_SHELL);
  m_ready = true;
  return Done{};
}

Result<gpu::Program*> ShellGrass::program(const ShellSettings& shell, const char* name) const {
  std::string defines;
  const auto add = [&](bool wanted, const char* define) {
    if (wanted) defines.append(defines.empty() ? "" : " ").append(define);
  };
  add(shell.method == ShellMethod::Plain, "SLICES");
  add(shell.sampling == ShellSampling::Texel, "TEXEL");
  add(m_frame.samples <= 1, "ONE_SAMPLE");
  return m_shaders->load(grassProgram(name), defines);
}

void ShellGrass::drawGround(const gpu::PassState& state) {
  if (m_groundInstances == 0) return;
  const bool quick = m_frame.quick && m_shell->method == ShellMethod::Filled;
  const Result<gpu::Program*> shells =
      quick ? m_shaders->load(grassProgram("grass/shell quick")) : program(*m_shell, "grass/shell");
  if (!shells) return;
  const gpu::DebugGroup group("shells");
  gpu::apply(state);
  const std::size_t coarse = m_frame.quick ? 1 : 0;
  (*shells)->use();
  (*shells)->set("firstInstance", 0);
  (*shells)->set("quads", coarse == 1 ? SHELL_TILE_SIDE_QUICK : SHELL_TILE_SIDE);
  m_form.bind(RENDER_TEXTURE_SHELL_FORM);
  m_colour.bind(RENDER_TEXTURE_SHELL_COLOUR);
  m_offsets.bind(RENDER_TEXTURE_SHELL_OFFSETS);
  m_instances.bindStorage(RENDER_SSBO_SHELL_INSTANCES);
  m_lattices[coarse].bind();
  const int quads = coarse == 1 ? SHELL_TILE_SIDE_QUICK : SHELL_TILE_SIDE;
  glDrawElementsInstanced(GL_TRIANGLES, 6 * quads * quads, GL_UNSIGNED_SHORT, nullptr, m_groundInstances);
}

int ShellGrass::useSurface(const Surface& surface, const glm::mat4& world, float away, const gpu::PassState& state) {
  if (!m_ready || surface.density <= 0) return 0;
  const Result<gpu::Program*> shells = program(*m_shell, "grass/shell surface");
  if (!shells) return 0;
  const GrassSettings& grass = *m_grass;
  const float size = sizeOn(surface, grass);
  std::size_t level = 0;
  int first = m_groundInstances;
  while (level + 1 < m_levels.size() && (m_levels[level + 1].from <= 0 || m_levels[level + 1].from * size < away)) {
    first += static_cast<int>(2 * m_levels[level].count);
    ++level;
  }
  const bool own = m_shell->pixels != nullptr;
  const float part =
      own ? 1.0f : std::min(surface.density * size * size / std::max(textureDensity(m_made), 1e-6f), 1.0f);
  const float scale = glm::length(glm::vec3(world[0]));
  gpu::apply(state);
  (*shells)->use();
  (*shells)->set("firstInstance", first);
  (*shells)->set("world", world);
  (*shells)->set("toOwn", glm::transpose(glm::mat3(world)) / scale);
  (*shells)->set("surface", glm::vec4(size, grass.stiffness / std::max(surface.stiffness, 1e-3f), part, scale));
  m_form.bind(RENDER_TEXTURE_SHELL_FORM);
  m_colour.bind(RENDER_TEXTURE_SHELL_COLOUR);
  m_offsets.bind(RENDER_TEXTURE_SHELL_OFFSETS);
  m_instances.bindStorage(RENDER_SSBO_SHELL_INSTANCES);
  const int count = static_cast<int>(m_levels[level].count) * (surface.bothSides ? 2 : 1);
  m_counts.layers += count;
  return count;
}

long long ShellGrass::blades() const {
  const double tile = static_cast<double>(m_texture.tileM) * static_cast<double>(m_texture.tileM);
  return std::llround(static_cast<double>(m_texture.blades) * static_cast<double>(m_groundPart) / tile * m_area);
}

}  // namespace windloom
