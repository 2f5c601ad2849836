// What people type: arithmetic in number fields, numbers, shortcuts, keys during a drag.

#include <cmath>
#include <optional>

#include "editor/core/arithmetic.hpp"
#include "editor/core/number_entry.hpp"
#include "editor/core/shortcut.hpp"
#include "engine/core/text.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"

using namespace windloom;
using namespace windloom::editor;
using fuzz::require;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string exact(fuzz::asText(data, size));
  for (const char* unit : {"", "m", "m/s", "s", "deg"}) {
    const Result<double> value = evaluateArithmetic(exact, unit);
    if (value) {
      require(std::isfinite(*value), "a value is a number");
    } else {
      require(!value.error().text().empty(), "a refusal says why");
    }
  }
  if (const std::optional<double> number = parseNumber(exact)) {
    require(parseNumber(shortest(*number)) == number, "a number is read as it was written");
    require(!fixed(*number, 3).empty(), "a number can be shown");
  }
  if (const std::optional<Shortcut> shortcut = parseShortcut(exact))
    require(parseShortcut(toText(*shortcut)) == shortcut, "a shortcut is read as it was written");
  NumberEntry entry;
  for (std::size_t i = 0; i + 1 < size; i += 2) {
    const auto key = static_cast<Key>(data[i] % static_cast<int>(Key::Count));
    entry.onKey({key, {(data[i + 1] & 1) != 0, (data[i + 1] & 2) != 0, (data[i + 1] & 4) != 0}, false});
    if (const std::optional<float> value = entry.value()) require(std::isfinite(*value), "a typed number is one");
  }
  return 0;
}
