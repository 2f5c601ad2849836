#ifndef WINDLOOM_RUNTIME_HPP
#define WINDLOOM_RUNTIME_HPP
// C++ over windloom_runtime.h, all inline: C++11 will do. See there for units, limits and threads.

#include <memory>
#include <string>

#include "windloom_runtime.h"

namespace windloom {
namespace runtime {

struct Velocity {
  float x, z;  ///< m/s
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

  // For a pack that loaded only.
  windloom_info info() const { return windloom_get_info(m_pack.get()); }
  void setEdges(windloom_edge x, windloom_edge z) { windloom_set_edges(m_pack.get(), x, z); }
  Velocity sample(float x, float z, double time) const {
    float v[2];
    windloom_sample(m_pack.get(), x, z, time, v);
    return {v[0], v[1]};
  }

 private:
  struct Free {
    void operator()(windloom_pack* pack) const { windloom_free(pack); }
  };
  std::unique_ptr<windloom_pack, Free> m_pack;
  windloom_status m_status = WINDLOOM_CANNOT_READ;
};

}  // namespace runtime
}  // namespace windloom
#endif
