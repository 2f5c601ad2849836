#include "engine/io/terrain_mesh.hpp"

#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <queue>

#include "engine/core/file.hpp"
#include "engine/core/text.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

Error refuse(const fs::path& file, std::string message) {
  return makeError(ErrorKind::BadInput, file.string(), {}, std::move(message));
}
Error stopped() {
  return makeError(ErrorKind::Usage, "stopped");
}

// What tinygltf reads besides the file itself: only buffers, and only from the file's own folder.

bool isPicture(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg" || ending == ".webp" || ending == ".ktx2";
}

bool mayRead(const std::string& name, void* folder) {
  const fs::path path = fs::path(name).lexically_normal();
  const fs::path relative = path.lexically_relative(*static_cast<const fs::path*>(folder));
  std::error_code ignored;
  return path.is_absolute() && !relative.empty() && *relative.begin() != ".." && !isPicture(path) &&
         fs::is_regular_file(path, ignored);
}

bool readWhole(std::vector<unsigned char>* out, std::string* problem, const std::string& name, void*) {
  const Result<std::string> bytes = readFile(name, kMaxTerrainBytes);
  if (!bytes) {
    if (problem != nullptr) *problem = bytes.error().text();
    return false;
  }
  out->assign(bytes->begin(), bytes->end());
  return true;
}

bool leavePicture(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

std::string oneLine(std::string text) {
  while (!text.empty() && text.back() == '\n') text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  return text;
}

Result<tinygltf::Model> parseModel(const fs::path& file) {
  const Result<std::string> bytes = readFile(file, kMaxTerrainBytes);
  if (!bytes) return bytes.error();
  std::error_code ignored;
  fs::path folder = fs::absolute(file, ignored).lexically_normal().parent_path();
  tinygltf::TinyGLTF loader;
  tinygltf::FsCallbacks files{};
  files.FileExists = mayRead;
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = readWhole;
  files.user_data = &folder;
  loader.SetFsCallbacks(files);
  loader.SetImageLoader(leavePicture, nullptr);
  tinygltf::Model model;
  std::string problem, warning;
  const auto size = static_cast<unsigned>(bytes->size());
  const bool binary = bytes->starts_with("glTF");
  const bool good =
      binary ? loader.LoadBinaryFromMemory(&model, &problem, &warning,
                                           reinterpret_cast<const unsigned char*>(bytes->data()), size, folder.string())
             : loader.LoadASCIIFromString(&model, &problem, &warning, bytes->data(), size, folder.string());
  if (!good)
    return refuse(file, "is no glTF file that can be read: " + oneLine(problem.empty() ? "it is damaged" : problem));
  for (const std::string& extension : model.extensionsRequired) {
    if (extension.starts_with("KHR_texture") || extension.starts_with("KHR_materials")) continue;
    return refuse(file, "needs the glTF extension " + extension + ", which can't be read: export it without");
  }
  return model;
}

/// The bytes of an accessor, checked: `elements` of `elementBytes` each, `stride` bytes apart.
struct Elements {
  const unsigned char* bytes = nullptr;
  std::size_t count = 0, stride = 0;
};

Result<Elements> elementsOf(const tinygltf::Model& model, int accessorIndex, std::size_t elementBytes,
                            const fs::path& file) {
  const auto inside = [](int index, const auto& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
  };
  const std::string name = "accessor " + std::to_string(accessorIndex);
  if (!inside(accessorIndex, model.accessors)) return refuse(file, "refers to " + name + ", which is not there");
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessorIndex)];
  if (accessor.sparse.isSparse) return refuse(file, "has a sparse " + name + ", which can't be read");
  if (!inside(accessor.bufferView, model.bufferViews)) return refuse(file, name + " has no buffer view");
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  if (!inside(view.buffer, model.buffers)) return refuse(file, name + " refers to a buffer that is not there");
  const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
  if (accessor.count > kMaxTerrainVertices * 3) {
    return refuse(file, "has " + std::to_string(accessor.count) + " elements in " + name + ", more than can be read");
  }
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : elementBytes;
  const std::size_t needed = accessor.count == 0 ? 0 : (accessor.count - 1) * stride + elementBytes;
  const bool fits = accessor.byteOffset <= view.byteLength && needed <= view.byteLength - accessor.byteOffset &&
                    view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset;
  if (!fits) return refuse(file, name + " reaches beyond its buffer");
  return Elements{data.data() + view.byteOffset + accessor.byteOffset, accessor.count, stride};
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

