#pragma once
// The whole export: records the wind of a project and writes it in one or more formats with a manifest.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/bake/frame_writer.hpp"
#include "engine/bake/recorder.hpp"
#include "engine/bake/seam.hpp"
#include "engine/session/resample.hpp"

namespace windloom {

inline constexpr int kMaxBakeFrames = 100'000;
inline constexpr std::int64_t kMaxBakeCells = std::int64_t{1} << 38;  ///< frames x cells: 2 TiB of wind

struct BakeRequest {
  std::filesystem::path folder;            ///< made where it isn't there
  std::vector<const WriterKind*> formats;  ///< at least one, none twice
  RecordPlan plan;
  bool loop = false;                     ///< then plan.crossfade says how many frames are blended
  std::optional<glm::ivec2> resolution;  ///< of the written frames; the wind always runs on the project's
  std::optional<float> fullScale;        ///< m/s that integer formats encode as full scale; else from the recording
  Preset preset = Preset::Generic;
  FlowSpace space = FlowSpace::World;
  HeightProfile profile;  ///< of volumes and wind packs
  bool response = false;  ///< also how plants lean: four more tracks (response.hpp)
  bool graph = false;     ///< also the arrow graph (graph_gltf.hpp)
  bool sidecars = true;   ///< also import settings, snippets and a how-to (sidecars.hpp)
  /// Writes only these frames of the plan (first, last), which then are the same bytes as in the whole recording; the
  /// simulation runs up to them. Several bakes into one folder, also at the same time, complete each other: the one
  /// that finds all frames there writes the manifest of the whole. Only with formats of numbered files and, where one
  /// needs it, a full scale.
  std::optional<std::pair<int, int>> part;
};

/// What the writers of this request will be told, before anything ran: for sizes and warnings.
BakeHeader headerOf(const Project& project, const BakeRequest& request);

enum class BakePhase { Recording, Writing };

struct BakeProgress {
  BakePhase phase = BakePhase::Recording;
  double part = 0;  ///< of the phase, 0..1
};

struct BakeReport {
  bool cancelled = false;                    ///< then nothing was written
  bool complete = true;                      ///< false: a part, and other parts are still missing
  std::vector<std::pair<int, int>> missing;  ///< these frames, first and last, where it isn't complete
  std::vector<std::string> files;            ///< names in the folder, the manifest last
  SeamReport seam;                           ///< of a loop
  std::uint64_t bytes = 0;                   ///< of all of them
  BakeHeader header;
  long steps = 0;  ///< of the simulation at the end
};

/// Runs `simulation` from where it stands through the plan. All files are written to a folder inside `folder` and
/// moved out when every one of them is complete: neither a failure nor a cancelled bake leaves anything, and an older
/// bake stays as it was until then. Files that the older manifest lists and the new one doesn't are removed. Frames
/// are kept in memory or in a temporary file only where a format has to know the fastest wind beforehand, or for a
/// loop. `keepGoing` is asked often; where it says no the bake is cancelled. Fails with Machine (disk full, folder
/// not writable) and with BadInput (a format can't hold that many frames).
Result<BakeReport> bake(Simulation& simulation, const BakeRequest& request,
                        const std::function<bool(const BakeProgress&)>& keepGoing);

/// Starts a simulation from a .npy file of float32 [height, width, 2] in m/s, rows z ascending, of the project's
/// resolution; of an array [frames, height, width, 2] (a bake) the last frame is taken, which continues it. The field
/// is that of `time` s, rounded to whole time steps. Fails with BadInput.
Status loadInitialField(Simulation& simulation, const std::filesystem::path& path, double time = 0);

}  // namespace windloom
