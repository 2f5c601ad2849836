#include "engine/bake/flow_facts.hpp"

#include "engine/core/text.hpp"

namespace windloom {
namespace {

std::string boundsText(const BakeHeader& header) {
  const PresetBounds bounds = boundsIn(rulesOf(header.preset), header.grid.minCorner, header.grid.size);
  return shortest(bounds.min.x) + " " + shortest(bounds.min.y) + " " + shortest(bounds.max.x) + " " +
         shortest(bounds.max.y);
}

bool inTextureSpace(const BakeHeader& header) {
  return header.space == FlowSpace::Uv && header.track.quantity == Quantity::Wind;
}

std::string axesText(const BakeHeader& header) {
  if (inTextureSpace(header)) return "u v";
  const PresetRules& rules = rulesOf(header.preset);
  return std::string(rules.axes[0]) + " " + std::string(rules.axes[1]);
}

/// Along which texture coordinates the recording repeats.
std::string wrapText(const BakeHeader& header) {
  if (!header.periodicX && !header.periodicZ) return "none";
  return std::string(header.periodicX ? "u" : "") + (header.periodicZ ? "v" : "");
}

}  // namespace

std::vector<std::pair<std::string, std::string>> flowFacts(const BakeHeader& header, const TargetFrame& target) {
  const PresetRules& rules = rulesOf(header.preset);
  return {{"axes", axesText(header)},
          {"bounds", boundsText(header)},
          {"fps", shortest(header.fps)},
          {"frames", std::to_string(header.frames)},
          {"lengthUnit", std::string(rules.lengthUnit)},
          {"loop", header.loop ? "yes" : "no"},
          {"preset", std::string(rules.name)},
          {"space", inTextureSpace(header) ? "uv" : "world"},
          {"start", shortest(header.start)},
          {"track", header.track.name},
          {"unit", target.unit()},
          {"wrap", wrapText(header)}};
}

}  // namespace windloom
