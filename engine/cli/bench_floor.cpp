// The floor under all other numbers: no pass over the field can be faster than its bytes at this bandwidth, and no
// chain of passes faster than this many dispatches.

#include <epoxy/gl.h>

#include <cstring>

#include "engine/cli/bench.hpp"
#include "engine/cli/bench_timing.hpp"
#include "engine/core/thread_pool.hpp"
#include "engine/gpu/buffer.hpp"

namespace windloom::cli {
namespace {

constexpr gpu::ProgramSpec kCopy{"bench/copy", {"bench/copy.comp"}};
constexpr gpu::ProgramSpec kEmpty{"bench/empty", {"bench/empty.comp"}};

BenchRow row(const char* where, const char* what, std::uint64_t bytes, double value, const char* unit, int runs) {
  return {{"where", where}, {"what", what}, {"MiB", bytes >> 20}, {"value", value}, {"unit", unit}, {"runs", runs}};
}

/// Bytes read and written per nanosecond.
double gigabytesPerSecond(std::uint64_t bytes, double ms) {
  return 2.0 * static_cast<double>(bytes) / (ms * 1e6);
}

BenchRow cpuCopy(const BenchSetup& setup, std::uint64_t bytes) {
  ThreadPool pool;
  std::vector<char> source(bytes, 1), target(bytes, 2);
  constexpr int kChunks = 64;
  const std::size_t size = bytes / kChunks;
  const auto once = [&] {
    return wallMs([&] {
      pool.parallelFor(kChunks, [&](int chunk) {
        const std::size_t at = static_cast<std::size_t>(chunk) * size;
        std::memcpy(target.data() + at, source.data() + at, size);
      });
    });
  };
  const Measured m = measure({3, 5, 30, setup.capSeconds}, once);
  return row("cpu", "copy", bytes, gigabytesPerSecond(bytes, m.median), "GB/s", m.runs);
}

Result<BenchRow> gpuCopy(const BenchSetup& setup, std::uint64_t bytes) {
  Result<gpu::Buffer> source = gpu::Buffer::create("bench source", bytes, gpu::BufferUse::Static);
  Result<gpu::Buffer> target = gpu::Buffer::create("bench target", bytes, gpu::BufferUse::Static);
  Result<gpu::Program*> program = setup.shaders->load(kCopy);
  if (!source) return source.error();
  if (!target) return target.error();
  if (!program) return program.error();
  constexpr int kCopies = 20;
  const auto once = [&] {
    return gpuMs([&] {
      (*program)->use();
      source->bindStorage(0);
      target->bindStorage(1);
      for (int i = 0; i < kCopies; ++i) {
        glDispatchCompute(static_cast<GLuint>(bytes / sizeof(float[4]) / 256), 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // each copy reads and writes what the last one did
      }
    });
  };
  const Measured m = measure({2, 5, 20, setup.capSeconds}, once);
  return row("gpu", "copy", bytes, gigabytesPerSecond(bytes, m.median / kCopies), "GB/s", m.runs);
}

Result<BenchRow> gpuEmptyDispatch(const BenchSetup& setup) {
  Result<gpu::Buffer> counter = gpu::Buffer::create("bench counter", 16, gpu::BufferUse::Static);
  Result<gpu::Program*> program = setup.shaders->load(kEmpty);
  if (!counter) return counter.error();
  if (!program) return program.error();
  constexpr int kDispatches = 500;
  const auto once = [&] {
    return gpuMs([&] {
      (*program)->use();
      counter->bindStorage(0);
      for (int i = 0; i < kDispatches; ++i) {
        glDispatchCompute(1, 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // each dispatch adds to what the last one wrote
      }
    });
  };
  const Measured m = measure({2, 5, 20, setup.capSeconds}, once);
  return row("gpu", "empty dispatch and barrier", 0, m.median / kDispatches * 1e3, "us", m.runs);
}

}  // namespace

Result<std::vector<BenchRow>> benchFloor(const BenchSetup& setup) {
  const bool quick = setup.size == BenchSize::Quick;
  const std::vector<std::uint64_t> sizes =
      quick ? std::vector<std::uint64_t>{1u << 20} : std::vector<std::uint64_t>{8u << 20, 256u << 20};
  std::vector<BenchRow> rows;
  for (const std::uint64_t bytes : sizes) {
    if (setup.cpu) rows.push_back(cpuCopy(setup, bytes));
    if (setup.context == nullptr) continue;
    Result<BenchRow> copied = gpuCopy(setup, bytes);
    if (!copied) return copied.error();
    rows.push_back(std::move(*copied));
  }
  if (setup.context != nullptr) {
    Result<BenchRow> empty = gpuEmptyDispatch(setup);
    if (!empty) return empty.error();
    rows.push_back(std::move(*empty));
  }
  return rows;
}

}  // namespace windloom::cli
