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

}  // namespace windloom
