#include "editor/core/size_text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/text.hpp"

namespace windloom::editor {

std::string bytesText(double bytes) {
  static constexpr const char* kUnits[] = {"bytes", "kB", "MB", "GB", "TB"};
  bytes = std::max(0.0, bytes);
  std::size_t unit = 0;
  // What would be rounded to 1000 is 1 of the next unit.
  while (bytes >= 999.5 && unit + 1 < std::size(kUnits)) {
    bytes /= 1000;
    ++unit;
  }
  return fixed(bytes, unit == 0 || bytes >= 99.95 ? 0 : 1) + " " + kUnits[unit];
}

std::string durationText(double seconds) {
  seconds = std::ceil(std::max(0.0, seconds));
  if (seconds < 90) return fixed(seconds, 0) + " s";
  const double minutes = std::ceil(seconds / 60);
  if (minutes < 90) return fixed(minutes, 0) + " min";
  return fixed(std::floor(minutes / 60), 0) + " h " + fixed(std::fmod(minutes, 60.0), 0) + " min";
}

}  // namespace windloom::editor
