#pragma once
// The pictures laid over the field that change density, height and colour of the meadow, on the GPU
// (shaders/include/grass_maps.glsl).

#include <array>
#include <memory>

#include "engine/core/result.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/model/project.hpp"

namespace windloom {

class GrassMaps {
 public:
  /// Fails with Machine.
  static Result<GrassMaps> create();

  /// Takes over the maps; a map that is the same as before is not uploaded again. Fails with Machine; the
  /// maps then stay as they were.
  Status configure(const GrassSettings& grass);

  /// For all passes of a frame.
  void bind() const;

 private:
  struct Map {
    std::shared_ptr<const GrassMap> pixels;
    gpu::Texture texture;
  };
  GrassMaps() = default;
  static Status adopt(Map& map, const std::shared_ptr<const GrassMap>& pixels, const char* label, std::uint8_t neutral);

  std::array<Map, 3> m_maps;  // density, height, colour
};

}  // namespace windloom
