#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/temporary_folder.hpp"
#include "tests/unit/runtime/pack_bytes.hpp"

namespace windloom::runtime {
namespace {

/// A pack whose every cell holds one number.
std::string still(std::uint16_t half) {
  PackBytes bytes;
  bytes.width = bytes.height = 32;
  bytes.halves.assign(32 * 32 * 2, half);
  return bytes.build();
}

class Follow : public testing::Test {
 protected:
  void write(const std::string& bytes) { std::ofstream(m_path, std::ios::binary) << bytes; }
  /// As an export does: a new file under the old name.
  void replace(const std::string& bytes) {
    const std::filesystem::path fresh = m_folder.path() / "fresh";
    std::ofstream(fresh, std::ios::binary) << bytes;
    std::filesystem::rename(fresh, m_path);
  }
  TemporaryFolder m_folder;
  std::filesystem::path m_path = m_folder.path() / "wind.windpack";
};

float windOf(const FollowedPack& followed) {
  return followed.pack().sample(1.0f, 1.0f, 0).x;
}

}  // namespace

TEST_F(Follow, WaitsForAFileThatComesLater) {
  FollowedPack followed(m_path.string());
  EXPECT_EQ(followed.poll(), 0);
  EXPECT_FALSE(followed.pack());
  EXPECT_EQ(followed.status(), WINDLOOM_CANNOT_READ);
  replace(still(kOne));
  EXPECT_EQ(followed.poll(), 1);
  EXPECT_EQ(followed.status(), WINDLOOM_OK);
  EXPECT_EQ(windOf(followed), 1.0f);
  EXPECT_EQ(followed.poll(), 0);
}

TEST_F(Follow, TakesEveryReplacement) {
  replace(still(kOne));
  FollowedPack followed(m_path.string());
  EXPECT_EQ(followed.poll(), 1);
  for (const auto& [half, value] : {std::pair{kTwo, 2.0f}, std::pair{kFour, 4.0f}, std::pair{kOne, 1.0f}}) {
    replace(still(half));
    EXPECT_EQ(followed.poll(), 1);
    EXPECT_EQ(windOf(followed), value);
    EXPECT_EQ(followed.poll(), 0);
  }
}

TEST_F(Follow, KeepsTheOldPackWhereTheNewOneIsBroken) {
  replace(still(kTwo));
  FollowedPack followed(m_path.string());
  EXPECT_EQ(followed.poll(), 1);
  replace(still(kFour).substr(0, 1000));
  EXPECT_EQ(followed.poll(), -1);
  EXPECT_EQ(followed.status(), WINDLOOM_CUT_SHORT);
  EXPECT_EQ(windOf(followed), 2.0f);
  EXPECT_EQ(followed.poll(), 0) << "told once";
  replace("no pack at all");
  EXPECT_EQ(followed.poll(), -1);
  EXPECT_EQ(followed.status(), WINDLOOM_NOT_A_PACK);
  std::filesystem::remove(m_path);
  EXPECT_EQ(followed.poll(), -1);
  EXPECT_EQ(followed.status(), WINDLOOM_CANNOT_READ);
  EXPECT_EQ(followed.poll(), 0);
  EXPECT_EQ(windOf(followed), 2.0f);
  replace(still(kEight));
  EXPECT_EQ(followed.poll(), 1);
  EXPECT_EQ(windOf(followed), 8.0f);
}

TEST_F(Follow, TakesAFileThatIsWrittenInPlaceOnceItIsWhole) {
  const std::string bytes = still(kFour);
  write(bytes.substr(0, bytes.size() / 2));
  FollowedPack followed(m_path.string());
  EXPECT_EQ(followed.poll(), -1);
  // The same size and, by a coarse clock, the same time: only trying again finds it.
  std::string damaged = bytes;
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  write(damaged);
  const auto time = std::filesystem::last_write_time(m_path);
  EXPECT_EQ(followed.poll(), -1);
  EXPECT_EQ(followed.status(), WINDLOOM_DAMAGED);
  write(bytes);
  std::filesystem::last_write_time(m_path, time);
  EXPECT_EQ(followed.poll(), 1);
  EXPECT_EQ(windOf(followed), 4.0f);
}

TEST_F(Follow, DoesNotOpenWhatIsNoFile) {
  FollowedPack followed(m_folder.path().string());
  EXPECT_EQ(followed.poll(), 0);
  EXPECT_FALSE(followed.pack());
  windloom_follow* none = windloom_follow_open(nullptr);
  ASSERT_NE(none, nullptr);
  EXPECT_EQ(windloom_follow_poll(none), 0);
  EXPECT_EQ(windloom_follow_pack(none), nullptr);
  windloom_follow_close(none);
}

TEST_F(Follow, ThreadsSampleWhileFilesAreReplaced) {
  const std::uint16_t halves[] = {kOne, kTwo, kFour, kEight};
  replace(still(kOne));
  windloom_follow* follow = windloom_follow_open(m_path.c_str());
  ASSERT_NE(follow, nullptr);
  ASSERT_EQ(windloom_follow_poll(follow), 1);
  constexpr int kThreads = 3;
  std::atomic<bool> stop = false;
  std::atomic<long> rounds[kThreads] = {};
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) {
    threads.emplace_back([&, t] {
      std::vector<float> places(64, 1.0f), wind(64);
      while (!stop) {
        const windloom_pack* pack = windloom_follow_pack(follow);
        windloom_sample_many(pack, places.data(), 32, 0.0, wind.data());
        for (const float v : wind) {
          if (v != wind[0] || (v != 1.0f && v != 2.0f && v != 4.0f && v != 8.0f)) ++wrong;
        }
        ++rounds[t];
      }
    });
  }
  int changes = 0;
  for (int n = 0; n < 30; ++n) {
    // The contract: a replaced pack lives until the next change, so every thread must have asked again by then.
    for (auto& round : rounds) {
      const long before = round;
      while (round < before + 2) std::this_thread::yield();
    }
    replace(still(halves[n % 4]));
    changes += windloom_follow_poll(follow);
  }
  stop = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(changes, 30);
  EXPECT_EQ(wrong, 0);
  windloom_follow_close(follow);
}

}  // namespace windloom::runtime
