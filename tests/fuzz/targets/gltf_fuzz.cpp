// glTF files, text and binary, by every reader: ground, plant, thing, surface, and what of files they need beside them.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/io/asset_copy.hpp"
#include "engine/io/plant_file.hpp"
#include "engine/io/terrain_file.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"
#include "tests/fuzz/support/json_mutator.hpp"

using namespace windloom;
using fuzz::require;
namespace fs = std::filesystem;

namespace {

bool finite(glm::vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void checkMesh(const PlantMesh& mesh, MeshUse use) {
  require(mesh.indices.size() >= 3 && mesh.indices.size() % 3 == 0, "a mesh has whole triangles");
  for (const std::uint32_t index : mesh.indices) require(index < mesh.vertices.size(), "an index is of a vertex");
  for (const PlantVertex& vertex : mesh.vertices) {
    require(finite(vertex.position) && finite(vertex.normal), "a vertex is somewhere");
    require(finite(glm::vec3(vertex.uv, vertex.colour.a)) && finite(glm::vec3(vertex.colour)), "a vertex has a colour");
  }
  require(mesh.texture.size() == std::size_t(4) * static_cast<std::size_t>(mesh.textureSize.x) *
                                     static_cast<std::size_t>(mesh.textureSize.y),
          "a texture has all its pixels");
  require(mesh.textureSize.x <= kMaxPlantTexture && mesh.textureSize.y <= kMaxPlantTexture,
          "a texture is within its limit");
  require(mesh.spheres.size() <= kMaxSpheres && (use != MeshUse::Object || !mesh.spheres.empty()),
          "a thing has spheres, not too many");
  for (const glm::vec4& sphere : mesh.spheres)
    require(finite(glm::vec3(sphere)) && std::isfinite(sphere.w) && sphere.w > 0, "a sphere has a size");
}

void checkHeights(const HeightSource& source) {
  require(source.samples.x >= 2 && source.samples.y >= 2 && source.samples.x <= kMaxHeightSamples &&
              source.samples.y <= kMaxHeightSamples,
          "ground has samples");
  for (const float value : source.values) require(std::isfinite(value), "a height is a number");
  require(source.lowest <= source.highest, "the lowest is below the highest");
}

void tryFile(const fs::path& file) {
  for (const MeshUse use : {MeshUse::Plant, MeshUse::Object, MeshUse::Surface}) {
    const Result<std::shared_ptr<PlantMesh>> mesh = readPlantFile(file, use);
    if (mesh) checkMesh(**mesh, use);
    require(mesh.ok() || !mesh.error().text().empty(), "a refusal says why");
  }
  const Result<std::shared_ptr<HeightSource>> ground = readTerrainFile(file, TerrainKind::Mesh);
  if (ground) checkHeights(**ground);
  if (const Result<std::vector<std::string>> names = assetCompanions(file)) {
    for (const std::string& name : *names) {
      const fs::path below = fs::path(name).lexically_normal();
      require(!below.is_absolute() && *below.begin() != "..", "companions lie in the file's folder");
    }
  }
}

const fuzz::JsonWords& words() {
  static const fuzz::JsonWords kWords{
      {"accessors",
       "alphaCutoff",
       "alphaMode",
       "asset",
       "attributes",
       "baseColorFactor",
       "baseColorTexture",
       "buffer",
       "bufferView",
       "bufferViews",
       "buffers",
       "byteLength",
       "byteOffset",
       "byteStride",
       "children",
       "componentType",
       "count",
       "extensions",
       "extensionsRequired",
       "extensionsUsed",
       "extras",
       "images",
       "index",
       "indices",
       "KHR_texture_transform",
       "material",
       "materials",
       "matrix",
       "mesh",
       "meshes",
       "mimeType",
       "min",
       "max",
       "mode",
       "name",
       "node",
       "nodes",
       "normalized",
       "offset",
       "pbrMetallicRoughness",
       "POSITION",
       "NORMAL",
       "TEXCOORD_0",
       "TEXCOORD_1",
       "COLOR_0",
       "primitives",
       "rotation",
       "sampler",
       "scale",
       "scene",
       "scenes",
       "skins",
       "source",
       "sparse",
       "target",
       "targets",
       "texCoord",
       "textures",
       "translation",
       "type",
       "uri",
       "values",
       "version",
       "animations",
       "channels",
       "cameras",
       "weights",
       "KHR_lights_punctual",
       "lights"},
      {"2.0", "SCALAR", "VEC2", "VEC3", "VEC4", "MAT4", "MASK", "BLEND", "OPAQUE", "image/png", "image/jpeg",
       "KHR_texture_transform", "KHR_draco_mesh_compression", "data:application/octet-stream;base64,AAAAAAAAAAAAAIA/",
       "data:image/png;base64,iVBORw0KGgo=", "fuzz.bin", "fuzz.glb", "http://example.com/a.bin"}};
  return kWords;
}

// A binary file: header of 12 bytes, then chunks, each with its length and kind before it.
constexpr std::size_t kHeader = 12, kChunkHeader = 8;
constexpr std::uint32_t kJsonKind = 0x4E4F534A, kBinaryKind = 0x004E4942;

std::uint32_t numberAt(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

void append(std::vector<std::uint8_t>& bytes, std::uint32_t value) {
  const auto* raw = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), raw, raw + sizeof value);
}

struct Glb {
  std::vector<std::uint8_t> json, binary;
};

bool split(const std::vector<std::uint8_t>& bytes, Glb& glb) {
  if (bytes.size() < kHeader + kChunkHeader || std::memcmp(bytes.data(), "glTF", 4) != 0) return false;
  const std::size_t start = kHeader + kChunkHeader;
  const std::size_t length = std::min<std::size_t>(numberAt(bytes, kHeader), bytes.size() - start);
  glb.json.assign(bytes.begin() + start, bytes.begin() + static_cast<std::ptrdiff_t>(start + length));
  if (start + length + kChunkHeader <= bytes.size())
    glb.binary.assign(bytes.begin() + static_cast<std::ptrdiff_t>(start + length + kChunkHeader), bytes.end());
  return true;
}

/// With all lengths right; those of buffers in the JSON stay as they are.
std::vector<std::uint8_t> joined(Glb glb) {
  glb.json.resize((glb.json.size() + 3) / 4 * 4, ' ');
  glb.binary.resize((glb.binary.size() + 3) / 4 * 4, 0);
  std::vector<std::uint8_t> bytes{'g', 'l', 'T', 'F', 2, 0, 0, 0};
  append(bytes, static_cast<std::uint32_t>(kHeader + 2 * kChunkHeader + glb.json.size() + glb.binary.size()));
  append(bytes, static_cast<std::uint32_t>(glb.json.size()));
  append(bytes, kJsonKind);
  bytes.insert(bytes.end(), glb.json.begin(), glb.json.end());
  append(bytes, static_cast<std::uint32_t>(glb.binary.size()));
  append(bytes, kBinaryKind);
  bytes.insert(bytes.end(), glb.binary.begin(), glb.binary.end());
  return bytes;
}

void mutateIn(std::vector<std::uint8_t>& part, std::size_t room, unsigned seed, bool json) {
  const std::size_t size = part.size();
  part.resize(size + room);
  const std::size_t made = json ? fuzz::mutateJson(part.data(), size, part.size(), seed, words())
                                : LLVMFuzzerMutate(part.data(), size, part.size());
  part.resize(made);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  const std::string_view bytes = fuzz::asText(data, size);
  tryFile(folder.put(bytes.starts_with("glTF") ? "fuzz.glb" : "fuzz.gltf", bytes));
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  const std::vector<std::uint8_t> bytes(data, data + size);
  Glb glb;
  if (!split(bytes, glb)) return fuzz::mutateJson(data, size, maxSize, seed, words());
  if (seed % 16 == 0) return LLVMFuzzerMutate(data, size, maxSize);
  const std::size_t room = maxSize > size + 8 ? maxSize - size - 8 : 0;
  const bool json = glb.binary.empty() || seed % 4 != 1;
  mutateIn(json ? glb.json : glb.binary, room, seed / 16, json);
  const std::vector<std::uint8_t> made = joined(std::move(glb));
  if (made.size() > maxSize) return size;
  std::memcpy(data, made.data(), made.size());
  return made.size();
}
