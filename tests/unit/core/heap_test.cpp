#include "engine/core/heap.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace windloom {
namespace {

TEST(Heap, TellsWhatIsHeldAndWhatWasGivenBack) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "the sanitizer's own allocator stands in place of the C library's";
#endif
  constexpr std::size_t kBlocks = 1000, kBytes = 10'000;
  const std::size_t before = heapBytesInUse();
  std::vector<std::vector<char>> blocks(kBlocks, std::vector<char>(kBytes, 'x'));
  EXPECT_GE(heapBytesInUse(), before + kBlocks * kBytes);
  blocks.clear();
  giveHeapBack();
  EXPECT_LT(heapBytesInUse(), before + kBlocks * kBytes / 10);
}

}  // namespace
}  // namespace windloom
