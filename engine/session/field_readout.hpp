#pragma once
// The whole wind of a moment for those outside the picture, without waiting for the GPU: what was asked for comes some
// frames later.

#include <deque>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/gpu/readback.hpp"

namespace windloom {

class Simulation;

/// A copy of the cell-centred field, laid out as WindSolver::readVelocity does.
struct FieldSnapshot {
  long number = 0;  ///< grows with each snapshot; 0: there is none yet
  double time = 0;  ///< simulated s
  GridMapping grid{};
  std::vector<glm::vec2> cells;  ///< m/s
};

class FieldReadout {
 public:
  /// Asks for the field as it is now; nothing where that is known, or on its way, already. On the CPU backend it is
  /// there at once. Where too many are on their way, or OpenGL has no memory for it (logged once), nothing is asked.
  void ask(Simulation& simulation);
  /// The newest that has come; never null. Whoever keeps it keeps it unchanged.
  std::shared_ptr<const FieldSnapshot> newest();
  /// The wind jumped or was changed without a step: the next ask() takes it again.
  void touch() { m_askedStep = -1; }

 private:
  struct Request {
    long tag = 0;
    double time = 0;
    GridMapping grid{};
  };
  void dropRing();
  bool fitRing(glm::ivec2 resolution);
  FieldSnapshot& next(double time, const GridMapping& grid);

  std::shared_ptr<FieldSnapshot> m_newest = std::make_shared<FieldSnapshot>();
  gpu::ReadbackRing m_ring;
  glm::ivec2 m_ringResolution{0};
  std::deque<Request> m_inFlight;
  long m_askedStep = -1, m_tag = 0;
  bool m_failed = false;
};

}  // namespace windloom
