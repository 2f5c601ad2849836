#include "engine/bake/bake.hpp"

#include <algorithm>
#include <cmath>

#include "engine/bake/bake_parts.hpp"
#include "engine/bake/frame_streams.hpp"
#include "engine/bake/graph_gltf.hpp"
#include "engine/bake/manifest.hpp"
#include "engine/bake/publish.hpp"
#include "engine/bake/sidecars.hpp"
#include "engine/bake/work_folder.hpp"
#include "engine/core/atomic_file.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"
#include "engine/io/file_limits.hpp"
#include "engine/io/npy.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/sha256.hpp"
#include "engine/model/calibration_card.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Refuses what can't be written, before anything runs.
Status requireWritable(const BakeRequest& request, const BakeHeader& header) {
  const std::int64_t cells = std::int64_t{header.grid.resolution.x} * header.grid.resolution.y;
  if (header.frames > kMaxBakeCells / cells) {
    return makeError(ErrorKind::Usage, "that is " + std::to_string(header.frames) + " frames of " +
                                           std::to_string(cells) + " cells, at most " + std::to_string(kMaxBakeCells) +
                                           " cells can be baked in all; use less --seconds, --fps or --resolution");
  }
  std::string whole;
  bool scale = false;
  for (const WriterKind* kind : request.formats) {
    if (!kind->missing.empty())
      return makeError(ErrorKind::Machine, std::string(kind->name) + ": " + std::string(kind->missing));
    if (const std::string refusal = kind->refusal != nullptr ? kind->refusal(header) : ""; !refusal.empty())
      return makeError(ErrorKind::BadInput, std::string(kind->name) + ": " + refusal);
    if (!kind->numbered) whole += (whole.empty() ? "" : ", ") + std::string(kind->name);
    scale = scale || kind->need == SpeedNeed::Range;
  }
  if (!request.part) return Done{};
  if (header.first < 0 || header.last >= header.frames || header.first > header.last)
    return makeError(ErrorKind::Usage, "the frames to write must lie within 0 to " + std::to_string(header.frames - 1));
  if (!whole.empty()) {
    return makeError(ErrorKind::Usage, "a range of frames can be written to formats of numbered files only, and " +
                                           whole + " holds all frames in one file");
  }
  if (scale && !request.fullScale) {
    return makeError(ErrorKind::Usage,
                     "a range of frames doesn't know the fastest wind of the whole recording: give the full scale of "
                     "integer formats (--vmax)");
  }
  return Done{};
}

Status requireSpace(const BakeRequest& request, const BakeHeader& header, const fs::path& folder) {
  const std::uint64_t tracks = request.response ? 1 + plantClasses().size() : 1;
  std::uint64_t needed = 0;
  for (const WriterKind* kind : request.formats) {
    if (kind->exactSize) needed += kind->bytes(header) * tracks;  // others shrink, nobody knows how far
  }
  std::error_code ec;
  const fs::space_info space = fs::space(folder, ec);
  if (ec || space.available == 0 || needed <= space.available) return Done{};
  return makeError(ErrorKind::Machine, request.folder.string(), {},
                   "the bake needs " + std::to_string(needed >> 20) + " MiB, the disk has " +
                       std::to_string(space.available >> 20) + " MiB free");
}

/// Names a plan: the same where, and only where, parts belong together.
/// `start`: what the simulation began with.
std::string planKey(const Project& project, Backend backend, const BakeRequest& request, const BakeHeader& header,
                    const std::string& start) {
  BakeHeader whole = header;
  whole.first = 0;
  whole.last = whole.frames - 1;
  whole.fastest = 0;
  whole.fullScale = request.fullScale.value_or(0.0f);
  std::string text =
      manifestText({whole, {}, request.response, false, {}}, project, backend, {}) + writeProject(project) + start;
  for (const WriterKind* kind : request.formats) text += std::string(kind->name) + ",";
  const HeightProfile& profile = request.profile;
  for (const float value : {whole.fullScale, profile.top, static_cast<float>(profile.layers)})
    text += std::to_string(value) + ",";
  return sha256(text);
}

