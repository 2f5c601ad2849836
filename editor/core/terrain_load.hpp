#pragma once
// Reading a terrain file beside the frame loop, and bringing it into the project's folder.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/core/result.hpp"
#include "engine/model/edit.hpp"

namespace windloom::editor {

class TerrainLoad {
 public:
  TerrainLoad() = default;
  ~TerrainLoad();  ///< waits for what still reads
  TerrainLoad(const TerrainLoad&) = delete;
  TerrainLoad& operator=(const TerrainLoad&) = delete;

  /// Begins to read `file` for the project at `projectFile`; what was being read is given up.
  void start(std::filesystem::path file, std::filesystem::path projectFile);
  [[nodiscard]] bool running() const { return m_job != nullptr; }
  /// "Reading hills.png"; empty where nothing runs.
  [[nodiscard]] std::string doing() const;
  /// Nothing comes of it any more, and nothing is copied.
  void cancel();
  /// The source with its file's name, once, when it is there. Fails as readTerrainFile and bringAsset.
  std::optional<Result<std::shared_ptr<const HeightSource>>> poll();

 private:
  struct Job;
  std::shared_ptr<Job> m_job;
  struct Worker {
    std::thread thread;
    std::shared_ptr<Job> job;
  };
  std::vector<Worker> m_workers;
};

/// Makes a source the project's ground, as one step. A first height map covers the wind field; one that takes the place
/// of another keeps its place and height.
Edit terrainEdit(const Project& project, std::shared_ptr<const HeightSource> source);

}  // namespace windloom::editor
