#pragma once
// A project brought to life for the editor and for `render`: it compares each new project with what it
// last saw, updates only what changed, keeps the wind blowing at its fixed step, and draws.

#include <memory>
#include <optional>
#include <vector>

#include "engine/render/frame_renderer.hpp"
#include "engine/session/field_readout.hpp"
#include "engine/session/simulation.hpp"

namespace windloom {

enum class LiveGrid {
  Full,       ///< the project's resolution, whatever it costs
  Automatic,  ///< a coarser grid where the project's is too slow for real time; shown in the status
};

struct SessionOptions {
  gpu::Context* context = nullptr;        ///< must outlive the session
  gpu::ShaderLibrary* shaders = nullptr;  ///< must outlive the session
  Backend backend = Backend::Auto;        ///< overrides the project's unless Auto
  LiveGrid liveGrid = LiveGrid::Automatic;
};

struct SessionStatus {
  Backend backend = Backend::Cpu;
  glm::ivec2 liveResolution{0};     ///< cells the live wind runs on
  glm::ivec2 projectResolution{0};  ///< cells that sample and bake use
  double stepMs = 0;                ///< median of recent steps
  double timeScale = 1;             ///< simulated seconds per wall second while playing; < 1: can't keep up
  WindDiagnostics wind;
  FrameStats frame;
};

/// A part of time that is played again and again.
struct LoopRange {
  double in = 0, out = 10;  ///< simulated s; out is at least a time step after in
  bool on = false;
};

/// On the way to a time that was asked for.
struct SeekProgress {
  double target = 0;  ///< s
  float part = 0;     ///< of the steps, 0..1
};

/// The wind at a watched place, at the time of a step.
struct WindSample {
  double time = 0;                    ///< simulated s
  glm::vec2 place{0.0f}, wind{0.0f};  ///< m; m/s
};

class Session {
 public:
  static Result<std::unique_ptr<Session>> create(const Project& project, const SessionOptions& options);
  virtual ~Session() = default;

  /// Equal parts cost nothing. On failure the session keeps showing the last project.
  virtual Status setProject(const Project& project) = 0;
  virtual Status setLiveGrid(LiveGrid choice) = 0;

  virtual void play() = 0;
  virtual void pause() = 0;
  [[nodiscard]] virtual bool playing() const = 0;
  virtual void stepOnce() = 0;
  virtual void restart() = 0;
  [[nodiscard]] virtual double time() const = 0;

  /// Goes to a time (s, >= 0): from the present, a checkpoint or the start, whichever needs the fewest steps and leads
  /// to the wind that running from the start gives. The steps are done by advance(), some in each frame; then playing
  /// or holding goes on. A second call changes the target.
  virtual void seek(double seconds) = 0;
  /// Stays at the time that was reached, holding.
  virtual void cancelSeek() = 0;
  [[nodiscard]] virtual std::optional<SeekProgress> seeking() const = 0;
  /// While it is on, playing goes back to `in` at `out`.
  virtual void setLoop(const LoopRange& loop) = 0;
  [[nodiscard]] virtual const LoopRange& loop() const = 0;

  /// Forces beside the project's in the steps from now on, but for those of a seek, until set again (the wind brush).
  virtual void setTransientForces(std::span<const ArrowForce> forces) = 0;

  /// While seeking, runs the steps that fit in a slice of a frame. While playing, runs the steps that `wallSeconds` of
  /// real time call for, but no more than fit in about half a frame: a slow machine slows time down instead of
  /// spiralling.
  virtual void advance(double wallSeconds) = 0;
  /// Steps to a time without drawing, for pictures at a time.
  virtual void runTo(double seconds) = 0;

  struct View {
    ViewCamera camera;
    glm::ivec2 size{1280, 720};
    unsigned framebuffer = 0;
    glm::ivec2 origin{0, 0};
    Overlays overlays;
    Highlight highlight;
    FrameQuality quality;
    GrassView grassView = GrassView::Normal;
    BezierCulling bezierCulling;
  };
  virtual void draw(const View& view) = 0;

  /// Wind at a world position in m/s; on the GPU backend of a recent step, so that nothing waits.
  virtual glm::vec2 windAt(glm::vec2 world) = 0;
  /// Samples these places from now on at steps about 1/30 s of simulated time apart.
  virtual void watch(std::vector<glm::vec2> places) = 0;
  /// What came since the last call, by ascending time but for where time went back. On the GPU backend samples come a
  /// few frames late, and some may be left out.
  virtual std::vector<WindSample> takeSamples() = 0;
  /// Asks for the whole field as it is now; nothing where that is known or on its way. It comes with field(): at once
  /// on the CPU backend, some frames later on the GPU, so that nothing waits.
  virtual void askField() = 0;
  /// The newest that came; never null. Whoever keeps it keeps it unchanged.
  virtual std::shared_ptr<const FieldSnapshot> field() = 0;
  [[nodiscard]] virtual const SessionStatus& status() = 0;
};

}  // namespace windloom
