#include "engine/render/render_programs.hpp"

#include <algorithm>

namespace windloom {
namespace {

constexpr gpu::ProgramSpec kPrograms[] = {
    {"sky/bake", {"include/fullscreen.vert", "sky/sky_bake.frag"}},
    {"sky/sky", {"include/fullscreen.vert", "sky/sky.frag"}},
    {"terrain/ground", {"terrain/ground.vert", "terrain/ground.frag"}, "FULL_DETAIL"},
    {"terrain/ground quick", {"terrain/ground.vert", "terrain/ground.frag"}},
    {"terrain/ground plain", {"terrain/ground.vert", "terrain/ground.frag"}, "PLAIN"},
    {"terrain/ground mesh", {"terrain/ground_mesh.vert", "terrain/ground.frag"}, "FULL_DETAIL"},
    {"terrain/ground mesh quick", {"terrain/ground_mesh.vert", "terrain/ground.frag"}},
    {"terrain/ground mesh plain", {"terrain/ground_mesh.vert", "terrain/ground.frag"}, "PLAIN"},
    {"terrain/solid map", {"terrain/solid_map.vert", "terrain/solid_map.frag"}},
    {"terrain/occluder level", {"terrain/occluder_level.comp"}},
    {"terrain/solid", {"terrain/solid.vert", "terrain/solid.frag"}},
    {"terrain/solid polygon", {"terrain/solid_polygon.vert", "terrain/solid.frag"}},
    {"terrain/collider", {"terrain/collider.vert", "terrain/collider.frag"}},
    {"terrain/collider mesh", {"terrain/collider.vert", "terrain/collider.frag"}, "MESH"},
    {"terrain/surface", {"terrain/surface.vert", "terrain/surface.frag"}},
    {"field/speed map", {"field/map.vert", "field/speed_map.frag"}},
    {"field/divergence map", {"field/map.vert", "field/gradient_map.frag"}},
    {"field/vorticity map", {"field/map.vert", "field/gradient_map.frag"}, "VORTICITY"},
    {"field/lic", {"field/map.vert", "field/lic.frag"}},
    {"field/map picture", {"field/map.vert", "field/map_picture.frag"}},
    {"field/trace streamlines", {"field/streamlines.comp"}},
    {"field/streamlines", {"field/streamlines.vert", "field/streamlines.frag"}},
    {"field/vectors", {"field/vectors.vert", "field/vectors.frag"}},
    {"field/arrow", {"field/arrow.vert", "field/arrow.frag"}},
    {"field/area", {"field/area.vert", "field/area.frag"}},
    {"field/point", {"field/point.vert", "field/point.frag"}},
    {"field/outline", {"field/outline.vert", "field/outline.frag"}},
};

}  // namespace

std::span<const gpu::ProgramSpec> renderPrograms() {
  return kPrograms;
}

const gpu::ProgramSpec& renderProgram(std::string_view name) {
  const auto* found = std::ranges::find(kPrograms, name, &gpu::ProgramSpec::name);
  WL_REQUIRE(found != std::end(kPrograms), "the program is in the table");
  return *found;
}

Status loadPrograms(gpu::ShaderLibrary& shaders,
                    std::initializer_list<std::pair<std::string_view, gpu::Program**>> wanted) {
  for (const auto& [name, place] : wanted) {
    Result<gpu::Program*> program = shaders.load(renderProgram(name));
    if (!program) return program.error();
    *place = *program;
  }
  return Done{};
}

}  // namespace windloom
