#pragma once
// What reader, writer and schema must agree on beyond the parameter tables.

#include <array>
#include <span>
#include <string_view>

#include "engine/model/project.hpp"

namespace windloom {

/// Top-level keys in the order of the file.
inline constexpr std::array<std::string_view, 18> kProjectKeys{
    "format", "version", "name",  "field",   "solver",    "ambient",  "graph",  "obstacles", "terrain",
    "grass",  "bezier",  "shell", "species", "colliders", "surfaces", "rotors", "probes",    "cameras"};

/// The member of a record that is a list and so in no parameter table; empty: none.
template <class Record>
inline constexpr std::string_view kListKey = "";
template <>
inline constexpr std::string_view kListKey<Signal> = "keys";
template <>
inline constexpr std::string_view kListKey<Obstacle> = "points";
template <>
inline constexpr std::string_view kListKey<Collider> = "keys";

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
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Species>{"id"};
template <>
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Collider>{"id"};
template <>
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Surface>{"id"};
template <>
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Rotor>{"id"};
template <>
inline constexpr std::array<std::string_view, 2> kRequiredKeys<Probe>{"id", "position"};
template <>
inline constexpr std::array<std::string_view, 1> kRequiredKeys<Camera>{"id"};

}  // namespace windloom
