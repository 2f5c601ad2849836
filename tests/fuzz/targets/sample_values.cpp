// What `windloom sample` reads out of the texts of its options; see bake_values.cpp.

#include "engine/cli/verb_sample.cpp"

#include "tests/fuzz/support/fuzz_target.hpp"

namespace windloom::fuzz {

void trySampleValues(const std::vector<std::string>& texts) {
  static const Project kProject;
  for (const std::string& text : texts) {
    cli::Options options;
    options.at = {text};
    if (const auto places = cli::placesOf(options, kProject)) {
      for (const cli::Place& place : *places)
        require(std::isfinite(place.position.x) && std::isfinite(place.position.y), "a place is in the field");
    }
  }
}

}  // namespace windloom::fuzz
