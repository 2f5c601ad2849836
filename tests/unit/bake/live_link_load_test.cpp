// Writers and readers at work at the same time.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "tests/unit/bake/live_link_fixture.hpp"

namespace windloom {
namespace {

/// Width and height of field `number` of the test under load.
glm::ivec2 sizeOf(int number) {
  return {64 + number * 37 % 449, 64 + number * 53 % 449};
}

}  // namespace

/// A writer that never rests and two readers in another process: each field's cells all hold its number.
TEST_F(LiveLinkTest, NoFieldIsTornUnderLoad) {
  int stop[2], ready[2];
  ASSERT_EQ(::pipe(stop), 0);
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t writer = inAnotherProcess([&] {
    ::fcntl(stop[0], F_SETFL, O_NONBLOCK);
    const auto link = make();
    char byte = 0;
    for (int number = 1; ::read(stop[0], &byte, 1) != 1; ++number) {
      const glm::ivec2 size = sizeOf(number % 1000);
      publishStill(*link, number % 1000, size.x, size.y);
      if (number == 1 && ::write(ready[1], &byte, 1) != 1) return 1;
    }
    return 0;
  });
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  std::atomic<int> torn = 0, taken = 0;
  const auto readFields = [&] {
    LiveField live = LiveField::open(m_name);
    if (!live) return;
    std::vector<float> places, wind;
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
    while (std::chrono::steady_clock::now() < end) {
      if (live.update() != 1) continue;
      ++taken;
      const windloom_info info = live.info();
      const auto number = static_cast<float>(info.start);
      if (glm::ivec2(info.width, info.height) != sizeOf(static_cast<int>(number))) ++torn;
      // Every 5th cell of every row of a field that changes its size all the time.
      places.clear();
      for (int k = 0; k < info.height; ++k) {
        for (int i = k % 5; i < info.width; i += 5) {
          places.push_back(info.min_x + static_cast<float>(i) + 0.5f);
          places.push_back(info.min_z + static_cast<float>(k) + 0.5f);
        }
      }
      wind.resize(places.size());
      live.sampleMany(places.data(), places.size() / 2, wind.data());
      for (std::size_t n = 0; n < wind.size(); n += 2) {
        if (std::fabs(wind[n] - number) > 0.01f || wind[n + 1] != -1.0f) {
          ++torn;
          break;
        }
      }
    }
  };
  std::thread other(readFields);
  readFields();
  other.join();
  ASSERT_EQ(::write(stop[1], "x", 1), 1);
  EXPECT_EQ(statusOf(writer), 0);
  EXPECT_EQ(torn, 0);
  EXPECT_GT(taken, 20);
  for (const int end : {stop[0], stop[1], ready[0], ready[1]}) ::close(end);
}

/// A writer that overwrites one slot again and again, four fields at a time, which the ring is there to make rare.
TEST_F(LiveLinkTest, AReaderNoticesAFieldThatChangesUnderIt) {
  constexpr std::uint32_t kSide = 256, kOne = 0x3c003c00, kTwo = 0x40004000;
  HostileObject object(m_name);
  object.putField();
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  ASSERT_EQ(live.update(), 1);
  const pid_t writer = inAnotherProcess([&] {
    constexpr std::size_t slot = HostileObject::kSlot;
    Mapped memory(m_name);
    memory.at<std::uint32_t>(slot + WINDLIVE_AT_WIDTH) = kSide;
    memory.at<std::uint32_t>(slot + WINDLIVE_AT_HEIGHT) = kSide;
    for (std::uint64_t number = 5;; number += 4) {
      const bool one = number % 8 == 5;
      memory.at<std::uint64_t>(slot + WINDLIVE_AT_SEQUENCE) = 2 * number - 1;
      std::fill_n(memory.cells(slot), kSide * kSide, one ? kOne : kTwo);
      memory.at<double>(slot + WINDLIVE_AT_TIME) = one ? 1.0 : 2.0;
      memory.at<std::uint64_t>(slot + WINDLIVE_AT_SEQUENCE) = 2 * number;
      memory.at<std::uint64_t>(WINDLIVE_AT_NEWEST) = number;
      if (number % 64 == 5) ::usleep(300);
    }
    return 0;
  });
  int taken = 0, torn = 0;
  std::vector<float> places, wind;
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1000);
  while (std::chrono::steady_clock::now() < end) {
    if (live.update() != 1) continue;
    const windloom_info info = live.info();
    if (info.width != static_cast<int>(kSide)) continue;
    ++taken;
    places.clear();
    for (int n = 0; n < 256; ++n) {
      places.push_back(info.min_x + (static_cast<float>(n) + 0.5f) / 64.0f);
      places.push_back(info.min_z + (static_cast<float>(n) + 0.5f) / 64.0f);
    }
    wind.resize(places.size());
    live.sampleMany(places.data(), 256, wind.data());
    for (const float v : wind) torn += std::fabs(static_cast<double>(v) - info.start) > 0.01 ? 1 : 0;
  }
  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  EXPECT_EQ(torn, 0);
  EXPECT_GT(taken, 10);
}

/// A reader that looks at any slot, not just at the newest, so that it often meets one that is being written.
TEST_F(LiveLinkTest, TheWriterMarksASlotWhileItChanges) {
  constexpr int kSide = 256;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t writer = inAnotherProcess([&] {
    const auto link = make();
    for (int number = 1;; ++number) {
      publishStill(*link, number % 1000, kSide, kSide);
      if (number == 8 && ::write(ready[1], "x", 1) != 1) return 1;
    }
  });
  char told = 0;
  ASSERT_EQ(::read(ready[0], &told, 1), 1);
  Mapped memory(m_name);
  int whole = 0, marked = 0, torn = 0;
  std::vector<std::uint32_t> copy(kSide * kSide);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1000);
  for (std::size_t n = 0; std::chrono::steady_clock::now() < end; ++n) {
    const std::size_t slot = WINDLIVE_HEADER_BYTES + n % WINDLIVE_SLOTS * WINDLIVE_SLOT_BYTES;
    const auto sequence = memory.at<std::uint64_t>(slot + WINDLIVE_AT_SEQUENCE);
    const std::uint64_t before = sequence.load();
    if (before % 2 == 1) {
      ++marked;
      continue;
    }
    for (std::size_t i = 0; i < copy.size(); ++i) {
      copy[i] = std::atomic_ref<std::uint32_t>(memory.cells(slot)[i]).load(std::memory_order_relaxed);
    }
    std::atomic_thread_fence(std::memory_order_seq_cst);
    if (sequence.load() != before) {
      ++marked;
      continue;
    }
    ++whole;
    torn += std::count(copy.begin(), copy.end(), copy[0]) == static_cast<long>(copy.size()) ? 0 : 1;
  }
  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  ::shm_unlink(("/" + m_name).c_str());
  ::close(ready[0]);
  ::close(ready[1]);
  EXPECT_EQ(torn, 0);
  EXPECT_GT(whole, 10);
  EXPECT_GT(marked, 10) << "the reader never met the writer at work, so this showed nothing";
}

}  // namespace windloom
