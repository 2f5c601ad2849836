#pragma once
// What makes a bake load rightly the first time: import settings, shader code and a short how-to with the numbers of
// this very bake, for the preset's engine.

#include <filesystem>

#include "engine/bake/frame_writer.hpp"
#include "engine/model/project.hpp"

namespace windloom {

/// Writes them beside the bake's files: HOWTO.md, shader snippets made from shaders/export, import settings. Fails with
/// Machine.
Result<std::vector<BakedFile>> writeSidecars(const Project& project, const BakeHeader& header,
                                             std::span<const BakedFile> files, const std::filesystem::path& folder);

}  // namespace windloom
