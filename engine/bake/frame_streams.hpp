#pragma once
// The middle of a bake: from the simulation's frames to the writers of every track and format.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/bake/bake.hpp"
#include "engine/bake/frame_spool.hpp"
#include "engine/bake/response.hpp"
#include "engine/bake/write_behind.hpp"

namespace windloom {

/// A speed to encode as full scale: the fastest wind rounded up to a hundredth; 1 m/s for still air.
float fullScaleFor(float fastest);

/// What one writer left.
struct StreamFiles {
  BakeHeader header;
  std::vector<BakedFile> files;
};

struct StreamResult {
  bool cancelled = false;
  std::vector<StreamFiles> files;  ///< by format in the request's order, in it by track
  SeamReport seam;                 ///< of a loop's wind
};

class FrameStreams {
 public:
  FrameStreams(Simulation& simulation, const BakeRequest& request, const BakeHeader& header,
               const std::function<bool(const BakeProgress&)>& keepGoing, std::filesystem::path work);

  /// Runs the simulation through the plan and writes all files into the work folder. Frames are kept in between only
  /// where a format has to know the fastest wind beforehand, or for a loop. Fails with Machine and BadInput.
  Result<StreamResult> run();

  /// Of the wind; `fastest` and `fullScale` are known after run().
  [[nodiscard]] const BakeHeader& header() const { return m_tracks.front().header; }

 private:
  struct Writer {
    std::size_t number;  // among all
    std::unique_ptr<FrameWriter> writer;
  };
  /// The wind, or the answer of one class of plants.
  struct TrackStream {
    BakeHeader header;
    std::unique_ptr<FrameSpool> spool;  // recorded frames in the order of m_kept
    std::vector<Writer> writers;
    std::vector<glm::vec2> frame, after, before;  // scratch
  };

  bool keepGoing(BakePhase phase, double done, double all) const;
  [[nodiscard]] std::size_t cells() const;
  void planFrames();
  Status openWriters();
  Status addToAll(TrackStream& track, int frame, std::span<const glm::vec2> cells);
  Status runDirect();
  Status runSpooled();
  Status record(const std::function<Status(TrackStream&, int, std::span<const glm::vec2>)>& sink);
  Status readBlended(TrackStream& track, int frame, std::vector<glm::vec2>& out);
  Status readKept(TrackStream& track, int frame, std::vector<glm::vec2>& out) const;
  Status writeSpooled(TrackStream& track, int frame);
  Status finishWriters();

  Simulation& m_simulation;
  const BakeRequest& m_request;
  const std::function<bool(const BakeProgress&)>& m_keepGoing;
  std::filesystem::path m_work;
  std::vector<TrackStream> m_tracks;  // the wind first
  std::optional<PlantResponse> m_response;
  std::vector<char> m_written;  // by recorded frame: part of a frame that is written
  std::vector<int> m_kept;      // by recorded frame: its place in the spools, -1: not kept
  int m_lastNeeded = 0;
  bool m_spooled = false, m_needsFastest = false;
  SeamMeter m_seam;
  StreamResult m_result;
  std::size_t m_writers = 0;
  std::optional<WriteBehind> m_behind;  // ends before the writers do
};

}  // namespace windloom
