#include "engine/bake/live_link.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <thread>
#include <utility>

#include "engine/bake/half.hpp"
#include "engine/runtime/live_format.h"
#include "engine/runtime/windpack_format.h"

namespace windloom {
namespace {

static_assert(LiveLink::kMaxSide == static_cast<int>(WINDLIVE_MAX_SIDE));

/// Readers and other starting writers hold the lock of a left object for a moment, too.
constexpr int kAttempts = 20;
constexpr auto kMoment = std::chrono::milliseconds(2);

/// A file descriptor that closes.
struct Descriptor {
  int number = -1;
  explicit Descriptor(int n) : number(n) {}
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int release() { return std::exchange(number, -1); }
};

/// The lock of an object that still has its name.
bool lock(int object) {
  struct stat found {};
  return ::flock(object, LOCK_EX | LOCK_NB) == 0 && ::fstat(object, &found) == 0 && found.st_nlink > 0;
}

/// Tells who still reads an object that its writer is gone, and takes its name.
void retire(int object, const std::string& path) {
  struct stat found {};
  const std::uint32_t ended = 1;
  if (::fstat(object, &found) == 0 && found.st_size >= static_cast<off_t>(WINDLIVE_HEADER_BYTES)) {
    // Whether this succeeds doesn't matter: readers notice the missing lock as well.
    [[maybe_unused]] const auto written = ::pwrite(object, &ended, sizeof ended, WINDLIVE_AT_ENDED);
  }
  ::shm_unlink(path.c_str());
}

Error failure(const std::string& path, const std::string& what, int code) {
  return makeError(ErrorKind::Machine, "the live link " + path + " can't be made: " + what + std::strerror(code));
}

/// A new locked object of that name, empty yet.
Result<int> makeObject(const std::string& path) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (attempt > 0) std::this_thread::sleep_for(kMoment);
    Descriptor fresh(::shm_open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
    if (fresh.number >= 0) {
      if (lock(fresh.number)) return fresh.release();
      continue;
    }
    if (errno != EEXIST) return failure(path, "", errno);
    const Descriptor old(::shm_open(path.c_str(), O_RDWR | O_CLOEXEC, 0));
    if (old.number >= 0) {
      if (lock(old.number)) retire(old.number, path);
    } else if (errno != ENOENT) {
      return failure(path, "", errno);
    }
  }
  return makeError(ErrorKind::Machine, "another program already shares its wind under the name '" + path.substr(1) +
                                           "'; end its live link or choose another name");
}

template <class Number>
void put(std::byte* at, Number value) {
  std::memcpy(at, &value, sizeof value);
}

template <class Number>
std::atomic_ref<Number> atom(std::byte* at) {
  return std::atomic_ref<Number>(*reinterpret_cast<Number*>(at));
}

}  // namespace

Result<std::unique_ptr<LiveLink>> LiveLink::create(const std::string& name) {
  if (name.empty() || name.size() > WINDLIVE_MAX_NAME ||
      name.find_first_of(std::string("/\0", 2)) != std::string::npos) {
    return makeError(ErrorKind::BadInput,
                     "'" + name + "' is no name for a live link: 1 to 64 characters without a slash");
  }
  const std::string path = "/" + name;
  Result<int> object = makeObject(path);
  if (!object) return object.error();
  std::unique_ptr<LiveLink> link(new LiveLink);
  link->m_path = path;
  link->m_object = *object;
  // Takes the memory now: where there is too little of it, writing to the map later would end the program.
  if (const int code = ::posix_fallocate(*object, 0, WINDLIVE_BYTES); code != 0) return failure(path, "", code);
  void* memory = ::mmap(nullptr, WINDLIVE_BYTES, PROT_READ | PROT_WRITE, MAP_SHARED, *object, 0);
  if (memory == MAP_FAILED) return failure(path, "", errno);
  link->m_memory = static_cast<std::byte*>(memory);
  put(link->m_memory + WINDLIVE_AT_VERSION, WINDLIVE_VERSION);
  put(link->m_memory + WINDLIVE_AT_SLOTS, WINDLIVE_SLOTS);
  put(link->m_memory + WINDLIVE_AT_SLOT_BYTES, WINDLIVE_SLOT_BYTES);
  put(link->m_memory + WINDLIVE_AT_PROCESS, static_cast<std::uint32_t>(::getpid()));
  std::atomic_thread_fence(std::memory_order_release);
  std::memcpy(link->m_memory + WINDLIVE_AT_MAGIC, WINDLIVE_MAGIC, 8);
  return link;
}

