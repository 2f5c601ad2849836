#include "engine/core/thread_pool.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace windloom {

TEST(ThreadPool, RunsEveryChunkOnce) {
  for (int threads : {1, 2, 7}) {
    ThreadPool pool(threads);
    EXPECT_EQ(pool.threads(), threads);
    for (int round = 0; round < 200; ++round) {
      std::vector<std::atomic<int>> hits(static_cast<std::size_t>(round));
      pool.parallelFor(round, [&](int chunk) { ++hits[static_cast<std::size_t>(chunk)]; });
      for (const auto& hit : hits) ASSERT_EQ(hit.load(), 1);
    }
  }
}

}  // namespace windloom
