#pragma once
// The described structs; see parameter.hpp. The order is the order of the project file.

#include "engine/model/parameter.hpp"
#include "engine/model/project.hpp"

namespace windloom {

template <>
std::span<const Parameter<FieldSettings>> parametersOf<FieldSettings>();
template <>
std::span<const Parameter<SolverSettings>> parametersOf<SolverSettings>();
template <>
std::span<const Parameter<AmbientWind>> parametersOf<AmbientWind>();
template <>
std::span<const Parameter<Point>> parametersOf<Point>();
template <>
std::span<const Parameter<Arrow>> parametersOf<Arrow>();
template <>
std::span<const Parameter<Signal>> parametersOf<Signal>();  // all but `keys`
template <>
std::span<const Parameter<Obstacle>> parametersOf<Obstacle>();  // all but `points`
template <>
std::span<const Parameter<Species>> parametersOf<Species>();
template <>
std::span<const Parameter<Collider>> parametersOf<Collider>();  // all but `keys`
template <>
std::span<const Parameter<Surface>> parametersOf<Surface>();
template <>
std::span<const Parameter<Rotor>> parametersOf<Rotor>();
template <>
std::span<const Parameter<Probe>> parametersOf<Probe>();
template <>
std::span<const Parameter<Camera>> parametersOf<Camera>();
template <>
std::span<const Parameter<TerrainSettings>> parametersOf<TerrainSettings>();
template <>
std::span<const Parameter<GrassSettings>> parametersOf<GrassSettings>();
template <>
std::span<const Parameter<BezierSettings>> parametersOf<BezierSettings>();
template <>
std::span<const Parameter<ShellSettings>> parametersOf<ShellSettings>();

/// Project::name, which stands by itself.
inline constexpr ParameterInfo kProjectName{
    .key = "name", .label = "Name", .unit = "", .help = "Name of the project.", .type = ParameterType::Text};

}  // namespace windloom
