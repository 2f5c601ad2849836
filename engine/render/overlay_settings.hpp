#pragma once
// What is laid over the meadow. Marks (arrows, vectors, streamlines) combine freely; the ground has one map at most.

#include <span>
#include <string>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

enum class GroundMap {
  None,
  Speed,
  Divergence,
  Vorticity,
  Lic,  ///< line integral convolution
};

struct Overlays {
  bool arrows = true;        ///< wind trees, points, obstacles' outlines, probes
  bool vectors = false;      ///< wind vectors on a regular grid
  bool streamlines = false;  ///< short lines that run with the wind
  GroundMap map = GroundMap::None;
  float speedRange = 12.0f;      ///< m/s at the top of the speed colours, > 0
  float divergenceRange = 0.5f;  ///< 1/s at both ends of the colours, > 0
  float vorticityRange = 4.0f;   ///< 1/s at both ends of the colours, > 0

  bool operator==(const Overlays&) const = default;
  [[nodiscard]] bool any() const { return arrows || vectors || streamlines || map != GroundMap::None; }
};

/// One overlay by name: for the command line, menus, keys and preferences.
struct OverlayKind {
  std::string_view name;            ///< "streamlines"
  bool Overlays::*mark = nullptr;   ///< a mark's switch; null for a map
  GroundMap map = GroundMap::None;  ///< a map
};

std::span<const OverlayKind> overlayKinds();
/// Null where there is none with this name.
const OverlayKind* findOverlay(std::string_view name);

[[nodiscard]] bool isOn(const Overlays& overlays, const OverlayKind& kind);
/// A map that is switched on takes the place of the map that was.
void setOn(Overlays& overlays, const OverlayKind& kind, bool on);

/// The overlays with these names and no others; "none" adds none. Fails with Usage where a name is unknown or a
/// second map is asked for.
Result<Overlays> overlaysByName(std::span<const std::string> names);

/// "arrows, vectors, ... or none".
std::string overlayNames();

}  // namespace windloom
