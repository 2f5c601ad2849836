#pragma once
// The export formats. A format is one file with a class derived from FrameWriter, and one line in the list of
// writer_kinds.cpp.

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bake/preset.hpp"
#include "engine/core/grid_mapping.hpp"
#include "engine/core/result.hpp"

namespace windloom {

/// What every writer is told about the recording.
struct BakeHeader {
  GridMapping grid{};  ///< of the written frames
  int frames = 1;
  double fps = 30;
  double start = 0;   ///< s: time of frame 0 in the project
  int crossfade = 0;  ///< frames blended into the seam
  bool loop = false;
  bool periodicX = false, periodicZ = false;  ///< the field repeats there
  float fastest = 0;     ///< m/s: no cell of any frame is faster; 0 where no writer needs to know it
  float speedRange = 1;  ///< m/s that integer formats encode as full scale; > 0
  Preset preset = Preset::Generic;
};

/// One file that a writer left in its folder.
struct BakedFile {
  std::string path;      ///< in the folder
  std::string role;      ///< "field": our frame; "flow": an image in the preset's frame
  std::string encoding;  ///< "float32", "half", "unorm8"
};

class FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// The frames in order, each with the header's grid: width x height (vx, vz) in m/s, rows z ascending. Fails with
  /// Machine.
  virtual Status add(int frame, std::span<const glm::vec2> cells) = 0;

  /// After the last frame: completes the files and names them.
  virtual Result<std::vector<BakedFile>> finish() = 0;
};

/// Which speeds a writer must know before it starts.
enum class SpeedNeed {
  None,
  Range,    ///< speedRange: from the recording, unless the user gave one
  Fastest,  ///< fastest: always from the recording
};

struct WriterKind {
  std::string_view name;  ///< as on the command line
  std::string_view help;
  SpeedNeed need;
  std::uint64_t (*bytesPerFrame)(glm::ivec2 resolution);  ///< at most; for the check of free space
  Result<std::unique_ptr<FrameWriter>> (*open)(const BakeHeader& header, const std::filesystem::path& folder);
};

std::span<const WriterKind> writerKinds();
/// Null for an unknown name.
const WriterKind* writerKindNamed(std::string_view name);

// The makers, each in a file of its own name.
Result<std::unique_ptr<FrameWriter>> openNpyWriter(const BakeHeader& header, const std::filesystem::path& folder);
Result<std::unique_ptr<FrameWriter>> openFlowMapWriter(const BakeHeader& header, const std::filesystem::path& folder);
Result<std::unique_ptr<FrameWriter>> openWindpackWriter(const BakeHeader& header, const std::filesystem::path& folder);

}  // namespace windloom
