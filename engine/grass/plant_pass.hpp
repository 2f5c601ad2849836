#pragma once
// Species of the meadow other than blades: built-in flowers and meshes. place_plants.comp makes them cell by cell,
// indirect draws draw them, a mesh near and a smaller one far. Nothing about a plant is kept or crosses the bus.

#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/grass/plant_layout.hpp"

namespace windloom {

class PlantPass {
 public:
  /// Fails with Machine.
  static Result<PlantPass> create(gpu::ShaderLibrary& shaders);

  /// Takes over species; meshes that stay the same are not uploaded again. Fails with Machine; the plants then stay as
  /// they were.
  Status configure(const FieldSettings& field, const GrassSettings& grass, const std::vector<Species>& species);

  /// Places the plants. Frame block, grass settings and maps, wind, noise, ground and solid textures must be bound.
  void prepare(const PlantView& view);

  /// Draws into the target of `state`; its coverage is set here.
  void draw(const gpu::PassState& state);

  /// The plants of a species (its place in the list of configure()) that prepare() placed; waits for the GPU: for
  /// tests.
  std::vector<shared::PlantInstance> placed(std::size_t species) const;

 private:
  struct Kind {
    std::size_t index = 0;  // in the project's list
    Species made;           // what the buffers were made from
    PlantKind block{};
    gpu::Buffer vertices, indices;
    gpu::Texture texture;
    gpu::VertexArray array;
    std::uint32_t count[PLANT_LEVELS] = {}, firstIndex[PLANT_LEVELS] = {}, baseVertex[PLANT_LEVELS] = {};
    PlantMeshSummary mesh;
  };

  PlantPass() = default;
  static Status makeMesh(Kind& kind, const Species& species);
  static Status upload(Kind& kind, const PlantMesh& near, const PlantMesh& far);
  static Status makeTexture(Kind& kind, const PlantMesh& mesh);
  Status makeRoom(std::vector<PlantKind>& blocks, const FieldSettings& field);
  void bindPlants(Kind& kind) const;

  gpu::Program* m_place = nullptr;
  gpu::Program* m_plain = nullptr;
  gpu::Program* m_textured = nullptr;
  gpu::Buffer m_plants, m_commands, m_blocks;
  std::vector<Kind> m_kinds;
  FieldSettings m_field;
};

}  // namespace windloom
