#pragma once
// The makers of the writers, each in a file of its own name; writer_kinds.cpp lists them.

#include "engine/bake/frame_writer.hpp"

namespace windloom {

using OpenedWriter = Result<std::unique_ptr<FrameWriter>>;

OpenedWriter openNpyWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openFlowMapWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openWindpackWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openWindpackFloatWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openWindpackZstdWriter(const BakeHeader& header, const std::filesystem::path& folder);
std::string windpackRefusal(const BakeHeader& header);
std::string windpackFloatRefusal(const BakeHeader& header);

OpenedWriter openFgaWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openFgaTilesWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openVfWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openVf2Writer(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openVdbWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openSlabWriter(const BakeHeader& header, const std::filesystem::path& folder);

OpenedWriter openExrWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openPng16Writer(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openAtlasWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openDdsWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openDdsRgbaWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openDdsBc5Writer(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openDdsVolumeWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openKtx2Writer(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openKtx2RgbaWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openKtx2Bc5Writer(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openKtx2ZstdWriter(const BakeHeader& header, const std::filesystem::path& folder);

// What they write, for sizes beforehand.
std::uint64_t exrBytes(const BakeHeader& header);  ///< at most
std::uint64_t ddsBytes(const BakeHeader& header);
std::uint64_t ddsRgbaBytes(const BakeHeader& header);
std::uint64_t ddsBc5Bytes(const BakeHeader& header);
std::uint64_t ktx2Bytes(const BakeHeader& header);
std::uint64_t ktx2RgbaBytes(const BakeHeader& header);
std::uint64_t ktx2Bc5Bytes(const BakeHeader& header);

// Why they can't (WriterKind::refusal) or what is good to know (WriterKind::warning).
std::string atlasRefusal(const BakeHeader& header);
std::string ddsArrayRefusal(const BakeHeader& header);
std::string ddsVolumeRefusal(const BakeHeader& header);
std::string ktx2Warning(const BakeHeader& header);

std::uint64_t fgaBytes(const BakeHeader& header);       ///< about
std::uint64_t fgaTilesBytes(const BakeHeader& header);  ///< about
std::uint64_t vfBytes(const BakeHeader& header);
std::uint64_t vf2Bytes(const BakeHeader& header);
std::uint64_t vdbBytesOfBake(const BakeHeader& header);  ///< at most
std::uint64_t slabBytes(const BakeHeader& header);       ///< at most
std::string fgaWarning(const BakeHeader& header);
std::string fgaTilesWarning(const BakeHeader& header);
std::string vfWarning(const BakeHeader& header);
std::string vdbRefusal(const BakeHeader& header);
std::string vdbWarning(const BakeHeader& header);
std::string slabWarning(const BakeHeader& header);

/// WriterKind::missing of "vdb".
#ifdef WINDLOOM_OPENVDB
inline constexpr std::string_view kVdbMissing = {};
#else
inline constexpr std::string_view kVdbMissing =
    "this build has no OpenVDB; install it (Debian: libopenvdb-dev libboost-dev) and build again";
#endif

}  // namespace windloom
