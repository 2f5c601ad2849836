// The live link's reader: a shared memory object that holds whatever it likes. The input is the object's header, the
// header of the slot it names, and cells that are repeated to fill the slot; an odd last byte cuts the object short.

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>

#include <cmath>
#include <cstring>

#include "engine/runtime/live_format.h"
#include "engine/runtime/windloom_runtime.h"
#include "tests/fuzz/support/fuzz_target.hpp"

using windloom::fuzz::require;

namespace {

/// Made once, as large as a link is; this process holds its writer's lock.
class Object {
 public:
  Object() : m_name("windloom-fuzz-" + std::to_string(::getpid())) {
    m_file = ::shm_open(("/" + m_name).c_str(), O_RDWR | O_CREAT | O_TRUNC, 0600);
    require(m_file >= 0 && ::ftruncate(m_file, WINDLIVE_BYTES) == 0 && ::flock(m_file, LOCK_EX) == 0,
            "a shared memory object can be made");
  }
  ~Object() {
    ::shm_unlink(("/" + m_name).c_str());
    ::close(m_file);
  }
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  [[nodiscard]] const char* name() const { return m_name.c_str(); }
  void resize(std::size_t bytes) const { require(::ftruncate(m_file, static_cast<off_t>(bytes)) == 0, "resized"); }
  void put(std::size_t at, const std::uint8_t* bytes, std::size_t size) const {
    require(::pwrite(m_file, bytes, size, static_cast<off_t>(at)) == static_cast<ssize_t>(size), "written");
  }

 private:
  std::string m_name;
  int m_file = -1;
};

void sampleAll(const windloom_live* live) {
  const windloom_info info = windloom_live_info(live);
  const float places[] = {0, 0, 1e30f, -1e30f, info.min_x, info.max_z, 0.5f * (info.min_x + info.max_x), info.min_z};
  float winds[8];
  windloom_live_sample_many(live, places, 4, winds);
  for (const float wind : winds) require(std::isfinite(wind), "a wind is a number");
  if (info.width == 0) return;
  require(info.width <= int(WINDLIVE_MAX_SIDE) && info.height > 0 && info.height <= int(WINDLIVE_MAX_SIDE),
          "a field has cells");
  require(info.min_x < info.max_x && info.min_z < info.max_z && std::isfinite(info.start), "a field is somewhere");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t kHeads = WINDLIVE_HEADER_BYTES + WINDLIVE_SLOT_HEADER_BYTES;
  static const Object object;
  if (size < kHeads) return 0;
  std::uint64_t newest = 0;
  std::memcpy(&newest, data + WINDLIVE_AT_NEWEST, sizeof newest);
  object.resize(WINDLIVE_BYTES);
  object.put(0, data, WINDLIVE_HEADER_BYTES);
  const std::size_t slot = WINDLIVE_HEADER_BYTES + newest % WINDLIVE_SLOTS * WINDLIVE_SLOT_BYTES;
  object.put(slot, data + WINDLIVE_HEADER_BYTES, WINDLIVE_SLOT_HEADER_BYTES);
  object.put(slot + WINDLIVE_SLOT_HEADER_BYTES, data + kHeads, size - kHeads);
  windloom_status status = WINDLOOM_OK;
  windloom_live* live = windloom_live_open(object.name(), &status);
  require((live != nullptr) == (status == WINDLOOM_OK), "a link or a reason");
  if (live == nullptr) return 0;
  const int first = windloom_live_update(live);
  require(first >= -1 && first <= 1, "an update says what it did");
  sampleAll(live);
  if (size > kHeads && data[size - 1] % 2 == 1) object.resize(slot + size - kHeads);
  windloom_live_update(live);
  sampleAll(live);
  windloom_live_close(live);
  return 0;
}

/// Keeps what the reader checks before anything else right, three times in four.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  const std::size_t made = LLVMFuzzerMutate(data, size, maxSize);
  if (seed % 4 == 0 || made < WINDLIVE_HEADER_BYTES + WINDLIVE_SLOT_HEADER_BYTES) return made;
  const std::uint32_t numbers[] = {WINDLIVE_VERSION, WINDLIVE_SLOTS, WINDLIVE_SLOT_BYTES};
  std::memcpy(data, WINDLIVE_MAGIC, 8);
  std::memcpy(data + WINDLIVE_AT_VERSION, numbers, sizeof numbers);
  std::uint64_t newest = 0;
  std::memcpy(&newest, data + WINDLIVE_AT_NEWEST, sizeof newest);
  newest *= 2;
  std::memcpy(data + WINDLIVE_HEADER_BYTES + WINDLIVE_AT_SEQUENCE, &newest, sizeof newest);
  return made;
}
