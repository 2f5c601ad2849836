#pragma once
// What every writer is told about the recording.

#include <glm/glm.hpp>
#include <string>

#include "engine/bake/height_profile.hpp"
#include "engine/bake/preset.hpp"
#include "engine/core/grid_mapping.hpp"

namespace windloom {

/// What a frame's vectors are.
enum class Quantity {
  Wind,  ///< velocity, m/s
  Bend,  ///< how far plants lean: direction times angle of the tip, rad (response.hpp)
};

/// One stream of frames of a bake: the wind, or the answer of one class of plants. Every format is written once for
/// each track.
struct Track {
  std::string name = "wind";  ///< as in the manifest; file names of other tracks than the wind begin with it
  Quantity quantity = Quantity::Wind;
};

/// What image formats hold.
enum class FlowSpace {
  World,  ///< vectors along the target's ground axes, in its units
  Uv,     ///< texture coordinates a second, for shaders that pan a texture
};

struct BakeHeader {
  GridMapping grid{};       ///< of the written frames
  int frames = 1;           ///< of the whole recording
  int first = 0, last = 0;  ///< these of them are written (first <= last < frames)
  double fps = 30;
  double start = 0;   ///< s: time of frame 0 in the project
  int crossfade = 0;  ///< frames blended into the seam
  bool loop = false;
  bool periodicX = false, periodicZ = false;  ///< the field repeats there
  float fastest = 0;      ///< m/s (rad): no cell of any frame is longer; 0 where no writer needs to know it
  float fastestHalf = 0;  ///< the same of vectors rounded to half floats
  float fullScale = 1;    ///< m/s (rad) that integer formats encode as their greatest code; > 0
  Preset preset = Preset::Generic;
  FlowSpace space = FlowSpace::World;
  Track track;
  HeightProfile profile;  ///< how volumes go on above the field
  std::string project;    ///< its name
  std::string formats;    ///< of the bake, as on the command line

  [[nodiscard]] int written() const { return last - first + 1; }
};

/// "flow" for the wind, "bend-soft-flow" for the track "bend-soft".
std::string stemOf(const Track& track, const std::string& stem);

/// "flow.0007.png": four digits, more from frame 10,000 on.
std::string frameFile(const Track& track, const std::string& stem, int frame, const std::string& extension);

}  // namespace windloom
