#pragma once
// What a frame of shell grass drew.

namespace windloom {

struct ShellCounts {
  int nearShells = 0;     ///< over the ground nearest to the camera
  int tiles = 0;          ///< pieces of the ground in sight that grass stands on
  int layers = 0;         ///< pieces of shells drawn, all in one call for the ground and one for each surface
  int skippedLayers = 0;  ///< that no blade reaches
  float error = 0;        ///< how far shells are off from the bent blades between them at most, part of the height
};

}  // namespace windloom
