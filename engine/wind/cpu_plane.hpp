#pragma once
// One array of the CPU backend: a plane of floats with room for ghosts on all sides, rows aligned for vectors.

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

namespace windloom {

class CpuPlane {
 public:
  static constexpr int kMargin = 16;  ///< floats before and at least 16 after each row: one cache line, one widest vector

  CpuPlane() = default;
  /// Zeroed; entries [-kMargin, width + kMargin) x [-1, height + 1) may be touched.
  CpuPlane(int width, int height)
      : m_width(width), m_height(height), m_stride((width + 2 * kMargin + kMargin - 1) / kMargin * kMargin),
        m_data(static_cast<float*>(::operator new[](bytes(), std::align_val_t{64}))) {
    clear();
  }

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  [[nodiscard]] int stride() const { return m_stride; }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(float) * static_cast<std::size_t>(m_stride) * static_cast<std::size_t>(m_height + 2);
  }
  /// Entry (0, k), 64-byte aligned; k in [-1, height].
  [[nodiscard]] float* row(int k) { return m_data.get() + offset(k); }
  [[nodiscard]] const float* row(int k) const { return m_data.get() + offset(k); }
  [[nodiscard]] float& at(int i, int k) { return row(k)[i]; }
  [[nodiscard]] float at(int i, int k) const { return row(k)[i]; }
  void clear() { std::memset(m_data.get(), 0, bytes()); }

 private:
  struct Free {
    void operator()(float* p) const { ::operator delete[](p, std::align_val_t{64}); }
  };
  [[nodiscard]] std::size_t offset(int k) const {
    return static_cast<std::size_t>(k + 1) * static_cast<std::size_t>(m_stride) + kMargin;
  }
  int m_width = 0, m_height = 0, m_stride = 0;
  std::unique_ptr<float[], Free> m_data;
};

}  // namespace windloom
