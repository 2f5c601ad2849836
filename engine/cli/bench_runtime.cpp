#include "engine/bake/frame_writer.hpp"
#include "engine/cli/bench.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/cli/scratch_folder.hpp"
#include "engine/core/file.hpp"
#include "engine/core/hash.hpp"
#include "engine/runtime/windloom_runtime.hpp"

namespace windloom::cli {
namespace {

/// A pack as a bake writes it, filled with noise.
Result<std::string> packBytes(int side, int frames) {
  const ScratchFolder scratch;
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {100, 100}, {side, side});
  header.frames = frames;
  header.loop = true;
  header.fastest = 20;
  Result<std::unique_ptr<FrameWriter>> writer = writerKindNamed("windpack")->open(header, scratch.path);
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
  return readFile(scratch.path / files->front().path, 1ull << 32);
}

/// Nanoseconds a sample at places all over the field.
double samplePass(const runtime::WindPack& pack, int samples, float& sum) {
  const double ms = wallMs([&] {
    for (int i = 0; i < samples; ++i) {
      const std::uint32_t noise = pcgHash(static_cast<std::uint32_t>(i));
      const runtime::Velocity v = pack.sample(100.0f * hashToUnit(noise) - 50.0f,
                                              100.0f * hashToUnit(pcgHash(noise)) - 50.0f, 0.016 + i * 1e-7);
      sum += v.x + v.z;
    }
  });
  return ms * 1e6 / samples;
}

}  // namespace

Result<std::vector<BenchRow>> benchRuntime(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  std::vector<BenchRow> rows;
  float sum = 0;
  for (const int side : quick ? std::vector<int>{32} : std::vector<int>{256, 512, 1000}) {
    const int frames = quick ? 2 : 16;
    const Result<std::string> bytes = packBytes(side, frames);
    if (!bytes) return bytes.error();
    runtime::WindPack pack;
    const Measured load = measure({1, 3, 10, setup.capSeconds}, [&] {
      return wallMs([&] { pack = runtime::WindPack::load(bytes->data(), bytes->size()); });
    });
    if (!pack) return makeError(ErrorKind::Machine, windloom_status_text(pack.status()));
    const Measured sample =
        measure({1, 3, 20, setup.capSeconds}, [&] { return samplePass(pack, quick ? 1000 : 1'000'000, sum); });
    rows.push_back({{"pack", std::to_string(side) + " x " + std::to_string(side)},
                    {"frames", frames},
                    {"MB", static_cast<double>(bytes->size()) / 1e6},
                    {"load ms", load.median},
                    {"ns a sample", sample.median},
                    {"runs", sample.runs}});
  }
  // The sum is used, so that no sample is optimised away.
  if (!(sum > 0)) return makeError(ErrorKind::Machine, "the samples of a pack of positive wind add up to nothing");
  return rows;
}

}  // namespace windloom::cli
