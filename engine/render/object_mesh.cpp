#include "engine/render/object_mesh.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstddef>

namespace windloom {
namespace {

Result<gpu::Texture> makeTexture(const PlantMesh& mesh) {
  Result<gpu::Texture> texture = gpu::Texture::create2D(
      "object texture", mesh.textureSize, GL_SRGB8_ALPHA8,
      {.levels = 0, .filter = gpu::Filter::Trilinear, .wrap = gpu::Wrap::Repeat, .anisotropy = 8.0f});
  if (!texture) return texture;
  texture->upload(GL_RGBA, GL_UNSIGNED_BYTE, mesh.texture.data());
  texture->generateMipmaps();
  return texture;
}

Result<ObjectMesh> makeObject(const std::shared_ptr<const PlantMesh>& mesh) {
  ObjectMesh object;
  object.mesh = mesh;
  Result<gpu::Buffer> vertices = gpu::Buffer::create("object vertices", std::span<const PlantVertex>(mesh->vertices));
  if (!vertices) return vertices.error();
  Result<gpu::Buffer> indices = gpu::Buffer::create("object indices", std::span<const std::uint32_t>(mesh->indices));
  if (!indices) return indices.error();
  object.vertices = std::move(*vertices);
  object.indices = std::move(*indices);
  object.array = gpu::VertexArray::create("object mesh");
  object.array.vertexBuffer(0, object.vertices, sizeof(PlantVertex));
  object.array.floats(0, 0, 3, offsetof(PlantVertex, position));
  object.array.floats(1, 0, 3, offsetof(PlantVertex, normal));
  object.array.floats(2, 0, 2, offsetof(PlantVertex, uv));
  object.array.floats(3, 0, 4, offsetof(PlantVertex, colour));
  object.array.indexBuffer(object.indices);
  if (mesh->texture.empty()) return object;
  Result<gpu::Texture> texture = makeTexture(*mesh);
  if (!texture) return texture.error();
  object.texture = std::move(*texture);
  return object;
}

}  // namespace

void ObjectMesh::draw(int instances) const {
  array.bind();
  const auto count = static_cast<GLsizei>(mesh->indices.size());
  glDrawElementsInstanced(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr, instances);
}

Status ObjectMeshes::configure(std::span<const std::shared_ptr<const PlantMesh>> meshes) {
  std::vector<ObjectMesh> wanted;
  for (const std::shared_ptr<const PlantMesh>& mesh : meshes) {
    if (!mesh || mesh->indices.empty()) continue;
    if (std::ranges::find(wanted, mesh, &ObjectMesh::mesh) != wanted.end()) continue;
    const auto kept = std::ranges::find(m_meshes, mesh, &ObjectMesh::mesh);
    if (kept != m_meshes.end()) {
      wanted.push_back(std::move(*kept));
      kept->mesh.reset();
      continue;
    }
    Result<ObjectMesh> made = makeObject(mesh);
    if (!made) {
      std::erase_if(m_meshes, [](const ObjectMesh& object) { return object.mesh == nullptr; });
      return made.error();
    }
    wanted.push_back(std::move(*made));
  }
  m_meshes = std::move(wanted);
  return Done{};
}

const ObjectMesh* ObjectMeshes::find(const std::shared_ptr<const PlantMesh>& mesh) const {
  const auto found = std::ranges::find(m_meshes, mesh, &ObjectMesh::mesh);
  return found != m_meshes.end() ? &*found : nullptr;
}

}  // namespace windloom
