#pragma once
// The CPU backend behind makeCpuWindSolver; here for tests and benchmarks that look at faces.

#include "engine/wind/cpu_fields.hpp"
#include "engine/wind/cpu_multigrid.hpp"
#include "engine/wind/cpu_projection.hpp"

namespace windloom {

class CpuWindSolver final : public WindSolver {
 public:
  /// The setup must pass checkWindSetup.
  CpuWindSolver(const WindSetup& setup, int threads);

  void configure(const WindSetup& setup) override;
  void step(std::span<const ArrowForce> arrows, double time) override;
  void reset() override;
  Status setVelocity(std::span<const glm::vec2> cells) override;
  void readVelocity(std::vector<glm::vec2>& cells) override;
  Result<std::unique_ptr<WindState>> save() override;
  void restore(const WindState& state) override;

  [[nodiscard]] unsigned velocityTexture() const override { return 0; }
  [[nodiscard]] const GridMapping& grid() const override { return m_fields.grid.mapping; }
  [[nodiscard]] const WindDiagnostics& diagnostics() override { return m_diagnostics; }
  [[nodiscard]] Backend backend() const override { return Backend::Cpu; }
  [[nodiscard]] std::size_t memoryBytes() const override;

  /// The state on the staggered grid. `velocity` may be changed between steps (ghosts aside).
  [[nodiscard]] CpuFields& fields() { return m_fields; }

 private:
  void applySettings(const WindSetup& setup);
  void takeReport(const ProjectionReport& report);

  ThreadPool m_pool;
  CpuFields m_fields;
  CpuMultigrid m_multigrid;
  ArrowTiles m_tiles;
  WindDiagnostics m_diagnostics;
};

}  // namespace windloom
