#pragma once
// The export's choices as the baker takes them, and what they will cost.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/core/export_choices.hpp"
#include "engine/bake/bake.hpp"

namespace windloom::editor {

/// A request without a folder. Formats that this build doesn't have are left out.
BakeRequest bakeRequest(const ExportChoices& choices, const Project& project);

/// The engine's formats, best first; only those that this build has.
std::vector<std::string_view> proposedFormats(Preset preset);

/// The groups of the formats, in the order of a menu.
std::vector<std::string_view> formatGroups();

/// What a request will take on the disk.
struct ExportSize {
  double bytes = 0;
  bool exact = true;  ///< else about, or at most, that
};
ExportSize sizeOf(const WriterKind& kind, const BakeHeader& header, const BakeRequest& request);
ExportSize sizeOf(const BakeHeader& header, const BakeRequest& request);
/// "12.3 MB", "about 12.3 MB".
std::string sizeText(const ExportSize& size);

/// What to know about the chosen formats before: "fga: 256 x 256 cells are averaged down ...".
std::vector<std::string> warningsOf(const BakeHeader& header, const BakeRequest& request);

bool hasVolume(const BakeRequest& request);     ///< a format with height layers
bool hasFullScale(const BakeRequest& request);  ///< a format of integers, which stand for parts of a full scale

/// Free bytes of the disk that a folder lies on, or will lie on; looked up every few seconds.
class FreeSpace {
 public:
  /// Nothing where it can't be told.
  std::optional<double> of(const std::filesystem::path& folder);

 private:
  std::filesystem::path m_folder;
  std::chrono::steady_clock::time_point m_at;
  std::optional<double> m_bytes;
};

}  // namespace windloom::editor
