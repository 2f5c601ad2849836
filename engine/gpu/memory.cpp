#include "engine/gpu/memory.hpp"

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace windloom::gpu {
namespace {

/// Bytes by label. Entries stay once made: labels are few, and objects point at theirs.
struct Totals {
  std::mutex mutex;
  std::map<std::string, std::size_t, std::less<>> bytes;
};

/// Outlives every object, also those that are destroyed at exit.
Totals& totals() {
  static auto* instance = new Totals();
  return *instance;
}

}  // namespace

std::size_t bytesInUse(std::string_view labelPrefix) {
  Totals& all = totals();
  const std::lock_guard lock(all.mutex);
  std::size_t sum = 0;
  for (auto it = all.bytes.lower_bound(labelPrefix); it != all.bytes.end() && it->first.starts_with(labelPrefix); ++it)
    sum += it->second;
  return sum;
}

std::map<std::string, std::size_t> bytesByLabel() {
  Totals& all = totals();
  const std::lock_guard lock(all.mutex);
  std::map<std::string, std::size_t> used;
  for (const auto& [label, bytes] : all.bytes)
    if (bytes > 0) used.emplace(label, bytes);
  return used;
}

MemoryUse::MemoryUse(std::string_view label, std::size_t bytes) : m_bytes(bytes) {
  Totals& all = totals();
  const std::lock_guard lock(all.mutex);
  m_total = &all.bytes.try_emplace(std::string(label)).first->second;
  *m_total += m_bytes;
}

MemoryUse::MemoryUse(MemoryUse&& other) noexcept
    : m_total(std::exchange(other.m_total, nullptr)), m_bytes(std::exchange(other.m_bytes, 0)) {}

MemoryUse& MemoryUse::operator=(MemoryUse&& other) noexcept {
  if (this == &other) return *this;
  release();
  m_total = std::exchange(other.m_total, nullptr);
  m_bytes = std::exchange(other.m_bytes, 0);
  return *this;
}

MemoryUse::~MemoryUse() {
  release();
}

void MemoryUse::release() {
  if (m_total == nullptr) return;
  const std::lock_guard lock(totals().mutex);
  *m_total -= m_bytes;
}

}  // namespace windloom::gpu
