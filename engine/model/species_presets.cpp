#include "engine/model/species_presets.hpp"

namespace windloom {

Species speciesPreset(PlantShape shape) {
  Species species;
  species.shape = shape;
  // Flowers stand over the meadow's blades, few to each of them.
  const auto flower = [&](const char* name, float height, float width, float weight, glm::vec3 petals) {
    species.name = name;
    species.height = height;
    species.heightVariation = 0.25f;
    species.width = width;
    species.weight = weight;
    species.stiffness = 1.6f;
    species.patchiness = 0.7f;
    species.tipColour = petals;
  };
  switch (shape) {
    case PlantShape::Blade:
      species.name = "tall grass";
      species.height = 1.0f;
      species.tipColour = {0.42f, 0.38f, 0.14f};
      break;
    case PlantShape::Daisy:
      flower("daisies", 0.5f, 0.006f, 0.03f, {0.88f, 0.88f, 0.84f});
      break;
    case PlantShape::Poppy:
      flower("poppies", 0.65f, 0.007f, 0.02f, {0.68f, 0.02f, 0.01f});
      break;
    case PlantShape::Spike:
      flower("flower spikes", 0.9f, 0.009f, 0.03f, {0.24f, 0.09f, 0.5f});
      break;
    case PlantShape::Mesh:
      species.tipColour = glm::vec3(1.0f);
      break;
  }
  return species;
}

}  // namespace windloom
