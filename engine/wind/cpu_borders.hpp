#pragma once
// Borders and solids of the CPU backend: ghosts, and faces that let nothing through.

#include "engine/wind/cpu_fields.hpp"

namespace windloom {

enum class OpenGhost {
  Ambient,  ///< behind an open border blows the ambient wind
  Copy,     ///< as the entry inside
};

/// Sets the ghosts of both components. With OpenGhost::Ambient it reads the border faces of `fields.velocity`.
void fillGhosts(const CpuFields& fields, CpuVelocity& velocity, OpenGhost open);

/// Finds blocked faces and solid nodes again after grid.solid changed.
void findBlocked(CpuFields& fields);

/// Makes every blocked face exactly 0, and the last face of a periodic pair equal to the first.
void blockFaces(const CpuFields& fields, CpuVelocity& velocity);

/// The runs of one row.
inline std::span<const CpuRun> runsOf(const CpuRuns& runs, int row) {
  const auto begin = static_cast<std::size_t>(runs.start[static_cast<std::size_t>(row)]);
  const auto end = static_cast<std::size_t>(runs.start[static_cast<std::size_t>(row) + 1]);
  return std::span(runs.runs).subspan(begin, end - begin);
}

}  // namespace windloom
