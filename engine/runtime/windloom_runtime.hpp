#ifndef WINDLOOM_RUNTIME_HPP
#define WINDLOOM_RUNTIME_HPP
// C++ over windloom_runtime.h, all inline: C++11 will do. See there for units, limits and threads.

#include <cstddef>
#include <memory>
#include <string>

#include "windloom_runtime.h"

namespace windloom {
namespace runtime {

struct Velocity {
  float x, z;  ///< m/s
};

/// A loaded pack that somebody else owns; empty where there is none. Only `operator bool` may be called then.
class WindView {
 public:
  WindView() : m_pack(nullptr) {}
  explicit WindView(const windloom_pack* pack) : m_pack(pack) {}

  explicit operator bool() const { return m_pack != nullptr; }
  const windloom_pack* get() const { return m_pack; }
  windloom_info info() const { return windloom_get_info(m_pack); }
  Velocity sample(float x, float z, double time) const {
    float v[2];
    windloom_sample(m_pack, x, z, time, v);
    return {v[0], v[1]};
  }
  void sampleMany(const float* positions, std::size_t count, double time, float* velocities) const {
    windloom_sample_many(m_pack, positions, count, time, velocities);
  }
  float heightFactor(float height) const { return windloom_height_factor(m_pack, height); }

 private:
  const windloom_pack* m_pack;
};

/// Move-only; empty where loading failed.
class WindPack {
 public:
  WindPack() = default;

  static WindPack load(const std::string& path) {
    WindPack pack;
    pack.m_pack.reset(windloom_load_file(path.c_str(), &pack.m_status));
    return pack;
  }
  static WindPack load(const void* bytes, std::size_t size) {
    WindPack pack;
    pack.m_pack.reset(windloom_load_memory(bytes, size, &pack.m_status));
    return pack;
  }

  explicit operator bool() const { return m_pack != nullptr; }
  windloom_status status() const { return m_status; }
  WindView view() const { return WindView(m_pack.get()); }

  // For a pack that loaded only.
  windloom_info info() const { return view().info(); }
  void setEdges(windloom_edge x, windloom_edge z) { windloom_set_edges(m_pack.get(), x, z); }
  Velocity sample(float x, float z, double time) const { return view().sample(x, z, time); }
  void sampleMany(const float* positions, std::size_t count, double time, float* velocities) const {
    view().sampleMany(positions, count, time, velocities);
  }
  float heightFactor(float height) const { return view().heightFactor(height); }

 private:
  struct Free {
    void operator()(windloom_pack* pack) const { windloom_free(pack); }
  };
  std::unique_ptr<windloom_pack, Free> m_pack;
  windloom_status m_status = WINDLOOM_CANNOT_READ;
};

/// A pack that is loaded again whenever its file is replaced. Move-only.
class FollowedPack {
 public:
  explicit FollowedPack(const std::string& path) : m_follow(windloom_follow_open(path.c_str())) {}

  /// As windloom_follow_poll.
  int poll() { return m_follow ? windloom_follow_poll(m_follow.get()) : -1; }
  /// Of the pack loaded last; empty before the first. Good until the second change after this call.
  WindView pack() const { return WindView(m_follow ? windloom_follow_pack(m_follow.get()) : nullptr); }
  windloom_status status() const { return m_follow ? windloom_follow_status(m_follow.get()) : WINDLOOM_OUT_OF_MEMORY; }

 private:
  struct Close {
    void operator()(windloom_follow* follow) const { windloom_follow_close(follow); }
  };
  std::unique_ptr<windloom_follow, Close> m_follow;
};

/// The wind of a running editor. Move-only; empty where there was none when it was opened.
class LiveField {
 public:
  LiveField() = default;

  static LiveField open(const std::string& name = "windloom") {
    LiveField field;
    field.m_live.reset(windloom_live_open(name.c_str(), &field.m_status));
    return field;
  }

  explicit operator bool() const { return m_live != nullptr; }
  windloom_status status() const { return m_status; }

  // For a field that opened only.
  int update() { return windloom_live_update(m_live.get()); }
  windloom_info info() const { return windloom_live_info(m_live.get()); }
  Velocity sample(float x, float z) const {
    float v[2];
    windloom_live_sample(m_live.get(), x, z, v);
    return {v[0], v[1]};
  }
  void sampleMany(const float* positions, std::size_t count, float* velocities) const {
    windloom_live_sample_many(m_live.get(), positions, count, velocities);
  }

 private:
  struct Close {
    void operator()(windloom_live* live) const { windloom_live_close(live); }
  };
  std::unique_ptr<windloom_live, Close> m_live;
  windloom_status m_status = WINDLOOM_NO_LIVE_FIELD;
};

}  // namespace runtime
}  // namespace windloom
#endif
