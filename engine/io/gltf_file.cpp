#include "engine/io/gltf_file.hpp"

#include <algorithm>
#include <cstring>
#include <exception>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <new>

#include "engine/core/file.hpp"
#include "engine/io/json_document.hpp"

namespace windloom::gltf {
namespace fs = std::filesystem;
namespace {

bool inside(int index, std::size_t count) {
  return index >= 0 && static_cast<std::size_t>(index) < count;
}

/// Where a file's other files may lie, and what became of that.
struct Reach {
  fs::path folder;
  Pictures pictures;
  FileAccess access;
  std::string refused;  // the first file that lies outside
  std::uint64_t bytesLeft = kMaxBufferBytes;
  std::size_t files = 0;  // read
  const tinygltf::Model* model = nullptr;
};

bool isPicture(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg" || ending == ".webp" || ending == ".ktx2";
}

bool mayRead(const std::string& name, void* data) {
  auto& reach = *static_cast<Reach*>(data);
  // As the system will open it: to shorten "link/.." would check another file.
  const fs::path path = name;
  const fs::path relative = path.lexically_relative(reach.folder);
  std::error_code ignored;
  if (!path.is_absolute() || (reach.pictures != Pictures::Keep && isPicture(path))) return false;
  if (!fs::is_regular_file(path, ignored)) return false;
  const bool beside = !relative.empty() && std::ranges::find(relative, fs::path("..")) == relative.end();
  const bool allowed = mayRead(reach.access, path) && (beside || reach.access.outside == OutsideFiles::Allow);
  if (!allowed && reach.refused.empty()) reach.refused = relative.generic_string();
  return allowed;
}

bool readWhole(std::vector<unsigned char>* out, std::string* problem, const std::string& name, void* data) {
  auto& reach = *static_cast<Reach*>(data);
  if (++reach.files > kMaxFiles) {
    if (problem != nullptr) *problem = "there are more than " + std::to_string(kMaxFiles) + " other files";
    return false;
  }
  const Result<std::string> bytes = readFile(name, std::min(kMaxBytes, reach.bytesLeft));
  if (!bytes) {
    if (problem != nullptr) *problem = bytes.error().text();
    return false;
  }
  reach.bytesLeft -= bytes->size();
  out->assign(bytes->begin(), bytes->end());
  return true;
}

/// The JSON of a file, alone or as the first chunk of a binary one.
std::string_view jsonOf(std::string_view bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  if (!bytes.starts_with("glTF")) return bytes;
  if (bytes.size() < kHeader + kChunkHeader) return {};
  std::uint32_t length = 0;  // little endian, as the file is
  std::memcpy(&length, bytes.data() + kHeader, sizeof length);
  return bytes.substr(kHeader + kChunkHeader, length);
}

/// Whether the view ends within its buffer, and takes `size` bytes of it: the library doesn't look.
bool viewEndsWithin(const tinygltf::Model& model, int index, int size) {
  if (!inside(index, model.bufferViews.size())) return false;
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
  if (!inside(view.buffer, model.buffers.size())) return false;
  const std::size_t there = model.buffers[static_cast<std::size_t>(view.buffer)].data.size();
  return size >= 0 && view.byteOffset <= there && static_cast<std::size_t>(size) <= there - view.byteOffset;
}

bool takePicture(tinygltf::Image* image, int, std::string* problem, std::string*, int, int, const unsigned char* bytes,
                 int size, void* data) {
  const tinygltf::Model& model = *static_cast<const Reach*>(data)->model;
  if (image->bufferView >= 0 && !viewEndsWithin(model, image->bufferView, size)) {
    if (problem != nullptr) *problem = "a picture ends beyond its buffer";
    return false;
  }
  if (static_cast<const Reach*>(data)->pictures == Pictures::Keep && size > 0) image->image.assign(bytes, bytes + size);
  return true;
}

std::string oneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

std::string amount(std::size_t count) {
  return count % 1'000'000 == 0 ? std::to_string(count / 1'000'000) + " million" : std::to_string(count);
}

glm::dmat4 transformOf(const tinygltf::Node& node) {
  glm::dmat4 own(1.0);
  if (node.matrix.size() == 16) {
    for (int i = 0; i < 16; ++i) own[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
    return own;
  }
  if (node.translation.size() == 3)
    own = glm::translate(own, {node.translation[0], node.translation[1], node.translation[2]});
  if (node.rotation.size() == 4)
    own *= glm::mat4_cast(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
  if (node.scale.size() == 3) own = glm::scale(own, {node.scale[0], node.scale[1], node.scale[2]});
  return own;
}

/// Whether the second chunk of a binary file ends within the file: the library leaves the chunk's header out of its
/// sum, and would read beyond.
bool chunksEndWithin(std::string_view bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  const auto lengthAt = [&](std::size_t at) {
    std::uint32_t length = 0;  // little endian, as the file is
    std::memcpy(&length, bytes.data() + at, sizeof length);
    return std::size_t(length);
  };
  if (bytes.size() < kHeader + kChunkHeader) return true;
  const std::size_t second = kHeader + kChunkHeader + lengthAt(kHeader);
  return second + kChunkHeader > bytes.size() || second + kChunkHeader + lengthAt(second) <= bytes.size();
}

Result<std::vector<int>> rootsOf(const tinygltf::Model& model, const fs::path& file) {
  std::vector<int> roots;
  if (model.scenes.empty()) {
    for (std::size_t i = 0; i < model.nodes.size(); ++i) roots.push_back(static_cast<int>(i));
    return roots;
  }
  const int wanted = model.defaultScene >= 0 ? model.defaultScene : 0;
  if (!inside(wanted, model.scenes.size())) return refuse(file, "has no scene " + std::to_string(wanted));
  return model.scenes[static_cast<std::size_t>(wanted)].nodes;
}

}  // namespace

Error refuse(const fs::path& file, std::string message) {
  return makeError(ErrorKind::BadInput, file.string(), {}, std::move(message));
}

Result<tinygltf::Model> parse(const fs::path& file, Pictures pictures, const FileAccess& access) {
  const Result<std::string> bytes = readFile(file, kMaxBytes);
  if (!bytes) return bytes.error();
  // The library knows no limits: it follows nested values by recursion and makes an object of each.
  if (Status within = checkJsonExtent(jsonOf(*bytes), kMaxValues, file.string()); !within) return within.error();
  std::error_code ignored;
  Reach reach{fs::absolute(file, ignored).parent_path(), pictures, access, {}};
  if (reach.access.folder.empty()) reach.access.folder = reach.folder;
  tinygltf::TinyGLTF loader;
  tinygltf::FsCallbacks files{};
  files.FileExists = mayRead;
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = readWhole;
  files.user_data = &reach;
  loader.SetFsCallbacks(files);
  loader.SetImageLoader(takePicture, &reach);
  tinygltf::Model model;
  reach.model = &model;
  std::string problem, warning;
  const auto size = static_cast<unsigned>(bytes->size());
  const std::string folder = reach.folder.string();
  const bool binary = bytes->starts_with("glTF");
  if (binary && !chunksEndWithin(*bytes))
    return refuse(file, "is no glTF file that can be read: its second chunk ends beyond the file");
  bool good = false;
  try {
    good = binary ? loader.LoadBinaryFromMemory(&model, &problem, &warning,
                                                reinterpret_cast<const unsigned char*>(bytes->data()), size, folder)
                  : loader.LoadASCIIFromString(&model, &problem, &warning, bytes->data(), size, folder);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    // Where a buffer of a binary file is empty, the library looks at its first byte by at().
    problem.clear();
  }
  if (!good && !reach.refused.empty()) {
    return refuse(file,
                  "refers to '" + reach.refused +
                      "', which holds '..' or lies outside its folder: such files are read only where you allow it");
  }
  if (!good)
    return refuse(file, "is no glTF file that can be read: " + oneLine(problem.empty() ? "it is damaged" : problem));
  for (const std::string& extension : model.extensionsRequired) {
    if (extension.starts_with("KHR_texture") || extension.starts_with("KHR_materials")) continue;
    return refuse(file, "needs the glTF extension " + extension + ", which can't be read: export it without");
  }
  return model;
}

Result<std::vector<PlacedMesh>> meshesOfScene(const tinygltf::Model& model, const fs::path& file) {
  const Result<std::vector<int>> roots = rootsOf(model, file);
  if (!roots) return roots.error();
  std::vector<std::pair<int, glm::dmat4>> open;
  for (const int root : *roots) open.emplace_back(root, glm::dmat4(1.0));
  std::vector<bool> seen(model.nodes.size());
  std::vector<PlacedMesh> placed;
  std::size_t primitives = 0;
  while (!open.empty()) {
    const auto [index, parent] = open.back();
    open.pop_back();
    if (!inside(index, model.nodes.size()))
      return refuse(file, "refers to node " + std::to_string(index) + ", which is not there");
    // A node has one parent; a ring would never end.
    if (seen[static_cast<std::size_t>(index)]) continue;
    seen[static_cast<std::size_t>(index)] = true;
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
    const glm::dmat4 world = parent * transformOf(node);
    if (node.mesh >= 0) {
      if (!inside(node.mesh, model.meshes.size()))
        return refuse(file, "refers to mesh " + std::to_string(node.mesh) + ", which is not there");
      primitives += model.meshes[static_cast<std::size_t>(node.mesh)].primitives.size();
      if (primitives > kMaxPlacedPrimitives)
        return refuse(file, "places more than " + amount(kMaxPlacedPrimitives) + " pieces of meshes in its scene");
      placed.push_back({static_cast<std::size_t>(node.mesh), world});
    }
    for (const int child : node.children) open.emplace_back(child, world);
  }
  return placed;
}

bool isTriangles(const tinygltf::Primitive& primitive) {
  return primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == -1;
}

Result<Elements> elementsOf(const tinygltf::Model& model, int accessorIndex, std::size_t elementBytes, std::size_t most,
                            const fs::path& file) {
  const std::string name = "accessor " + std::to_string(accessorIndex);
  if (!inside(accessorIndex, model.accessors.size())) return refuse(file, "refers to " + name + ", which is not there");
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessorIndex)];
  if (accessor.sparse.isSparse) return refuse(file, "has a sparse " + name + ", which can't be read");
  if (!inside(accessor.bufferView, model.bufferViews.size())) return refuse(file, name + " has no buffer view");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  if (!inside(view.buffer, model.buffers.size())) return refuse(file, name + " refers to a buffer that is not there");
  const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (accessor.count > most) {
    return refuse(file, "has " + std::to_string(accessor.count) + " elements in " + name + ", more than can be read");
  }
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : elementBytes;
  const std::size_t needed = accessor.count == 0 ? 0 : (accessor.count - 1) * stride + elementBytes;
  const bool fits = accessor.byteOffset <= view.byteLength && needed <= view.byteLength - accessor.byteOffset &&
                    view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
  if (!fits) return refuse(file, name + " reaches beyond its buffer");
  return Elements{data.data() + view.byteOffset + accessor.byteOffset, accessor.count, stride};
}

Status appendIndices(const tinygltf::Model& model, int accessorIndex, std::size_t first, std::size_t vertices,
                     std::size_t most, const fs::path& file, std::vector<std::uint32_t>& into) {
  if (accessorIndex < 0) {
    for (std::size_t i = 0; i < vertices - vertices % 3; ++i) into.push_back(static_cast<std::uint32_t>(first + i));
    return Done{};
  }
  if (!inside(accessorIndex, model.accessors.size()))
    return refuse(file, "refers to accessor " + std::to_string(accessorIndex) + ", which is not there");
  const int type = model.accessors[static_cast<std::size_t>(accessorIndex)].componentType;
  const std::size_t size = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                           : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                           : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? 4
                                                                            : 0;
  if (size == 0) return refuse(file, "has indices that are no unsigned whole numbers");
  const Result<Elements> elements = elementsOf(model, accessorIndex, size, kMaxBytes, file);
  if (!elements) return elements.error();
  if (into.size() + elements->count > most) return refuse(file, "has more than " + amount(most / 3) + " triangles");
  for (std::size_t i = 0; i < elements->count - elements->count % 3; ++i) {
    std::uint32_t index = 0;  // little endian, as the file is
    std::memcpy(&index, elements->bytes + i * elements->stride, size);
    if (index >= vertices) {
      return refuse(file, "has the index " + std::to_string(index) + ", but its mesh has only " +
                              std::to_string(vertices) + " vertices");
    }
    into.push_back(static_cast<std::uint32_t>(first) + index);
  }
  return Done{};
}

Status appendPositions(const tinygltf::Model& model, int accessorIndex, const glm::dmat4& world, std::size_t most,
                       const fs::path& file, std::vector<glm::vec3>& into) {
  const Result<Elements> places = elementsOf(model, accessorIndex, 3 * sizeof(float), kMaxBytes, file);
  if (!places) return places.error();
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessorIndex)];
  if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || accessor.type != TINYGLTF_TYPE_VEC3)
    return refuse(file, "has positions that are not three floats each");
  if (into.size() + places->count > most) return refuse(file, "has more than " + amount(most) + " vertices");
  for (std::size_t i = 0; i < places->count; ++i) {
    float xyz[3];
    std::memcpy(xyz, places->bytes + i * places->stride, sizeof xyz);
    const glm::vec3 at(world * glm::dvec4(xyz[0], xyz[1], xyz[2], 1.0));
    if (!(glm::length(at) < 1e9f))
      return refuse(file, "has a vertex (" + std::to_string(i) + ") that is nowhere: not finite or too far");
    into.push_back(at);
  }
  return Done{};
}

}  // namespace windloom::gltf
