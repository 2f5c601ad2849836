#include "editor/core/inspector_relevance.hpp"

#include <algorithm>
#include <iterator>

namespace windloom::editor {

bool isRelevant(const Arrow& arrow, std::string_view key) {
  return key != "response" || arrow.drive == Drive::Speed;
}

bool isRelevant(const Signal& signal, std::string_view key) {
  if (key == "on" || key == "release") return signal.kind == SignalKind::Pulse;
  if (key == "period") return signal.kind == SignalKind::Pulse || (signal.kind == SignalKind::Curve && signal.loop);
  if (key == "depth" || key == "rate" || key == "seed") return signal.kind == SignalKind::Gusts;
  return key != "loop" || signal.kind == SignalKind::Curve;
}

bool isRelevant(const Obstacle& obstacle, std::string_view key) {
  if (key == "radius") return obstacle.shape == ObstacleShape::Circle;
  if (key == "size") return obstacle.shape == ObstacleShape::Box;
  if (key == "rotation") return obstacle.shape != ObstacleShape::Circle;
  return true;
}

bool isRelevant(const Species& species, std::string_view key) {
  const bool mesh = species.shape == PlantShape::Mesh;
  if (key == "file") return mesh;
  if (key == "width" || key == "colours/base") return !mesh;
  return key != "patchSize" || species.patchiness > 0;
}

bool isRelevant(const Collider& collider, std::string_view key) {
  const bool mesh = collider.shape == ColliderShape::Mesh;
  if (key == "file" || key == "scale" || key == "spheres") return mesh;
  if (key == "radius") return !mesh;
  if (key == "length") return collider.shape == ColliderShape::Capsule;
  if (key == "rotation") return collider.shape != ColliderShape::Sphere;
  if (key == "loop") return collider.keys.size() > 1;
  return key != "roll" || (collider.shape == ColliderShape::Sphere && collider.keys.size() > 1);
}

bool isRelevant(const Surface& surface, std::string_view key) {
  const bool mesh = surface.shape == SurfaceShape::Mesh;
  if (key == "file" || key == "scale") return mesh;
  // What is closed has no backs to see.
  if (key == "bothSides") return mesh;
  return key != "size" || !mesh;
}

bool isRelevant(const SolverSettings& solver, std::string_view key) {
  if (key == "sweeps") return solver.pressure == Pressure::Jacobi;
  return (key != "maxCycles" && key != "divergenceTolerance") || solver.pressure == Pressure::Multigrid;
}

bool isRelevant(const TerrainSettings& terrain, std::string_view key) {
  if (key == "size" || key == "height") return terrain.kind == TerrainKind::HeightMap;
  if (key == "scale") return terrain.kind == TerrainKind::Mesh;
  return (key != "centre" && key != "base") || terrain.kind != TerrainKind::Flat;
}

bool isRelevant(const GrassSettings& grass, std::string_view key) {
  if (grass.kind == GrassKind::None) return key == "kind";
  if (grass.kind == GrassKind::Bezier) {
    // Its blades move by forces of their own, see BezierSettings.
    constexpr std::string_view kOfInstanced[] = {"deformation", "windFactor", "restBlend", "flutter", "interacting"};
    return std::ranges::find(kOfInstanced, key) == std::end(kOfInstanced) && !key.starts_with("droop/") &&
           !key.starts_with("swing/");
  }
  if (grass.kind == GrassKind::Shell) {
    // One texture stands for all blades: none has a stiffness, a pose or a memory of its own.
    constexpr std::string_view kOfSingleBlades[] = {"deformation", "stiffnessVariation", "restBlend", "interacting"};
    return std::ranges::find(kOfSingleBlades, key) == std::end(kOfSingleBlades) && !key.starts_with("droop/") &&
           !key.starts_with("swing/");
  }
  // Blades that objects bent swing whatever the others do.
  const bool inertial = grass.deformation == Deformation::Inertial;
  if (key == "swing/exponent") return inertial;
  if (key.starts_with("swing/")) return inertial || grass.interacting > 0;
  return key != "restBlend" || grass.deformation == Deformation::Quadratic;
}

bool isRelevant(const BezierSettings& bezier, std::string_view key) {
  if (key == "tufts/spacing" || key == "tufts/radius") return bezier.tufts > 0;
  if (key == "blade/tip") return bezier.form == BladeForm::TriangleTip;
  if (key == "gravity/direction" || key == "gravity/strength") return bezier.centreBlend < 1;
  if (key == "gravity/centre" || key == "gravity/centreStrength") return bezier.centreBlend > 0;
  if (key == "collision/fade") return bezier.collisionStrength > 0;
  return !key.starts_with("wind/wave") || bezier.wind != BezierWind::Field;
}

bool isRelevant(const ShellSettings& shell, std::string_view key) {
  // A picture has its blades already.
  if (key == "texture/fullness" || key == "texture/thickness" || key == "texture/taper") return shell.texture.empty();
  if (key == "wind/strength") return shell.wind != ShellWind::Source;
  const bool ofRings = key.starts_with("wind/source") && key != "wind/source";
  return !ofRings || shell.wind != ShellWind::Field;
}

}  // namespace windloom::editor
