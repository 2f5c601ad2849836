#pragma once
// The benchmark: scenes that measure one part each and give rows of numbers. A scene is one file and one line in the
// list of bench_scenes.cpp.

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/cli/common.hpp"
#include "engine/gpu/context.hpp"
#include "engine/gpu/shader_library.hpp"

namespace windloom::cli {

enum class BenchSize {
  Full,
  Quick,  ///< tiny: shows that everything runs, its numbers mean nothing
};

struct BenchSetup {
  BenchSize size = BenchSize::Full;
  bool cpu = true;                  ///< measure the CPU backend
  gpu::Context* context = nullptr;  ///< null: measure nothing on the GPU
  gpu::ShaderLibrary* shaders = nullptr;
  std::optional<glm::ivec2> picture;  ///< pixels of the scenes that draw; none: their own choice
  std::string pictures;               ///< folder that scene `picture` puts its pictures into; empty: nowhere
  std::vector<std::string> views;     ///< cameras of scene `picture` by name; empty: all
  std::vector<int> blades;            ///< millions of blades of the scenes with a choice; empty: their own
  std::vector<int> cells;             ///< sides of the fields of scene `solver`; empty: its own choice
  double capSeconds = 20;             ///< about how long one row may take; rows that would take longer have fewer runs
};

/// One line of a scene's table: names and values in the order of the columns. Values that are objects (times by stage)
/// stand in the report only.
using BenchRow = Json;

struct BenchScene {
  std::string_view name, help;
  Result<std::vector<BenchRow>> (*run)(const BenchSetup& setup);
};

std::span<const BenchScene> benchScenes();

// The scenes.
Result<std::vector<BenchRow>> benchSolver(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchMeadowTable(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchGrassland(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchBezier(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchShell(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchLive(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchPicture(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchLoad(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchStartup(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchExport(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchRuntime(const BenchSetup& setup);
Result<std::vector<BenchRow>> benchFloor(const BenchSetup& setup);

/// Processor, cores, memory, system, compiler, commit; with a context also the OpenGL driver.
Json benchMachine(const gpu::Context* context);

/// The rows as a table for people.
void printBenchTable(std::string_view title, const std::vector<BenchRow>& rows);

}  // namespace windloom::cli
