#pragma once
// Takes frames from a running simulation at the resolution of a recording. On the GPU backend the filter runs there and
// what it gives is read back some frames later, so that neither side waits for the other.

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>

#include "engine/core/result.hpp"
#include "engine/gpu/shader_library.hpp"
#include "engine/session/simulation.hpp"

namespace windloom {

class FrameTap {
 public:
  virtual ~FrameTap() = default;

  /// Asks for the field as it is now. False: as many frames as fit are on their way, take() one first.
  virtual bool ask(int frame) = 0;

  struct Frame {
    int number = 0;
    std::span<const glm::vec2> cells;  ///< rows z ascending, m/s; valid until the next call
  };
  enum class Wait { No, Yes };
  /// The oldest frame that was asked for and not taken yet; nothing where there is none, or it hasn't come.
  virtual std::optional<Frame> take(Wait wait) = 0;
  /// The GPU was reset: frames that were asked for and not taken yet never come.
  [[nodiscard]] virtual bool lost() const { return false; }
};

/// Of frames with `resolution` cells. The simulation must outlive it. Fails with Machine (OpenGL has no memory).
Result<std::unique_ptr<FrameTap>> makeFrameTap(Simulation& simulation, glm::ivec2 resolution);

/// For the test that compiles every shader.
std::span<const gpu::ProgramSpec> frameTapPrograms();

}  // namespace windloom
