#pragma once
// Shell grass: layers over the ground and over surfaces that show cuts through blades (Bakay, Lalonde & Heidrich,
// "Real-time animated grass", 2002), and what lies between them.
//
// The texture is made beside the frame. Tiles of the ground in sight (shell_tiles.hpp) are each drawn with as many
// shells as their distance needs, groups of near tiles first and their uppermost shells first, in one call; every
// surface in one more. A fragment looks down to the next shell, so that a few shells show what many would.
// ShellMethod::Plain draws as the paper did.

#include <array>
#include <memory>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/gpu/buffer.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "engine/grass/made_beside.hpp"
#include "engine/grass/shell_placing.hpp"
#include "engine/grass/shell_texture.hpp"
#include "engine/grass/shell_tiles.hpp"
#include "engine/grass/shell_view.hpp"

namespace windloom {

/// How the shell grass of a frame is drawn; see FrameQuality.
struct ShellFrame {
  float detail = 1.0f;   ///< 0..1
  bool thinning = true;  ///< false: it doesn't turn into the ground's shading, however small, and shows just what plain
                         ///< shells would
  int samples = 1;       ///< a pixel
  bool quick = false;    ///< on a software renderer
};

class ShellGrass {
 public:
  /// Fails with Machine.
  static Result<ShellGrass> create(gpu::ShaderLibrary& shaders);

  /// Takes over what the texture shows and how blades bend; costs nothing while that stays the same. With `Later` the
  /// texture of before is kept until the new one is made. Fails with Machine where the GPU has no memory: the grass
  /// stays as it was.
  Status configure(const Project& project, Placement placement);
  [[nodiscard]] bool growing() const { return m_job != nullptr; }

  /// Fills the settings for this frame and finds the tiles in sight. Fails with Machine, and then nothing is drawn.
  Status prepare(const Project& project, const ShellFrame& frame, const shared::FrameBlock& view);

  /// The ground's shells. Frame block, grass settings, wind, noise, ground, maps, map of solids, colliders' shades and
  /// rotors must be bound.
  void drawGround(const gpu::PassState& state);

  /// Makes ready for the shells of a surface whose mesh is at `world`, `away` m from the camera: gives how many
  /// instances of the mesh are to be drawn then, 0 where nothing is. The same as above must be bound. Vertices bring
  /// their position at location 0, their normal at 1.
  int useSurface(const Surface& surface, const glm::mat4& world, float away, const gpu::PassState& state);

  [[nodiscard]] const ShellCounts& counts() const { return m_counts; }
  /// In the texture's square, times the area of the field over its own.
  [[nodiscard]] long long blades() const;

 private:
  /// Shells of one count, for tiles from some distance on.
  struct Level {
    ShellPlacing placing;
    float from = 0;         // m
    std::size_t count = 0;  // of placing.ends that blades reach
  };
  ShellGrass() = default;
  Status makeTexture(const Result<ShellTexture>& made);
  Status makeBending(const ShellSettings& shell);
  void spreadLevels(const shared::FrameBlock& view, const ShellFrame& frame);
  void listTiles(const std::vector<ShellTile>& tiles);
  void listFilled(const std::vector<ShellTile>& tiles);
  void addShell(const ShellTile& tile, std::size_t level, std::size_t shell);
  [[nodiscard]] std::size_t levelOf(const ShellTile& tile) const;
  Result<gpu::Program*> program(const ShellSettings& shell, const char* name) const;
  Status uploadInstances();

  gpu::ShaderLibrary* m_shaders = nullptr;
  std::shared_ptr<MadeBeside<ShellTexture>> m_job;
  Project m_made;  // that the texture was made from
  bool m_any = false;
  ShellSettings m_bending;  // that table and levels were made from
  bool m_bent = false;
  ShellTexture m_texture;  // without its levels
  float m_highest = 1;     // part of the tallest height that something of the texture reaches
  gpu::Texture m_form, m_colour, m_offsets;
  gpu::Buffer m_settings, m_instances;
  std::array<gpu::Buffer, 2> m_indices;  // full, quick
  std::array<gpu::VertexArray, 2> m_lattices;
  std::vector<Level> m_levels;  // falling number of shells
  std::vector<shared::ShellInstance> m_list;
  GrowthMask m_mask;
  std::shared_ptr<const GrassMap> m_maskMap;
  Shared<FieldSettings> m_maskField;
  Shared<ShellSettings> m_shell;
  Shared<GrassSettings> m_grass;
  bool m_ready = false;       // prepared for this frame
  float m_groundPart = 1.0f;  // of the texture's blades that the ground has
  ShellFrame m_frame;
  int m_groundInstances = 0;
  ShellCounts m_counts;
  double m_area = 0;  // m^2 of the field
};

}  // namespace windloom
