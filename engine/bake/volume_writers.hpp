#pragma once
// What the list of formats (writer_kinds.cpp) says of the volumes beside their makers: sizes and warnings.

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/bake/bake_header.hpp"

namespace windloom {

std::uint64_t fgaBytes(const BakeHeader& header);
std::uint64_t fgaTilesBytes(const BakeHeader& header);
std::uint64_t vfBytes(const BakeHeader& header);
std::uint64_t vf2Bytes(const BakeHeader& header);
std::uint64_t vdbBytesOfBake(const BakeHeader& header);
std::uint64_t slabBytes(const BakeHeader& header);

std::string fgaWarning(const BakeHeader& header);
std::string fgaTilesWarning(const BakeHeader& header);
std::string vfWarning(const BakeHeader& header);
std::string vdbWarning(const BakeHeader& header);
std::string slabWarning(const BakeHeader& header);

/// Empty where OpenVDB is built in.
#ifdef WINDLOOM_OPENVDB
inline constexpr std::string_view kVdbMissing = {};
#else
inline constexpr std::string_view kVdbMissing =
    "this build has no OpenVDB; install it (Debian: libopenvdb-dev libboost-dev) and build again";
#endif

}  // namespace windloom
