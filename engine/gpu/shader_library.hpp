#pragma once
// Programs from the files of shaders/: includes resolved, variants by defines, compile errors that name the
// real file and line on every driver, hot reload.
//
// A shader file begins with `#version 450 core`. `#include "shaders/..."` counts from the root, any other
// quoted path from the including file; a file is included once per stage, later includes of it are empty, so
// headers shared with C++ work as they are. `#include <...>` is for C++ only and is skipped.
//
// Each room lists its programs in one constexpr table of ProgramSpec and offers it as a span
// (`std::span<const gpu::ProgramSpec> windPrograms()`): the passes load from it, and a test compiles all.

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/program.hpp"

namespace windloom::gpu {

/// One program variant.
struct ProgramSpec {
  std::string_view name;          ///< label, unique in its table: "wind/advect maccormack"
  std::string_view stages[3];     ///< files below shaders/, kind by extension: .vert .frag .geom .comp; unused: empty
  std::string_view defines = {};  ///< "NAME NAME=VALUE", separated by spaces, put after the version line of each stage
};

class ShaderLibrary {
 public:
  /// Finds shaders/ (findDataFolder). Fails with Machine.
  static Result<std::unique_ptr<ShaderLibrary>> create();
  /// As create() from a given folder.
  explicit ShaderLibrary(std::filesystem::path folder);
  ~ShaderLibrary();

  /// Compiles and links, or finds again what the same stages and defines gave before. The program is owned by
  /// the library and stays at its address; reloadChanged() may replace what is behind it. `moreDefines`, as
  /// ProgramSpec::defines, adds constants known only at run time. Fails with Machine: one problem for each
  /// message of the driver, its file as "shaders/wind/advect.comp" and its place as "line 12".
  Result<Program*> load(const ProgramSpec& spec, std::string_view moreDefines = {});

  /// Compiles every program of a table and collects the problems of all of them.
  Status loadAll(std::span<const ProgramSpec> specs);

  struct Reload {
    int replaced = 0;               ///< programs that now run newer code
    std::vector<Problem> problems;  ///< of programs that keep their old code
  };
  /// Looks at the files of all programs and rebuilds those that changed since they were read.
  Reload reloadChanged();

  [[nodiscard]] const std::filesystem::path& folder() const { return m_folder; }

 private:
  struct Entry;
  Result<Handle<ProgramKind>> build(Entry& entry) const;
  std::filesystem::path m_folder;
  std::map<std::string, std::unique_ptr<Entry>, std::less<>> m_entries;
};

}  // namespace windloom::gpu
