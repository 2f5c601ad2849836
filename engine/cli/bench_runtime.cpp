#include "engine/bake/frame_writer.hpp"
#include "engine/cli/bench.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/cli/scratch_folder.hpp"
#include "engine/core/file.hpp"
#include "engine/core/hash.hpp"
#include "engine/runtime/windloom_runtime.hpp"

#include <cstring>
#include <functional>
#include <memory>

namespace windloom::cli {
namespace fs = std::filesystem;
namespace {

/// A pack as a bake writes it, filled with noise, in the scratch folder.
Result<fs::path> writePack(const ScratchFolder& scratch, std::string_view kind, int side, int frames) {
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {100, 100}, {side, side});
  header.frames = frames;
  header.last = frames - 1;
  header.loop = true;
  header.fastest = 20;
  Result<std::unique_ptr<FrameWriter>> writer = writerKindNamed(kind)->open(header, scratch.path);
  if (!writer) return writer.error();
  std::vector<glm::vec2> cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::uint32_t noise = pcgHash(static_cast<std::uint32_t>(i) + 7919u * static_cast<std::uint32_t>(frame));
      cells[i] = {10.0f * hashToUnit(noise), 10.0f * hashToUnit(pcgHash(noise))};
    }
    if (Status added = (*writer)->add(frame, cells); !added) return added.error();
  }
  Result<std::vector<BakedFile>> files = (*writer)->finish();
  if (!files) return files.error();
  return scratch.path / files->front().path;
}

constexpr int kBatch = 1000;

/// Places all over the field, a batch a moment.
std::vector<float> randomPlaces(int batches) {
  std::vector<float> places(static_cast<std::size_t>(batches) * kBatch * 2);
  std::uint32_t noise = 1;
  for (float& place : places) place = 100.0f * hashToUnit(noise = pcgHash(noise)) - 50.0f;
  return places;
}

/// What a game does: it asks for the wind at many places of a moment, and a sixtieth of a second later at others. The
/// pack loops, so a long pass walks through all of it. Nanoseconds a place.
struct Passes {
  static constexpr int kSets = 16;  ///< of places
  std::vector<float> places = randomPlaces(kSets);
  int batches = 0;
  std::vector<float> wind = std::vector<float>(kBatch * 2);
  double sum = 0;  ///< used, so that nothing is optimised away

  explicit Passes(int batchCount) : batches(batchCount) {}

  [[nodiscard]] const float* placesOf(int batch) const {
    return places.data() + static_cast<std::size_t>(batch % kSets) * kBatch * 2;
  }

  /// With `perMoment` batches at each moment: 1 finds nothing of the moment's frames in the cache.
  double run(int perMoment, const std::function<void(const float* at, double time)>& ask) {
    const double ms = wallMs([&] {
      for (int batch = 0; batch < batches; ++batch) {
        ask(placesOf(batch), batch / perMoment / 60.0);
        sum += static_cast<double>(wind[0]) + static_cast<double>(wind[2 * kBatch - 1]);
      }
    });
    return ms * 1e6 / batches / kBatch;
  }

  double single(const runtime::WindPack& pack, int perMoment) {
    return run(perMoment, [&](const float* at, double time) {
      for (int i = 0; i < kBatch; ++i) {
        const runtime::Velocity v = pack.sample(at[2 * i], at[2 * i + 1], time);
        wind[static_cast<std::size_t>(2 * i)] = v.x;
        wind[static_cast<std::size_t>(2 * i + 1)] = v.z;
      }
    });
  }

  double batched(const runtime::WindPack& pack, int perMoment) {
    return run(perMoment, [&](const float* at, double time) { pack.sampleMany(at, kBatch, time, wind.data()); });
  }
};

/// The least that loading could cost: fresh memory and one copy of the bytes.
double copyMs(const std::string& bytes) {
  std::unique_ptr<char[]> copy;
  return wallMs([&] {
    copy.reset(new char[bytes.size()]);
    std::memcpy(copy.get(), bytes.data(), bytes.size());
  });
}

Result<BenchRow> packRow(const BenchSetup& setup, std::string_view kind, int side, int frames, Passes& passes) {
  const ScratchFolder scratch;
  const Result<fs::path> path = writePack(scratch, kind, side, frames);
  if (!path) return path.error();
  const Result<std::string> bytes = readFile(*path, 1ull << 32);
  if (!bytes) return bytes.error();
  runtime::WindPack pack;
  const auto load = [&] {
    pack = {};
    return wallMs([&] { pack = runtime::WindPack::load(bytes->data(), bytes->size()); });
  };
  const auto loadFile = [&] {
    pack = {};
    return wallMs([&] { pack = runtime::WindPack::load(path->string()); });
  };
  const RunLimits loads{1, 3, 10, setup.capSeconds};
  const double first = loadFile();
  const double floor = measure(loads, [&] { return copyMs(*bytes); }).median;
  const double memory = measure(loads, load).median;
  const Measured file = measure(loads, loadFile);
  if (!pack) return makeError(ErrorKind::Machine, windloom_status_text(pack.status()));
  const RunLimits samples{1, 3, 20, setup.capSeconds / 4};
  const auto pass = [&](double (Passes::*ask)(const runtime::WindPack&, int), int perMoment) {
    return measure(samples, [&] { return (passes.*ask)(pack, perMoment); }).median;
  };
  return BenchRow{{"pack", std::to_string(side) + " x " + std::to_string(side)},
                  {"frames", frames},
                  {"cells", kind == "windpack" ? "half" : "float"},
                  {"MB", static_cast<double>(bytes->size()) / 1e6},
                  {"first load ms", first},
                  {"load ms", file.median},
                  {"from memory ms", memory},
                  {"floor: copy ms", floor},
                  {"ns a sample", pass(&Passes::single, Passes::kSets)},
                  {"ns a point in 1,000", pass(&Passes::batched, Passes::kSets)},
                  {"cold sample", pass(&Passes::single, 1)},
                  {"cold point in 1,000", pass(&Passes::batched, 1)},
                  {"runs", file.runs}};
}

}  // namespace

Result<std::vector<BenchRow>> benchRuntime(const BenchSetup& setup) {
  struct Case {
    std::string_view kind;
    int side, frames;
  };
  const bool quick = setup.size == BenchSize::Quick;
  const std::vector<Case> cases =
      quick ? std::vector<Case>{{"windpack", 32, 2}, {"windpack-f32", 32, 2}}
            : std::vector<Case>{
                  {"windpack", 256, 64}, {"windpack-f32", 256, 64}, {"windpack", 512, 64}, {"windpack", 1000, 16}};
  Passes passes(quick ? 2 : 1600);
  std::vector<BenchRow> rows;
  for (const Case& c : cases) {
    Result<BenchRow> row = packRow(setup, c.kind, c.side, c.frames, passes);
    if (!row) return row.error();
    rows.push_back(std::move(*row));
  }
  if (!(passes.sum > 0)) {
    return makeError(ErrorKind::Machine, "the samples of a pack of positive wind add up to nothing");
  }
  return rows;
}

}  // namespace windloom::cli
