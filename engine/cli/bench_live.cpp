// The meadow, and the prairie of shell grass, as the editor plays it, without its window: the wind on a grid that keeps
// up, the grass at the detail that quality control finds. Tells how fast it gets and whether it comes to rest.
#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

#include "engine/cli/bench_project.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/cli/bench_views.hpp"
#include "engine/model/templates.hpp"
#include "engine/render/framing.hpp"
#include "engine/session/quality_control.hpp"
#include "engine/session/session.hpp"

namespace windloom::cli {
namespace {

/// What the frames of a stretch of time were like.
struct Stretch {
  std::vector<double> ms;
  int changes = 0;  // times the detail began to move

  void add(double frameMs, bool began) {
    ms.push_back(frameMs);
    changes += began ? 1 : 0;
  }
  [[nodiscard]] double slowest(double part) const {  // of the frames, `part` are slower
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>((1.0 - part) * static_cast<double>(sorted.size() - 1))];
  }
};

BenchRow rowOf(const char* name, const Stretch& stretch, float detail, const SessionStatus& status) {
  const double ms = median(stretch.ms);
  BenchRow row = {
      {"stretch", name},
      {"frame ms", ms},
      {"fps", 1000 / ms},
      {"5% slower than, ms", stretch.slowest(0.05)},
      {"detail", detail},
      {"changes of detail", stretch.changes},
      {"wind cells", std::to_string(status.liveResolution.x) + " x " + std::to_string(status.liveResolution.y)},
      {"wind step ms", status.stepMs},
      {"drawn", status.frame.bladesDrawn},
      {"runs", stretch.ms.size()}};
  row["stages"] = Json::object();
  for (const auto& [stage, stageMs] : status.frame.passMs) row["stages"][stage] = stageMs;
  return row;
}

struct Live {
  Session& session;
  QualityControl quality;
  Session::View view;
  double lastMs = 16;
  bool moving = false;

  /// As the editor's frame: the steps that are due, the picture, the wait for it.
  void frame(Stretch& stretch) {
    lastMs = wallMs([&] {
      session.advance(lastMs * 1e-3);
      view.quality.detail = quality.detail();
      session.draw(view);
      glFinish();
    });
    const float before = quality.detail();
    quality.frameDone(lastMs);
    const bool moves = quality.detail() != before;
    stretch.add(lastMs, moves && !moving);
    moving = moves;
  }
};

const char* kindName(GrassKind kind) {
  switch (kind) {
    case GrassKind::Instanced:
      return "instanced";
    case GrassKind::Bezier:
      return "bezier";
    case GrassKind::Shell:
      return "shell";
    case GrassKind::None:
      break;
  }
  return "none";
}

/// Plays the project, once to settle and once to count.
Status addPlayed(const BenchSetup& setup, const char* name, const Project& project, std::vector<BenchRow>& rows) {
  const bool quick = setup.size == BenchSize::Quick;
  SessionOptions options;
  options.context = setup.context;
  options.shaders = setup.shaders;
  const Result<std::unique_ptr<Session>> session = Session::create(project, options);
  if (!session) return session.error();
  const Result<gpu::Framebuffer> target =
      benchTarget(setup.picture.value_or(quick ? glm::ivec2(160, 90) : glm::ivec2(1280, 720)));
  if (!target) return target.error();
  (*session)->play();
  Live live{**session, QualityControl(setup.context->info().software ? kSoftwareTarget : kGpuTarget), {}};
  live.view.camera = viewThrough(project.cameras->front());
  live.view.size = target->size();
  live.view.framebuffer = target->name();
  const double seconds = quick ? 0.5 : 10.0;
  for (const char* part : {"settling", "settled"}) {
    Stretch stretch;
    for (double spent = 0; spent < seconds; spent += live.lastMs * 1e-3) live.frame(stretch);
    BenchRow row = {{"sample", name}, {"grass", kindName(project.grass->kind)}};
    row.update(rowOf(part, stretch, live.quality.detail(), (*session)->status()));
    rows.push_back(std::move(row));
  }
  return Done{};
}

}  // namespace

Result<std::vector<BenchRow>> benchLive(const BenchSetup& setup) {
  std::vector<BenchRow> rows;
  if (setup.context == nullptr) return rows;
  for (const GrassKind kind : {GrassKind::Instanced, GrassKind::Bezier}) {
    Project project = findTemplate("meadow")->make();
    GrassSettings grass = *project.grass;
    grass.kind = kind;
    project.grass = std::make_shared<GrassSettings>(grass);
    if (Status added = addPlayed(setup, "meadow", project, rows); !added) return added.error();
  }
  const Result<Project> prairie = benchSample("prairie");
  if (!prairie) return prairie.error();
  if (Status added = addPlayed(setup, "prairie", *prairie, rows); !added) return added.error();
  return rows;
}

}  // namespace windloom::cli
