// The actions that put species and colliders into the project.
#include <algorithm>

#include "editor/core/action_adder.hpp"
#include "editor/core/collider_shape.hpp"
#include "editor/core/object_edits.hpp"
#include "engine/model/species_presets.hpp"

namespace windloom::editor {
namespace {

void addCollider(Workspace& w) {
  Collider collider;
  collider.position = freePlace(w, reachOf(collider));
  const AddResult added = addColliderEdit(w.document.committed(), std::move(collider));
  if (w.apply(added.edit)) w.selection.replace(added.id);
}

void addSpecies(Workspace& w, PlantShape shape) {
  const AddResult added = addSpeciesEdit(w.document.committed(), speciesPreset(shape));
  if (w.apply(added.edit)) w.selection.replace(added.id);
}

}  // namespace

glm::vec2 freePlace(Workspace& w, float reachM) {
  const glm::vec3 target = w.camera.target;
  glm::vec2 place = w.context().groundAt(0.5f * w.viewportSize).value_or(glm::vec2(target.x, target.z));
  const std::vector<Collider>& others = *w.document.committed().colliders;
  constexpr float kGapM = 0.01f;
  while (std::ranges::any_of(others, [&](const Collider& c) { return glm::distance(c.position, place) < kGapM; })) {
    place.x += 2.0f * reachM + kGapM;
  }
  return place;
}

void addAddActions(Workspace& workspace) {
  Adder add(workspace, "Add");
  add.always("add.collider", "Add collider", "A ball in the middle of the view that bends the grass", {"C"},
             addCollider);
  const auto species = [&](const char* id, const char* label, const char* help, PlantShape shape) {
    add.always(id, label, help, {}, [shape](Workspace& w) { addSpecies(w, shape); });
  };
  species("add.tall_grass", "Add species: tall grass", "Longer blades among the meadow's own", PlantShape::Blade);
  species("add.daisies", "Add species: daisies", "White flowers on stems", PlantShape::Daisy);
  species("add.poppies", "Add species: poppies", "Red cups on stems", PlantShape::Poppy);
  species("add.spikes", "Add species: flower spikes", "Flowers along the upper part of a stem", PlantShape::Spike);
}

}  // namespace windloom::editor
