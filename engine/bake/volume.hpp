#pragma once
// A recorded frame as a block of vectors in an engine's axes: the field's plane times layers of height.

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/bake/bake_header.hpp"
#include "engine/session/resample.hpp"

namespace windloom {

/// The layers of a volume, from the ground up.
struct VolumeLayers {
  std::vector<float> factors;     ///< what the field is multiplied with in each; at least one
  float low = 0.0f, high = 1.0f;  ///< m over the ground: where the first begins and the last ends
};

/// The layers that a header's volumes have, but no more than `most` (then thicker ones of the same height). The wind
/// follows the height profile; a bend is a plant's own and the same at every height. One layer is the field as it is,
/// with the profile's reference height in its middle.
VolumeLayers layersOf(const BakeHeader& header, int most);

/// A vector for a manifest, 0.1f written as 0.1.
nlohmann::ordered_json plainTriple(glm::vec3 value);

/// Corners in the target's frame and unit of length.
struct VolumeBox {
  glm::vec3 min, max;
};

class Volume {
 public:
  /// `grid` in our own frame. The block is in the axes of `preset`, whatever the header's.
  Volume(const GridMapping& grid, VolumeLayers layers, Quantity quantity, Preset preset);

  /// Cells along the target's x, y and z.
  [[nodiscard]] glm::ivec3 size() const;
  [[nodiscard]] std::size_t cells() const;
  [[nodiscard]] const VolumeBox& box() const { return m_box; }
  /// "m/s", "cm/s" or "rad".
  [[nodiscard]] const std::string& unit() const { return m_unit; }
  /// What turns a length of one of our vectors into `unit()`.
  [[nodiscard]] float unitFactor() const { return m_unitFactor; }
  /// How much faster the fastest layer is than the field.
  [[nodiscard]] float fastestFactor() const;

  /// The frame's vectors along the target's axes, in unit(): x fastest, then y, then z of the target. `out` is resized
  /// to cells(). What is beyond the range of half floats (655 m/s in centimetres) is shortened to it without turning.
  void block(std::span<const glm::vec2> cells, std::vector<glm::vec3>& out) const;

  /// What a manifest says of such a file: number of the frame, coordinates, cells, corners, units.
  [[nodiscard]] nlohmann::ordered_json details(int frame) const;

 private:
  const PresetRules& m_rules;
  glm::ivec2 m_plane;
  VolumeLayers m_layers;
  VolumeBox m_box{};
  std::string m_unit;
  float m_unitFactor = 1;
  bool m_zUp = false;
};

/// Frames brought to at most so many cells a side by an area filter, keeping the shape of the cells as well as whole
/// numbers allow.
class FittedField {
 public:
  FittedField(const GridMapping& grid, int mostPerSide);

  [[nodiscard]] const GridMapping& grid() const { return m_grid; }
  /// The frame on grid(): `cells` itself where nothing has to change, else held until the next call.
  std::span<const glm::vec2> of(std::span<const glm::vec2> cells);

 private:
  GridMapping m_grid{};
  std::optional<Resampler> m_resampler;
  std::vector<glm::vec2> m_fitted;
};

/// The cells of FittedField.
glm::ivec2 fittedResolution(glm::ivec2 resolution, int mostPerSide);

/// "1000 x 1000 cells are averaged down to 128 x 128, ..." where `header` has more a side, "" else.
std::string fittingWarning(const BakeHeader& header, int mostPerSide, const std::string& limitOf);

}  // namespace windloom
