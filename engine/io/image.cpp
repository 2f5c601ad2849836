#include "engine/io/image.hpp"

#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>
#include <string>

#include "engine/core/file.hpp"
#include "engine/io/file_limits.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "16-bit samples are swapped to PNG's byte order");

/// What libpng's callbacks see. It reports errors by longjmp, so the functions that call setjmp hold
/// only trivial locals; everything with a destructor lives in their callers.
struct Trouble {
  jmp_buf jump;
  char message[160] = "";
};

void onError(png_structp png, png_const_charp message) {
  auto* trouble = static_cast<Trouble*>(png_get_error_ptr(png));
  std::strncpy(trouble->message, message, sizeof trouble->message - 1);
  std::longjmp(trouble->jump, 1);
}

void onWarning(png_structp, png_const_charp) {}

struct Source {
  const unsigned char* bytes = nullptr;
  std::size_t left = 0;
};

void onRead(png_structp png, png_bytep out, std::size_t n) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (n > source->left) png_error(png, "the file is cut short");
  std::memcpy(out, source->bytes, n);
  source->bytes += n;
  source->left -= n;
}

void onWrite(png_structp png, png_bytep bytes, std::size_t n) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), n);
}

void onFlush(png_structp) {}

struct Layout {
  png_uint_32 width = 0, height = 0;
  int channels = 0;
};