/// The card turns once in its period: only recordings of whole turns repeat as it does.
void warnOfTurnedCard(const RecordPlan& plan) {
  const double turns = plan.frames / plan.fps / static_cast<double>(kCardPeriod);
  if (std::abs(turns - std::round(turns)) < 1e-6 && turns > 0.5) return;
  logWarning("the calibration card repeats every " + shortest(kCardPeriod) +
             " s: a loop of another length blends it, and the checker won't turn green");
}

class Baker {
 public:
  Baker(Simulation& simulation, const BakeRequest& request, const std::function<bool(const BakeProgress&)>& keepGoing,
        fs::path work)
      : m_simulation(simulation),
        m_request(request),
        m_keepGoing(keepGoing),
        m_work(std::move(work)),
        m_header(headerOf(simulation.project(), request)),
        m_streams(simulation, request, m_header, keepGoing, m_work) {
    m_header.grid = m_streams.header().grid;
    const std::vector<glm::vec2>& air = simulation.velocity();
    const std::string start = std::to_string(simulation.steps()) + ":" +
                              sha256({reinterpret_cast<const char*>(air.data()), air.size() * sizeof air[0]});
    m_plan =
        planKey(simulation.project(), simulation.solver().backend(), request, m_header, start).substr(0, kPlanDigits);
  }

  Status run() {
    if (Status enough = requireSpace(m_request, m_header, m_work); !enough) return enough;
    Result<StreamResult> written = m_streams.run();
    if (!written) return written.error();
    m_report.cancelled = written->cancelled;
    if (m_report.cancelled) return Done{};
    m_header = m_streams.header();
    m_seam = written->seam;
    Result<std::vector<std::vector<Json>>> groups = entriesOf(written->files);
    if (!groups) return groups.error();
    tellOfOtherParts();
    if (m_request.part) return finishPart(std::move(*groups));
    std::vector<BakedFile> files;
    for (StreamFiles& group : written->files) std::ranges::move(group.files, std::back_inserter(files));
    Result<FolderLock> lock = FolderLock::take(m_request.folder, [&] { return keepWaiting(); });
    if (!lock) return lock.error();
    m_report.cancelled = !lock->held();
    if (m_report.cancelled) return Done{};
    return finishWhole(std::move(*groups), std::move(files), m_work);
  }

  BakeReport report() {
    m_report.header = m_header;
    m_report.seam = m_seam;
    m_report.steps = m_simulation.steps();
    return std::move(m_report);
  }

 private:
  Result<std::vector<std::vector<Json>>> entriesOf(const std::vector<StreamFiles>& groups) const {
    std::vector<std::vector<Json>> entries;
    for (const StreamFiles& group : groups) {
      entries.emplace_back();
      for (const BakedFile& file : group.files) {
        Result<Json> entry = manifestEntry(file, group.header, m_work);
        if (!entry) return entry.error();
        entries.back().push_back(std::move(*entry));
      }
    }
    return entries;
  }

  /// What stands beside the frames, and the manifest; then moves everything from `frames` and the work folder out.
  Status finishWhole(std::vector<std::vector<Json>> groups, std::vector<BakedFile> files, const fs::path& frames) {
    std::vector<Json> entries;
    for (std::vector<Json>& group : groups) std::ranges::move(group, std::back_inserter(entries));
    std::vector<BakedFile> extras;
    const Project& project = m_simulation.project();
    if (m_request.graph) {
      Result<BakedFile> graph = writeGraphGltf(project, m_header, files, m_work);
      if (!graph) return graph.error();
      extras.push_back(std::move(*graph));
    }
    if (m_request.sidecars) {
      Result<std::vector<BakedFile>> sidecars = writeSidecars(project, m_header, files, m_work);
      if (!sidecars) return sidecars.error();
      std::ranges::move(*sidecars, std::back_inserter(extras));
    }
    for (const BakedFile& file : extras) {
      Result<Json> entry = manifestEntry(file, m_header, m_work);
      if (!entry) return entry.error();
      entries.push_back(std::move(*entry));
    }
    const ManifestFacts facts{m_header, m_seam, m_request.response, project.solver->source == WindSource::Card, m_plan};
    const std::string text = manifestText(facts, project, m_simulation.solver().backend(), entries);
    if (Status written = writeFileUnsynced(m_work / "manifest.json", text); !written) return written;
    if (Status synced = syncFiles(m_work); !synced) return synced;
    Publication publication{m_request.folder, m_work, frames, {}, files.size()};
    for (const BakedFile& file : files) publication.files.push_back(file.path);
    for (const BakedFile& file : extras) publication.files.push_back(file.path);
    const Result<std::uint64_t> moved = publish(publication);
    if (!moved) return moved.error();
    m_report.bytes += *moved;
    m_report.files = std::move(publication.files);
    m_report.files.emplace_back("manifest.json");
    return Done{};
  }

