#include "engine/bake/bake.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "engine/bake/frame_spool.hpp"
#include "engine/bake/manifest.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/core/text.hpp"
#include "engine/io/npy.hpp"
#include "engine/io/sha256.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

/// A folder in which the files come into being; removed with all that is in it.
class WorkFolder {
 public:
  static Result<WorkFolder> create(const fs::path& parent) {
    std::string name = (parent / ".bake.XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      return makeError(ErrorKind::Machine, parent.string(), {},
                       std::string("can't write here: ") + std::strerror(errno));
    }
    return WorkFolder(name);
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (!m_path.empty()) fs::remove_all(m_path, ignored);
  }
  WorkFolder(WorkFolder&& other) noexcept : m_path(std::exchange(other.m_path, {})) {}
  WorkFolder& operator=(WorkFolder&&) = delete;
  [[nodiscard]] const fs::path& path() const { return m_path; }

 private:
  explicit WorkFolder(fs::path path) : m_path(std::move(path)) {}
  fs::path m_path;
};

float fastestOf(std::span<const glm::vec2> cells) {
  float square = 0;
  for (const glm::vec2 v : cells) square = std::max(square, glm::dot(v, v));
  return std::sqrt(square);
}

/// A speed to encode as full scale: the fastest wind rounded up to a hundredth; 1 m/s for still air.
float rangeFor(float fastest) {
  if (!(fastest > 0.0f)) return 1.0f;
  const float rounded = std::ceil(fastest * 100.0f) / 100.0f;
  return std::max(rounded, fastest);
}

