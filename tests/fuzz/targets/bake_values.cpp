// What `windloom bake` reads out of the texts of its options. The functions are its own, so its source is taken in
// whole.

#include "engine/cli/verb_bake.cpp"

#include "tests/fuzz/support/fuzz_target.hpp"

namespace windloom::fuzz {

void tryBakeValues(const std::vector<std::string>& texts) {
  static const Project kProject;
  for (const std::string& text : texts) {
    if (const auto size = cli::parseResolution(text))
      require(size->x >= 1 && size->y >= 1 && size->x <= cli::kMaxBakeSide && size->y <= cli::kMaxBakeSide,
              "cells within their limit");
    if (const auto part = cli::parsePart(text))
      require(part->first >= 0 && part->first <= part->second && part->second < kMaxBakeFrames, "a range of frames");
  }
  cli::Options options;
  options.formats = {texts.begin(), texts.end()};
  if (const Result<BakeRequest> request = cli::requestOf(options, kProject))
    require(request->formats.size() <= writerKinds().size(), "each format once");
  if (texts.size() < 4) return;
  options.formats.clear();
  options.preset = texts[0];
  options.resolution = texts[1];
  options.part = texts[2];
  options.from = parseNumber(texts[3]).value_or(0);
  options.steps = static_cast<long>(texts[0].size() * 1000);
  options.fps = 0.01 + static_cast<double>(texts[1].size());
  static_cast<void>(cli::requestOf(options, kProject));
}

}  // namespace windloom::fuzz
