#include "engine/grass/grass_programs.hpp"

#include <algorithm>

namespace windloom {
namespace {

constexpr gpu::ProgramSpec kPrograms[] = {
    {"grass/cull tiles", {"grass/cull_tiles.comp"}},
    {"grass/scan groups", {"grass/scan_groups.comp"}},
    {"grass/list chunks", {"grass/list_chunks.comp"}},
    {"grass/place blades", {"grass/place_blades.comp"}, "CHAINS"},
    {"grass/place blades plain", {"grass/place_blades.comp"}},
    {"grass/blade near quick", {"grass/blade.vert", "grass/blade.frag"}, "SEGMENTS=6 QUICK"},
    {"grass/blade middle quick", {"grass/blade.vert", "grass/blade.frag"}, "SEGMENTS=3 QUICK"},
    {"grass/blade far quick", {"grass/blade.vert", "grass/blade.frag"}, "SEGMENTS=1 QUICK"},
    {"grass/virtual blades", {"grass/virtual_blades.comp"}},
    {"grass/step patches", {"grass/step_patches.comp"}, "CHAINS"},
    {"grass/blade near", {"grass/blade.vert", "grass/blade.frag"}, "SEGMENTS=6"},
    {"grass/blade middle", {"grass/blade.vert", "grass/blade.frag"}, "SEGMENTS=3"},
    {"grass/blade far", {"grass/blade.vert", "grass/blade.frag"}, "SEGMENTS=1"},
    {"grass/place plants", {"grass/place_plants.comp"}},
    {"grass/bezier patches", {"grass/bezier_patches.comp"}},
    {"grass/bezier list", {"grass/bezier_list.comp"}},
    {"grass/bezier cull", {"grass/bezier_cull.comp"}},
    {"grass/bezier next round", {"grass/bezier_round.comp"}},
    {"grass/bezier depth", {"grass/bezier_depth.comp"}},
    {"grass/bezier depth 2", {"grass/bezier_depth.comp"}, "SAMPLES=2"},
    {"grass/bezier depth 4", {"grass/bezier_depth.comp"}, "SAMPLES=4"},
    {"grass/bezier depth 8", {"grass/bezier_depth.comp"}, "SAMPLES=8"},
    {"grass/bezier wake", {"grass/bezier_wake.comp"}},
    {"grass/bezier step", {"grass/bezier_step.comp"}},
    {"grass/bezier step touched", {"grass/bezier_step.comp"}, "TOUCHED"},
    {"grass/bezier near", {"grass/bezier.vert", "grass/bezier.frag"}, "LIST=0 ROWS=8 COLUMNS=3"},
    {"grass/bezier middle", {"grass/bezier.vert", "grass/bezier.frag"}, "LIST=1 ROWS=5 COLUMNS=2"},
    {"grass/bezier far", {"grass/bezier.vert", "grass/bezier.frag"}, "LIST=2 ROWS=3 COLUMNS=2"},
    {"grass/bezier farthest", {"grass/bezier.vert", "grass/bezier.frag"}, "LIST=3 ROWS=2 COLUMNS=2"},
    {"grass/bezier dandelion",
     {"grass/bezier.vert", "grass/bezier.frag"},
     "LIST=4 ROWS=21 COLUMNS=2 DANDELION STALK=4"},
    {"grass/bezier dandelion far",
     {"grass/bezier.vert", "grass/bezier.frag"},
     "LIST=5 ROWS=9 COLUMNS=2 DANDELION STALK=2"},
    {"grass/shell", {"grass/shell.vert", "grass/shell.frag"}},
    {"grass/shell surface", {"grass/shell.vert", "grass/shell.frag"}, "SURFACE"},
    {"grass/shell slices", {"grass/shell.vert", "grass/shell.frag"}, "SLICES ONE_SAMPLE"},
    {"grass/shell texel", {"grass/shell.vert", "grass/shell.frag"}, "TEXEL"},
    {"grass/shell surface texel", {"grass/shell.vert", "grass/shell.frag"}, "SURFACE TEXEL ONE_SAMPLE"},
    {"grass/shell quick", {"grass/shell.vert", "grass/shell_quick.frag"}, "QUICK"},
    {"grass/plant", {"grass/plant.vert", "grass/plant.frag"}},
    {"grass/plant textured", {"grass/plant.vert", "grass/plant.frag"}, "TEXTURED"},
};

}  // namespace

std::span<const gpu::ProgramSpec> grassPrograms() {
  return kPrograms;
}

const gpu::ProgramSpec& grassProgram(std::string_view name) {
  const auto* found = std::ranges::find(kPrograms, name, &gpu::ProgramSpec::name);
  WL_REQUIRE(found != std::end(kPrograms), "the program is in the table");
  return *found;
}

}  // namespace windloom
