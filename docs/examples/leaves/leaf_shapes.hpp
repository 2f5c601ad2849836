#pragma once

#include <vector>

namespace game {

/// A corner of a leaf of length 1, lying flat: x across, y along from the stem (-0.5) to the tip (0.5), and 1 at the
/// rim, 0 inside.
struct LeafCorner {
  float x, y, rim;
};

/// A maple (0), beech (1), oak (2) or birch (3) leaf with its stem, as a fan of triangles: its middle first, then once
/// round its outline.
std::vector<LeafCorner> leafShape(int kind);

}  // namespace game