class Collector {
 public:
  Collector(const tinygltf::Model& model, const fs::path& file)
      : m_model(model), m_file(file), m_seen(model.nodes.size()) {}

  Result<TriangleMesh> collect() {
    std::vector<int> roots;
    if (!m_model.scenes.empty()) {
      const int wanted = m_model.defaultScene >= 0 ? m_model.defaultScene : 0;
      if (static_cast<std::size_t>(wanted) >= m_model.scenes.size())
        return refuse(m_file, "has no scene " + std::to_string(wanted));
      roots = m_model.scenes[static_cast<std::size_t>(wanted)].nodes;
    } else {
      for (std::size_t i = 0; i < m_model.nodes.size(); ++i) roots.push_back(static_cast<int>(i));
    }
    std::vector<std::pair<int, glm::dmat4>> open;
    for (const int root : roots) open.emplace_back(root, glm::dmat4(1.0));
    while (!open.empty()) {
      const auto [index, parent] = open.back();
      open.pop_back();
      if (index < 0 || static_cast<std::size_t>(index) >= m_model.nodes.size())
        return refuse(m_file, "refers to node " + std::to_string(index) + ", which is not there");
      // A node has one parent; a ring would never end.
      if (m_seen[static_cast<std::size_t>(index)]) continue;
      m_seen[static_cast<std::size_t>(index)] = true;
      const tinygltf::Node& node = m_model.nodes[static_cast<std::size_t>(index)];
      const glm::dmat4 world = parent * transformOf(node);
      if (node.mesh >= 0) {
        if (Status added = addMesh(node.mesh, world); !added) return added.error();
      }
      for (const int child : node.children) open.emplace_back(child, world);
    }
    if (m_mesh.indices.empty()) return refuse(m_file, "has no triangles in its scene");
    return std::move(m_mesh);
  }

 private:
  Status addMesh(int index, const glm::dmat4& world) {
    if (static_cast<std::size_t>(index) >= m_model.meshes.size())
      return refuse(m_file, "refers to mesh " + std::to_string(index) + ", which is not there");
    for (const tinygltf::Primitive& primitive : m_model.meshes[static_cast<std::size_t>(index)].primitives) {
      const bool triangles = primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == -1;
      if (!triangles) continue;
      if (Status added = addPrimitive(primitive, world); !added) return added;
    }
    return Done{};
  }

  Status addPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& world) {
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return Done{};
    const Result<Elements> places = elementsOf(m_model, position->second, 3 * sizeof(float), m_file);
    if (!places) return places.error();
    const tinygltf::Accessor& accessor = m_model.accessors[static_cast<std::size_t>(position->second)];
    if (accessor.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || accessor.type != TINYGLTF_TYPE_VEC3)
      return refuse(m_file, "has positions that are not three floats each");
    const std::size_t first = m_mesh.vertices.size();
    if (first + places->count > kMaxTerrainVertices) {
      return refuse(m_file, "has more than " + std::to_string(kMaxTerrainVertices / 1'000'000) + " million vertices");
    }
    for (std::size_t i = 0; i < places->count; ++i) {
      float xyz[3];
      std::memcpy(xyz, places->bytes + i * places->stride, sizeof xyz);
      const glm::vec3 at(world * glm::dvec4(xyz[0], xyz[1], xyz[2], 1.0));
      if (!(glm::length(at) < 1e9f))
        return refuse(m_file, "has a vertex (" + std::to_string(i) + ") that is nowhere: not finite or too far");
      m_mesh.vertices.push_back(at);
    }
    return primitive.indices < 0 ? addRun(first, places->count) : addIndices(primitive.indices, first, places->count);
  }

  Status addRun(std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count - count % 3; ++i) m_mesh.indices.push_back(static_cast<std::uint32_t>(first + i));
    return Done{};
  }

  Status addIndices(int accessorIndex, std::size_t first, std::size_t vertices) {
    if (static_cast<std::size_t>(accessorIndex) >= m_model.accessors.size())
      return refuse(m_file, "refers to accessor " + std::to_string(accessorIndex) + ", which is not there");
    const int type = m_model.accessors[static_cast<std::size_t>(accessorIndex)].componentType;
    const std::size_t size = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? 1
                             : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? 2
                             : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT   ? 4
                                                                              : 0;
    if (size == 0) return refuse(m_file, "has indices that are no unsigned whole numbers");
    const Result<Elements> elements = elementsOf(m_model, accessorIndex, size, m_file);
    if (!elements) return elements.error();
    if (m_mesh.indices.size() + elements->count > 3 * kMaxTerrainVertices) {
      return refuse(m_file, "has more than " + std::to_string(kMaxTerrainVertices / 1'000'000) + " million triangles");
    }
    for (std::size_t i = 0; i < elements->count - elements->count % 3; ++i) {
      std::uint32_t index = 0;  // little endian, as the file is
      std::memcpy(&index, elements->bytes + i * elements->stride, size);
      if (index >= vertices) {
        return refuse(m_file, "has the index " + std::to_string(index) + ", but its mesh has only " +
                                  std::to_string(vertices) + " vertices");
      }
      m_mesh.indices.push_back(static_cast<std::uint32_t>(first) + index);
    }
    return Done{};
  }

  const tinygltf::Model& m_model;
  const fs::path& m_file;
  std::vector<bool> m_seen;
  TriangleMesh m_mesh;
};