  /// Puts the part beside the others; completes the bake where it was the last one.
  Status finishPart(std::vector<std::vector<Json>> groups) {
    const fs::path parts = partsFolder(m_request.folder, m_plan);
    if (Status synced = syncFiles(m_work); !synced) return synced;
    Result<FolderLock> lock = FolderLock::take(m_request.folder, [&] { return keepWaiting(); });
    if (!lock) return lock.error();
    m_report.cancelled = !lock->held();
    if (m_report.cancelled) return Done{};
    std::error_code ec;
    // Where the whole bake is there already, the part's files take the place of their likes.
    const bool again = planOfManifest(m_request.folder) == m_plan;
    const fs::path target = again ? m_request.folder : parts;
    if (Status made = makeFolder(target); !made) return made;
    if (!again && !isRealFolder(parts))
      return makeError(ErrorKind::Machine, parts.string(), {}, "is a link, expected a folder: move it away");
    for (const std::vector<Json>& group : groups) {
      for (const Json& entry : group) {
        const std::string name = entry["path"];
        m_report.bytes += fs::file_size(m_work / name, ec);
        fs::rename(m_work / name, target / name, ec);
        if (ec) return makeError(ErrorKind::Machine, (target / name).string(), {}, "can't write: " + ec.message());
        m_report.files.push_back(again ? name : (parts.filename() / name).string());
      }
    }
    if (again) {
      fs::remove_all(parts, ec);
      return Done{};
    }
    if (Status noted = writePart(parts, {m_header.first, m_header.last, m_header.fastest, m_seam, std::move(groups)});
        !noted)
      return noted;
    std::vector<BakePart> there = readParts(parts);
    m_report.missing = missingFrames(there, m_header.frames);
    std::optional<BakePart> whole = joinParts(std::move(there), m_header.frames);
    m_report.complete = whole.has_value();
    if (!whole) return Done{};
    m_report.files.clear();
    m_report.bytes = 0;
    m_header.first = 0;
    m_header.last = m_header.frames - 1;
    m_header.fastest = whole->fastest;
    m_header.fullScale = m_request.fullScale.value_or(fullScaleFor(whole->fastest));
    m_seam = whole->seam;
    std::vector<BakedFile> files;
    for (const std::vector<Json>& group : whole->groups) {
      for (const Json& entry : group) files.push_back(fileOf(entry));
    }
    if (Status finished = finishWhole(std::move(whole->groups), std::move(files), parts); !finished) return finished;
    fs::remove_all(parts, ec);
    return Done{};
  }

  [[nodiscard]] bool keepWaiting() const { return !m_keepGoing || m_keepGoing({BakePhase::Writing, 1}); }

  /// Parts of another plan in the same folder: most often a range was baked with other options by mistake.
  void tellOfOtherParts() const {
    const fs::path own = partsFolder(m_request.folder, m_plan);
    std::error_code ec;
    for (const fs::directory_entry& entry : fs::directory_iterator(m_request.folder, ec)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".parts-") && entry.path() != own) {
        logWarning((m_request.folder / name).string() +
                   " holds parts of a bake with other settings, which don't belong to this one");
      }
    }
  }

  /// What a writer had said of a file of another part.
  static BakedFile fileOf(const Json& entry) {
    BakedFile file{entry["path"], entry["role"], entry["encoding"]};
    for (const auto& [key, value] : entry.items()) {
      if (key != "path" && key != "role" && key != "encoding" && key != "sha256") file.details[key] = value;
    }
    return file;
  }

  Simulation& m_simulation;
  const BakeRequest& m_request;
  const std::function<bool(const BakeProgress&)>& m_keepGoing;
  fs::path m_work;
  BakeHeader m_header;
  FrameStreams m_streams;
  std::string m_plan;  // the same in all parts of one bake
  SeamReport m_seam;
  BakeReport m_report;
};

}  // namespace

