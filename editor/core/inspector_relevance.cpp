#include "editor/core/inspector_relevance.hpp"

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
  if (key == "file" || key == "scale") return mesh;
  if (key == "radius") return !mesh;
  if (key == "length") return collider.shape == ColliderShape::Capsule;
  if (key == "rotation") return collider.shape != ColliderShape::Sphere;
  if (key == "loop") return collider.keys.size() > 1;
  return key != "roll" || (collider.shape == ColliderShape::Sphere && collider.keys.size() > 1);
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
  // Blades that objects bent swing whatever the others do.
  const bool inertial = grass.deformation == Deformation::Inertial;
  if (key == "swing/exponent") return inertial;
  if (key.starts_with("swing/")) return inertial || grass.interacting > 0;
  return key != "restBlend" || grass.deformation == Deformation::Quadratic;
}

}  // namespace windloom::editor
