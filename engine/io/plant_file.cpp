#include "engine/io/plant_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>

#include "engine/core/out_of_memory.hpp"
#include "engine/io/gltf_file.hpp"
#include "engine/io/plant_texture.hpp"
#include "engine/model/sphere_packing.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using gltf::refuse;

/// One component of an attribute, 0..1 where it is a whole number.
float componentAt(const unsigned char* bytes, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return static_cast<float>(*bytes) / 255.0f;
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
    std::uint16_t value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<float>(value) / 65535.0f;
  }
  float value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

class PlantReader {
 public:
  PlantReader(const tinygltf::Model& model, const fs::path& file, MeshUse use)
      : m_model(model), m_file(file), m_use(use) {
    m_mostTriangles = use == MeshUse::Plant    ? kMaxPlantTriangles
                      : use == MeshUse::Object ? kMaxObjectTriangles
                                               : kMaxSurfaceTriangles;
  }

  Result<std::shared_ptr<PlantMesh>> read() {
    Result<std::vector<gltf::PlacedMesh>> placed = gltf::meshesOfScene(m_model, m_file);
    if (!placed) return placed.error();
    if (m_use != MeshUse::Surface) {
      if (Status gathered = gatherMaterials(*placed); !gathered) return gathered.error();
    }
    for (const gltf::PlacedMesh& one : *placed) {
      for (const tinygltf::Primitive& primitive : m_model.meshes[one.mesh].primitives) {
        if (!drawn(primitive)) continue;
        if (Status added = addPrimitive(primitive, one.world); !added) return added.error();
      }
    }
    if (m_mesh->indices.empty()) return refuse(m_file, "has no triangles in its scene");
    if (Status bounded = bound(); !bounded) return bounded.error();
    return m_mesh;
  }

 private:
  static bool drawn(const tinygltf::Primitive& primitive) {
    return gltf::isTriangles(primitive) && primitive.attributes.contains("POSITION");
  }

  Status gatherMaterials(const std::vector<gltf::PlacedMesh>& placed) {
    for (const gltf::PlacedMesh& one : placed) {
      for (const tinygltf::Primitive& primitive : m_model.meshes[one.mesh].primitives) {
        if (m_used.size() > gltf::kMaxMaterials) break;  // refused below; so many are not looked up one by one
        const bool known = std::ranges::find(m_used, primitive.material) != m_used.end();
        if (drawn(primitive) && !known) m_used.push_back(primitive.material);
      }
    }
    Result<std::vector<gltf::PlantMaterial>> made = gltf::packMaterials(m_model, m_used, m_file, *m_mesh);
    if (!made) return made.error();
    m_materials = std::move(*made);
    return Done{};
  }

  gltf::PlantMaterial materialOf(const tinygltf::Primitive& primitive) const {
    if (m_materials.empty()) return {};
    return m_materials[static_cast<std::size_t>(std::ranges::find(m_used, primitive.material) - m_used.begin())];
  }

  Status addPrimitive(const tinygltf::Primitive& primitive, const glm::dmat4& world) {
    const std::size_t first = m_mesh->vertices.size(), firstIndex = m_mesh->indices.size();
    std::vector<glm::vec3> places;
    const std::size_t room = 3 * m_mostTriangles - first;
    Status added = gltf::appendPositions(m_model, primitive.attributes.at("POSITION"), world, room, m_file, places);
    if (!added) return added;
    added = gltf::appendIndices(m_model, primitive.indices, first, places.size(), 3 * m_mostTriangles, m_file,
                                m_mesh->indices);
    if (!added) return added;
    // Without indices nothing above has counted triangles.
    if (m_mesh->indices.size() > 3 * m_mostTriangles)
      return refuse(m_file, "has more than " + std::to_string(m_mostTriangles) + " triangles");
    for (const glm::vec3 place : places) m_mesh->vertices.push_back({.position = place});
    // A mirrored node would turn every triangle over.
    if (glm::determinant(glm::dmat3(world)) < 0) {
      for (std::size_t i = firstIndex; i + 2 < m_mesh->indices.size(); i += 3)
        std::swap(m_mesh->indices[i + 1], m_mesh->indices[i + 2]);
    }
    added = addNormals(primitive, world, first, firstIndex);
    if (!added || m_use == MeshUse::Surface) return added;
    added = addCoordinates(primitive, first);
    return added ? addColours(primitive, first) : added;
  }