LiveLink::~LiveLink() {
  if (m_memory != nullptr) {
    atom<std::uint32_t>(m_memory + WINDLIVE_AT_ENDED).store(1, std::memory_order_release);
    ::munmap(m_memory, WINDLIVE_BYTES);
  }
  ::shm_unlink(m_path.c_str());
  ::close(m_object);
}

void LiveLink::writeCells(std::uint32_t* to, std::span<const glm::vec2> cells) {
  float fastest = 0;
  m_halves.resize(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const glm::vec2 v = cells[i];
    const std::uint16_t x = halfFromFloat(v.x), z = halfFromFloat(v.y);
    const glm::vec2 stored(floatFromHalf(x), floatFromHalf(z));
    fastest = std::max(fastest, glm::dot(stored, stored));
    m_halves[i] = x | static_cast<std::uint32_t>(z) << 16;
  }
  m_fastest = std::sqrt(fastest);
  for (std::size_t i = 0; i < m_halves.size(); ++i) {
    std::atomic_ref<std::uint32_t>(to[i]).store(m_halves[i], std::memory_order_relaxed);
  }
}

void LiveLink::publish(const GridMapping& grid, std::span<const glm::vec2> cells, double time, LiveEdges edges) {
  const glm::ivec2 resolution = glm::min(grid.resolution, glm::ivec2(kMaxSide));
  if (resolution != grid.resolution) {
    if (m_resampled != grid.resolution) m_resampler.emplace(grid.resolution, resolution);
    m_resampled = grid.resolution;
    m_resampler->apply(cells, m_small);
    cells = m_small;
  }
  const auto number = static_cast<std::uint64_t>(m_published) + 1;
  std::byte* slot = m_memory + WINDLIVE_HEADER_BYTES + number % WINDLIVE_SLOTS * WINDLIVE_SLOT_BYTES;
  const auto sequence = atom<std::uint64_t>(slot + WINDLIVE_AT_SEQUENCE);
  sequence.store(2 * number - 1, std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_seq_cst);
  writeCells(reinterpret_cast<std::uint32_t*>(slot + WINDLIVE_SLOT_HEADER_BYTES), cells);
  put(slot + WINDLIVE_AT_WIDTH, static_cast<std::uint32_t>(resolution.x));
  put(slot + WINDLIVE_AT_HEIGHT, static_cast<std::uint32_t>(resolution.y));
  put(slot + WINDLIVE_AT_MIN_X, grid.minCorner.x);
  put(slot + WINDLIVE_AT_MIN_Z, grid.minCorner.y);
  put(slot + WINDLIVE_AT_MAX_X, grid.minCorner.x + grid.size.x);
  put(slot + WINDLIVE_AT_MAX_Z, grid.minCorner.y + grid.size.y);
  put(slot + WINDLIVE_AT_MAX_SPEED, m_fastest);
  put(slot + WINDLIVE_AT_FLAGS,
      (edges.periodicX ? WINDPACK_FLAG_WRAP_X : 0u) | (edges.periodicZ ? WINDPACK_FLAG_WRAP_Z : 0u));
  put(slot + WINDLIVE_AT_TIME, time);
  sequence.store(2 * number, std::memory_order_release);
  atom<std::uint64_t>(m_memory + WINDLIVE_AT_NEWEST).store(number, std::memory_order_release);
  m_published = static_cast<long long>(number);
}

}  // namespace windloom
