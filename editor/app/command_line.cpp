#include "editor/app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>
#include <utility>

#include "engine/cli/completion.hpp"
#include "engine/cli/man_page.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"

#include "engine/core/text.hpp"

namespace windloom::editor {

namespace {

bool parseSize(const std::string& text, CommandLine& line) {
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return false;
  int width = 0, height = 0;
  const char* begin = text.data();
  const auto first = std::from_chars(begin, begin + cross, width);
  const auto second = std::from_chars(begin + cross + 1, begin + text.size(), height);
  if (first.ec != std::errc{} || first.ptr != begin + cross || second.ec != std::errc{} ||
      second.ptr != begin + text.size())
    return false;
  if (width < 320 || height < 240 || width > 16384 || height > 16384) return false;
  line.width = width;
  line.height = height;
  return true;
}

/// For the build; needs no display.
int writeDocs(CLI::App& app, const std::filesystem::path& folder) {
  const cli::ProgramHelp help = cli::describe(app);
  std::vector<std::pair<std::string, std::string>> files{{"windloom-editor.bash", cli::bashCompletion(help)},
                                                         {"_windloom-editor", cli::zshCompletion(help)}};
  for (const cli::ManPage& page : cli::manPages(help, WINDLOOM_VERSION)) files.emplace_back(page.fileName, page.text);
  for (const auto& [name, text] : files)
    if (const Status written = writeFileAtomically(folder / name, text); !written) {
      logError(written.error().text());
      return 3;
    }
  return 0;
}

}  // namespace

std::optional<CommandLine> parseCommandLine(int argc, const char* const* argv, int& exitStatus) {
  CommandLine line;
  CLI::App app("Draw wind, see grass answer, export it for games.", "windloom-editor");
  std::string size, file, screenshot, keys, uiMap, docs;
  app.add_option("FILE", file, "Project to open (NAME.wind.json)");
  app.add_option("--size", size, "Window size in pixels, e.g. 1280x720")->check([&](const std::string& text) {
    return parseSize(text, line) ? std::string() : "expected WIDTHxHEIGHT, at least 320x240, found '" + text + "'";
  });
  app.add_option("--scale", line.scale, "Size of text and controls, 1 = 100%")->check([](const std::string& text) {
    const auto scale = parseNumber(text);  // CLI::Range would let "nan" pass
    return scale && *scale >= 0.5 && *scale <= 4 ? std::string()
                                                 : "expected a number from 0.5 to 4, found '" + text + "'";
  });
  app.add_option("--select", line.selected, "Ids of what is selected at the start: 1,4")->delimiter(',');
  app.add_option("--screenshot", screenshot, "Write the window as PNG after --frames frames, and end");
  app.add_option("--frames", line.frames, "Frames before the screenshot; each is 1/30 s of wind")
      ->check(CLI::Range(1, 100000));
  app.add_option("--keys", keys, "Write the list of all keys and gestures as Markdown, and end");
  app.add_option("--ui-map", uiMap,
                 "Keep FILE up to date with the names and places of controls (window tests, accessibility)");
  app.set_version_flag("--version", "windloom-editor " WINDLOOM_VERSION);
  app.add_option("--docs", docs, "Write the manual page and shell completions into this folder, and end");
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return printable(error.what()) + "\nRun with --help for more information.\n";
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    exitStatus = app.exit(error) == 0 ? 0 : 2;
    return std::nullopt;
  }
  if (!docs.empty()) {
    exitStatus = writeDocs(app, docs);
    return std::nullopt;
  }
  line.file = file;
  line.screenshot = screenshot;
  line.keys = keys;
  line.uiMap = uiMap;
  return line;
}

}  // namespace windloom::editor
