#pragma once
// Live links of a name of their own, processes, and objects made by hand.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/bake/live_link.hpp"
#include "engine/runtime/live_format.h"
#include "engine/runtime/windloom_runtime.hpp"

namespace windloom {

using runtime::LiveField;

inline GridMapping gridOf(int width, int height) {
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
inline pid_t inAnotherProcess(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it goes with the test, however that ends
    ::_exit(work());
  }
  return child;
}

inline int statusOf(pid_t child) {
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

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

}  // namespace windloom
