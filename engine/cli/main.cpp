#include <cstdio>
#include <exception>

#include "engine/cli/command_line.hpp"
#include "engine/cli/common.hpp"

int main(int argc, char** argv) {
  using namespace windloom::cli;
  try {
    int exitStatus = kExitDone;
    const auto action = parseCommandLine(argc, argv, exitStatus);
    return action ? (*action)() : exitStatus;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "windloom: %s\n", error.what());
    return kExitMachine;
  }
}
