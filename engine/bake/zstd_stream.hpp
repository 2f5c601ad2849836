#pragma once
// One zstd frame from bytes that come piece by piece, packed on all threads.

#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>

#include "engine/core/result.hpp"

namespace windloom {

class ZstdStream {
 public:
  using Sink = std::function<Status(std::string_view packed)>;

  /// `totalBytes` will come; the frame says so. Packed bytes go to `sink`, the same ones for any number of threads.
  ZstdStream(std::uint64_t totalBytes, Sink sink);
  ~ZstdStream();
  ZstdStream(const ZstdStream&) = delete;
  ZstdStream& operator=(const ZstdStream&) = delete;

  /// Fails with what `sink` fails with.
  Status write(std::string_view bytes);
  /// After totalBytes bytes: ends the frame.
  Status finish();

 private:
  struct State;
  std::unique_ptr<State> m_state;
};

}  // namespace windloom
