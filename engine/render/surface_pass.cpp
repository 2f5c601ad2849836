#include "engine/render/surface_pass.hpp"

#include "engine/gpu/debug_group.hpp"
#include "engine/model/surface_pose.hpp"
#include "engine/model/surface_shapes.hpp"
#include "engine/render/render_programs.hpp"
#include "engine/render/surface_shade.hpp"

namespace windloom {
namespace {

constexpr std::size_t kShades = 28;  // spheres of a surface

}  // namespace

Result<SurfacePass> SurfacePass::create(gpu::ShaderLibrary& shaders) {
  SurfacePass pass;
  if (Status loaded = loadPrograms(shaders, {{"terrain/surface", &pass.m_program}}); !loaded) return loaded.error();
  return pass;
}

Status SurfacePass::configure(const std::vector<Surface>& surfaces, const HeightField* ground) {
  std::vector<Shown> shown;
  std::vector<glm::vec4> shades;
  std::vector<std::shared_ptr<const PlantMesh>> meshes;
  for (const Surface& surface : surfaces) {
    if (surface.hidden) continue;
    std::shared_ptr<const PlantMesh> mesh = surfaceMesh(surface);
    if (!mesh || mesh->indices.empty()) continue;
    const glm::mat4 world = surfacePose(surface, ground);
    const std::vector<glm::vec4> own = surfaceShades(*mesh, world, kShades);
    shades.insert(shades.end(), own.begin(), own.end());
    meshes.push_back(mesh);
    shown.push_back({surface, std::move(mesh), world});
  }
  if (Status configured = m_meshes.configure(meshes); !configured) return configured;
  m_shown = std::move(shown);
  m_shades = std::move(shades);
  return Done{};
}

void SurfacePass::draw(const gpu::PassState& state) const {
  if (!any()) return;
  const gpu::DebugGroup group("surfaces");
  gpu::apply(state);
  m_program->use();
  each([&](const Surface& surface, const glm::mat4& world, const ObjectMesh& mesh) {
    m_program->set("world", world);
    m_program->set("surfaceColour", surface.colour);
    mesh.draw();
  });
}

}  // namespace windloom
