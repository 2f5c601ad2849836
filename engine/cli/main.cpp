#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>

#include "engine/cli/command_line.hpp"
#include "engine/cli/common.hpp"
#include "engine/core/memory_reserve.hpp"
#include "engine/core/process.hpp"
#include "engine/core/text.hpp"

namespace {

using namespace windloom::cli;

/// A result that never arrived (standard output is closed, or a file on a full disk) is no success.
int withOutputWritten(int status) {
  errno = 0;
  const bool lost = std::fflush(stdout) != 0;
  const int code = errno;
  if (!lost && std::ferror(stdout) == 0) return status;
  std::fprintf(stderr, "windloom: can't write the result to standard output%s%s\n", code != 0 ? ": " : "",
               code != 0 ? std::strerror(code) : "");
  return kExitMachine;
}

}  // namespace

int main(int argc, char** argv) {
  windloom::prepareProcess();
  windloom::keepMemoryReserve();
  try {
    int exitStatus = kExitDone;
    const auto action = parseCommandLine(argc, argv, exitStatus);
    return withOutputWritten(action ? (*action)() : exitStatus);
  } catch (const std::bad_alloc&) {
    std::fputs("windloom: there is not enough memory for this\n", stderr);
    return kExitMachine;
  } catch (const std::length_error&) {
    std::fputs("windloom: there is not enough memory for this\n", stderr);
    return kExitMachine;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "windloom: %s\n", windloom::printable(error.what()).c_str());
    return kExitMachine;
  }
}
