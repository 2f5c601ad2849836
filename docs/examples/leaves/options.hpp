#pragma once

#include <cstdint>
#include <string>

namespace game {

struct Options {
  std::string file, liveName, screenshot;
  bool live = false, print = false, help = false;
  double time = 0;  ///< s in the recording to begin at
  int frames = 0;   ///< drawn before it ends by itself; 0: until the window is closed
  int width = 1280, height = 720;
  std::uint32_t seed = 1;
  std::string problem;  ///< what is wrong with the command line, or nothing
};

Options parseOptions(int argc, char** argv);
const char* helpText();

}  // namespace game
