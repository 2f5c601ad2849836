#include <sys/sysinfo.h>
#include <sys/utsname.h>

#include <fstream>
#include <thread>

#include "engine/cli/bench.hpp"

namespace windloom::cli {
namespace {

/// The value of a "key : value" line of /proc/cpuinfo.
std::string cpuInfo(const std::string& key) {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line);) {
    const auto colon = line.find(':');
    if (line.starts_with(key) && colon != std::string::npos && colon + 2 <= line.size()) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string systemName() {
  struct utsname name {};
  if (::uname(&name) != 0) return "unknown";
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

std::string compilerName() {
#ifdef __clang__
  return "clang " __clang_version__;
#else
  return "gcc " __VERSION__;
#endif
}

}  // namespace

Json benchMachine(const gpu::Context* context) {
  struct sysinfo memory {};
  const bool known = ::sysinfo(&memory) == 0;
  Json machine = {{"cpu", cpuInfo("model name")},
                  {"cores", std::thread::hardware_concurrency()},
                  {"memoryMiB", known ? (static_cast<std::uint64_t>(memory.totalram) * memory.mem_unit) >> 20 : 0},
                  {"system", systemName()},
                  {"compiler", compilerName()},
                  {"build", WINDLOOM_BUILD_TYPE},
                  {"version", WINDLOOM_VERSION},
                  {"commit", WINDLOOM_COMMIT}};
  if (context != nullptr) {
    const gpu::ContextInfo& info = context->info();
    machine["opengl"] = {{"vendor", info.vendor},
                         {"renderer", info.renderer},
                         {"version", info.version},
                         {"platform", info.platform},
                         {"software", info.software}};
  }
  return machine;
}

}  // namespace windloom::cli
