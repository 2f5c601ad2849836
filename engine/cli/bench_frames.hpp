#pragma once
// Measures frames of a meadow whose wind is solved as it is drawn: one step of the wind, one picture.

#include <functional>

#include "engine/cli/bench_views.hpp"
#include "engine/gpu/timer.hpp"
#include "engine/session/simulation.hpp"

namespace windloom::cli {

/// Medians over the frames of a run.
struct FrameTimes {
  double windMs = 0;     ///< the wind's step, GPU
  double grassMs = 0;    ///< finding, placing and bending the blades: the stages of the picture named "grass ...", GPU
  double drawingMs = 0;  ///< all other stages of the picture, GPU
  double frameMs = 0;    ///< from a frame's begin to the next one's where they follow without a wait, GPU
  double wallMs = 0;     ///< the same on the wall clock
  long long drawn = 0;   ///< blades
  BezierCounts bezier;   ///< of the last frame
  ShellCounts shell;     ///< of the last frame
  int frames = 0;        ///< measured
  /// Of one frame, everything in it: drawn triangles, shaded fragments. Only where FrameBench::countWork was called;
  /// fragments are 0 where the driver doesn't count them.
  long long triangles = 0, fragments = 0;
  std::size_t grassBytes = 0, allBytes = 0;    ///< of GPU memory while it ran
  std::size_t shapeBytes = 0, stateBytes = 0;  ///< the Bezier blades' part of it
  std::size_t shellBytes = 0;                  ///< the shells'
  Json stages = Json::object();                ///< of the picture, ms
};

class FrameBench {
 public:
  /// Fails with Machine. The setup must have a context and outlive this.
  static Result<FrameBench> create(const BenchSetup& setup, glm::ivec2 size);

  /// `simulation` null: nothing is solved; the air is as `hold` has it, else still.
  /// Fails with Machine where the picture couldn't be drawn (no memory).
  Result<FrameTimes> run(const Project& project, Simulation* simulation, const ViewCamera& camera,
                         const FrameQuality& quality, const BezierCulling& culling = {});

  /// For runs without a simulation: this wind, at this time, in every frame. It must outlive them.
  void hold(const WindTexture& wind, double time);
  /// Runs draw one more frame and count its triangles and fragments.
  void countWork() { m_counts = true; }
  /// The last frame drawn.
  [[nodiscard]] const gpu::Framebuffer& picture() const { return m_target; }

 private:
  explicit FrameBench(const BenchSetup& setup) : m_setup(&setup) {}
  const BenchSetup* m_setup;
  std::unique_ptr<FrameRenderer> m_renderer;
  gpu::Framebuffer m_target;
  WindTexture m_wind{};
  double m_time = 0;
  bool m_counts = false;
};

/// The wind of a meadow on the GPU.
Result<std::unique_ptr<Simulation>> benchWind(const BenchSetup& setup, const Project& project);

/// 1920 x 1080 where the setup asks for no other size; tiny where it is quick.
glm::ivec2 benchPictureSize(const BenchSetup& setup);

}  // namespace windloom::cli
