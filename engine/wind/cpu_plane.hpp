#pragma once
// One array of the CPU backend: a plane of floats with room for ghosts on all sides, rows aligned for vectors.

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>

namespace windloom {

class CpuPlane {
 public:
  static constexpr int kMargin =
      16;  ///< floats before and at least 16 after each row: one cache line, one widest vector
  static constexpr int kRowMargin = 2;  ///< rows below and above: one of ghosts, one that may be read but says nothing

  CpuPlane() = default;
  /// Zeroed; entries [-kMargin, width + kMargin) x [-kRowMargin, height + kRowMargin) may be touched, and read up to
  /// kMargin beyond a row's end.
  CpuPlane(int width, int height)
      : m_width(width),
        m_height(height),
        m_stride((width + 2 * kMargin + kMargin - 1) / kMargin * kMargin),
        m_data(static_cast<float*>(::operator new[](bytes(), std::align_val_t{64}))) {
    clear();
  }

  [[nodiscard]] int width() const { return m_width; }
  [[nodiscard]] int height() const { return m_height; }
  [[nodiscard]] int stride() const { return m_stride; }
  [[nodiscard]] std::size_t bytes() const {
    const auto rows = static_cast<std::size_t>(m_height + 2 * kRowMargin);
    return sizeof(float) * (static_cast<std::size_t>(m_stride) * rows + 2 * kMargin);
  }
  /// Entry (0, k), 64-byte aligned; k in [-kRowMargin, height + kRowMargin).
  [[nodiscard]] float* row(int k) { return m_data.get() + offset(k); }
  [[nodiscard]] const float* row(int k) const { return m_data.get() + offset(k); }
  [[nodiscard]] float& at(int i, int k) { return row(k)[i]; }
  [[nodiscard]] float at(int i, int k) const { return row(k)[i]; }
  /// All of it, bytes() long.
  [[nodiscard]] float* memory() { return m_data.get(); }
  [[nodiscard]] const float* memory() const { return m_data.get(); }
  void clear() { std::memset(m_data.get(), 0, bytes()); }

 private:
  struct Free {
    void operator()(float* p) const { ::operator delete[](p, std::align_val_t{64}); }
  };
  [[nodiscard]] std::size_t offset(int k) const {
    return static_cast<std::size_t>(k + kRowMargin) * static_cast<std::size_t>(m_stride) + kMargin;
  }
  int m_width = 0, m_height = 0, m_stride = 0;
  std::unique_ptr<float[], Free> m_data;
};

}  // namespace windloom
