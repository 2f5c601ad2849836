#pragma once
// Which parameters have an effect as the others stand: the inspector dims the rest.

#include <string_view>

#include "engine/model/project.hpp"

namespace windloom::editor {

bool isRelevant(const Arrow& arrow, std::string_view key);
bool isRelevant(const Signal& signal, std::string_view key);
bool isRelevant(const Obstacle& obstacle, std::string_view key);
bool isRelevant(const Species& species, std::string_view key);
bool isRelevant(const Collider& collider, std::string_view key);
bool isRelevant(const Surface& surface, std::string_view key);
bool isRelevant(const SolverSettings& solver, std::string_view key);
bool isRelevant(const TerrainSettings& terrain, std::string_view key);
bool isRelevant(const GrassSettings& grass, std::string_view key);
bool isRelevant(const BezierSettings& bezier, std::string_view key);
bool isRelevant(const ShellSettings& shell, std::string_view key);

template <class Owner>
bool isRelevant(const Owner&, std::string_view) {
  return true;
}

}  // namespace windloom::editor
