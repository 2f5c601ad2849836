#pragma once
// What species of plants and colliders are made of where a file gives their shape, and pictures laid over the field.
// Values only; engine/io reads them.

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace windloom {

inline constexpr std::size_t kMaxPlantTriangles = 20'000;    ///< of one plant
inline constexpr int kMaxPlantTexture = 4096;                ///< pixels per side; larger ones are made smaller
inline constexpr std::size_t kMaxObjectTriangles = 500'000;  ///< of one collider
inline constexpr std::size_t kMaxSpheres = 1024;             ///< of one collider
inline constexpr std::size_t kUsualSpheres = 256;            ///< of one that asks for nothing else
inline constexpr int kMaxGrassMap = 2048;                    ///< pixels per side; larger ones are made smaller

struct PlantVertex {
  glm::vec3 position{0.0f};            ///< m, y up, the root at the origin
  glm::vec3 normal{0.0f, 1.0f, 0.0f};  ///< unit vector
  glm::vec2 uv{0.0f};                  ///< v down, as glTF
  glm::vec4 colour{1.0f};              ///< linear RGB and alpha, times the texture
};

/// A plant, a tuft, or a thing that rolls through the grass. Three indices a triangle, all below vertices.size().
struct PlantMesh {
  std::string file;  ///< that it was read from, as the species or collider names it
  std::vector<PlantVertex> vertices;
  std::vector<std::uint32_t> indices;
  glm::ivec2 textureSize{0};                ///< 0: none
  std::vector<std::uint8_t> texture;        ///< RGBA, sRGB, rows from the top
  float alphaCutoff = 0.5f;                 ///< below it nothing is drawn
  glm::vec3 low{0.0f}, high{0.0f};          ///< bounds, m
  std::vector<glm::vec4> spheres;           ///< packed into it (colliders): centre and radius, m
  std::size_t mostSpheres = kUsualSpheres;  ///< that it was packed with
};

/// A picture laid over the field: its left upper corner lies at low x and low z.
struct GrassMap {
  std::string file;                  ///< as GrassSettings names it
  glm::ivec2 size{0};                ///< pixels
  std::vector<std::uint8_t> pixels;  ///< RGBA a pixel, rows from the top
};

}  // namespace windloom