class Baker {
 public:
  Baker(Simulation& simulation, const BakeRequest& request, const std::function<bool(const BakeProgress&)>& keepGoing,
        fs::path work)
      : m_simulation(simulation), m_request(request), m_keepGoing(keepGoing), m_work(std::move(work)) {
    const FieldSettings& field = *simulation.project().field;
    const glm::ivec2 resolution = request.resolution.value_or(simulation.solver().grid().resolution);
    m_header.grid = makeGridMapping(field.centre, field.size, resolution);
    m_header.frames = request.plan.frames;
    m_header.fps = request.plan.fps;
    m_header.start = request.plan.from;
    m_header.loop = request.loop;
    m_header.crossfade = request.plan.crossfade;
    m_header.periodicX = field.xMin == Border::Periodic && field.xMax == Border::Periodic;
    m_header.periodicZ = field.zMin == Border::Periodic && field.zMax == Border::Periodic;
    m_header.preset = request.preset;
    for (const WriterKind* kind : request.formats) {
      const bool known = kind->need == SpeedNeed::None || (kind->need == SpeedNeed::Range && request.speedRange);
      m_spooled = m_spooled || !known || request.plan.crossfade > 0;
    }
  }

  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(m_header.grid.resolution.x) * static_cast<std::size_t>(m_header.grid.resolution.y);
  }

  /// Refuses at once what can't end well.
  Status requireSpace() const {
    std::uint64_t needed = 0;
    const auto frames = static_cast<std::uint64_t>(m_header.frames);
    for (const WriterKind* kind : m_request.formats) {
      if (kind->name != "png")
        needed += kind->bytesPerFrame(m_header.grid.resolution) * frames;  // PNG shrinks, nobody knows how far
    }
    std::error_code ec;
    const fs::space_info space = fs::space(m_work, ec);
    if (ec || space.available == 0 || needed <= space.available) return Done{};
    return makeError(ErrorKind::Machine, m_request.folder.string(), {},
                     "the bake needs " + std::to_string(needed >> 20) + " MiB, the disk has " +
                         std::to_string(space.available >> 20) + " MiB free");
  }

  Status run() {
    if (Status enough = requireSpace(); !enough) return enough;
    return m_spooled ? runSpooled() : runDirect();
  }

  /// Sums of all files, and the manifest that lists them.
  Status writeManifest() {
    std::vector<ManifestFile> listed;
    for (BakedFile& file : m_files) {
      const Result<std::string> digest = sha256OfFile(m_work / file.path);
      if (!digest) return digest.error();
      listed.push_back({std::move(file), *digest});
    }
    for (const ManifestFile& file : listed) m_report.files.push_back(file.file.path);
    m_report.files.emplace_back("manifest.json");
    const std::string text = manifestText(m_header, m_simulation.project(), m_simulation.solver().backend(), listed);
    return writeFileAtomically(m_work / "manifest.json", text);
  }

  /// Moves everything to its place; the manifest, which makes it a bake, comes last.
  Status publish() {
    const std::vector<std::string> older = filesOfManifest(m_request.folder);
    std::error_code ec;
    for (const std::string& name : m_report.files) {
      m_report.bytes += fs::file_size(m_work / name, ec);
      fs::rename(m_work / name, m_request.folder / name, ec);
      if (ec)
        return makeError(ErrorKind::Machine, (m_request.folder / name).string(), {}, "can't write: " + ec.message());
    }
    for (const std::string& name : older) {
      if (std::find(m_report.files.begin(), m_report.files.end(), name) == m_report.files.end()) {
        fs::remove(m_request.folder / name, ec);
      }
    }
    return Done{};
  }

  BakeReport report() {
    m_report.header = m_header;
    m_report.steps = m_simulation.steps();
    return std::move(m_report);
  }
  [[nodiscard]] bool cancelled() const { return m_report.cancelled; }

 private:
  bool keepGoing(BakePhase phase, double done, double all) {
    return !m_keepGoing || m_keepGoing({phase, all > 0 ? std::min(done / all, 1.0) : 1.0});
  }

  Status openWriters() {
    m_header.speedRange = m_request.speedRange.value_or(rangeFor(m_header.fastest));
    for (const WriterKind* kind : m_request.formats) {
      Result<std::unique_ptr<FrameWriter>> writer = kind->open(m_header, m_work);
      if (!writer) return writer.error();
      m_writers.push_back(std::move(*writer));
    }
    return Done{};
  }

  Status addToAll(int frame, std::span<const glm::vec2> cells) {
    for (const std::unique_ptr<FrameWriter>& writer : m_writers) {
      if (Status added = writer->add(frame, cells); !added) return added;
    }
    return Done{};
  }

  Status finishWriters() {
    for (const std::unique_ptr<FrameWriter>& writer : m_writers) {
      Result<std::vector<BakedFile>> files = writer->finish();
      if (!files) return files.error();
      std::move(files->begin(), files->end(), std::back_inserter(m_files));
    }
    return Done{};
  }

  Status recordInto(const std::function<Status(int, std::span<const glm::vec2>)>& sink) {
    const auto take = [&](int frame, std::span<const glm::vec2> field) -> Status {
      m_header.fastest = std::max(m_header.fastest, fastestOf(field));
      return sink(frame, field);
    };
    const auto stepped = [&](const RecordProgress& p) {
      return keepGoing(BakePhase::Recording, static_cast<double>(p.step), static_cast<double>(p.steps));
    };
    const Result<RecordEnd> end = record(m_simulation, m_request.plan, m_request.resolution, take, stepped);
    if (!end) return end.error();
    m_report.cancelled = *end == RecordEnd::Cancelled;
    return Done{};
  }

  Status runDirect() {
    if (Status opened = openWriters(); !opened) return opened;
    Status recorded = recordInto([&](int frame, std::span<const glm::vec2> field) { return addToAll(frame, field); });
    return !recorded || m_report.cancelled ? recorded : finishWriters();
  }

  Status runSpooled() {
    FrameSpool spool(cells(), m_work);
    Status recorded = recordInto([&](int, std::span<const glm::vec2> field) { return spool.add(field); });
    if (!recorded || m_report.cancelled) return recorded;
    if (Status opened = openWriters(); !opened) return opened;
    std::vector<glm::vec2> field, after;
    for (int frame = 0; frame < m_header.frames; ++frame) {
      if (!keepGoing(BakePhase::Writing, frame, m_header.frames)) {
        m_report.cancelled = true;
        return Done{};
      }
      if (Status read = spool.read(frame, field); !read) return read;
      if (frame < m_header.crossfade) {
        if (Status read = spool.read(m_header.frames + frame, after); !read) return read;
        blend(field, after, seamWeight(m_request.plan, frame));
      }
      if (Status added = addToAll(frame, field); !added) return added;
    }
    keepGoing(BakePhase::Writing, 1, 1);
    return finishWriters();
  }

  /// field = mix(after, field, weight).
  static void blend(std::vector<glm::vec2>& field, const std::vector<glm::vec2>& after, float weight) {
    for (std::size_t i = 0; i < field.size(); ++i) field[i] = glm::mix(after[i], field[i], weight);
  }

  Simulation& m_simulation;
  const BakeRequest& m_request;
  const std::function<bool(const BakeProgress&)>& m_keepGoing;
  fs::path m_work;
  BakeHeader m_header;
  bool m_spooled = false;
  std::vector<std::unique_ptr<FrameWriter>> m_writers;
  std::vector<BakedFile> m_files;
  BakeReport m_report;
};

}  // namespace

Result<BakeReport> bake(Simulation& simulation, const BakeRequest& request,
                        const std::function<bool(const BakeProgress&)>& keepGoing) {
  WL_REQUIRE(!request.formats.empty(), "a bake has a format");
  WL_REQUIRE(request.plan.frames >= 1 && request.plan.frames <= kMaxBakeFrames, "number of frames out of range");
  if (Status made = makeFolder(request.folder); !made) return made.error();
  Result<WorkFolder> work = WorkFolder::create(request.folder);
  if (!work) return work.error();
  Baker baker(simulation, request, keepGoing, work->path());
  if (Status ran = baker.run(); !ran) return ran.error();
  if (!baker.cancelled()) {
    if (Status written = baker.writeManifest(); !written) return written.error();
    if (Status published = baker.publish(); !published) return published.error();
  }
  if (const long broken = simulation.solver().diagnostics().nonFiniteCells; broken > 0) {
    logWarning(std::to_string(broken) + " cells stopped being finite on the way and were reset");
  }
  return baker.report();
}

Status loadInitialField(Simulation& simulation, const fs::path& path, double time) {
  Result<NpyArray> array = readNpy(path);
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
