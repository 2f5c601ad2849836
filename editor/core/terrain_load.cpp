#include "editor/core/terrain_load.hpp"

#include <atomic>
#include <mutex>
#include <new>

#include "engine/io/asset_copy.hpp"
#include "engine/io/terrain_file.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;

using Loaded = Result<std::shared_ptr<const HeightSource>>;

struct TerrainLoad::Job {
  std::atomic<bool> stop = false, done = false;
  mutable std::mutex mutex;
  std::string doing;
  std::unique_ptr<Loaded> result;
};

namespace {

Loaded load(const fs::path& file, const fs::path& projectFile, const LoadWatch& watch) {
  const auto kind = terrainKindOf(file);
  if (!kind) {
    return makeError(ErrorKind::BadInput, file.string(), {}, "is no terrain, expected .png, .glb or .gltf");
  }
  Result<std::shared_ptr<HeightSource>> source = readTerrainFile(file, *kind, watch);
  if (!source) return source.error();
  // Copied only when it is known to be good.
  if (!watch("Bringing it into the project's folder")) return makeError(ErrorKind::Usage, "stopped");
  std::error_code ignored;
  Result<std::string> name = bringAsset(file, fs::absolute(projectFile, ignored).parent_path());
  if (!name) return name.error();
  const std::shared_ptr<HeightSource> made = *source;
  WL_REQUIRE(made != nullptr, "a file that was read has a source");
  made->file = *name;
  return std::shared_ptr<const HeightSource>(made);
}

/// A file within the limits may still ask for more memory than there is: no reason to lose the editor's work.
Loaded loadOrSay(const fs::path& file, const fs::path& projectFile, const LoadWatch& watch) {
  try {
    return load(file, projectFile, watch);
  } catch (const std::bad_alloc&) {
    return makeError(ErrorKind::Machine, file.string(), {}, "can't be read: there is not enough memory");
  }
}

}  // namespace

TerrainLoad::~TerrainLoad() {
  cancel();
  for (Worker& worker : m_workers) worker.thread.join();
}

void TerrainLoad::start(fs::path file, fs::path projectFile) {
  cancel();
  std::erase_if(m_workers, [](Worker& worker) {
    if (!worker.job->done) return false;
    worker.thread.join();
    return true;
  });
  auto job = std::make_shared<Job>();
  job->doing = "Reading " + file.filename().string();
  m_job = job;
  m_workers.push_back({std::thread([job, file = std::move(file), projectFile = std::move(projectFile)] {
                         const auto watch = [&](std::string_view doing) {
                           const std::scoped_lock lock(job->mutex);
                           job->doing = doing;
                           return !job->stop.load();
                         };
                         Loaded loaded = loadOrSay(file, projectFile, watch);
                         const std::scoped_lock lock(job->mutex);
                         job->result = std::make_unique<Loaded>(std::move(loaded));
                         job->done = true;
                       }),
                       job});
}

std::string TerrainLoad::doing() const {
  if (!m_job) return {};
  const std::scoped_lock lock(m_job->mutex);
  return m_job->doing;
}

void TerrainLoad::cancel() {
  if (m_job) m_job->stop = true;
  m_job.reset();
}

std::optional<Loaded> TerrainLoad::poll() {
  if (!m_job) return std::nullopt;
  std::unique_ptr<Loaded> result;
  {
    const std::scoped_lock lock(m_job->mutex);
    result = std::move(m_job->result);
  }
  if (!result) return std::nullopt;
  m_job.reset();
  return std::move(*result);
}

Edit terrainEdit(const Project& project, std::shared_ptr<const HeightSource> source) {
  TerrainSettings terrain = *project.terrain;
  if (source->kind == TerrainKind::HeightMap && terrain.kind != TerrainKind::HeightMap) {
    terrain.centre = project.field->centre;
    terrain.size = project.field->size;
  } else if (source->kind == TerrainKind::Mesh && terrain.kind != TerrainKind::Mesh) {
    terrain.centre = project.field->centre - (source->low + 0.5f * source->size) * terrain.scale;
  }
  terrain.kind = source->kind;
  terrain.file = source->file;
  terrain.heights = placeHeights(terrain, std::move(source));
  return {.label = "Set terrain", .steps = {Set<TerrainSettings>{std::move(terrain)}}, .mergeKey = {}};
}

}  // namespace windloom::editor
