#pragma once
// Where the game's wind comes from: a .windpack that is loaded again whenever an artist exports it anew, or the editor
// itself while it runs. The rest of the game asks for the wind at places and doesn't know which. Copy this into your
// game first.

#include <windloom_runtime.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "maths.hpp"

namespace game {

/// The rectangle of ground that the wind was simulated on, m.
struct Bounds {
  float minX = 0, minZ = 0, maxX = 0, maxZ = 0;
  float width() const { return maxX - minX; }
  float depth() const { return maxZ - minZ; }
  bool operator==(const Bounds& o) const {
    return minX == o.minX && minZ == o.minZ && maxX == o.maxX && maxZ == o.maxZ;
  }
};

class WindSource {
 public:
  /// Either may be missing, but not both: `file` empty means live wind only, `liveName` empty means the editor's usual
  /// name. False where there is no wind at all; problem() says why.
  bool open(const std::string& file, const std::string& liveName, bool live);

  /// Looks for a new file every quarter second and for a new live field each time; `now` in s of a clock on the wall.
  /// Call it where nobody samples, once a frame.
  void update(double now);
  /// Moves on in the recording. Live wind has its own time.
  void advance(double seconds) { m_time += seconds; }
  void restart(double time) { m_time = time; }

  /// Tries to change between file and live wind; stays with what it has where the other one isn't there.
  void toggleLive();

  /// Wind in m/s over the ground at (x, z), at the height that the recording holds for.
  Vec2 sample(float x, float z) const;
  /// Speed in m/s that the wind has there on the whole; of live wind, as it is now.
  float usualSpeed(float x, float z) const;
  /// As sample, for many places at once, which is quicker: x0 z0 x1 z1 ... to vx0 vz0 vx1 vz1 ...
  void sampleMany(const std::vector<float>& places, std::vector<float>& winds) const;
  /// Part of that wind that blows `height` m over the ground: little in the grass, more at the top of a pole.
  float heightFactor(float height) const;

  const windloom_info& info() const { return m_info; }
  Bounds bounds() const { return {m_info.min_x, m_info.min_z, m_info.max_x, m_info.max_z}; }
  bool isLive() const { return m_isLive; }
  double time() const { return m_time; }       ///< s after the recording's first frame
  int reloads() const { return m_reloads; }    ///< times that a new file was taken over
  int liveFields() const { return m_fields; }  ///< fields taken over from the editor
  std::string name() const;                    ///< for people: "meadow.windpack" or "live: windloom"
  const std::string& problem() const { return m_problem; }
  /// What happened since the last call, or nothing.
  std::string takeNote() { return std::exchange(m_note, {}); }

 private:
  bool openFile();
  bool openLive();
  void updateFile(double now);
  void updateLive(double now);
  windloom::runtime::WindView pack() const { return m_whole ? m_whole.view() : m_file->pack(); }

  std::optional<windloom::runtime::FollowedPack> m_file;
  windloom::runtime::WindPack m_whole;  // instead, on systems where files can't be followed
  windloom::runtime::LiveField m_live;
  windloom_info m_info{};
  std::string m_path, m_liveName, m_problem, m_note;
  double m_time = 0, m_nextLook = 0, m_nextLiveLook = 0;
  int m_reloads = 0, m_fields = 0;
  bool m_isLive = false;     // the wind comes from the editor
  bool m_wantsLive = false;  // and should, as soon as there is one
  bool m_liveEnded = false;  // m_live is what the last editor left
};

}  // namespace game
