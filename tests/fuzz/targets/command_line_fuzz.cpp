// The command lines of `windloom` and of `windloom-editor`: one argument a line. Nothing is run; what bake and sample
// read out of texts later (sizes, ranges of frames, places, formats) is tried by itself.

#include <vector>

#include "editor/app/command_line.hpp"
#include "engine/cli/command_line.hpp"
#include "engine/cli/common.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"

using namespace windloom;
using fuzz::require;

namespace windloom::fuzz {
void tryBakeValues(const std::vector<std::string>& texts);
void trySampleValues(const std::vector<std::string>& texts);
}  // namespace windloom::fuzz

namespace {

constexpr std::size_t kMaxArguments = 24;

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < kMaxArguments) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    // An argument ends at its zero.
    lines.back().resize(std::min(lines.back().find('\0'), lines.back().size()));
    if (end == text.npos) break;
    text.remove_prefix(end + 1);
  }
  return lines;
}

bool isStatus(int status) {
  return status >= 0 && status <= 3;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string> lines = linesOf(fuzz::asText(data, size));
  std::vector<const char*> arguments{"windloom"};
  for (const std::string& line : lines) arguments.push_back(line.c_str());
  const int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);

  int status = -1;
  const auto action = cli::parseCommandLine(count, arguments.data(), status);
  require(action ? bool(*action) : isStatus(status), "a verb, or a reason why not");
  status = -1;
  const auto line = editor::parseCommandLine(count, arguments.data(), status);
  require(line || isStatus(status), "what to open, or a reason why not");
  if (line) {
    require(line->width.has_value() == line->height.has_value() && line->width.value_or(320) >= 320, "a size is whole");
    require(line->scale == 0 || (line->scale >= 0.5f && line->scale <= 4.0f), "the scale is usable");
    require(line->frames >= 1, "there are frames");
  }
  for (const std::string& text : lines) {
    if (const auto pair = cli::parsePair(text, 4096))
      require(pair->x >= 8 && pair->x <= 4096 && pair->y >= 8 && pair->y <= 4096, "a size is within its limit");
  }
  fuzz::tryBakeValues(lines);
  fuzz::trySampleValues(lines);
  return 0;
}