BakeHeader headerOf(const Project& project, const BakeRequest& request) {
  const FieldSettings& field = *project.field;
  BakeHeader header;
  header.grid = makeGridMapping(field.centre, field.size, request.resolution.value_or(field.resolution));
  header.frames = request.plan.frames;
  header.first = request.part ? request.part->first : 0;
  header.last = request.part ? request.part->second : header.frames - 1;
  header.fps = request.plan.fps;
  header.start = request.plan.from;
  header.loop = request.loop;
  header.crossfade = request.plan.crossfade;
  const glm::bvec2 wraps = wrapsOf(field);
  header.periodicX = wraps.x;
  header.periodicZ = wraps.y;
  header.fullScale = request.fullScale.value_or(1.0f);
  header.preset = request.preset;
  header.space = request.space;
  header.profile = request.profile;
  header.project = project.name;
  for (const WriterKind* kind : request.formats) {
    if (!header.formats.empty()) header.formats.push_back(',');
    header.formats.append(kind->name);
  }
  return header;
}

Result<BakeReport> bake(Simulation& simulation, const BakeRequest& request,
                        const std::function<bool(const BakeProgress&)>& keepGoing) {
  WL_REQUIRE(!request.formats.empty(), "a bake has a format");
  WL_REQUIRE(request.plan.frames >= 1 && request.plan.frames <= kMaxBakeFrames, "number of frames out of range");
  if (Status can = requireWritable(request, headerOf(simulation.project(), request)); !can) return can.error();
  if (const auto older = filesOfManifest(request.folder); !older) return older.error();
  if (simulation.project().solver->source == WindSource::Card && request.loop) warnOfTurnedCard(request.plan);
  const MadeFolders made(request.folder);
  if (Status there = makeFolder(request.folder); !there) return there.error();
  clearLeftBakes(request.folder);
  Result<WorkFolder> work = WorkFolder::create(request.folder);
  if (!work) return work.error();
  Baker baker(simulation, request, keepGoing, work->path());
  if (Status ran = baker.run(); !ran) return ran.error();
  if (const long broken = simulation.solver().diagnostics().nonFiniteCells; broken > 0) {
    logWarning(std::to_string(broken) + " cells stopped being finite on the way and were reset");
  }
  return baker.report();
}

Status loadInitialField(Simulation& simulation, const fs::path& path, double time) {
  Result<NpyArray> array = readNpy(path, kMaxNpyBytes);
  if (!array) return array.error();
  const std::vector<std::size_t>& shape = array->shape;
  const std::size_t axes = shape.size();
  if ((axes != 3 && axes != 4) || shape.back() != 2 || array->values.empty() || shape[axes - 2] > 1u << 20 ||
      shape[axes - 3] > 1u << 20) {
    return makeError(ErrorKind::BadInput, path.string(), {},
                     "has the wrong shape, expected [height, width, 2] or [frames, height, width, 2]");
  }
  const glm::ivec2 resolution(static_cast<int>(shape[axes - 2]), static_cast<int>(shape[axes - 3]));
  const std::size_t cells = shape[axes - 2] * shape[axes - 3];
  std::vector<glm::vec2> field(cells);
  const float* last = array->values.data() + array->values.size() - 2 * cells;
  for (std::size_t i = 0; i < cells; ++i) field[i] = {last[2 * i], last[2 * i + 1]};
  const long step = std::lround(time / static_cast<double>(simulation.project().field->timeStep));
  if (Status set = simulation.setInitialField(resolution, field, step); !set) {
    Error error = set.error();
    for (Problem& problem : error.problems) problem.file = path.string();
    return error;
  }
  return Done{};
}

}  // namespace windloom
