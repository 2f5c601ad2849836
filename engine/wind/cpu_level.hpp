#pragma once
// One level of the CPU backend's multigrid, and the one pass over it that everything is made of.

#include <span>
#include <vector>

#include "engine/wind/cpu_plane.hpp"
#include "engine/wind/pressure_levels.hpp"

namespace windloom {

/// Cells [begin, end) of a row; plain ones all have the level's common conductances and no border or solid at a face.
struct LevelRun {
  int begin, end;
  bool plain;
};

struct CpuLevel {
  int width = 0, height = 0, factorX = 1, factorZ = 1;
  bool periodicX = false, periodicZ = false;
  CpuPlane d, b, next;              // cells
  CpuPlane cx, cz, shareX, shareZ;  // faces
  CpuPlane inverse;                 // cells
  CpuPlane applied, lastApplied;    // cells, on the finest level only
  float plainX = 0, plainZ = 0, plainInverse = 0;
  std::vector<LevelRun> runs;
  std::vector<int> runStart;  // height + 1
};

/// Rows a task of a pass works on; even, so that a pair of rows that coarsens into one stays in one task.
inline constexpr int kLevelRowsPerTask = 48;

/// Most sweeps of one pass.
inline constexpr std::size_t kMostSweeps = 5;

enum class PassStart {
  Zero,     ///< d is 0
  Plane,    ///< d as it is
  Prolong,  ///< a sweep from 0 of weight WIND_SMOOTH_DOWN, plus the coarse level's correction
};
enum class PassEnd {
  Restrict,  ///< the residual becomes the coarse level's b, and d is not kept: the way up finds it again
  Apply,     ///< A d is stored in level.applied, and its products are summed
  None,
};

/// Scalar products over the rows of a pass that ends with Apply.
struct LevelProducts {
  double withResidual = 0;  ///< b . A d
  double withLast = 0;      ///< A d . level.lastApplied
  double withItself = 0;    ///< A d . A d
};

/// Sweeps of the smoother over one level, with what comes before and after them, row by row, so that a row stays in the
/// cache from the first sweep to the last. The result is written to level.next, except for
/// Restrict.
struct LevelPass {
  CpuLevel* level = nullptr;
  CpuLevel* coarse = nullptr;  // for Prolong and Restrict; for Prolong with the ghosts of its d set
  PassStart start = PassStart::Zero;
  PassEnd end = PassEnd::None;
  std::span<const float> weights;  // of the sweeps, 1 to kMostSweeps of them
  bool joins = false;              // Apply: whether there is a level.lastApplied
};

/// Runs rows [begin, end) of a pass. Tasks of one pass may run at the same time.
LevelProducts runLevelPass(const LevelPass& pass, int begin, int end);

/// direction = fresh - beta direction, for `count` values; the same for `applied`. Then solution += alpha direction and
/// residual -= alpha applied.
struct DirectionRows {
  const float *fresh, *freshApplied;
  float *direction, *applied, *solution, *residual;
};
void advanceSolution(const DirectionRows& rows, int count, float alpha, float beta);
/// The first time: direction = fresh, applied = freshApplied, solution = alpha direction.
void beginSolution(const DirectionRows& rows, int count, float alpha);

}  // namespace windloom
