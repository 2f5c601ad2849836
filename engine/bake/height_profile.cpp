#include "engine/bake/height_profile.hpp"

#include <cmath>

namespace windloom {

float HeightProfile::at(float height) const {
  return height > 0.0f ? std::log1p(height / roughness) / std::log1p(reference / roughness) : 0.0f;
}

float HeightProfile::heightOf(int n) const {
  return layers == 1 ? reference : (static_cast<float>(n) + 0.5f) * top / static_cast<float>(layers);
}

}  // namespace windloom
