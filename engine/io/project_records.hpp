#pragma once
// What reader, writer and schema must agree on beyond the parameter tables.

#include <array>
#include <span>
#include <string_view>

#include "engine/model/project.hpp"

namespace windloom {

/// Top-level keys in the order of the file. "colliders" is reserved: it has no meaning yet, is kept
/// verbatim and is not reported as unknown.
inline constexpr std::array<std::string_view, 13> kProjectKeys{"format",    "version", "name",      "field",   "solver",
                                                               "ambient",   "graph",   "obstacles", "terrain", "grass",
                                                               "colliders", "probes",  "cameras"};
inline constexpr std::string_view kCollidersKey = "colliders";

/// Keys that a record must have: who it is and where.
template <class Record>
inline constexpr std::array<std::string_view, 0> kRequiredKeys{};
template <>
inline constexpr std::array<std::string_view, 2> kRequiredKeys<Point>{"id", "position"};
template <>
inline constexpr std::array<std::string_view, 3> kRequiredKeys<Arrow>{"id", "from", "to"};
template <>
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Signal>{"root"};
template <>
inline constexpr std::array<std::string_view, 2> kRequiredKeys<Obstacle>{"id", "centre"};
template <>
inline constexpr std::array<std::string_view, 2> kRequiredKeys<Probe>{"id", "position"};
template <>
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Camera>{"id"};

}  // namespace windloom
