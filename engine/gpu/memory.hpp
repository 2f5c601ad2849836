#pragma once
// How much memory of the GPU buffers and textures hold, counted by label as it was asked for. What the driver adds
// (padding, compression data, programs, the window) is not in it.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace windloom::gpu {

/// Bytes of all buffers and textures alive in this process whose label begins like this.
std::size_t bytesInUse(std::string_view labelPrefix = {});

/// Bytes of all buffers and textures alive in this process, by label; labels whose objects are all gone are left out.
std::map<std::string, std::size_t> bytesByLabel();

/// Counts an object for as long as it lives. Buffers and textures own one.
class MemoryUse {
 public:
  MemoryUse() = default;
  MemoryUse(std::string_view label, std::size_t bytes);
  MemoryUse(MemoryUse&& other) noexcept;
  MemoryUse& operator=(MemoryUse&& other) noexcept;
  ~MemoryUse();

 private:
  void release();
  std::size_t* m_total = nullptr;  // of the label
  std::size_t m_bytes = 0;
};

}  // namespace windloom::gpu
