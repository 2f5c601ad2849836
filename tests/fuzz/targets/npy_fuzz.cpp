// NumPy arrays, as `sample` and `bake` begin from. The mutator gives the file the length that its shape asks for.

#include <charconv>
#include <cstring>

#include "engine/io/npy.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"

using namespace windloom;
using fuzz::require;

namespace {

/// Product of the whole numbers behind "shape", 0 where it is none or large.
std::size_t cellsIn(std::string_view text) {
  std::size_t at = text.find("shape"), count = 1, numbers = 0;
  if (at == text.npos) return 0;
  for (; at < text.size() && text[at] != ')'; ++at) {
    std::size_t extent = 0;
    const auto [end, code] = std::from_chars(text.data() + at, text.data() + text.size(), extent);
    if (code != std::errc()) continue;
    if (extent > 4096) return 0;
    count *= extent;
    if (count > 4096 || ++numbers > 8) return 0;
    at = static_cast<std::size_t>(end - text.data()) - 1;
  }
  return numbers > 0 ? count : 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  const Result<NpyArray> array = readNpy(folder.put("fuzz.npy", fuzz::asText(data, size)));
  if (!array) {
    require(!array.error().text().empty(), "a refusal says why");
    return 0;
  }
  std::size_t count = 1;
  for (const std::size_t extent : array->shape) count *= extent;
  require(count == array->values.size(), "an array has as many values as its shape says");
  require(count * sizeof(float) < size, "no value comes from elsewhere");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  std::size_t made = LLVMFuzzerMutate(data, size, maxSize);
  constexpr std::size_t kPrefix = 10;  // before the header's text in version 1
  if (seed % 4 == 0 || made < kPrefix + 1) return made;
  const std::string_view text = fuzz::asText(data, made);
  const std::size_t end = text.find('}');
  if (end == text.npos || end < kPrefix) return made;
  const std::size_t header = end + 1, wanted = header + cellsIn(text.substr(0, end)) * sizeof(float);
  if (wanted > maxSize || header - kPrefix > 0xffff) return made;
  data[8] = static_cast<std::uint8_t>((header - kPrefix) & 0xff);
  data[9] = static_cast<std::uint8_t>((header - kPrefix) >> 8);
  if (wanted > made) std::memset(data + made, 0, wanted - made);
  return wanted;
}
