#pragma once
// The makers of the writers, each in a file of its own name; writer_kinds.cpp lists them.

#include "engine/bake/frame_writer.hpp"

namespace windloom {

using OpenedWriter = Result<std::unique_ptr<FrameWriter>>;

OpenedWriter openNpyWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openFlowMapWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openWindpackWriter(const BakeHeader& header, const std::filesystem::path& folder);

OpenedWriter openFgaWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openFgaTilesWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openVfWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openVf2Writer(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openVdbWriter(const BakeHeader& header, const std::filesystem::path& folder);
OpenedWriter openSlabWriter(const BakeHeader& header, const std::filesystem::path& folder);

}  // namespace windloom
