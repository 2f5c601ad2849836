#pragma once
// One picture of a project: sky, ground, grass in wind, obstacles, overlays, arrows, tone map.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/grid_mapping.hpp"
#include "engine/core/result.hpp"
#include "engine/grass/bezier_view.hpp"
#include "engine/grass/shell_view.hpp"
#include "engine/model/evaluate.hpp"
#include "engine/model/project.hpp"
#include "engine/render/overlay_settings.hpp"
#include "engine/render/view_camera.hpp"

namespace windloom {

namespace gpu {
class Context;
class ShaderLibrary;
}  // namespace gpu

/// The wind as the renderers read it.
struct WindTexture {
  unsigned name = 0;  ///< RG32F or RG16F texture, texel (i, k) = cell (i, k), m/s
  GridMapping grid{};
};

/// What the editor marks.
struct Highlight {
  std::span<const Id> selected;
  Id hovered = 0;
};

/// How finely a frame is drawn.
struct FrameQuality {
  float detail = 1.0f;   ///< of the grass, 0..1: fewer blades far away first, then fewer near; 1 = all within reach
  bool thinning = true;  ///< false: every blade is drawn in full, however small, to compare pictures with
  bool culling = true;   ///< false: blades out of sight are drawn, too, to compare times with
  bool still = false;    ///< nothing moves: ground, maps and edges as fine as they can be, though it takes longer
  bool complete = true;  ///< waits for what is made beside the frame (Bezier blades); false: the frame goes without it
  int samples = 0;       ///< a pixel: 1, 2, 4 or 8; 0: as many as fit the machine and the detail
};

struct FrameInput {
  const Project* project = nullptr;
  const GraphEvaluator* graph = nullptr;  ///< for the arrows' colour at `time`; may be null: drawn at full strength
  WindTexture wind;                       ///< name 0: still air
  double time = 0;                        ///< s
  ViewCamera camera;
  glm::ivec2 size{1280, 720};  ///< pixels
  unsigned framebuffer = 0;    ///< target, 8-bit colour; the picture is written sRGB-encoded
  glm::ivec2 origin{0, 0};     ///< lower left corner in the target
  Overlays overlays;
  Highlight highlight;
  FrameQuality quality;
  GrassView grassView = GrassView::Normal;  ///< Bezier grass only
  BezierCulling bezierCulling;
};

struct FrameStats {
  long long bladesTotal = 0;  ///< that the project asks for
  long long bladesDrawn = 0;  ///< of a recent finished frame
  BezierCounts bezier;        ///< all 0 with other grass
  ShellCounts shell;          ///< all 0 with other grass
  bool complete = true;       ///< false: grass is still being placed beside the frame
  double gpuMs = 0;           ///< of a recent finished frame; 0 until known
  std::vector<std::pair<std::string, double>> passMs;
};

class FrameRenderer {
 public:
  /// Fails with Machine (file and line of a shader that doesn't compile).
  static Result<std::unique_ptr<FrameRenderer>> create(gpu::Context& context, gpu::ShaderLibrary& shaders);
  virtual ~FrameRenderer() = default;

  /// Leads grass that remembers to the time of `input` without drawing, so that a later picture shows what happened on
  /// the way.
  virtual void advance(const FrameInput& input) = 0;

  /// Never waits for the GPU.
  virtual FrameStats render(const FrameInput& input) = 0;
};

/// The speed colour map (perceptually even, colour-blind safe) at t in 0..1, sRGB. The legend uses it too.
glm::vec3 speedColour(float t);
/// The colour map of divergence and vorticity at t in -1..1, sRGB: near black at 0.
glm::vec3 divergingColour(float t);

}  // namespace windloom
