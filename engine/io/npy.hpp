#pragma once
// NumPy's .npy files of little-endian float32 in C order. Format: NumPy Enhancement Proposal 1,
// versions 1 to 3.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/core/atomic_file.hpp"
#include "engine/core/result.hpp"

namespace windloom {

struct NpyArray {
  std::vector<std::size_t> shape;  ///< slowest axis first; empty: one scalar
  std::vector<float> values;       ///< the product of `shape`, last axis fastest
};

/// Fails with BadInput where the file is missing, is no .npy, isn't '<f4' in C order (the message says
/// what it is and how to convert it), is cut short or too long for its shape, or is over `limitBytes`.
Result<NpyArray> readNpy(const std::filesystem::path& path, std::uint64_t limitBytes = 1ull << 30);

/// Writes version 1 atomically. `values` must have as many elements as `shape` says. Fails with Machine.
Status writeNpy(const std::filesystem::path& path, const std::vector<std::size_t>& shape,
                std::span<const float> values);

/// Writes a large array piece by piece; the file appears when finish() succeeds.
class NpyStream {
 public:
  static Result<NpyStream> create(const std::filesystem::path& path, const std::vector<std::size_t>& shape);

  /// Appends the next values. More than `shape` says is a broken promise. Fails with Machine.
  Status write(std::span<const float> values);
  /// All values must have been written. Fails with Machine.
  Status finish();

 private:
  NpyStream(AtomicFile file, std::size_t values) : m_file(std::move(file)), m_left(values) {}
  AtomicFile m_file;
  std::size_t m_left;
};

}  // namespace windloom
