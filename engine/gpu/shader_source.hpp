#pragma once
// The text side of the shader loader, without OpenGL: includes, defines, line map.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.hpp"

namespace windloom::gpu {

/// One stage ready for the compiler, and where each of its lines came from. The text has no line directives:
/// Mesa loses their source number in many messages, so lines of messages are looked up here instead.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;  ///< as messages show them: "shaders/wind/advect.comp"
  struct Line {
    std::size_t file = 0;  ///< index into `files`
    int number = 0;        ///< from 1
  };
  std::vector<Line> lines;  ///< one for each line of `text`
};

/// Reads `file` (below `folder`) and all it includes. Fails with Machine: missing file (naming the including
/// file and line), no `#version` first. Also on failure `files` read so far are added to `touched`.
Result<ShaderSource> readShaderSource(const std::filesystem::path& folder, std::string_view file,
                                      std::string_view defines, std::vector<std::filesystem::path>& touched);

/// A driver's compile log as problems with real files and lines. Understands the forms of Mesa
/// ("0:12(5): error: ..."), NVIDIA ("0(12) : error ...") and others ("ERROR: 0:12: ..."); other lines are added to
/// the problem before them.
std::vector<Problem> problemsOfLog(std::string_view log, const ShaderSource& source);

}  // namespace windloom::gpu
