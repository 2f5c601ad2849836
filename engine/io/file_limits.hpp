#pragma once
// Greatest sizes of files that are read as a whole. docs/limits.md says why.

#include <cstdint>

namespace windloom {

inline constexpr std::uint64_t kMaxPngBytes = 256ull << 20;
inline constexpr std::uint64_t kMaxNpyBytes = 1ull << 30;  ///< of --initial

}  // namespace windloom
