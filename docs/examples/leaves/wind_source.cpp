#include "wind_source.hpp"

namespace game {

namespace {

using windloom::runtime::LiveField;
using windloom::runtime::WindPack;

constexpr double kLookEvery = 0.25;     // s; looking at the file costs microseconds, an artist waits gladly this long
constexpr double kLookLiveEvery = 1.0;  // s, for an editor where there was none

// A bake of the plants' response has packs of the same form.
constexpr const char* kNoWind = "This pack tells how plants lean, not how the wind blows.";

/// The file's name without its folders.
std::string baseName(const std::string& path) {
  const auto slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

bool WindSource::open(const std::string& file, const std::string& liveName, bool live) {
  m_path = file;
  m_liveName = liveName.empty() ? "windloom" : liveName;
  m_wantsLive = live;
  if (live && openLive()) return true;
  const std::string liveProblem = m_problem;
  if (m_path.empty() || !openFile()) return false;
  if (live) m_note = liveProblem + " Playing the file meanwhile.";
  return true;
}

bool WindSource::openFile() {
  if (!m_file) m_file.emplace(m_path);
  if (!pack()) m_file->poll();
  windloom_status status = m_file->status();
  if (!pack() && status == WINDLOOM_NOT_HERE) {
    m_whole = WindPack::load(m_path);
    status = m_whole.status();
  }
  if (!pack()) {
    m_problem = m_path + ": " + windloom_status_text(status);
    return false;
  }
  if (pack().info().quantity != 0) {
    m_problem = m_path + ": " + kNoWind;
    return false;
  }
  m_info = pack().info();
  m_isLive = false;
  return true;
}

bool WindSource::openLive() {
  LiveField live = LiveField::open(m_liveName);
  if (live) live.update();
  if (!live || live.info().width == 0) {
    const windloom_status why = live ? WINDLOOM_NO_LIVE_FIELD : live.status();
    m_problem = "Live wind \"" + m_liveName + "\": " + windloom_status_text(why);
    return false;
  }
  m_live = std::move(live);
  m_info = m_live.info();
  m_isLive = true;
  m_liveEnded = false;
  ++m_fields;
  return true;
}

void WindSource::update(double now) {
  updateLive(now);
  if (m_file) updateFile(now);
}

void WindSource::updateFile(double now) {
  if (now < m_nextLook) return;
  m_nextLook = now + kLookEvery;
  const int change = m_file->poll();
  if (change < 0)
    m_note = std::string("Kept the wind, the new file is no good: ") + windloom_status_text(m_file->status());
  if (change <= 0) return;
  ++m_reloads;
  if (!m_isLive) m_info = pack().info();
  m_note = pack().info().quantity == 0 ? "New wind from " + baseName(m_path) : kNoWind;
}

void WindSource::updateLive(double now) {
  if (m_isLive && !m_liveEnded) {
    const int change = m_live.update();
    if (change > 0) ++m_fields;
    if (change > 0) m_info = m_live.info();
    if (change >= 0) return;
    // The editor has gone. Its last field would blow on for ever, so the recording takes over where there is one.
    m_liveEnded = true;
    m_nextLiveLook = now + kLookLiveEvery;
    const bool played = !m_path.empty() && openFile();
    m_note = played ? "The editor has ended the live link. Playing the file meanwhile."
                    : "The editor has ended the live link. Keeping its last wind.";
  } else if (m_wantsLive && now >= m_nextLiveLook) {
    m_nextLiveLook = now + kLookLiveEvery;
    if (openLive()) m_note = "Following the editor";
  }
}

void WindSource::toggleLive() {
  if (!m_isLive) {
    m_wantsLive = openLive();
    m_note = m_wantsLive ? "Following the editor" : m_problem;
  } else if (m_path.empty()) {
    m_note = "No file was given to go back to";
  } else if (openFile()) {
    m_wantsLive = false;
    m_note = "Playing the file";
  } else {
    m_note = m_problem;
  }
}

Vec2 WindSource::sample(float x, float z) const {
  const windloom::runtime::Velocity wind = m_isLive ? m_live.sample(x, z) : pack().sample(x, z, m_time);
  return {wind.x, wind.z};
}

void WindSource::sampleMany(const std::vector<float>& places, std::vector<float>& winds) const {
  winds.resize(places.size());
  if (m_isLive) {
    m_live.sampleMany(places.data(), places.size() / 2, winds.data());
  } else {
    pack().sampleMany(places.data(), places.size() / 2, m_time, winds.data());
  }
}

float WindSource::usualSpeed(float x, float z) const {
  if (m_isLive) return length(sample(x, z));
  constexpr int kMoments = 8;
  const double seconds = m_info.frames / static_cast<double>(m_info.fps);
  float sum = 0;
  for (int i = 0; i < kMoments; ++i) {
    const windloom::runtime::Velocity wind = pack().sample(x, z, seconds * i / kMoments);
    sum += length(Vec2{wind.x, wind.z});
  }
  return sum / kMoments;
}

float WindSource::heightFactor(float height) const {
  if (!m_isLive) return pack().heightFactor(height);
  // The same law, for a field that is no pack.
  if (height <= 0) return 0;
  if (m_info.roughness <= 0) return 1;
  return std::log1p(height / m_info.roughness) / std::log1p(m_info.reference_height / m_info.roughness);
}

std::string WindSource::name() const {
  return m_isLive ? "live: " + m_liveName : baseName(m_path);
}

}  // namespace game