// Samples looked at until the watch is asked again, a part of a second; a triangle itself counts as some.
constexpr std::size_t kWorkBetweenWatches = 10'000'000, kTriangleWork = 50;

constexpr float kNothing = std::numeric_limits<float>::lowest();

/// Raises the samples under a triangle to it and says how many were looked at. `a`, `b`, `c`: x and z in grid
/// coordinates, y in metres.
std::size_t drawTriangle(HeightSource& source, glm::dvec3 a, glm::dvec3 b, glm::dvec3 c) {
  const double area = (b.x - a.x) * (c.z - a.z) - (c.x - a.x) * (b.z - a.z);
  if (std::abs(area) < 1e-12) return 0;
  const auto bound = [](double x, double y, double z, int last, int& low, int& high) {
    low = std::max(0, static_cast<int>(std::ceil(std::min({x, y, z}) - 1e-6)));
    high = std::min(last, static_cast<int>(std::floor(std::max({x, y, z}) + 1e-6)));
  };
  int x0, x1, z0, z1;
  bound(a.x, b.x, c.x, source.samples.x - 1, x0, x1);
  bound(a.z, b.z, c.z, source.samples.y - 1, z0, z1);
  constexpr double kEdge = -1e-7;  // a sample on an edge belongs to both sides
  for (int k = z0; k <= z1; ++k) {
    for (int i = x0; i <= x1; ++i) {
      const double v = ((i - a.x) * (c.z - a.z) - (c.x - a.x) * (k - a.z)) / area;
      const double w = ((b.x - a.x) * (k - a.z) - (i - a.x) * (b.z - a.z)) / area;
      if (v < kEdge || w < kEdge || 1.0 - v - w < kEdge) continue;
      float& value = source.values[static_cast<std::size_t>(k) * static_cast<std::size_t>(source.samples.x) +
                                   static_cast<std::size_t>(i)];
      value = std::max(value, static_cast<float>(a.y + v * (b.y - a.y) + w * (c.y - a.y)));
    }
  }
  return static_cast<std::size_t>(std::max(0, x1 - x0 + 1)) * static_cast<std::size_t>(std::max(0, z1 - z0 + 1));
}

