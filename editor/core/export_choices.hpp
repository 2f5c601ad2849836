#pragma once
// What the user last chose in the export: kept in the preferences, since it belongs to the user and not to a project.

#include <glm/glm.hpp>
#include <set>
#include <string>
#include <string_view>

#include "editor/core/preferences.hpp"

namespace windloom::editor {

struct ExportChoices {
  std::string preset = "generic";  ///< name of the engine; unknown ones count as this
  std::set<std::string, std::less<>> formats{"exr", "windpack"};
  double from = 2, seconds = 4, fps = 15;  ///< s, s, frames a second
  bool ownWarmUp = false;                  ///< else the wind blows from the project's start on
  double warmUp = 2;                       ///< s, before `from`
  bool loop = true;
  bool ownResolution = true;        ///< else the project's grid
  glm::ivec2 resolution{256, 256};  ///< cells of the written frames
  bool uvFlow = false;              ///< texture coordinates a second instead of speeds in the world
  bool ownFullScale = false;        ///< else from the recording
  double fullScale = 12;            ///< m/s
  int layers = 8;                   ///< of volumes
  double top = 8;                   ///< m
  double reference = 2;             ///< m
  double roughness = 0.03;          ///< m
  bool response = false, graph = false, sidecars = true;
  bool again = false;  ///< export again after changes

  bool operator==(const ExportChoices&) const = default;
};

/// Ranges of the numbers; what is read or typed is brought into them.
struct ChoiceRange {
  double min, max;
};
inline constexpr ChoiceRange kFromRange{0, 3600}, kWarmUpRange{0, 3600}, kSecondsRange{0.05, 3600}, kFpsRange{0.1, 240},
    kSideRange{8, 4096}, kFullScaleRange{0.01, 1000}, kLayersRange{1, 128}, kTopRange{0.1, 1000},
    kReferenceRange{0.1, 1000}, kRoughnessRange{0.0001, 10};

/// What the preferences hold; where they hold nothing, or nonsense, the default.
ExportChoices exportChoices(const Preferences& preferences);
void keepExportChoices(Preferences& preferences, const ExportChoices& choices);

/// The folder that was chosen for this project; empty: none. Kept for as long as the project is a recent file.
std::string exportFolder(const Preferences& preferences, const std::string& project);
void keepExportFolder(Preferences& preferences, const std::string& project, const std::string& folder);

}  // namespace windloom::editor
