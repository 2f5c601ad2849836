#include <algorithm>
#include <cstdio>

#include "engine/cli/bench.hpp"
#include "engine/core/text.hpp"

namespace windloom::cli {
namespace {

constexpr BenchScene kScenes[] = {
    {"floor", "what the machine can do at best: memory bandwidth, the cost of an empty dispatch", benchFloor},
    {"solver", "one wind step at 256 to 4096 squared, beside the plain scheme", benchSolver},
    {"meadow", "a wind step and a picture of 1 to 100 million blades, 1920 x 1080 (needs OpenGL)", benchMeadowTable},
    {"grassland", "a million blades on 280 m, still, in wind, touched by balls (needs OpenGL)", benchGrassland},
    {"bezier", "Bezier grass: samples nature and helicopter, 1024 x 768, 8 samples a pixel (needs OpenGL)",
     benchBezier},
    {"shell", "shell grass: the paper's table, and ours against 65 plain shells (needs OpenGL)", benchShell},
    {"live", "the samples meadow and prairie played at 1280 x 720 for 20 s each, with quality control (needs OpenGL)",
     benchLive},
    {"picture", "how near the thinned meadow comes to one with every blade drawn (needs OpenGL)", benchPicture},
    {"load", "reading a project of 10,000 arrows", benchLoad},
    {"startup", "from nothing to the first picture", benchStartup},
    {"export", "every format's writer, beside writing the same bytes; a bake beside its simulation", benchExport},
    {"runtime", "a baked pack in a game: loading it, one sample, samples in batches of 1,000", benchRuntime},
};

/// Four significant digits for numbers, enough to compare and short enough to read.
std::string cellText(const Json& value) {
  if (value.is_string()) return printable(value.get<std::string>());
  if (value.is_number_integer()) return std::to_string(value.get<long long>());
  if (!value.is_number()) return value.is_null() ? "" : value.dump();
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value.get<double>());
  return text;
}

}  // namespace

std::span<const BenchScene> benchScenes() {
  return kScenes;
}

void printBenchTable(std::string_view title, const std::vector<BenchRow>& rows) {
  std::vector<std::string> columns;
  for (const BenchRow& row : rows) {
    for (const auto& [name, value] : row.items()) {
      if (value.is_structured()) continue;  // for the report only
      if (std::find(columns.begin(), columns.end(), name) == columns.end()) columns.push_back(name);
    }
  }
  std::printf("\n%.*s\n", static_cast<int>(title.size()), title.data());
  std::vector<std::string> lines(rows.size() + 1);
  for (const std::string& column : columns) {
    std::vector<std::string> cells = {column};
    for (const BenchRow& row : rows) cells.push_back(row.contains(column) ? cellText(row[column]) : "");
    std::size_t width = 0;
    for (const std::string& cell : cells) width = std::max(width, cell.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string padding(width - cells[i].size(), ' ');
      const bool words = rows.front().contains(column) && rows.front()[column].is_string();
      lines[i] += (words ? cells[i] + padding : padding + cells[i]) + "  ";
    }
  }
  for (const std::string& line : lines) std::printf("  %s\n", line.substr(0, line.find_last_not_of(' ') + 1).c_str());
  std::fflush(stdout);
}

}  // namespace windloom::cli
