#pragma once
// A PNG file of RGBA samples, written some rows at a time: pictures that are too large to be held whole.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "engine/core/atomic_file.hpp"
#include "engine/core/result.hpp"

namespace windloom {

template <class Sample>
class PngStream {
 public:
  /// Starts a file of `width` x `height` pixels, at most 2^31 - 1 a side. Fails with Machine.
  static Result<PngStream> create(const std::filesystem::path& path, int width, int height);
  /// Without finish(), nothing stays on disk.
  ~PngStream();
  PngStream(PngStream&& other) noexcept;
  PngStream& operator=(PngStream&& other) noexcept;

  /// The next rows from the top: whole ones of width * 4 samples, not more than the picture has. Fails with Machine;
  /// the file is then given up.
  Status write(std::span<const Sample> rows);

  /// After the last row: the file appears under its name. Fails with Machine.
  Status finish(Sync sync = Sync::Now);

 private:
  struct State;
  explicit PngStream(std::unique_ptr<State> state);
  std::unique_ptr<State> m_state;
};

extern template class PngStream<std::uint8_t>;
extern template class PngStream<std::uint16_t>;

}  // namespace windloom
