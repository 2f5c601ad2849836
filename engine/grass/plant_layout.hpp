#pragma once
// How many plants of each species stand where, and what their shaders need to know about it. Pure arithmetic.
//
// The world is cut into square cells, a size for each species; a cell's plants follow from hashes of the cell, their
// index and the species, so that they stay where they are whatever the camera does. Those of a cell are ordered so that
// any first part of them covers it evenly.

#include <vector>

#include "engine/model/project.hpp"
#include "shaders/shared/plant_block.h"

namespace windloom {

using shared::PlantKind;

/// Part of GrassSettings::density that the meadow's own blades have: 1 over 1 plus all weights. Hidden species count,
/// too, so that hiding one doesn't move the others.
float ownShare(const std::vector<Species>& species);
/// Plants of a species per m^2, where nothing thins them out.
float plantDensity(const GrassSettings& grass, const std::vector<Species>& species, std::size_t index);

/// Species that are drawn from meshes: shown, not blades, with a density, and where they need a file, read.
std::vector<std::size_t> meshSpecies(const GrassSettings& grass, const std::vector<Species>& species);

/// What the camera is to the plants.
struct PlantView {
  glm::vec3 eye{0.0f};  ///< m; perspective
  bool orthographic = false;
  float pixelScale = 1.0f;  ///< pixels a metre covers at 1 m (perspective) or anywhere (orthographic)
  float detail = 1.0f;      ///< as FrameQuality
  bool thinning = true, culling = true;
};

/// A rectangle of cells.
struct PlantCells {
  glm::ivec2 first{0}, count{0};
};
/// The cells of a species over the field and its margin, those within its reach of the eye.
PlantCells cellsInReach(const PlantKind& kind, const FieldSettings& field, const PlantView& view);

/// What the layout needs to know of a mesh.
struct PlantMeshSummary {
  glm::vec3 low{0.0f}, high{0.0f};  ///< bounds
  std::size_t triangles = 0;
  float alphaCutoff = 0.5f;
};

/// The shaders' view of a species; `mesh` is what it is drawn from. `first` and `room` are left 0.
PlantKind makePlantKind(const GrassSettings& grass, const std::vector<Species>& species, std::size_t index,
                        const PlantMeshSummary& mesh);

/// Most plants of a species that can be drawn at once in each level.
glm::uvec2 plantRoom(const PlantKind& kind, const FieldSettings& field);

}  // namespace windloom
