#include "engine/io/npy.hpp"

#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>

#include "engine/core/file.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little, "values go to and from the file as they lie in memory");

constexpr std::string_view kMagic("\x93NUMPY", 6);

std::size_t elementCount(const std::vector<std::size_t>& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  return count;
}

std::string shapeText(const std::vector<std::size_t>& shape) {
  std::string text = "(";
  for (const std::size_t extent : shape) text += std::to_string(extent) + (shape.size() == 1 ? "," : ", ");
  if (shape.size() > 1) text.resize(text.size() - 2);
  return text + ")";
}

std::string headerText(const std::vector<std::size_t>& shape) {
  std::string dictionary = "{'descr': '<f4', 'fortran_order': False, 'shape': " + shapeText(shape) + ", }";
  constexpr std::size_t kPrefix = 10;  // magic, version, length
  constexpr std::size_t kAlignment = 64;
  const std::size_t rest = (kPrefix + dictionary.size() + 1) % kAlignment;
  dictionary.append(rest == 0 ? 0 : kAlignment - rest, ' ');
  dictionary += '\n';
  std::string header(kMagic);
  header += '\x01';
  header += '\x00';
  header += static_cast<char>(dictionary.size() & 0xff);
  header += static_cast<char>(dictionary.size() >> 8);
  return header + dictionary;
}

std::string_view asBytes(std::span<const float> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// The text after `'key':` in the header's dictionary.
std::optional<std::string_view> valueOf(std::string_view dictionary, std::string_view key) {
  for (const char quote : {'\'', '"'}) {
    const std::string quoted = quote + std::string(key) + quote;
    const auto at = dictionary.find(quoted);
    if (at == std::string_view::npos) continue;
    std::string_view rest = trimmed(dictionary.substr(at + quoted.size()));
    if (rest.empty() || rest.front() != ':') return std::nullopt;
    return trimmed(rest.substr(1));
  }
  return std::nullopt;
}

/// What stands between the quotes at the start of `text`; a type with fields is given as a whole.
std::string descriptionOf(std::string_view text) {
  if (text.empty() || (text.front() != '\'' && text.front() != '"')) return "a record type";
  const auto end = text.find(text.front(), 1);
  return std::string(text.substr(1, end == std::string_view::npos ? end : end - 1));
}

std::optional<std::vector<std::size_t>> parseShape(std::string_view text) {
  if (text.empty() || text.front() != '(') return std::nullopt;
  const auto end = text.find(')');
  if (end == std::string_view::npos) return std::nullopt;
  text = text.substr(1, end - 1);
  std::vector<std::size_t> shape;
  while (!trimmed(text).empty()) {
    const auto comma = text.find(',');
    const std::string_view part = trimmed(text.substr(0, comma));
    std::size_t extent = 0;
    const auto [stop, code] = std::from_chars(part.data(), part.data() + part.size(), extent);
    if (code != std::errc() || stop != part.data() + part.size() || shape.size() == 32) return std::nullopt;
    shape.push_back(extent);
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
  }
  return shape;
}

struct Header {
  std::string_view dictionary;
  std::size_t dataOffset = 0;
};

std::optional<Header> splitHeader(std::string_view bytes) {
  if (bytes.size() < 10 || bytes.substr(0, 6) != kMagic) return std::nullopt;
  const auto byteAt = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const std::size_t version = byteAt(6);
  if (version < 1 || version > 3) return std::nullopt;
  const std::size_t prefix = version == 1 ? 10 : 12;
  if (bytes.size() < prefix) return std::nullopt;
  std::size_t length = byteAt(8) | byteAt(9) << 8;
  if (version > 1) length |= byteAt(10) << 16 | byteAt(11) << 24;
  if (bytes.size() - prefix < length) return std::nullopt;
  return Header{bytes.substr(prefix, length), prefix + length};
}

}  // namespace

Result<NpyArray> readNpy(const fs::path& path, std::uint64_t limitBytes) {
  const auto refuse = [&](const std::string& message) {
    return makeError(ErrorKind::BadInput, path.string(), {}, message);
  };
  const Result<std::string> bytes = readFile(path, limitBytes);
  if (!bytes) return bytes.error();
  const std::optional<Header> header = splitHeader(*bytes);
  if (!header) return refuse("is not a .npy file (version 1 to 3), or its header is damaged");
  const auto type = valueOf(header->dictionary, "descr");
  const auto order = valueOf(header->dictionary, "fortran_order");
  const auto shapeValue = valueOf(header->dictionary, "shape");
  const auto shape = shapeValue ? parseShape(*shapeValue) : std::nullopt;
  if (!type || !order || !shape) return refuse("has a .npy header without a readable type, order and shape");
  if (const std::string found = descriptionOf(*type); found != "<f4") {
    return refuse("holds values of type '" + found + "', expected little-endian float32 '<f4' (a.astype('<f4'))");
  }
  if (!order->starts_with("False")) {
    return refuse("is in Fortran order, expected C order (numpy.ascontiguousarray(a))");
  }
  const std::size_t available = (bytes->size() - header->dataOffset) / sizeof(float);
  std::size_t count = 1;
  bool fits = (bytes->size() - header->dataOffset) % sizeof(float) == 0;
  for (const std::size_t extent : *shape) {
    if (extent != 0 && count > std::numeric_limits<std::size_t>::max() / extent) fits = false;
    count *= extent;
  }
  if (!fits || count != available) {
    return refuse("has the shape " + shapeText(*shape) + ", but holds " +
                  std::to_string(bytes->size() - header->dataOffset) + " bytes of values: it is cut short or damaged");
  }
  NpyArray array{*shape, std::vector<float>(count)};
  if (count > 0) std::memcpy(array.values.data(), bytes->data() + header->dataOffset, count * sizeof(float));
  return array;
}

Status writeNpy(const fs::path& path, const std::vector<std::size_t>& shape, std::span<const float> values) {
  Result<NpyStream> stream = NpyStream::create(path, shape);
  if (!stream) return stream.error();
  if (Status status = stream->write(values); !status) return status;
  return stream->finish();
}

Result<NpyStream> NpyStream::create(const fs::path& path, const std::vector<std::size_t>& shape) {
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file) return file.error();
  if (Status status = file->write(headerText(shape)); !status) return status.error();
  return NpyStream(std::move(*file), elementCount(shape));
}

Status NpyStream::write(std::span<const float> values) {
  WL_REQUIRE(values.size() <= m_left, "more values than the shape of the .npy file says");
  m_left -= values.size();
  return m_file.write(asBytes(values));
}

Status NpyStream::finish() {
  WL_REQUIRE(m_left == 0, "fewer values than the shape of the .npy file says");
  return m_file.finish();
}

}  // namespace windloom
