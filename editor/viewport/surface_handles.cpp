// Marks of surfaces and rotors.
#include "editor/core/object_kind.hpp"
#include "editor/core/surface_shape.hpp"
#include "editor/viewport/ground_brush.hpp"

namespace windloom::editor {
namespace {

/// The edges of its box, and a line down to its handle where it hangs in the air.
void drawBox(const GroundBrush& brush, const Surface& surface, ImU32 colour) {
  const auto corners = cornersOf(surface, brush.ground());
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t next = (i + 1) % 4;
    brush.line(corners[i], corners[next], colour, scaled(2.0f));
    brush.line(corners[i + 4], corners[next + 4], colour, scaled(2.0f));
    brush.line(corners[i], corners[i + 4], colour, scaled(2.0f));
  }
  const glm::vec3 foot = brush.ground().lift(surface.position);
  if (corners[0].y > foot.y) brush.line(foot, {foot.x, corners[0].y, foot.z}, colour, scaled(2.0f));
}

}  // namespace

void drawSurfaces(const GroundBrush& brush, const Project& project, const Marks& marks, bool withOutlines) {
  const Palette& palette = look().palette;
  const ImVec4 plain{0.72f, 0.94f, 0.66f, 0.95f};
  for (const Surface& surface : *project.surfaces) {
    if (surface.hidden) continue;
    const bool selected = marks.selected(surface.id), hovered = marks.hovered == surface.id;
    const ImU32 colour = packed(selected ? palette.accent : plain);
    if (withOutlines || selected || hovered) drawBox(brush, surface, colour);
    const auto at = brush.screen(surface.position);
    if (!at || !brush.inside(*at)) continue;
    diamond(brush, *at, selected || hovered, packed(selected || hovered ? palette.accent : plain));
    name(brush, "surface:" + std::to_string(surface.id), *at);
  }
}

/// A ring with two blades at its height, and a stem down to its handle; on the ground the disc below it.
void drawRotors(const GroundBrush& brush, const Project& project, const Marks& marks) {
  const Palette& palette = look().palette;
  const ImVec4 plain{0.62f, 0.86f, 0.98f, 0.95f};
  for (const Rotor& rotor : *project.rotors) {
    if (rotor.hidden) continue;
    const bool selected = marks.selected(rotor.id), hovered = marks.hovered == rotor.id;
    const float strength = rotor.muted ? 0.4f : 1.0f;
    const ImU32 colour = packed(selected || hovered ? palette.accent : plain, strength);
    const std::vector<glm::vec3> ring = ringOf(rotor, brush.ground());
    for (std::size_t i = 0; i < ring.size(); ++i)
      brush.line(ring[i], ring[(i + 1) % ring.size()], colour, scaled(selected ? 2.5f : 2.0f));
    for (std::size_t blade = 0; blade < 4; ++blade)
      brush.line(hubOf(rotor, brush.ground()), ring[blade * ring.size() / 4], colour, scaled(2.0f));
    const glm::vec3 foot = brush.ground().lift(rotor.position);
    brush.line(foot, hubOf(rotor, brush.ground()), packed(selected ? palette.accent : plain, 0.6f * strength),
               scaled(1.0f));
    if (selected) brush.ring(foot, rotor.radius, packed(palette.accent, 0.5f), scaled(1.0f));
    const auto at = brush.screen(rotor.position);
    if (!at || !brush.inside(*at)) continue;
    diamond(brush, *at, selected || hovered, colour);
    name(brush, "rotor:" + std::to_string(rotor.id), *at);
  }
}

}  // namespace windloom::editor
