#pragma once
// What a glTF file may hold. docs/limits.md says why.

#include <cstddef>
#include <cstdint>

namespace windloom::gltf {

inline constexpr std::uint64_t kMaxBytes = 1ull << 30;        ///< of any one file
inline constexpr std::uint64_t kMaxBufferBytes = 2ull << 30;  ///< of all its buffers and pictures in files together
inline constexpr std::size_t kMaxValues = 1'000'000;  ///< in its JSON: bounds nodes, accessors and all else there
inline constexpr std::size_t kMaxFiles = 10'000;      ///< that it names as its buffers and pictures
inline constexpr std::size_t kMaxPlacedPrimitives = 200'000;  ///< a mesh that nodes place often counts as often
inline constexpr std::size_t kMaxMaterials = 16;              ///< of one plant
inline constexpr int kMaxPictureSide = 8192;                  ///< pixels of one picture of a plant
inline constexpr std::size_t kMaxJpegScans = 100;             ///< of one picture
inline constexpr std::int64_t kMaxPicturePixels = 1 << 27;    ///< of all pictures of a plant together: 512 MB

}  // namespace windloom::gltf
