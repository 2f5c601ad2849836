#include "engine/bake/vdb_bytes.hpp"

#include <openvdb/io/Archive.h>
#include <openvdb/io/Compression.h>
#include <openvdb/openvdb.h>
#include <tbb/task_arena.h>

#include <exception>
#include <sstream>

#include "engine/io/sha256.hpp"

namespace windloom {
namespace {

/// Writes to any stream, with the table of offsets that lets readers find a grid (openvdb::io::File wants a path).
class StreamArchive final : public openvdb::io::Archive {
 public:
  using Archive::write;
};

openvdb::Vec3SGrid::Ptr gridOf(const VdbBlock& block) {
  const openvdb::Vec3s none(0.0f);
  auto grid = openvdb::Vec3SGrid::create(none);
  grid->setName(block.name);
  grid->setVectorType(openvdb::VEC_CONTRAVARIANT_RELATIVE);
  grid->setSaveFloatAsHalf(true);
  // Index (0, 0, 0) is the centre of the first voxel.
  const auto transform = openvdb::math::Transform::createLinearTransform(static_cast<double>(block.side));
  const glm::dvec3 centre = glm::dvec3(block.low) + 0.5 * static_cast<double>(block.side);
  transform->postTranslate({centre.x, centre.y, centre.z});
  grid->setTransform(transform);
  // All voxels are active, those without wind as well: some readers refuse an empty grid.
  grid->denseFill({{0, 0, 0}, {block.size.x - 1, block.size.y - 1, block.size.z - 1}}, none, true);
  for (auto leaf = grid->tree().beginLeaf(); leaf; ++leaf) {
    for (auto voxel = leaf->beginValueOn(); voxel; ++voxel) {
      const openvdb::Coord at = voxel.getCoord();
      const std::int64_t index = at.x() + std::int64_t{block.size.x} * (at.y() + std::int64_t{block.size.y} * at.z());
      const glm::vec3 v = block.vectors[static_cast<std::size_t>(index)];
      voxel.setValue({v.x, v.y, v.z});
    }
  }
  return grid;
}

/// The library begins a file with magic number (8 bytes), file version (4), library version (8), a flag (1) and a
/// random id as text (36). It becomes one of the content, so that the same wind is the same file.
void makeRepeatable(std::string& bytes) {
  constexpr std::size_t kAt = 21, kLength = 36;
  WL_REQUIRE(bytes.size() > kAt + kLength, "an OpenVDB file has a header");
  constexpr std::size_t kDashes[] = {8, 13, 18, 23};
  for (const std::size_t dash : kDashes) WL_REQUIRE(bytes[kAt + dash] == '-', "an OpenVDB header has its id here");
  bytes.replace(kAt, kLength, kLength, '0');
  std::string id = sha256(bytes).substr(0, kLength);
  for (const std::size_t dash : kDashes) id[dash] = '-';
  id[14] = '8';  // RFC 9562: an id of the maker's own kind
  id[19] = 'a';
  bytes.replace(kAt, kLength, id);
}

std::string written(const VdbBlock& block) {
  openvdb::initialize();
  std::ostringstream stream(std::ios_base::binary);
  StreamArchive archive;
  archive.setCompression(
      openvdb::io::COMPRESS_ACTIVE_MASK |
      (openvdb::io::Archive::hasBloscCompression() ? openvdb::io::COMPRESS_BLOSC : openvdb::io::COMPRESS_ZIP));
  archive.write(stream, openvdb::GridCPtrVec{gridOf(block)}, true);
  std::string bytes = std::move(stream).str();
  makeRepeatable(bytes);
  return bytes;
}

}  // namespace

Result<std::string> vdbBytes(const VdbBlock& block) {
  // The library reports by exceptions; none may leave this room.
  try {
    // On the caller's thread alone: frames are written side by side as it is.
    return tbb::task_arena(1).execute([&] { return written(block); });
  } catch (const std::exception& failure) {
    return makeError(ErrorKind::Machine, std::string("OpenVDB can't write this volume: ") + failure.what());
  }
}

}  // namespace windloom
