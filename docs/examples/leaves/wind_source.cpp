#include "wind_source.hpp"

namespace game {

namespace {

constexpr double kLookEvery = 0.25;  // s; looking at the file costs microseconds, an artist waits gladly this long

/// The file's name without its folders.
std::string baseName(const std::string& path) {
  const auto slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

}  // namespace

bool WindSource::open(const std::string& file, const std::string& liveName, bool live) {
  m_file = file;
  m_liveName = liveName.empty() ? "windloom" : liveName;
  std::string liveProblem;
  if (live) {
    if (openLive()) return true;
    liveProblem = m_problem;
  }
  if (m_file.empty() || !openFile()) return false;
  if (live) m_note = liveProblem + " Playing the file.";
  return true;
}

bool WindSource::openFile() {
  if (!m_follow) m_follow.reset(windloom_follow_open(m_file.c_str()));
  if (m_follow && pack() == nullptr) windloom_follow_poll(m_follow.get());
  if (!m_follow || pack() == nullptr) {
    const windloom_status why = m_follow ? windloom_follow_status(m_follow.get()) : WINDLOOM_OUT_OF_MEMORY;
    m_problem = m_file + ": " + windloom_status_text(why);
    return false;
  }
  m_info = windloom_get_info(pack());
  m_isLive = false;
  return true;
}

bool WindSource::openLive() {
  windloom_status why = WINDLOOM_OK;
  m_live.reset(windloom_live_open(m_liveName.c_str(), &why));
  if (m_live) windloom_live_update(m_live.get());
  if (!m_live || windloom_live_info(m_live.get()).width == 0) {
    if (m_live) why = WINDLOOM_NO_LIVE_FIELD;  // the link is there, but the editor has put nothing in yet
    m_live.reset();
    m_problem = "Live wind \"" + m_liveName + "\": " + windloom_status_text(why);
    return false;
  }
  m_info = windloom_live_info(m_live.get());
  m_isLive = true;
  m_fields = 1;
  return true;
}

void WindSource::update(double now) {
  if (m_isLive) updateLive();
  if (m_follow) updateFile(now);
}

void WindSource::updateFile(double now) {
  if (now < m_nextLook) return;
  m_nextLook = now + kLookEvery;
  const int change = windloom_follow_poll(m_follow.get());
  if (change < 0) {
    m_note = "Kept the wind, the new file is no good: " +
             std::string(windloom_status_text(windloom_follow_status(m_follow.get())));
  }
  if (change <= 0) return;
  ++m_reloads;
  if (!m_isLive) m_info = windloom_get_info(pack());
  m_note = "New wind from " + baseName(m_file);
}

void WindSource::updateLive() {
  const int change = windloom_live_update(m_live.get());
  if (change > 0) {
    ++m_fields;
    m_info = windloom_live_info(m_live.get());
  }
  if (change >= 0) return;
  // The editor has gone. Its last field would blow on for ever, so the recording takes over where there is one.
  if (!m_file.empty() && openFile()) {
    m_live.reset();
    m_note = "The editor has ended the live link. Playing the file.";
  } else {
    m_note = "The editor has ended the live link. Keeping its last wind.";
  }
}

void WindSource::toggleLive() {
  if (!m_isLive) {
    const windloom_info file = m_info;
    m_note = openLive() ? "Following the editor" : m_problem;
    if (!m_isLive) m_info = file;
  } else if (m_file.empty()) {
    m_note = "No file was given to go back to";
  } else if (openFile()) {
    m_live.reset();
    m_note = "Playing the file";
  } else {
    m_note = m_problem;
  }
}

Vec2 WindSource::sample(float x, float z) const {
  float wind[2] = {0, 0};
  if (m_isLive) {
    windloom_live_sample(m_live.get(), x, z, wind);
  } else {
    windloom_sample(pack(), x, z, m_time, wind);
  }
  return {wind[0], wind[1]};
}

float WindSource::usualSpeed(float x, float z) const {
  if (m_isLive) return length(sample(x, z));
  constexpr int kMoments = 8;
  const double seconds = m_info.frames / static_cast<double>(m_info.fps);
  float sum = 0;
  for (int i = 0; i < kMoments; ++i) {
    float wind[2];
    windloom_sample(pack(), x, z, seconds * i / kMoments, wind);
    sum += length(Vec2{wind[0], wind[1]});
  }
  return sum / kMoments;
}

void WindSource::sampleMany(const std::vector<float>& places, std::vector<float>& winds) const {
  winds.resize(places.size());
  if (!m_isLive) {
    windloom_sample_many(pack(), places.data(), places.size() / 2, m_time, winds.data());
    return;
  }
  for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
    windloom_live_sample(m_live.get(), places[i], places[i + 1], &winds[i]);
  }
}

float WindSource::heightFactor(float height) const {
  if (!m_isLive) return windloom_height_factor(pack(), height);
  // The same law as windloom_height_factor, which wants a pack.
  if (height <= 0) return 0;
  if (m_info.roughness <= 0) return 1;
  return std::log1p(height / m_info.roughness) / std::log1p(m_info.reference_height / m_info.roughness);
}

std::string WindSource::name() const {
  return m_isLive ? "live: " + m_liveName : baseName(m_file);
}

}  // namespace game
