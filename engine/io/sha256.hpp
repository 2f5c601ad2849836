#pragma once
// SHA-256 (FIPS 180-4), so that a game's pipeline can tell whether a baked file arrived whole.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

class Sha256 {
 public:
  void add(std::string_view bytes);
  /// The digest of all bytes added, as 64 lower-case hexadecimal digits. Ends the object's use.
  std::string finish();

 private:
  void addBlock(const unsigned char* block);

  std::array<std::uint32_t, 8> m_state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                          0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<unsigned char, 64> m_pending{};
  std::size_t m_pendingBytes = 0;
  std::uint64_t m_totalBytes = 0;
};

std::string sha256(std::string_view bytes);

/// Of a whole file, read piece by piece. Fails with Machine.
Result<std::string> sha256OfFile(const std::filesystem::path& path);

}  // namespace windloom
