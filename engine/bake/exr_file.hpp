#pragma once
// OpenEXR files with three half-float channels: scanlines, ZIP compression. Written by hand, since libdeflate packs a
// block in half the time of the zlib within the OpenEXR library, and the file can be appended to in one go.

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom {

/// Rows of one block, which is packed by itself.
inline constexpr int kExrRowsPerBlock = 16;

/// Names (1 to 31 characters, none of the standard attributes') and texts.
using ExrAttributes = std::vector<std::pair<std::string, std::string>>;

/// Everything before the table of block offsets.
std::string exrHeader(glm::ivec2 resolution, const ExrAttributes& attributes);

/// No file is longer, attributes of about 1 KB included: rows that can't be packed lie there as they are.
std::uint64_t exrBytesAtMost(glm::ivec2 resolution);

/// Packs and writes pictures of one size on all threads. The bytes don't depend on their number.
class ExrWriter {
 public:
  explicit ExrWriter(glm::ivec2 resolution);
  ~ExrWriter();
  ExrWriter(const ExrWriter&) = delete;
  ExrWriter& operator=(const ExrWriter&) = delete;

  /// `rows`: of each row, the top one first, all B, all G, all R. The file appears when it is whole. Fails with
  /// Machine.
  Status write(const std::filesystem::path& path, const ExrAttributes& attributes, std::span<const std::uint16_t> rows);

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace windloom
