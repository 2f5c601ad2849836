#include "engine/io/png_stream.hpp"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>
#include <optional>
#include <string>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

static_assert(std::endian::native == std::endian::little, "16-bit samples are swapped to PNG's byte order");

/// Of zlib. Flow maps of a meadow's wind, 256 x 256, 8 bits, on one core: level 2 with the Paeth filter in every row
/// 66 MB/s to 27 % of the bytes; level 6 with the best filter for each row 12 MB/s to 21.5 %. 16 bits: 41 MB/s to 66 %
/// and 6 MB/s to 59 %.
constexpr int kLevel = 2;

/// libpng reports errors by longjmp: the functions that call setjmp hold only trivial locals.
struct Target {
  explicit Target(AtomicFile atomic) : file(std::move(atomic)) {}
  jmp_buf jump;
  AtomicFile file;
  std::optional<Error> error;  // of the disk
  char message[160] = "";      // of libpng
};

void onError(png_structp png, png_const_charp message) {
  auto* target = static_cast<Target*>(png_get_error_ptr(png));
  std::strncpy(target->message, message, sizeof target->message - 1);
  std::longjmp(target->jump, 1);
}

void onWarning(png_structp, png_const_charp) {}

/// False where the disk refused; the reason is kept.
bool appendTo(Target& target, std::string_view bytes) {
  const Status written = target.file.write(bytes);
  if (!written) target.error = written.error();
  return written.ok();
}

void onWrite(png_structp png, png_bytep bytes, std::size_t n) {
  auto* target = static_cast<Target*>(png_get_io_ptr(png));
  if (!appendTo(*target, {reinterpret_cast<const char*>(bytes), n})) png_error(png, "can't write");
}

void onFlush(png_structp) {}

}  // namespace

template <class Sample>
struct PngStream<Sample>::State {
  explicit State(AtomicFile file) : target(std::move(file)) {}
  ~State() { png_destroy_write_struct(&png, &info); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  bool start() {
    if (setjmp(target.jump) != 0) return false;
    constexpr int kBits = static_cast<int>(sizeof(Sample)) * 8;
    png_set_write_fn(png, &target, onWrite, onFlush);
    png_set_user_limits(png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), kBits,
                 PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, kLevel);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
    png_write_info(png, info);
    if constexpr (kBits == 16) png_set_swap(png);
    return true;
  }

  bool writeRows(const Sample* rows, std::size_t count) {
    if (setjmp(target.jump) != 0) return false;
    const std::size_t samples = static_cast<std::size_t>(width) * 4;
    for (std::size_t i = 0; i < count; ++i) png_write_row(png, reinterpret_cast<png_const_bytep>(rows + i * samples));
    return true;
  }

  bool end() {
    if (setjmp(target.jump) != 0) return false;
    png_write_end(png, nullptr);
    return true;
  }

  [[nodiscard]] Error failure() const {
    if (target.error) return *target.error;
    return makeError(ErrorKind::Machine, path, {}, std::string("can't encode the picture: ") + target.message);
  }

  std::string path;
  Target target;
  png_structp png = nullptr;
  png_infop info = nullptr;
  int width = 0, height = 0;
  std::size_t rowsLeft = 0;
};

template <class Sample>
PngStream<Sample>::PngStream(std::unique_ptr<State> state) : m_state(std::move(state)) {}
template <class Sample>
PngStream<Sample>::~PngStream() = default;
template <class Sample>
PngStream<Sample>::PngStream(PngStream&&) noexcept = default;
template <class Sample>
PngStream<Sample>& PngStream<Sample>::operator=(PngStream&&) noexcept = default;

template <class Sample>
Result<PngStream<Sample>> PngStream<Sample>::create(const std::filesystem::path& path, int width, int height) {
  WL_REQUIRE(width > 0 && height > 0, "a picture has pixels");
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  auto state = std::make_unique<State>(std::move(*file));
  state->path = path.string();
  state->width = width;
  state->height = height;
  state->rowsLeft = static_cast<std::size_t>(height);
  state->png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &state->target, onError, onWarning);
  state->info = state->png != nullptr ? png_create_info_struct(state->png) : nullptr;
  if (state->info == nullptr) return makeError(ErrorKind::Machine, path.string(), {}, "out of memory");
  if (!state->start()) return state->failure();
  return PngStream(std::move(state));
}

template <class Sample>
Status PngStream<Sample>::write(std::span<const Sample> rows) {
  const std::size_t samples = static_cast<std::size_t>(m_state->width) * 4;
  const std::size_t count = rows.size() / samples;
  WL_REQUIRE(count * samples == rows.size() && count <= m_state->rowsLeft, "whole rows, not more than the picture has");
  m_state->rowsLeft -= count;
  if (!m_state->writeRows(rows.data(), count)) return m_state->failure();
  return Done{};
}

template <class Sample>
Status PngStream<Sample>::finish(Sync sync) {
  WL_REQUIRE(m_state->rowsLeft == 0, "a picture is finished after its last row");
  if (!m_state->end()) return m_state->failure();
  return m_state->target.file.finish(sync);
}

template class PngStream<std::uint8_t>;
template class PngStream<std::uint16_t>;

}  // namespace windloom
