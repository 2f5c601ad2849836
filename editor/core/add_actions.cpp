// The actions that put species, colliders, surfaces and rotors into the project.
#include <algorithm>

#include "editor/core/action_adder.hpp"
#include "editor/core/collider_shape.hpp"
#include "editor/core/object_edits.hpp"
#include "editor/core/surface_shape.hpp"
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

void addSurface(Workspace& w, SurfaceShape shape) {
  Surface surface;
  surface.shape = shape;
  surface.position = freePlace(w, reachOf(surface));
  const AddResult added = addSurfaceEdit(w.document.committed(), std::move(surface));
  if (!w.apply(added.edit)) return;
  w.selection.replace(added.id);
  const GrassKind kind = w.document.project().grass->kind;
  if (kind != GrassKind::Bezier && kind != GrassKind::Shell)
    w.say(MessageKind::Info, "Only Bezier and shell grass grow on surfaces: keys 2 and 3 switch to them");
}

void addRotor(Workspace& w) {
  Rotor rotor;
  rotor.position = freePlace(w, rotor.radius);
  const AddResult added = addRotorEdit(w.document.committed(), std::move(rotor));
  if (w.apply(added.edit)) w.selection.replace(added.id);
}

void addSurfaceActions(Adder& add) {
  const auto surface = [&](const char* id, const char* label, const char* help, SurfaceShape shape) {
    add.always(id, label, help, {}, [shape](Workspace& w) { addSurface(w, shape); });
  };
  surface("add.moebius", "Add surface: Moebius band", "A twisted band with grass all over its one side",
          SurfaceShape::Moebius);
  surface("add.torus", "Add surface: ring", "A torus with grass all over it", SurfaceShape::Torus);
  surface("add.sphere", "Add surface: ball", "A ball with grass all over it", SurfaceShape::Sphere);
  surface("add.hare", "Add surface: hare", "A sitting hare with a coat of grass", SurfaceShape::Hare);
}

}  // namespace

glm::vec2 freePlace(Workspace& w, float reachM) {
  const glm::vec3 target = w.camera.target;
  glm::vec2 place = w.context().groundAt(0.5f * w.viewportSize).value_or(glm::vec2(target.x, target.z));
  const Project& project = w.document.committed();
  constexpr float kGapM = 0.01f;
  const auto there = [&](const auto& others) {
    return std::ranges::any_of(others, [&](const auto& one) { return glm::distance(one.position, place) < kGapM; });
  };
  while (there(*project.colliders) || there(*project.surfaces) || there(*project.rotors))
    place.x += 2.0f * reachM + kGapM;
  return place;
}

void addAddActions(Workspace& workspace) {
  Adder add(workspace, "Add");
  add.always("add.collider", "Add collider", "A ball in the middle of the view that bends the grass", {"C"},
             addCollider);
  add.always("add.rotor", "Add rotor", "A helicopter's rotor that blows air down in the middle of the view", {},
             addRotor);
  addSurfaceActions(add);
  const auto species = [&](const char* id, const char* label, const char* help, PlantShape shape) {
    add.always(id, label, help, {}, [shape](Workspace& w) { addSpecies(w, shape); });
  };
  species("add.tall_grass", "Add species: tall grass", "Longer blades among the meadow's own", PlantShape::Blade);
  species("add.daisies", "Add species: daisies", "White flowers on stems", PlantShape::Daisy);
  species("add.poppies", "Add species: poppies", "Red cups on stems", PlantShape::Poppy);
  species("add.spikes", "Add species: flower spikes", "Flowers along the upper part of a stem", PlantShape::Spike);
}

}  // namespace windloom::editor