  /// Reads up to 4 components of each vertex; false where the attribute isn't there.
  Result<bool> readAttribute(const tinygltf::Primitive& primitive, const std::string& name, int leastParts,
                             std::size_t count, std::vector<glm::vec4>& into) {
    const auto found = primitive.attributes.find(name);
    if (found == primitive.attributes.end()) return false;
    const auto bad = [&](const char* text) { return refuse(m_file, "has a " + name + " that " + text); };
    if (found->second < 0 || static_cast<std::size_t>(found->second) >= m_model.accessors.size())
      return bad("is not there");
    const tinygltf::Accessor& accessor = m_model.accessors[static_cast<std::size_t>(found->second)];
    const int parts = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    const int bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    const bool known = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                       accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                       accessor.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    if (!known || parts < leastParts || parts > 4) return bad("has a type it can't have");
    const Result<gltf::Elements> elements =
        gltf::elementsOf(m_model, found->second, static_cast<std::size_t>(parts * bytes), gltf::kMaxBytes, m_file);
    if (!elements) return elements.error();
    if (elements->count != count) return bad("has another number of values than there are positions");
    into.assign(count, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    for (std::size_t i = 0; i < count; ++i) {
      for (int part = 0; part < parts; ++part) {
        const unsigned char* at = elements->bytes + i * elements->stride + static_cast<std::size_t>(part * bytes);
        const float value = componentAt(at, accessor.componentType);
        if (!std::isfinite(value)) return bad("holds a value that is not finite");
        into[i][part] = value;
      }
    }
    return true;
  }

  Status addNormals(const tinygltf::Primitive& primitive, const glm::dmat4& world, std::size_t first,
                    std::size_t firstIndex) {
    std::vector<PlantVertex>& vertices = m_mesh->vertices;
    std::vector<glm::vec4> values;
    const Result<bool> there = readAttribute(primitive, "NORMAL", 3, vertices.size() - first, values);
    if (!there) return there.error();
    if (*there) {
      const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(world)));
      for (std::size_t i = 0; i < values.size(); ++i)
        vertices[first + i].normal = glm::vec3(turn * glm::dvec3(values[i]));
    } else {
      for (std::size_t i = first; i < vertices.size(); ++i) vertices[i].normal = glm::vec3(0.0f);
      for (std::size_t i = firstIndex; i + 2 < m_mesh->indices.size(); i += 3) {
        PlantVertex& a = vertices[m_mesh->indices[i]];
        PlantVertex& b = vertices[m_mesh->indices[i + 1]];
        PlantVertex& c = vertices[m_mesh->indices[i + 2]];
        const glm::vec3 area = glm::cross(b.position - a.position, c.position - a.position);
        a.normal += area;
        b.normal += area;
        c.normal += area;
      }
    }
    for (std::size_t i = first; i < vertices.size(); ++i) {
      const float size = glm::length(vertices[i].normal);
      vertices[i].normal = size > 1e-20f && std::isfinite(size) ? vertices[i].normal / size : glm::vec3(0, 1, 0);
    }
    return Done{};
  }

  Status addCoordinates(const tinygltf::Primitive& primitive, std::size_t first) {
    const gltf::PlantMaterial material = materialOf(primitive);
    std::vector<PlantVertex>& vertices = m_mesh->vertices;
    std::vector<glm::vec4> values;
    if (material.texCoord >= 0) {
      const std::string name = "TEXCOORD_" + std::to_string(material.texCoord);
      const Result<bool> there = readAttribute(primitive, name, 2, vertices.size() - first, values);
      if (!there) return there.error();
      if (!*there) return refuse(m_file, "has a texture, but no " + name + " to place it");
    }
    for (std::size_t i = first; i < vertices.size(); ++i) {
      glm::vec2 uv(0.5f);
      if (material.texCoord >= 0) uv = glm::vec2(material.transform * glm::vec3(glm::vec2(values[i - first]), 1.0f));
      if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
        return refuse(m_file, "has a texture that is moved or scaled beyond all measure");
      constexpr float kSlack = 0.01f;
      if (!material.alone && (std::min(uv.x, uv.y) < -kSlack || std::max(uv.x, uv.y) > 1.0f + kSlack)) {
        return refuse(m_file, "has several textures and repeats one of them: use one texture, or coordinates in 0..1");
      }
      vertices[i].uv = material.alone ? uv : material.low + glm::clamp(uv, 0.0f, 1.0f) * material.size;
    }
    return Done{};
  }

  Status addColours(const tinygltf::Primitive& primitive, std::size_t first) {
    const glm::vec4 factor = materialOf(primitive).colour;
    std::vector<PlantVertex>& vertices = m_mesh->vertices;
    std::vector<glm::vec4> values;
    const Result<bool> there = readAttribute(primitive, "COLOR_0", 3, vertices.size() - first, values);
    if (!there) return there.error();
    for (std::size_t i = first; i < vertices.size(); ++i)
      vertices[i].colour = *there ? factor * values[i - first] : factor;
    return Done{};
  }

  Status bound() {
    PlantMesh& mesh = *m_mesh;
    mesh.low = mesh.high = mesh.vertices[mesh.indices.front()].position;
    for (const std::uint32_t index : mesh.indices) {
      mesh.low = glm::min(mesh.low, mesh.vertices[index].position);
      mesh.high = glm::max(mesh.high, mesh.vertices[index].position);
    }
    const glm::vec3 size = mesh.high - mesh.low;
    const float longest = std::max({size.x, size.y, size.z});
    if (longest > 1000.0f || longest < 1e-4f)
      return refuse(m_file, "is " + std::to_string(longest) + " m large, expected 0.1 mm to 1 km");
    if (m_use == MeshUse::Plant && (mesh.high.y < 1e-4f || mesh.high.y < 0.01f * longest))
      return refuse(m_file, "doesn't rise over its root: y must be up and the root at the origin");
    if (m_use == MeshUse::Surface && area() <= 0)
      return refuse(m_file, "has no area that grass could grow on: all its triangles are points or lines");
    return Done{};
  }

  double area() const {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < m_mesh->indices.size(); i += 3) {
      const auto at = [&](std::size_t k) { return glm::dvec3(m_mesh->vertices[m_mesh->indices[i + k]].position); };
      sum += 0.5 * glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    return sum;
  }

  const tinygltf::Model& m_model;
  const fs::path& m_file;
  MeshUse m_use;
  std::size_t m_mostTriangles = 0;
  std::vector<int> m_used;  // materials
  std::vector<gltf::PlantMaterial> m_materials;
  std::shared_ptr<PlantMesh> m_mesh = std::make_shared<PlantMesh>();
};

bool isGltf(const fs::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".glb" || ending == ".gltf";
}

}  // namespace

Result<std::shared_ptr<PlantMesh>> readPlantFile(const fs::path& file, MeshUse use, const FileAccess& access) {
  if (!isGltf(file)) return refuse(file, "is no mesh, expected a glTF file (.glb or .gltf)");
  return orOutOfMemory(file.string(), [&]() -> Result<std::shared_ptr<PlantMesh>> {
    const Result<tinygltf::Model> model =
        gltf::parse(file, use == MeshUse::Surface ? gltf::Pictures::Leave : gltf::Pictures::Keep, access);
    if (!model) return model.error();
    Result<std::shared_ptr<PlantMesh>> mesh = PlantReader(*model, file, use).read();
    if (mesh && use == MeshUse::Object) (*mesh)->spheres = packSpheres(**mesh);
    return mesh;
  });
}

}  // namespace windloom
