#include "engine/bake/live_link.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <functional>
#include <random>
#include <thread>

#include "engine/runtime/live_format.h"
#include "engine/runtime/windloom_runtime.hpp"

namespace windloom {
namespace {

using runtime::LiveField;

GridMapping gridOf(int width, int height) {
  return makeGridMapping({0, 0}, {static_cast<float>(width), static_cast<float>(height)}, {width, height});
}

class LiveLinkTest : public testing::Test {
 protected:
  /// A name that no other test run has.
  std::string m_name = "windloom-test-" + std::to_string(::getpid());

  void publishStill(LiveLink& link, int number, int width = 16, int height = 9) {
    const std::vector<glm::vec2> cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                       glm::vec2(static_cast<float>(number), -1.0f));
    link.publish(gridOf(width, height), cells, number);
  }

  std::unique_ptr<LiveLink> make() {
    Result<std::unique_ptr<LiveLink>> link = LiveLink::create(m_name);
    EXPECT_TRUE(link) << link.error().text();
    return link ? std::move(*link) : nullptr;
  }
};

/// Runs `work` in a process of its own; its id.
pid_t inAnotherProcess(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it goes with the test, however that ends
    ::_exit(work());
  }
  return child;
}

int statusOf(pid_t child) {
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// Width and height of field `number` of the test under load.
glm::ivec2 sizeOf(int number) {
  return {64 + number * 37 % 449, 64 + number * 53 % 449};
}

}  // namespace

TEST_F(LiveLinkTest, ShowsAGameTheFieldOfTheEditor) {
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
  const auto link = make();
  ASSERT_NE(link, nullptr);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live) << windloom_status_text(live.status());
  EXPECT_EQ(live.update(), 0);
  EXPECT_EQ(live.info().width, 0);
  EXPECT_EQ(live.sample(1, 1).x, 0.0f) << "calm before the first field";
  std::vector<glm::vec2> cells;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 6; ++i) cells.emplace_back(static_cast<float>(i) * 0.5f, static_cast<float>(-k) * 0.25f);
  }
  const GridMapping grid = makeGridMapping({5, -2}, {12, 8}, {6, 4});
  link->publish(grid, cells, 3.25, {.periodicX = true});
  EXPECT_EQ(live.update(), 1);
  EXPECT_EQ(live.update(), 0);
  const windloom_info info = live.info();
  EXPECT_EQ(info.width, 6);
  EXPECT_EQ(info.height, 4);
  EXPECT_EQ(info.frames, 1);
  EXPECT_EQ(info.fps, 0.0f);
  EXPECT_EQ(info.start, 3.25);
  EXPECT_EQ(info.min_x, -1.0f);
  EXPECT_EQ(info.max_z, 2.0f);
  EXPECT_FLOAT_EQ(info.max_speed, std::hypot(2.5f, 0.75f));
  EXPECT_EQ(info.edge_x, WINDLOOM_WRAP);
  EXPECT_EQ(info.edge_z, WINDLOOM_CLAMP);
  EXPECT_FLOAT_EQ(live.sample(2, -5).x, 0.5f);
  EXPECT_FLOAT_EQ(live.sample(2, 1).z, -0.75f);
  const float places[] = {2, -5, 4, 1};
  float wind[4];
  live.sampleMany(places, 2, wind);
  EXPECT_FLOAT_EQ(wind[0], 0.5f);
  EXPECT_FLOAT_EQ(wind[2], 1.0f);
}

TEST_F(LiveLinkTest, AveragesLargeFieldsDown) {
  const auto link = make();
  ASSERT_NE(link, nullptr);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  std::vector<glm::vec2> cells(std::size_t{1024} * 300);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = {i % 2 == 0 ? 1.0f : 3.0f, static_cast<float>(i / 1024)};
  link->publish(gridOf(1024, 300), cells, 1);
  ASSERT_EQ(live.update(), 1);
  EXPECT_EQ(live.info().width, LiveLink::kMaxSide);
  EXPECT_EQ(live.info().height, 300);
  EXPECT_FLOAT_EQ(live.info().max_x, 512.0f);
  EXPECT_FLOAT_EQ(live.sample(100.3f, 0).x, 2.0f) << "two columns make one";
  EXPECT_FLOAT_EQ(live.sample(0, -149.5f).z, 0.0f);
  EXPECT_FLOAT_EQ(live.sample(0, 149.5f).z, 299.0f);
}

TEST_F(LiveLinkTest, TellsTheEndAndKeepsTheLastField) {
  auto link = make();
  ASSERT_NE(link, nullptr);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  publishStill(*link, 7);
  link.reset();
  EXPECT_EQ(live.update(), 1) << "the last field comes before the end";
  EXPECT_EQ(live.update(), -1);
  EXPECT_EQ(live.update(), -1);
  EXPECT_EQ(live.sample(0, 0).x, 7.0f);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
}

