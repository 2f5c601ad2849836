#include "engine/bake/frame_streams.hpp"

#include <algorithm>
#include <cmath>

#include "engine/bake/half.hpp"

namespace windloom {
namespace {

float fastestOf(std::span<const glm::vec2> cells) {
  float square = 0;
  for (const glm::vec2 v : cells) square = std::max(square, glm::dot(v, v));
  return std::sqrt(square);
}

/// Of the vectors as half floats hold them.
float fastestHalfOf(std::span<const glm::vec2> cells) {
  const auto stored = [](float value) { return floatFromHalf(halfFromFloat(value)); };
  float square = 0;
  for (const glm::vec2 v : cells) {
    const glm::vec2 half(stored(v.x), stored(v.y));
    square = std::max(square, glm::dot(half, half));
  }
  return std::sqrt(square);
}

/// field = mix(after, field, weight).
void blend(std::vector<glm::vec2>& field, const std::vector<glm::vec2>& after, float weight) {
  for (std::size_t i = 0; i < field.size(); ++i) field[i] = glm::mix(after[i], field[i], weight);
}

}  // namespace

float fullScaleFor(float fastest) {
  if (!(fastest > 0.0f)) return 1.0f;
  const float rounded = std::ceil(fastest * 100.0f) / 100.0f;
  return std::max(rounded, fastest);
}

FrameStreams::FrameStreams(Simulation& simulation, const BakeRequest& request, const BakeHeader& header,
                           const std::function<bool(const BakeProgress&)>& keepGoing, std::filesystem::path work)
    : m_simulation(simulation), m_request(request), m_keepGoing(keepGoing), m_work(std::move(work)) {
  m_tracks.emplace_back().header = header;
  if (request.response) {
    for (const PlantClass& plant : plantClasses()) {
      BakeHeader& own = m_tracks.emplace_back().header;
      own = header;
      own.track = {std::string(plant.name), Quantity::Bend};
      own.fullScale = kBendFullScale;
    }
    m_response.emplace(cells());
  }
  m_spooled = request.plan.crossfade > 0;
  for (const WriterKind* kind : request.formats) {
    const bool known = kind->need == SpeedNeed::None || (kind->need == SpeedNeed::Range && request.fullScale);
    m_spooled = m_spooled || !known;
    m_needsFastest = m_needsFastest || kind->need == SpeedNeed::Fastest;
  }
  planFrames();
}

std::size_t FrameStreams::cells() const {
  const glm::ivec2 resolution = header().grid.resolution;
  return static_cast<std::size_t>(resolution.x) * static_cast<std::size_t>(resolution.y);
}

/// Which recorded frames are needed: those of the written frames, their blends, and for a loop the frame that plays
/// before the first written one, to see how smoothly it follows.
void FrameStreams::planFrames() {
  const RecordPlan& plan = m_request.plan;
  const auto recorded = static_cast<std::size_t>(plan.frames + plan.crossfade);
  m_written.assign(recorded, 0);
  std::vector<char> needed(recorded, 0);
  const auto mark = [&](std::vector<char>& marks, int frame) {
    marks[static_cast<std::size_t>(frame)] = 1;
    if (frame < plan.crossfade) marks[static_cast<std::size_t>(plan.frames + frame)] = 1;
  };
  for (int frame = header().first; frame <= header().last; ++frame) mark(m_written, frame);
  needed = m_written;
  if (plan.crossfade > 0) mark(needed, header().first > 0 ? header().first - 1 : plan.frames - 1);
  m_kept.assign(recorded, -1);
  int place = 0;
  for (std::size_t frame = 0; frame < recorded; ++frame) {
    if (!needed[frame]) continue;
    m_kept[frame] = place++;
    m_lastNeeded = static_cast<int>(frame);
  }
}

bool FrameStreams::keepGoing(BakePhase phase, double done, double all) const {
  return !m_keepGoing || m_keepGoing({phase, all > 0 ? std::min(done / all, 1.0) : 1.0});
}

Result<StreamResult> FrameStreams::run() {
  if (Status ran = m_spooled ? runSpooled() : runDirect(); !ran) return ran.error();
  m_result.seam = m_seam.report();
  return std::move(m_result);
}

Status FrameStreams::openWriters() {
  // Blended frames are no faster than what they are made of, but may round to halves that are.
  if (m_request.plan.crossfade > 0) {
    for (TrackStream& track : m_tracks) track.header.fastestHalf *= 1.0f + 1.0f / 2048;
  }
  if (!m_request.fullScale) m_tracks.front().header.fullScale = fullScaleFor(header().fastest);
  for (std::size_t format = 0; format < m_request.formats.size(); ++format) {
    for (TrackStream& track : m_tracks) {
      Result<std::unique_ptr<FrameWriter>> writer = m_request.formats[format]->open(track.header, m_work);
      if (!writer) return writer.error();
      track.writers.push_back({m_writers++, std::move(*writer)});
    }
  }
  m_behind.emplace(m_writers);
  return Done{};
}

Status FrameStreams::addToAll(TrackStream& track, int frame, std::span<const glm::vec2> cells) {
  const auto shared = std::make_shared<const std::vector<glm::vec2>>(cells.begin(), cells.end());
  for (const Writer& to : track.writers) {
    if (Status added = m_behind->add(to.number, *to.writer, frame, shared); !added) return added;
  }
  return Done{};
}

Status FrameStreams::finishWriters() {
  if (Status written = m_behind->finish(); !written) return written;
  for (std::size_t format = 0; format < m_request.formats.size(); ++format) {
    for (TrackStream& track : m_tracks) {
      Result<std::vector<BakedFile>> files = track.writers[format].writer->finish();
      if (!files) return files.error();
      m_result.files.push_back({track.header, std::move(*files)});
    }
  }
  return Done{};
}

/// Gives every track's frames that are needed to `sink`.
Status FrameStreams::record(const std::function<Status(TrackStream&, int, std::span<const glm::vec2>)>& sink) {
  const auto needed = [&](int frame) { return m_kept[static_cast<std::size_t>(frame)] >= 0; };
  // Plants answer to all that blew before.
  const auto wanted = [&](int frame) { return needed(frame) || (m_response && frame < m_lastNeeded); };
  const double interval = 1.0 / m_request.plan.fps;
  const auto take = [&](int frame, std::span<const glm::vec2> wind) -> Status {
    if (m_response) m_response->advance(wind, interval);
    if (!needed(frame)) return Done{};
    for (std::size_t t = 0; t < m_tracks.size(); ++t) {
      TrackStream& track = m_tracks[t];
      const std::span<const glm::vec2> field = t == 0 ? wind : m_response->bend(static_cast<int>(t) - 1);
      if (m_written[static_cast<std::size_t>(frame)]) {
        track.header.fastest = std::max(track.header.fastest, fastestOf(field));
        if (m_needsFastest) track.header.fastestHalf = std::max(track.header.fastestHalf, fastestHalfOf(field));
      }
      if (Status given = sink(track, frame, field); !given) return given;
    }
    return Done{};
  };
  const auto stepped = [&](const RecordProgress& p) {
    return keepGoing(BakePhase::Recording, static_cast<double>(p.step), static_cast<double>(p.steps));
  };
  const Result<RecordEnd> end =
      windloom::record(m_simulation, m_request.plan, m_request.resolution, wanted, take, stepped);
  if (!end) return end.error();
  m_result.cancelled = *end == RecordEnd::Cancelled;
  return Done{};
}

Status FrameStreams::runDirect() {
  if (Status opened = openWriters(); !opened) return opened;
  Status recorded = record(
      [&](TrackStream& track, int frame, std::span<const glm::vec2> field) { return addToAll(track, frame, field); });
  return !recorded || m_result.cancelled ? recorded : finishWriters();
}

Status FrameStreams::runSpooled() {
  for (TrackStream& track : m_tracks) track.spool = std::make_unique<FrameSpool>(cells(), m_work);
  Status recorded =
      record([](TrackStream& track, int, std::span<const glm::vec2> field) { return track.spool->add(field); });
  if (!recorded || m_result.cancelled) return recorded;
  if (Status opened = openWriters(); !opened) return opened;
  const double all = header().written();
  for (int frame = header().first; frame <= header().last; ++frame) {
    if (!keepGoing(BakePhase::Writing, frame - header().first, all)) {
      m_result.cancelled = true;
      return Done{};
    }
    for (TrackStream& track : m_tracks) {
      if (Status written = writeSpooled(track, frame); !written) return written;
    }
  }
  keepGoing(BakePhase::Writing, 1, 1);
  return finishWriters();
}

Status FrameStreams::writeSpooled(TrackStream& track, int frame) {
  if (Status read = readBlended(track, frame, track.frame); !read) return read;
  if (m_request.plan.crossfade > 0 && track.header.track.quantity == Quantity::Wind) {
    if (frame == header().first) {
      const int before = frame > 0 ? frame - 1 : m_request.plan.frames - 1;
      if (Status read = readBlended(track, before, track.before); !read) return read;
    }
    m_seam.compare(frame, track.before, track.frame);
  }
  if (Status added = addToAll(track, frame, track.frame); !added) return added;
  std::swap(track.before, track.frame);
  return Done{};
}

Status FrameStreams::readBlended(TrackStream& track, int frame, std::vector<glm::vec2>& out) {
  const RecordPlan& plan = m_request.plan;
  if (Status read = readKept(track, frame, out); !read || frame >= plan.crossfade) return read;
  if (Status read = readKept(track, plan.frames + frame, track.after); !read) return read;
  blend(out, track.after, seamWeight(plan, frame));
  return Done{};
}

Status FrameStreams::readKept(TrackStream& track, int frame, std::vector<glm::vec2>& out) const {
  return track.spool->read(m_kept[static_cast<std::size_t>(frame)], out);
}

}  // namespace windloom
