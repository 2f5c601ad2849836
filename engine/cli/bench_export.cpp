#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include "engine/bake/bake.hpp"
#include "engine/cli/bench.hpp"
#include "engine/cli/bench_project.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/cli/scratch_folder.hpp"
#include "engine/core/file.hpp"
#include "engine/session/simulation.hpp"

namespace windloom::cli {
namespace fs = std::filesystem;
namespace {

using Frames = std::vector<std::vector<glm::vec2>>;

constexpr int kDifferentFrames = 8;  // recorded; longer recordings repeat them
constexpr double kFps = 30;
constexpr std::uint64_t kMaxRowBytes = 512ull << 20;  // volumes of all frames would fill disks

/// `part` of the time that a row may take.
RunLimits limitsOf(const BenchSetup& setup, int runs, double part) {
  if (setup.size == BenchSize::Quick) return {0, 1, 1, setup.capSeconds};
  return {1, 3, runs, setup.capSeconds * part};
}

Result<std::unique_ptr<Simulation>> simulationOf(const BenchSetup& setup, const Project& project, Backend backend) {
  SimulationOptions options;
  options.backend = backend;
  if (backend == Backend::Gpu) {
    options.context = setup.context;
    options.shaders = setup.shaders;
  }
  return Simulation::create(project, options);
}

/// Solved wind, since how far formats shrink it counts.
Result<Frames> recordedFrames(const BenchSetup& setup, int side) {
  Result<std::unique_ptr<Simulation>> simulation = simulationOf(setup, benchProject(side, 10), Backend::Cpu);
  if (!simulation) return simulation.error();
  const int warmUp = setup.size == BenchSize::Quick ? 2 : 30;
  for (int step = 0; step < warmUp; ++step) (*simulation)->step();
  Frames frames;
  for (int frame = 0; frame < kDifferentFrames; ++frame) {
    (*simulation)->step();
    (*simulation)->step();
    frames.push_back((*simulation)->velocity());
  }
  return frames;
}

BakeHeader headerFor(const Frames& frames, int side, int count) {
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, glm::vec2(0.1f * static_cast<float>(side)), {side, side});
  header.frames = count;
  header.last = count - 1;
  header.fps = kFps;
  for (const std::vector<glm::vec2>& frame : frames) {
    for (const glm::vec2 v : frame) header.fastest = std::max(header.fastest, glm::length(v));
  }
  header.fullScale = header.fastest;
  return header;
}

Result<std::vector<BakedFile>> writeAll(const WriterKind& kind, const BakeHeader& header, const Frames& frames,
                                        const fs::path& folder) {
  Result<std::unique_ptr<FrameWriter>> writer = kind.open(header, folder);
  if (!writer) return writer.error();
  for (int frame = 0; frame < header.frames; ++frame) {
    if (Status added = (*writer)->add(frame, frames[static_cast<std::size_t>(frame) % frames.size()]); !added)
      return added.error();
  }
  return (*writer)->finish();
}

/// The floor: the same files, written with plain calls. A bake syncs all its files together, after its last one.
Status writePlainly(const std::vector<std::string>& contents, const fs::path& folder) {
  for (std::size_t i = 0; i < contents.size(); ++i) {
    const fs::path path = folder / std::to_string(i);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    std::string_view left = contents[i];
    while (file >= 0 && !left.empty()) {
      const ssize_t n = ::write(file, left.data(), left.size());
      if (n < 0) break;
      left.remove_prefix(static_cast<std::size_t>(n));
    }
    if (file < 0 || ::close(file) != 0 || !left.empty()) {
      return makeError(ErrorKind::Machine, path.string(), {}, "can't write");
    }
  }
  return Done{};
}

Result<double> plainMs(const BenchSetup& setup, const std::vector<BakedFile>& files, const fs::path& folder) {
  std::vector<std::string> contents;
  for (const BakedFile& file : files) {
    Result<std::string> bytes = readFile(folder / file.path, 1ull << 33);
    if (!bytes) return bytes.error();
    contents.push_back(std::move(*bytes));
  }
  const ScratchFolder plain;
  Status written = Done{};
  const Measured m = measure(limitsOf(setup, 5, 0.25), [&] {
    return wallMs([&] {
      if (written) written = writePlainly(contents, plain.path);
    });
  });
  if (!written) return written.error();
  return m.median;
}

Result<BenchRow> writerRow(const BenchSetup& setup, const WriterKind& kind, const BakeHeader& header,
                           const Frames& frames) {
  const ScratchFolder scratch;
  Result<std::vector<BakedFile>> files = std::vector<BakedFile>{};
  const Measured m = measure(limitsOf(setup, 9, 0.5), [&] {
    return wallMs([&] {
      if (files) files = writeAll(kind, header, frames, scratch.path);
    });
  });
  if (!files) return files.error();
  std::uint64_t fileBytes = 0;
  for (const BakedFile& file : *files) fileBytes += fs::file_size(scratch.path / file.path);
  const Result<double> plain = plainMs(setup, *files, scratch.path);
  if (!plain) return plain.error();
  const double megabytes = static_cast<double>(kind.bytes(header)) / 1e6;
  const std::string side = std::to_string(header.grid.resolution.x);
  return BenchRow{{"format", kind.name},      {"frames", std::to_string(header.frames) + " of " + side + " x " + side},
                  {"MB", megabytes},          {"MB in files", static_cast<double>(fileBytes) / 1e6},
                  {"ms", m.median},           {"MB/s", megabytes / m.median * 1e3},
                  {"plain write ms", *plain}, {"runs", m.runs}};
}

/// Every format, or only some of them.
Status addWriters(const BenchSetup& setup, int side, int count, std::span<const std::string_view> only,
                  std::vector<BenchRow>& rows) {
  const Result<Frames> frames = recordedFrames(setup, side);
  if (!frames) return frames.error();
  const BakeHeader header = headerFor(*frames, side, count);
  for (const WriterKind& kind : writerKinds()) {
    if (!kind.missing.empty() || (kind.refusal != nullptr && !kind.refusal(header).empty())) continue;
    if (!only.empty() && std::ranges::find(only, kind.name) == only.end()) continue;
    BakeHeader fewer = header;
    while (fewer.frames > 1 && kind.bytes(fewer) > kMaxRowBytes) {
      fewer.frames /= 2;
      fewer.last = fewer.frames - 1;
    }
    Result<BenchRow> row = writerRow(setup, kind, fewer, *frames);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  return Done{};
}

/// Milliseconds of the steps that a bake of this plan takes, and nothing else.
double simulateMs(const BenchSetup& setup, Simulation& simulation, const RecordPlan& plan) {
  const long steps = stepOfFrame(plan, plan.frames - 1, static_cast<double>(simulation.project().field->timeStep));
  simulation.restart();
  return wallMs([&] {
    for (long step = 0; step < steps; ++step) simulation.step();
    if (setup.context != nullptr && simulation.solver().backend() == Backend::Gpu) glFinish();
  });
}

Result<BenchRow> bakeRow(const BenchSetup& setup, Backend backend, const char* names) {
  const bool quick = setup.size == BenchSize::Quick;
  const int cells = quick ? 64 : 1000;
  Result<std::unique_ptr<Simulation>> simulation = simulationOf(setup, benchProject(cells, 10), backend);
  if (!simulation) return simulation.error();
  const ScratchFolder scratch;
  BakeRequest request;
  request.folder = scratch.path;
  request.plan.fps = kFps;
  request.plan.frames = quick ? 4 : 64;
  request.resolution = quick ? glm::ivec2(16) : glm::ivec2(256);
  std::string all = names;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(',', at), all.size());
    request.formats.push_back(writerKindNamed(all.substr(at, end - at)));
    WL_REQUIRE(request.formats.back() != nullptr, "formats of the benchmark exist");
    at = end + 1;
  }
  std::vector<double> simulated;
  std::optional<Error> trouble;
  // The two take turns, so that a machine that gets slower does so for both.
  const Measured baked = measure(limitsOf(setup, 5, 2), [&] {
    simulated.push_back(simulateMs(setup, **simulation, request.plan));
    (*simulation)->restart();
    return wallMs([&] {
      if (const Result<BakeReport> report = bake(**simulation, request, {}); !report) trouble = report.error();
    });
  });
  if (trouble) return *trouble;
  if (simulated.size() > 1) simulated.erase(simulated.begin());  // the warm-up
  const double plain = median(simulated);
  return BenchRow{{"format", "bake: " + all},
                  {"frames", std::to_string(request.plan.frames) + " of " + std::to_string(request.resolution->x) +
                                 " x " + std::to_string(request.resolution->y)},
                  {"where", std::string(backend == Backend::Gpu ? "gpu" : "cpu") + ", " + std::to_string(cells) +
                                " x " + std::to_string(cells)},
                  {"ms", baked.median},
                  {"only simulated ms", plain},
                  {"more %", 100 * (baked.median / plain - 1)},
                  {"runs", baked.runs}};
}

}  // namespace

Result<std::vector<BenchRow>> benchExport(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  std::vector<BenchRow> rows;
  if (Status added = addWriters(setup, quick ? 16 : 256, quick ? 2 : 64, {}, rows); !added) return added.error();
  constexpr std::string_view kLarge[] = {"exr", "dds"};
  if (Status added = addWriters(setup, quick ? 32 : 1024, quick ? 2 : 16, kLarge, rows); !added) return added.error();
  for (const Backend backend : {Backend::Cpu, Backend::Gpu}) {
    if (backend == Backend::Cpu ? !setup.cpu : setup.context == nullptr) continue;
    for (const char* formats : {"windpack", "exr", "exr,png,dds,windpack"}) {
      Result<BenchRow> row = bakeRow(setup, backend, formats);
      if (!row) return row.error();
      rows.push_back(std::move(*row));
    }
  }
  return rows;
}

}  // namespace windloom::cli
