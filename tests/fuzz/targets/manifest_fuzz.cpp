// What a bake finds in its folder: the manifest of an earlier bake, and the notes that parts of a bake leave for each
// other.

#include <cmath>

#include "engine/bake/bake_parts.hpp"
#include "engine/bake/manifest.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"
#include "tests/fuzz/support/json_mutator.hpp"

using namespace windloom;
using fuzz::require;

namespace {

constexpr int kFrames = 12;

void checkPlain(const std::string& name) {
  require(!name.empty() && name != "." && name != ".." && name.find_first_of("/\\") == name.npos,
          "a file lies in the folder itself");
}

void checkPart(const BakePart& part) {
  require(part.first >= 0 && part.first <= part.last, "a part has frames");
  require(std::isfinite(part.fastest) && part.fastest >= 0, "a speed is a number");
  for (const auto& group : part.groups) {
    for (const auto& entry : group) checkPlain(entry.at("path").get<std::string>());
  }
}

const fuzz::JsonWords& words() {
  static const fuzz::JsonWords kWords{
      {"format", "files", "path", "sha256", "plan", "first", "last", "fastest", "seam", "step", "groups", "frame",
       "role", "encoding", "bytes", "tiles", "import", "strength"},
      {"windpack", "f0.bin", "f1.bin", "..", "a/b", "field", "flow", "float16"}};
  return kWords;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  static const bool kFilesAreThere = !folder.put("f0.bin", "x").empty() && !folder.put("f1.bin", "x").empty();
  require(kFilesAreThere, "files of a part");
  const std::string_view bytes = fuzz::asText(data, size);
  folder.put("manifest.json", bytes);
  if (const std::string plan = planOfManifest(folder.path()); !plan.empty())
    require(plan.size() == kPlanDigits && isPlainName(plan), "a plan is digits");
  if (const Result<std::vector<ListedFile>> files = filesOfManifest(folder.path())) {
    for (const ListedFile& file : *files) checkPlain(file.path);
  }
  folder.put("part-0-5.json", bytes);
  folder.put("part-6-11.json", R"({"first":6,"last":11,"fastest":2,"seam":0,"step":0,"groups":[[)"
                               R"({"path":"f1.bin","role":"field","encoding":"float16","frame":6}]]})");
  const std::vector<BakePart> parts = readParts(folder.path());
  require(!parts.empty(), "the good part is found");
  for (const BakePart& part : parts) checkPart(part);
  const auto missing = missingFrames(parts, kFrames);
  for (const auto& [first, last] : missing)
    require(first >= 0 && first <= last && last < kFrames, "missing frames are of the bake");
  const std::optional<BakePart> whole = joinParts(parts, kFrames);
  require(whole.has_value() == missing.empty(), "the parts are one where no frame is missing");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  return fuzz::mutateJson(data, size, maxSize, seed, words());
}
