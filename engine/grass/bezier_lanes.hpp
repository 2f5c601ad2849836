#pragma once
// Variants of the passes that look after a patch with a work-group, by how many blades of it are shown: a software
// renderer does the work of idle invocations, too.

#include <array>
#include <cstdint>
#include <string>

#include "engine/core/result.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/grass/grass_programs.hpp"
#include "shaders/shared/bezier_blade.h"

namespace windloom {

class BezierLanes {
 public:
  /// Loads the variants of a program of grassPrograms(). Fails with Machine.
  Status load(gpu::ShaderLibrary& shaders, std::string_view program) {
    for (std::size_t i = 0; i < kLanes.size(); ++i) {
      Result<gpu::Program*> made = shaders.load(grassProgram(program), "LANES=" + std::to_string(kLanes[i]) + "u");
      if (!made) return made.error();
      m_programs[i] = *made;
    }
    return Done{};
  }
  /// The smallest work-groups that hold so many blades of a patch.
  [[nodiscard]] const gpu::Program& forBlades(std::uint32_t kept) const {
    std::size_t i = 0;
    while (i + 1 < kLanes.size() && kLanes[i] < kept) ++i;
    return *m_programs[i];
  }

 private:
  static constexpr std::array<std::uint32_t, 3> kLanes{16, 64, BEZIER_PATCH};
  std::array<gpu::Program*, 3> m_programs{};
};

}  // namespace windloom
