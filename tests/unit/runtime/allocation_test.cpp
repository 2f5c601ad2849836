// The linker gives the library these in place of the C library's functions (--wrap in CMakeLists.txt).

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <vector>

#include "tests/temporary_folder.hpp"
#include "tests/unit/runtime/pack_bytes.hpp"

namespace {
std::atomic<long> allocations = 0;
}

extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);

void* __wrap_malloc(std::size_t size) {
  ++allocations;
  return __real_malloc(size);
}
void* __wrap_calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __real_calloc(count, size);
}
void* __wrap_realloc(void* memory, std::size_t size) {
  ++allocations;
  return __real_realloc(memory, size);
}
}

namespace windloom::runtime {

TEST(Memory, IsTakenByLoadingAlone) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "wind.windpack").string();
  std::ofstream(path, std::ios::binary) << twoByTwo().build();
  std::vector<float> places(2000, 1.0f), wind(2000);
  const long before = allocations;
  WindPack pack = WindPack::load(path);
  FollowedPack followed(path);
  ASSERT_EQ(followed.poll(), 1);
  EXPECT_GE(allocations - before, 4) << "the counting works";
  const long loaded = allocations;
  for (int n = 0; n < 10; ++n) {
    pack.sample(1.0f, 2.0f, 0.1 * n);
    pack.sampleMany(places.data(), 1000, 0.1 * n, wind.data());
    pack.heightFactor(1.0f);
    pack.setEdges(WINDLOOM_WRAP, WINDLOOM_CLAMP);
    EXPECT_EQ(followed.poll(), 0);
    followed.pack().sample(1.0f, 1.0f, 0);
  }
  EXPECT_EQ(allocations, loaded);
}

}  // namespace windloom::runtime
