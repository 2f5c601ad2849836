#include "engine/wind/gpu_programs.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace windloom {
namespace {

// clang-format off
constexpr gpu::ProgramSpec kPrograms[] = {
    {"wind/fill", {"wind/fill.comp"}},
    {"wind/inflow", {"wind/inflow.comp"}},
    {"wind/arrows", {"wind/arrows.comp"}},
    {"wind/forces", {"wind/forces.comp"}},
    {"wind/predict", {"wind/predict.comp"}},
    {"wind/predict and settle", {"wind/predict.comp"}, "SETTLE"},
    {"wind/correct", {"wind/correct.comp"}},
    {"wind/correct and settle", {"wind/correct.comp"}, "SETTLE"},
    {"wind/viscosity start", {"wind/viscosity.comp"}, "START"},
    {"wind/viscosity", {"wind/viscosity.comp"}},
    {"wind/viscosity and settle", {"wind/viscosity.comp"}, "SETTLE"},
    {"wind/pressure first", {"wind/pressure_down.comp"}, "FIRST"},
    {"wind/pressure again", {"wind/pressure_down.comp"}, "AGAIN"},
    {"wind/pressure down", {"wind/pressure_down.comp"}},
    {"wind/pressure tail", {"wind/pressure_tail.comp"}, "TAIL_CELLS=1344 TAIL_FIRST=1024 TAIL_NODES=370 TAIL_STRIDES=1 TAIL_LAST=64"},
    {"wind/pressure up", {"wind/pressure_up.comp"}},
    {"wind/pressure top", {"wind/pressure_up.comp"}, "LEVEL0"},
    {"wind/pressure tail start", {"wind/pressure_tail.comp"}, "START TAIL_CELLS=1344 TAIL_FIRST=1024 TAIL_NODES=370 TAIL_STRIDES=1 TAIL_LAST=64"},
    {"wind/start", {"wind/start.comp"}},
    {"wind/end of cycle", {"wind/end_cycle.comp"}},
    {"wind/report", {"wind/report.comp"}},
    {"wind/adopt", {"wind/adopt.comp"}},
    {"wind/jacobi first", {"wind/jacobi.comp"}, "FIRST"},
    {"wind/jacobi", {"wind/jacobi.comp"}},
    {"wind/project", {"wind/project.comp"}},
    {"wind/project jacobi", {"wind/project.comp"}, "JACOBI"},
    {"wind/resample", {"wind/project.comp"}, "RESAMPLE_ONLY"},
};
// clang-format on

}  // namespace

std::span<const gpu::ProgramSpec> windPrograms() {
  return kPrograms;
}

const gpu::ProgramSpec& windProgram(std::string_view name) {
  const auto* found = std::find_if(std::begin(kPrograms), std::end(kPrograms),
                                   [&](const gpu::ProgramSpec& spec) { return spec.name == name; });
  WL_REQUIRE(found != std::end(kPrograms), "the table of wind programs holds every variant in use");
  return *found;
}

}  // namespace windloom
