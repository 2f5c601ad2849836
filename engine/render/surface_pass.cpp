#include "engine/render/surface_pass.hpp"

#include "engine/gpu/debug_group.hpp"
#include "engine/model/surface_pose.hpp"
#include "engine/model/surface_shapes.hpp"
#include "engine/render/render_programs.hpp"

namespace windloom {

Result<SurfacePass> SurfacePass::create(gpu::ShaderLibrary& shaders) {
  SurfacePass pass;
  if (Status loaded = loadPrograms(shaders, {{"terrain/surface", &pass.m_program}}); !loaded) return loaded.error();
  return pass;
}

Status SurfacePass::configure(const std::vector<Surface>& surfaces, const HeightField* ground) {
  std::vector<Shown> shown;
  std::vector<std::shared_ptr<const PlantMesh>> meshes;
  for (const Surface& surface : surfaces) {
    if (surface.hidden) continue;
    std::shared_ptr<const PlantMesh> mesh = surfaceMesh(surface);
    if (!mesh || mesh->indices.empty()) continue;
    meshes.push_back(mesh);
    shown.push_back({std::move(mesh), surfacePose(surface, ground), surface.colour});
  }
  if (Status configured = m_meshes.configure(meshes); !configured) return configured;
  m_shown = std::move(shown);
  return Done{};
}

void SurfacePass::draw(const gpu::PassState& state) const {
  if (!any()) return;
  const gpu::DebugGroup group("surfaces");
  gpu::apply(state);
  m_program->use();
  for (const Shown& surface : m_shown) {
    m_program->set("world", surface.world);
    m_program->set("surfaceColour", surface.colour);
    m_meshes.find(surface.mesh)->draw();
  }
}

}  // namespace windloom
