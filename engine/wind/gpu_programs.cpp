#include "engine/wind/gpu_programs.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace windloom {
namespace {

// clang-format off
#define WIND_PRESSURE_VARIANTS(X, Z) \
  {"wind/pressure first " #X "x" #Z, {"wind/pressure_down.comp"}, "FIRST FACTOR_X=" #X " FACTOR_Z=" #Z}, \
  {"wind/pressure again " #X "x" #Z, {"wind/pressure_down.comp"}, "AGAIN FACTOR_X=" #X " FACTOR_Z=" #Z}, \
  {"wind/pressure down " #X "x" #Z, {"wind/pressure_down.comp"}, "FACTOR_X=" #X " FACTOR_Z=" #Z}, \
  {"wind/pressure up " #X "x" #Z, {"wind/pressure_up.comp"}, "FACTOR_X=" #X " FACTOR_Z=" #Z}, \
  {"wind/pressure top " #X "x" #Z, {"wind/pressure_up.comp"}, "LEVEL0 FACTOR_X=" #X " FACTOR_Z=" #Z}

constexpr gpu::ProgramSpec kPrograms[] = {
    {"wind/fill", {"wind/fill.comp"}},
    {"wind/forces", {"wind/forces.comp"}},
    {"wind/predict", {"wind/predict.comp"}},
    {"wind/predict and settle", {"wind/predict.comp"}, "SETTLE"},
    {"wind/correct", {"wind/correct.comp"}},
    {"wind/correct and settle", {"wind/correct.comp"}, "SETTLE"},
    {"wind/viscosity start", {"wind/viscosity.comp"}, "START"},
    {"wind/viscosity", {"wind/viscosity.comp"}},
    {"wind/viscosity and settle", {"wind/viscosity.comp"}, "SETTLE"},
    WIND_PRESSURE_VARIANTS(4, 4),
    WIND_PRESSURE_VARIANTS(4, 2),
    WIND_PRESSURE_VARIANTS(2, 4),
    WIND_PRESSURE_VARIANTS(4, 1),
    WIND_PRESSURE_VARIANTS(1, 4),
    WIND_PRESSURE_VARIANTS(2, 2),
    WIND_PRESSURE_VARIANTS(2, 1),
    WIND_PRESSURE_VARIANTS(1, 2),
    WIND_PRESSURE_VARIANTS(1, 1),
    {"wind/pressure tail", {"wind/pressure_tail.comp"}, "TAIL_CELLS=1360 TAIL_RHS=336 TAIL_RESIDUALS=1024 TAIL_STRIDES=1"},
    {"wind/jacobi first", {"wind/pressure_down.comp"}, "FIRST JACOBI"},
    {"wind/jacobi", {"wind/pressure_down.comp"}, "JACOBI"},
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

const gpu::ProgramSpec& pressureProgram(std::string_view pass, glm::ivec2 factor) {
  return windProgram("wind/pressure " + std::string(pass) + " " + std::to_string(factor.x) + "x" +
                     std::to_string(factor.y));
}

}  // namespace windloom
