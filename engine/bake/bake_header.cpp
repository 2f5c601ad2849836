#include "engine/bake/bake_header.hpp"

namespace windloom {

std::string stemOf(const Track& track, const std::string& stem) {
  return track.quantity == Quantity::Wind ? stem : track.name + "-" + stem;
}

std::string frameFile(const Track& track, const std::string& stem, int frame, const std::string& extension) {
  std::string number = std::to_string(frame);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return stemOf(track, stem) + "." + number + "." + extension;
}

}  // namespace windloom