/// Samples without a triangle take the mean of their neighbours that have a height, from the rims of a hole inwards.
void fillHoles(HeightSource& source) {
  const int width = source.samples.x, depth = source.samples.y;
  const auto at = [&](int i, int k) -> float& {
    return source.values[static_cast<std::size_t>(k) * static_cast<std::size_t>(width) + static_cast<std::size_t>(i)];
  };
  std::vector<glm::ivec2> rim;
  const auto hasNeighbour = [&](int i, int k) {
    return (i > 0 && at(i - 1, k) != kNothing) || (i + 1 < width && at(i + 1, k) != kNothing) ||
           (k > 0 && at(i, k - 1) != kNothing) || (k + 1 < depth && at(i, k + 1) != kNothing);
  };
  for (int k = 0; k < depth; ++k) {
    for (int i = 0; i < width; ++i) {
      if (at(i, k) == kNothing && hasNeighbour(i, k)) rim.emplace_back(i, k);
    }
  }
  while (!rim.empty()) {
    std::vector<float> found;
    for (const glm::ivec2 p : rim) {
      double sum = 0;
      int count = 0;
      for (int k = std::max(0, p.y - 1); k <= std::min(depth - 1, p.y + 1); ++k) {
        for (int i = std::max(0, p.x - 1); i <= std::min(width - 1, p.x + 1); ++i) {
          if (at(i, k) == kNothing) continue;
          sum += static_cast<double>(at(i, k));
          ++count;
        }
      }
      found.push_back(static_cast<float>(sum / count));
    }
    for (std::size_t n = 0; n < rim.size(); ++n) at(rim[n].x, rim[n].y) = found[n];
    std::vector<glm::ivec2> next;
    for (const glm::ivec2 p : rim) {
      for (const glm::ivec2 way : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)}) {
        const glm::ivec2 q = p + way;
        if (q.x >= 0 && q.y >= 0 && q.x < width && q.y < depth && at(q.x, q.y) == kNothing) next.push_back(q);
      }
    }
    std::ranges::sort(next, {}, [](glm::ivec2 p) { return std::pair(p.y, p.x); });
    next.erase(std::unique(next.begin(), next.end()), next.end());
    rim = std::move(next);
  }
}

}  // namespace

Result<TriangleMesh> readMesh(const fs::path& file, const LoadWatch& watch) {
  const Result<tinygltf::Model> model = parseModel(file);
  if (!model) return model.error();
  if (watch && !watch("Gathering triangles")) return stopped();
  return Collector(*model, file).collect();
}

Result<std::shared_ptr<HeightSource>> heightsOfMesh(const TriangleMesh& mesh, const fs::path& file,
                                                    const LoadWatch& watch) {
  glm::vec3 low = mesh.vertices[mesh.indices.front()], high = low;
  for (const std::uint32_t index : mesh.indices) {
    low = glm::min(low, mesh.vertices[index]);
    high = glm::max(high, mesh.vertices[index]);
  }
  auto source = std::make_shared<HeightSource>();
  source->triangles = mesh.indices.size() / 3;
  source->low = {low.x, low.z};
  source->size = {high.x - low.x, high.z - low.z};
  const float longest = std::max(source->size.x, source->size.y), shortest = std::min(source->size.x, source->size.y);
  if (!(shortest > 1e-4f) || !(shortest > longest * 1e-3f))
    return refuse(file, "covers no ground: it is a wall or a line seen from above");
  const double along =
      std::clamp(2.0 * std::sqrt(0.5 * static_cast<double>(source->triangles)), 256.0, double(kMaxHeightSamples));
  source->samples = glm::max(glm::ivec2(glm::round(source->size / longest * static_cast<float>(along))), glm::ivec2(2));
  source->values.assign(static_cast<std::size_t>(source->samples.x) * static_cast<std::size_t>(source->samples.y),
                        kNothing);
  const glm::dvec2 perMetre = glm::dvec2(source->samples - 1) / glm::dvec2(source->size);
  const auto onGrid = [&](std::uint32_t index) {
    const glm::dvec3 at(mesh.vertices[index]);
    return glm::dvec3((at.x - static_cast<double>(low.x)) * perMetre.x, at.y,
                      (at.z - static_cast<double>(low.z)) * perMetre.y);
  };
  std::size_t work = kWorkBetweenWatches;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    if (watch && work >= kWorkBetweenWatches) {
      work = 0;
      const auto percent = 100 * t / mesh.indices.size();
      if (!watch("Making heights, " + std::to_string(percent) + "%")) return stopped();
    }
    work += kTriangleWork;
    work += drawTriangle(*source, onGrid(mesh.indices[t]), onGrid(mesh.indices[t + 1]), onGrid(mesh.indices[t + 2]));
  }
  if (std::ranges::all_of(source->values, [](float v) { return v == kNothing; }))
    return refuse(file, "covers no ground: all its triangles stand upright");
  fillHoles(*source);
  return source;
}

}  // namespace windloom
