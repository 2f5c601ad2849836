#include "editor/app/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>

#include "engine/cli/completion.hpp"
#include "engine/cli/man_page.hpp"
#include "engine/cli/option_checks.hpp"
#include "engine/cli/usage_text.hpp"
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

int usageError(CLI::App& app, const CLI::ParseError& error, const std::vector<std::string>& words) {
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return app.exit(error);  // --help, --version
  std::fprintf(stderr, "windloom-editor: %s\nRun 'windloom-editor --help' for how to use it.\n",
               printable(cli::usageProblem(app, error, words)).c_str());
  return 2;
}

}  // namespace

std::optional<CommandLine> parseCommandLine(int argc, const char* const* argv, int& exitStatus) {
  CommandLine line;
  CLI::App app("Draw wind, see grass answer, export it for games.", "windloom-editor");
  std::string size, file, screenshot, keys, uiMap, docs;
  app.add_option("FILE", file, "Project to open (NAME.wind.json)");
  app.formatter(cli::helpFormatter());
  app.add_option("--size", size, "Window size in pixels, e.g. 1280x720")
      ->type_name("WxH")
      ->check([&](const std::string& text) {
        return parseSize(text, line) ? std::string() : "expected WIDTHxHEIGHT, at least 320x240, found '" + text + "'";
      });
  app.add_option("--scale", line.scale, "Size of text and controls, 1 = 100%")
      ->type_name("S")
      ->check(cli::numberFrom(0.5, 4));
  app.add_option("--select", line.selected, "Ids of what is selected at the start: 1,4")
      ->type_name("ID[,ID...]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->transform(cli::wholeFrom(0, std::numeric_limits<std::uint32_t>::max()));
  app.add_option("--screenshot", screenshot, "Write the window as PNG after --frames frames, and end")
      ->type_name("PNG")
      ->check(cli::pngName());
  app.add_option("--frames", line.frames, "Frames before the screenshot; each is 1/30 s of wind")
      ->type_name("N")
      ->transform(cli::wholeFrom(1, 100000));
  app.add_option("--keys", keys, "Write the list of all keys and gestures as Markdown, and end")->type_name("FILE");
  app.add_option("--ui-map", uiMap,
                 "Keep FILE up to date with the names and places of controls (window tests, accessibility)")
      ->type_name("FILE");
  app.set_version_flag("--version", "windloom-editor " WINDLOOM_VERSION);
  app.add_option("--docs", docs, "Write the manual page and shell completions into this folder, and end")
      ->type_name("DIR");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    exitStatus = usageError(app, error, {argv + std::min(argc, 1), argv + argc});
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