struct Reader {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Reads the header and sets the conversion to 8 or 16-bit gray, RGB or RGBA.
bool readHeader(Reader& reader, Trouble& trouble, Source& source, int bits, Layout& layout) {
  if (setjmp(trouble.jump) != 0) return false;
  png_set_read_fn(reader.png, &source, onRead);
  png_set_user_limits(reader.png, kMaxImageSide, kMaxImageSide);
  png_set_chunk_malloc_max(reader.png, 8u << 20);
  // Only what makes pixels is wanted. Texts, profiles and the like are passed over: libpng would unpack and keep a
  // thousand of them, each to the size above.
  png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  png_read_info(reader.png, reader.info);
  png_set_expand(reader.png);
  const int colour = png_get_color_type(reader.png, reader.info);
  if (colour == PNG_COLOR_TYPE_GRAY_ALPHA || png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0) {
    png_set_gray_to_rgb(reader.png);
  }
  if (bits == 16) {
    png_set_expand_16(reader.png);
    png_set_swap(reader.png);
  } else {
    png_set_scale_16(reader.png);
  }
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  layout.width = png_get_image_width(reader.png, reader.info);
  layout.height = png_get_image_height(reader.png, reader.info);
  layout.channels = png_get_channels(reader.png, reader.info);
  return true;
}

bool readRows(Reader& reader, Trouble& trouble, png_bytepp rows) {
  if (setjmp(trouble.jump) != 0) return false;
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

template <class Sample>
std::vector<png_bytep> rowPointers(BasicImage<Sample>& image) {
  std::vector<png_bytep> rows(static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y)
    rows[static_cast<std::size_t>(y)] = reinterpret_cast<png_bytep>(image.at(0, y));
  return rows;
}

template <class Sample>
Result<BasicImage<Sample>> decodeAs(std::span<const unsigned char> bytes, const std::string& file,
                                    const std::string& pointer) {
  const auto refuse = [&](const std::string& message) {
    return makeError(ErrorKind::BadInput, file, pointer, message);
  };
  Source source{bytes.data(), bytes.size()};
  if (source.left < 8 || png_sig_cmp(source.bytes, 0, 8) != 0) return refuse("is not a PNG file");
  Trouble trouble;
  Reader reader;
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &trouble, onError, onWarning);
  reader.info = reader.png != nullptr ? png_create_info_struct(reader.png) : nullptr;
  if (reader.info == nullptr) return makeError(ErrorKind::Machine, file, pointer, "out of memory");
  Layout layout;
  if (!readHeader(reader, trouble, source, static_cast<int>(sizeof(Sample)) * 8, layout)) {
    return refuse(std::string("is a damaged PNG file: ") + trouble.message);
  }
  const std::int64_t pixels = static_cast<std::int64_t>(layout.width) * layout.height;
  if (pixels > kMaxImagePixels) {
    return refuse("has " + std::to_string(pixels) + " pixels, at most " + std::to_string(kMaxImagePixels) +
                  " can be read");
  }
  // Deflate can't shrink more than about 1032 times and the smallest pixel has one bit: a short file
  // that claims to be huge is refused before its memory is taken.
  if (pixels / 8 > static_cast<std::int64_t>(bytes.size()) * 1100)
    return refuse("is a damaged PNG file: it is cut short");
  BasicImage<Sample> image(static_cast<int>(layout.width), static_cast<int>(layout.height), layout.channels);
  std::vector<png_bytep> rows = rowPointers(image);
  if (!readRows(reader, trouble, rows.data())) return refuse(std::string("is a damaged PNG file: ") + trouble.message);
  return image;
}

template <class Sample>
Result<BasicImage<Sample>> readAs(const fs::path& path) {
  const Result<std::string> bytes = readFile(path, kMaxPngBytes);
  if (!bytes) return bytes.error();
  return decodeAs<Sample>({reinterpret_cast<const unsigned char*>(bytes->data()), bytes->size()}, path.string(), {});
}

struct Writer {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

bool writeAll(Writer& writer, Trouble& trouble, std::string& bytes, const Layout& layout, int bits, png_bytepp rows) {
  if (setjmp(trouble.jump) != 0) return false;
  const int colour = layout.channels == 1   ? PNG_COLOR_TYPE_GRAY
                     : layout.channels == 3 ? PNG_COLOR_TYPE_RGB
                                            : PNG_COLOR_TYPE_RGB_ALPHA;
  png_set_write_fn(writer.png, &bytes, onWrite, onFlush);
  png_set_IHDR(writer.png, writer.info, layout.width, layout.height, bits, colour, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(writer.png, 6);
  png_write_info(writer.png, writer.info);
  if (bits == 16) png_set_swap(writer.png);
  png_write_image(writer.png, rows);
  png_write_end(writer.png, nullptr);
  return true;
}

template <class Sample>
Status writeAs(const fs::path& path, const BasicImage<Sample>& image) {
  WL_REQUIRE(image.channels == 1 || image.channels == 3 || image.channels == 4, "a PNG has 1, 3 or 4 channels");
  WL_REQUIRE(image.width > 0 && image.height > 0 && image.width <= kMaxImageSide && image.height <= kMaxImageSide,
             "image size out of range");
  const std::size_t samples = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                              static_cast<std::size_t>(image.channels);
  WL_REQUIRE(image.pixels.size() == samples, "an image holds width x height x channels samples");
  std::string bytes;
  Trouble trouble;
  Writer writer;
  writer.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &trouble, onError, onWarning);
  writer.info = writer.png != nullptr ? png_create_info_struct(writer.png) : nullptr;
  if (writer.info == nullptr) return makeError(ErrorKind::Machine, path.string(), {}, "out of memory");
  // libpng takes rows it doesn't change by pointers that aren't const.
  std::vector<png_bytep> rows = rowPointers(const_cast<BasicImage<Sample>&>(image));
  const Layout layout{static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), image.channels};
  if (!writeAll(writer, trouble, bytes, layout, static_cast<int>(sizeof(Sample)) * 8, rows.data())) {
    return makeError(ErrorKind::Machine, path.string(), {},
                     std::string("can't encode the picture: ") + trouble.message);
  }
  return writeFileAtomically(path, bytes);
}

}  // namespace

Result<Image> readPng(const fs::path& path) {
  return readAs<std::uint8_t>(path);
}
Result<Image16> readPng16(const fs::path& path) {
  return readAs<std::uint16_t>(path);
}
Result<Image> decodePng(std::span<const unsigned char> bytes, const std::string& file, const std::string& pointer) {
  return decodeAs<std::uint8_t>(bytes, file, pointer);
}
Status writePng(const fs::path& path, const Image& image) {
  return writeAs(path, image);
}
Status writePng(const fs::path& path, const Image16& image) {
  return writeAs(path, image);
}

}  // namespace windloom
