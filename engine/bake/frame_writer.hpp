#pragma once
// The export formats. A format is one file with a class derived from FrameWriter, and one line in the list of
// writer_kinds.cpp. docs/formats.md has their bytes.

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bake/bake_header.hpp"
#include "engine/core/result.hpp"

namespace windloom {

/// One file that a writer left in its folder.
struct BakedFile {
  std::string path;      ///< in the folder
  std::string role;      ///< "field": our frame; "flow": images in the preset's frame; "volume"; "graph"; "sidecar"
  std::string encoding;  ///< "float32", "half", "unorm8", "unorm16", "bc5", "text"
  /// What else the manifest's entry says, e.g. {"frame": 3}, {"layout": "array"}, {"bounds": ...}; null: nothing.
  nlohmann::ordered_json details = {};
};

class FrameWriter {
 public:
  virtual ~FrameWriter() = default;

  /// Frames header.first to header.last in order, each with the header's grid: width x height (vx, vz) in m/s (rad),
  /// rows z ascending. Fails with Machine.
  virtual Status add(int frame, std::span<const glm::vec2> cells) = 0;

  /// After the last frame: completes the files and names them.
  virtual Result<std::vector<BakedFile>> finish() = 0;
};

/// Which speeds a writer must know before it starts.
enum class SpeedNeed {
  None,
  Range,    ///< fullScale: from the recording, unless the user gave one
  Fastest,  ///< fastest: always from the recording
};

struct WriterKind {
  std::string_view name;        ///< as on the command line
  std::string_view group = {};  ///< for menus: "Images", "Textures", "Volumes", "Data"
  std::string_view help;
  SpeedNeed need = SpeedNeed::None;
  bool numbered = false;   ///< a file (or several) a frame, so that a bake can be split into ranges of frames
  bool exactSize = false;  ///< `bytes` is what it will be, else at most or about that
  /// Of all files of one track, for the check of free space and for sizes in the dialog.
  std::uint64_t (*bytes)(const BakeHeader& header) = nullptr;
  Result<std::unique_ptr<FrameWriter>> (*open)(const BakeHeader& header, const std::filesystem::path& folder) = nullptr;
  /// What the user should know beforehand, e.g. that the grid is resampled to the format's limit; empty: nothing.
  std::string (*warning)(const BakeHeader& header) = nullptr;
  /// Why the format can't hold such a recording (open() fails with the same words as BadInput); empty: it can.
  std::string (*refusal)(const BakeHeader& header) = nullptr;
  /// Formats that need a library which was left out of this build say so here; open() then fails with Machine.
  std::string_view missing = {};
};

std::span<const WriterKind> writerKinds();
/// Null for an unknown name.
const WriterKind* writerKindNamed(std::string_view name);

}  // namespace windloom
