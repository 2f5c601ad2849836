#pragma once
// Ground from files: grey PNG pictures (8 or 16 bit) and glTF 2.0 meshes (.glb, .gltf).
//
// A picture's rows run along +x and its lower rows lie at higher z. One larger than kMaxHeightSamples a side is made
// smaller by averaging. Colours count by their luma (Rec. 709).
//
// Of a mesh the triangles of its default scene count, placed by their nodes; y is up. They are seen from above: each
// sample of the grid takes the highest triangle over it, samples with none take the mean of what lies next to them. The
// grid has about two samples for each side of a triangle in an even mesh: 2 sqrt(triangles / 2) along the longer side,
// at least 256, at most kMaxHeightSamples. Overhangs and caves are so lost.

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/result.hpp"
#include "engine/io/file_access.hpp"
#include "engine/model/project.hpp"

namespace windloom {

inline constexpr int kMaxTerrainPicture = 16384;                ///< pixels per side
inline constexpr std::size_t kMaxTerrainVertices = 20'000'000;  ///< of a mesh; as many triangles
/// Samples looked at while a mesh's triangles are drawn, every triangle those of its bounding rectangle. Ground of any
/// size looks at each sample two to ten times, which makes 40 million; this many take a second or two.
inline constexpr std::size_t kMaxDrawnSamples = 500'000'000;
inline constexpr std::uint64_t kMaxTerrainBytes = 1ull << 30;  ///< of any one file

/// Told what a loader does next ("Reading hills.png"); false stops it.
using LoadWatch = std::function<bool(std::string_view doing)>;

/// By the file name's ending: .png, .glb, .gltf in any case.
std::optional<TerrainKind> terrainKindOf(const std::filesystem::path& file);

/// Fails with BadInput (file named) where the file is missing, damaged, over a limit above, or of another kind, and
/// with Usage where `watch` stopped it, with Machine where there is not enough memory. The source's `file` is left
/// empty; `access` is for the files that a mesh needs.
Result<std::shared_ptr<HeightSource>> readTerrainFile(const std::filesystem::path& file, TerrainKind kind,
                                                      const LoadWatch& watch = {}, const FileAccess& access = {});

/// Fills in the heights of a project of this file. Fails with BadInput at /terrain/file; the ground is then flat and
/// all else as it was.
Status loadTerrain(Project& project, const std::filesystem::path& projectFile,
                   OutsideFiles outside = OutsideFiles::Refuse);

}  // namespace windloom
