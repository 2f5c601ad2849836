// libFuzzer target: loads whatever it is given as a wind pack, from memory and as a file, and samples what loads. Each
// input is tried twice, the second time with its checksum put right, which no mutation would find.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "engine/runtime/checksum.h"
#include "engine/runtime/windloom_runtime.h"

extern "C" {
#include "engine/runtime/pack.h"
}

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "broken: %s\n", what);
  std::abort();
}

/// But for products of weights so small that a float holds them with few digits.
bool same(float a, float b) {
  return a == b || (std::isnan(a) && std::isnan(b)) || std::fabs(a - b) < 1e-30f;
}

void sampleAll(windloom_pack* pack) {
  const windloom_info info = windloom_get_info(pack);
  require(info.width > 0 && info.height > 0 && info.frames > 0, "a pack has cells");
  const float wide = info.max_x - info.min_x, deep = info.max_z - info.min_z;
  float places[2 * 19], winds[2 * 19];
  for (int n = 0; n < 19; ++n) {
    places[2 * n] = info.min_x + wide * (0.1f * static_cast<float>(n) - 0.4f);
    places[2 * n + 1] = info.min_z + deep * (1.4f - 0.1f * static_cast<float>(n));
  }
  places[0] = 1e38f;
  for (const windloom_edge edge : {WINDLOOM_CLAMP, WINDLOOM_WRAP}) {
    windloom_set_edges(pack, edge, edge);
    for (const double time : {0.0, 0.77, -1e9, 1e300}) {
      windloom_sample_many(pack, places, 19, time, winds);
      for (int n = 0; n < 19; ++n) {
        float wind[2];
        windloom_sample(pack, places[2 * n], places[2 * n + 1], time, wind);
        require(same(wind[0], winds[2 * n]) && same(wind[1], winds[2 * n + 1]),
                "batches give what single samples give");
      }
    }
  }
  const float factor = windloom_height_factor(pack, 1.5f);
  require(factor >= 0.0f && factor < 1e9f, "the height factor is a number");
}

/// The bytes end exactly where their memory does.
void tryBytes(const std::uint8_t* bytes, std::size_t size) {
  const std::unique_ptr<std::uint8_t[]> exact(new std::uint8_t[size]);
  std::memcpy(exact.get(), bytes, size);
  windloom_status status = WINDLOOM_OK;
  windloom_pack* pack = windloom_load_memory(exact.get(), size, &status);
  require((pack != nullptr) == (status == WINDLOOM_OK), "a pack or a reason");
  require(windloom_status_text(status) != nullptr, "the reason has a text");
  if (pack != nullptr) sampleAll(pack);
  windloom_free(pack);

  if (size == 0) return;
  std::FILE* file = fmemopen(exact.get(), size, "rb");
  windloom_status fromFile = WINDLOOM_OK;
  windloom_free(windloom_load_stream(file, &fromFile));
  std::fclose(file);
  require(fromFile == status, "a file gives what memory gives");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  tryBytes(data, size);
  if (size < 4) return 0;
  std::vector<std::uint8_t> right(data, data + size);
  const std::uint32_t checksum = windloom_checksum(0, right.data(), size - 4);
  std::memcpy(right.data() + size - 4, &checksum, 4);
  tryBytes(right.data(), size);
  return 0;
}
