#include "options.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace game {

namespace {

constexpr int kFramesForScreenshot = 120;

/// A whole number of `low` to `high` that is all of `text`.
bool readWhole(const char* text, long long low, long long high, long long& value) {
  char* end = nullptr;
  value = std::strtoll(text, &end, 10);
  return end != text && *end == 0 && value >= low && value <= high;
}

bool readSize(const char* text, Options& options) {
  char rest = 0;
  return std::sscanf(text, "%dx%d%c", &options.width, &options.height, &rest) == 2 && options.width >= 64 &&
         options.width <= 8192 && options.height >= 64 && options.height <= 8192;
}

/// Takes an option's value; false where it makes no sense.
bool takeValue(const std::string& name, const char* text, Options& options) {
  long long whole = 0;
  if (name == "--time") {
    char* end = nullptr;
    options.time = std::strtod(text, &end);
    return end != text && *end == 0 && std::isfinite(options.time);
  }
  if (name == "--frames") {
    if (!readWhole(text, 1, 10000000, whole)) return false;
    options.frames = static_cast<int>(whole);
  } else if (name == "--seed") {
    if (!readWhole(text, 0, 4294967295, whole)) return false;
    options.seed = static_cast<std::uint32_t>(whole);
  } else if (name == "--size") {
    return readSize(text, options);
  } else {
    options.screenshot = text;
  }
  return true;
}

/// Tells a file from a live link's name after --live.
bool isPack(const std::string& word) {
  const std::string ending = ".windpack";
  return word.size() >= ending.size() && word.compare(word.size() - ending.size(), ending.size(), ending) == 0;
}

bool takesValue(const std::string& name) {
  return name == "--time" || name == "--frames" || name == "--seed" || name == "--size" || name == "--screenshot";
}

}  // namespace

Options parseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc && options.problem.empty(); ++i) {
    const std::string word = argv[i];
    const char* next = i + 1 < argc ? argv[i + 1] : nullptr;
    if (word == "--help" || word == "-h") {
      options.help = true;
    } else if (word == "--print") {
      options.print = true;
    } else if (word == "--live") {
      options.live = true;
      if (next != nullptr && next[0] != '-' && !isPack(next)) options.liveName = argv[++i];
    } else if (takesValue(word)) {
      if (next == nullptr || !takeValue(word, next, options)) {
        options.problem = word + ": not this: " + (next != nullptr ? next : "(nothing)");
      }
      ++i;
    } else if (word[0] == '-') {
      options.problem = "unknown option " + word;
    } else if (options.file.empty()) {
      options.file = word;
    } else {
      options.problem = "one file is enough, not " + word + " as well";
    }
  }
  if (options.file.empty() && !options.live && !options.help && options.problem.empty())
    options.problem = "which file?";
  if (!options.screenshot.empty() && options.frames == 0) options.frames = kFramesForScreenshot;
  return options;
}

const char* helpText() {
  return "usage: windloom-leaves FILE.windpack [--live [NAME]] [options]\n"
         "Leaves and flags in the wind of a file that Windloom baked, or of the running editor.\n"
         "  --live [NAME]     follow the editor's live link; the file where there is none\n"
         "  --time S          begin S seconds into the recording\n"
         "  --frames N        draw N frames of 1/30 s each and end\n"
         "  --size WxH        of the window, in pixels (1280x720)\n"
         "  --screenshot PNG  save the last frame (the 120th without --frames)\n"
         "  --seed N          other leaves in other places\n"
         "  --print           at the end, tell how far each leaf came\n"
         "Keys: space pauses, R restarts, L changes between file and live link, Esc ends.\n"
         "Mouse: drag to orbit, wheel to come nearer.\n";
}

}  // namespace game
