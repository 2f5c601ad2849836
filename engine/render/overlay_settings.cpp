#include "engine/render/overlay_settings.hpp"

#include <algorithm>

namespace windloom {
namespace {

constexpr OverlayKind kKinds[] = {
    {.name = "arrows", .mark = &Overlays::arrows},
    {.name = "vectors", .mark = &Overlays::vectors},
    {.name = "streamlines", .mark = &Overlays::streamlines},
    {.name = "speed", .map = GroundMap::Speed},
    {.name = "divergence", .map = GroundMap::Divergence},
    {.name = "vorticity", .map = GroundMap::Vorticity},
    {.name = "lic", .map = GroundMap::Lic},
};

}  // namespace

std::span<const OverlayKind> overlayKinds() {
  return kKinds;
}

const OverlayKind* findOverlay(std::string_view name) {
  const auto* kind = std::ranges::find(kKinds, name, &OverlayKind::name);
  return kind == std::end(kKinds) ? nullptr : kind;
}

bool isOn(const Overlays& overlays, const OverlayKind& kind) {
  return kind.mark != nullptr ? overlays.*kind.mark : overlays.map == kind.map;
}

void setOn(Overlays& overlays, const OverlayKind& kind, bool on) {
  if (kind.mark != nullptr) {
    overlays.*kind.mark = on;
  } else if (on || overlays.map == kind.map) {
    overlays.map = on ? kind.map : GroundMap::None;
  }
}

std::string overlayNames() {
  std::string names;
  for (const OverlayKind& kind : kKinds) names += std::string(kind.name) + ", ";
  return names.substr(0, names.size() - 2) + " or none";
}

Result<Overlays> overlaysByName(std::span<const std::string> names) {
  Overlays overlays;
  overlays.arrows = false;
  const OverlayKind* map = nullptr;
  for (const std::string& name : names) {
    if (name == "none") continue;
    const OverlayKind* kind = findOverlay(name);
    if (kind == nullptr) {
      return makeError(ErrorKind::Usage, "--overlay: found '" + name + "', expected " + overlayNames());
    }
    if (kind->mark == nullptr && map != nullptr && map != kind) {
      return makeError(ErrorKind::Usage, "--overlay: found '" + std::string(map->name) + "' and '" + name +
                                             "', expected at most one map of the ground");
    }
    if (kind->mark == nullptr) map = kind;
    setOn(overlays, *kind, true);
  }
  return overlays;
}

}  // namespace windloom