TEST_F(LiveLinkTest, RefusesASecondWriter) {
  const auto link = make();
  ASSERT_NE(link, nullptr);
  const auto refusal = [this] {
    const Result<std::unique_ptr<LiveLink>> second = LiveLink::create(m_name);
    return !second && second.error().kind == ErrorKind::Machine &&
           second.error().text().find("another program") != std::string::npos;
  };
  EXPECT_TRUE(refusal());
  EXPECT_EQ(statusOf(inAnotherProcess([&] { return refusal() ? 0 : 1; })), 0);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live) << "the refused one did no harm";
  publishStill(*link, 3);
  EXPECT_EQ(live.update(), 1);
}

TEST_F(LiveLinkTest, RefusesNamesThatAreNone) {
  for (const std::string& name : {std::string(), std::string("a/b"), std::string(65, 'x'), std::string("a\0b", 3)}) {
    const auto link = LiveLink::create(name);
    ASSERT_FALSE(link);
    EXPECT_EQ(link.error().kind, ErrorKind::BadInput);
    EXPECT_FALSE(LiveField::open(name));
  }
}

TEST_F(LiveLinkTest, TakesOverFromAWriterThatWasKilled) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t writer = inAnotherProcess([&] {
    const auto link = make();
    publishStill(*link, 5);
    const char told = 'x';
    if (::write(ready[1], &told, 1) != 1) return 1;
    for (;;) ::pause();
  });
  char told = 0;
  ASSERT_EQ(::read(ready[0], &told, 1), 1);
  LiveField old = LiveField::open(m_name);
  ASSERT_TRUE(old);
  EXPECT_EQ(old.update(), 1);
  EXPECT_EQ(old.update(), 0);
  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  EXPECT_EQ(old.update(), -1);
  EXPECT_EQ(old.sample(0, 0).x, 5.0f);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD) << "a stale object is no link";

  const auto link = make();
  ASSERT_NE(link, nullptr);
  publishStill(*link, 6);
  EXPECT_EQ(old.update(), -1) << "a link once ended stays so";
  LiveField fresh = LiveField::open(m_name);
  ASSERT_TRUE(fresh);
  EXPECT_EQ(fresh.update(), 1);
  EXPECT_EQ(fresh.sample(0, 0).x, 6.0f);
  ::close(ready[0]);
  ::close(ready[1]);
}

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

namespace {

/// An object that somebody made who means harm, with the writer's lock.
class HostileObject {
 public:
  explicit HostileObject(const std::string& name) : m_path("/" + name) {
    m_object = ::shm_open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600);
    EXPECT_EQ(::flock(m_object, LOCK_EX | LOCK_NB), 0);
    EXPECT_EQ(::ftruncate(m_object, WINDLIVE_BYTES), 0);
    write(0, "WINDLIVE");
    const std::uint32_t numbers[] = {WINDLIVE_VERSION, WINDLIVE_SLOTS, WINDLIVE_SLOT_BYTES, 0};
    EXPECT_EQ(::pwrite(m_object, numbers, sizeof numbers, WINDLIVE_AT_VERSION), 16);
  }
  ~HostileObject() {
    ::shm_unlink(m_path.c_str());
    ::close(m_object);
  }
  HostileObject(const HostileObject&) = delete;
  HostileObject& operator=(const HostileObject&) = delete;

  void write(off_t at, const std::string& bytes) {
    EXPECT_EQ(::pwrite(m_object, bytes.data(), bytes.size(), at), static_cast<ssize_t>(bytes.size()));
  }
  template <class Number>
  void put(std::size_t at, Number value) {
    EXPECT_EQ(::pwrite(m_object, &value, sizeof value, static_cast<off_t>(at)), static_cast<ssize_t>(sizeof value));
  }
  void cut(off_t size) { EXPECT_EQ(::ftruncate(m_object, size), 0); }

  static constexpr std::size_t kSlot = WINDLIVE_HEADER_BYTES + WINDLIVE_SLOT_BYTES;  ///< of field 1

  /// A small good field 1.
  void putField() {
    put(kSlot + WINDLIVE_AT_WIDTH, std::uint32_t{4});
    put(kSlot + WINDLIVE_AT_HEIGHT, std::uint32_t{4});
    put(kSlot + WINDLIVE_AT_MIN_X, 0.0f);
    put(kSlot + WINDLIVE_AT_MIN_Z, 0.0f);
    put(kSlot + WINDLIVE_AT_MAX_X, 4.0f);
    put(kSlot + WINDLIVE_AT_MAX_Z, 4.0f);
    put(kSlot + WINDLIVE_AT_MAX_SPEED, 9.0f);
    put(kSlot + WINDLIVE_AT_FLAGS, std::uint32_t{0});
    put(kSlot + WINDLIVE_AT_TIME, 1.0);
    put(kSlot + WINDLIVE_AT_SEQUENCE, std::uint64_t{2});
    put(WINDLIVE_AT_NEWEST, std::uint64_t{1});
  }

 private:
  std::string m_path;
  int m_object = -1;
};

}  // namespace

