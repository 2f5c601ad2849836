// Side files of the autosave, which an editor finds after a crash. The mutator also changes the project that such a
// file holds as a text.

#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

#include "editor/core/autosave.hpp"
#include "engine/core/log.hpp"
#include "engine/model/validate.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"
#include "tests/fuzz/support/json_mutator.hpp"

using namespace windloom;
using namespace windloom::editor;
using fuzz::require;

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  setLogLevel(LogLevel::Error);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  folder.put("1.rescue.json", fuzz::asText(data, size));
  std::vector<Rescue> rescues = findRescues(folder.path());
  require(rescues.size() <= 1, "one file is one rescue");
  for (Rescue& rescue : rescues) {
    // What the file names is not to be read here: it may be anything on this machine.
    if (!rescue.original.empty()) rescue.original = folder.path() / "gone.wind.json";
    require(!describeRescue(rescue).empty() || rescue.original.empty(), "differences or a reason");
    Document document;
    if (restoreRescue(document, rescue)) {
      require(document.dirty(), "a rescued project is unsaved");
      require(validate(document.project()).empty(), "a rescued project is valid");
    }
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  using Json = nlohmann::ordered_json;
  static const fuzz::JsonWords kWords{{"format", "original", "savedAt", "project"},
                                      {"windloom-rescue", "/tmp/a.wind.json"}};
  if (seed % 4 == 0) return fuzz::mutateJson(data, size, maxSize, seed / 4, kWords);
  Json json = Json::parse(data, data + size, nullptr, false);
  if (!json.is_object() || !json.contains("project") || !json["project"].is_string())
    return fuzz::mutateJson(data, size, maxSize, seed / 4, kWords);
  std::string project = json["project"];
  const std::size_t length = project.size();
  project.resize(length + 1024);
  auto* bytes = reinterpret_cast<std::uint8_t*>(project.data());
  project.resize(fuzz::mutateJson(bytes, length, project.size(), seed / 4, fuzz::projectWords()));
  json["project"] = project;
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (text.size() > maxSize) return size;
  std::memcpy(data, text.data(), text.size());
  return text.size();
}