namespace {

/// A shared memory object as bytes of this process.
class Mapped {
 public:
  explicit Mapped(const std::string& name) {
    const int object = ::shm_open(("/" + name).c_str(), O_RDWR, 0);
    m_bytes = static_cast<std::byte*>(::mmap(nullptr, WINDLIVE_BYTES, PROT_READ | PROT_WRITE, MAP_SHARED, object, 0));
    ::close(object);
  }
  ~Mapped() { ::munmap(m_bytes, WINDLIVE_BYTES); }
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;

  template <class Number>
  std::atomic_ref<Number> at(std::size_t offset) {
    return std::atomic_ref<Number>(*reinterpret_cast<Number*>(m_bytes + offset));
  }
  std::uint32_t* cells(std::size_t slot) {
    return reinterpret_cast<std::uint32_t*>(m_bytes + slot + WINDLIVE_SLOT_HEADER_BYTES);
  }

 private:
  std::byte* m_bytes = nullptr;
};

}  // namespace

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

TEST_F(LiveLinkTest, RefusesObjectsOfAnotherKind) {
  HostileObject object(m_name);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_OK);
  object.put(WINDLIVE_AT_VERSION, WINDLIVE_VERSION + 1);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NEWER_VERSION);
  object.put(WINDLIVE_AT_VERSION, WINDLIVE_VERSION);
  object.put(WINDLIVE_AT_SLOTS, 0u);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_DAMAGED);
  object.put(WINDLIVE_AT_SLOTS, WINDLIVE_SLOTS);
  object.put(WINDLIVE_AT_SLOT_BYTES, 0xffffffffu);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_DAMAGED);
  object.put(WINDLIVE_AT_SLOT_BYTES, WINDLIVE_SLOT_BYTES);
  object.cut(WINDLIVE_BYTES - 1);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_DAMAGED);
  object.cut(10);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
  object.cut(WINDLIVE_BYTES);
  object.write(0, "SOMEBODY");
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
}

TEST_F(LiveLinkTest, TakesNoFieldThatMakesNoSense) {
  HostileObject object(m_name);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  constexpr std::size_t slot = HostileObject::kSlot;
  const std::vector<std::function<void()>> harm = {
      [&] { object.put(slot + WINDLIVE_AT_WIDTH, 513u); },
      [&] { object.put(slot + WINDLIVE_AT_WIDTH, 0u); },
      [&] { object.put(slot + WINDLIVE_AT_HEIGHT, 0x80000004u); },
      [&] { object.put(slot + WINDLIVE_AT_MAX_X, 0.0f); },
      [&] { object.put(slot + WINDLIVE_AT_MIN_Z, std::nanf("")); },
      [&] { object.put(slot + WINDLIVE_AT_MAX_SPEED, -1.0f); },
      [&] { object.put(slot + WINDLIVE_AT_TIME, HUGE_VAL); },
      [&] { object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, 0x7c00u); },
      [&] { object.put(slot + WINDLIVE_AT_SEQUENCE, std::uint64_t{1}); },
      [&] { object.put(slot + WINDLIVE_AT_SEQUENCE, std::uint64_t{10}); },
  };
  for (std::size_t n = 0; n < harm.size(); ++n) {
    object.putField();
    object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, 0u);
    harm[n]();
    EXPECT_EQ(live.update(), 0) << n;
    EXPECT_EQ(live.info().width, 0) << n;
  }
  object.putField();
  object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, 0u);
  EXPECT_EQ(live.update(), 1);
}

TEST_F(LiveLinkTest, SurvivesAnObjectThatIsCutShort) {
  HostileObject object(m_name);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  object.putField();
  ASSERT_EQ(live.update(), 1);
  object.put(WINDLIVE_AT_NEWEST, std::uint64_t{2});
  object.cut(static_cast<off_t>(WINDLIVE_HEADER_BYTES));
  EXPECT_EQ(live.update(), 0) << "the field's bytes are gone";
  object.cut(0);
  EXPECT_EQ(live.update(), -1);
  EXPECT_EQ(live.sample(1, 1).x, 0.0f);
}

TEST_F(LiveLinkTest, SurvivesRandomBytes) {
  HostileObject object(m_name);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  std::mt19937 random(11);
  int taken = 0;
  for (int n = 0; n < 20000; ++n) {
    object.putField();
    for (unsigned changes = random() % 3; changes > 0; --changes) {
      object.put(HostileObject::kSlot + 8 + random() % 60, static_cast<unsigned char>(random()));
    }
    // Newest goes up and down, so that each field counts as new.
    object.put(WINDLIVE_AT_NEWEST, std::uint64_t{n % 2 == 0 ? 1u : 5u});
    object.put(HostileObject::kSlot + WINDLIVE_AT_SEQUENCE, std::uint64_t{n % 2 == 0 ? 2u : 10u});
    taken += live.update() == 1 ? 1 : 0;
    const runtime::Velocity v = live.sample(1.3f, 2.7f);
    ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.z)) << n;
  }
  EXPECT_GT(taken, 1000);
}

}  // namespace windloom
