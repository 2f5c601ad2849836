// KTX2 textures: the frames of a recording as a 2D array, one frame alone as a plain 2D texture.

#include <algorithm>
#include <optional>

#include "engine/bake/dds_header.hpp"
#include "engine/bake/flow_facts.hpp"
#include "engine/bake/ktx2_header.hpp"
#include "engine/bake/writers.hpp"
#include "engine/bake/zstd_stream.hpp"
#include "engine/core/atomic_file.hpp"
#include "engine/core/text.hpp"

namespace windloom {
namespace {

struct Ktx2Kind {
  TextureFormat format;
  Supercompression supercompression;
  const char* stem;
};

Ktx2Texture textureOf(const BakeHeader& header, const Ktx2Kind& kind) {
  Ktx2Texture texture;
  texture.format = kind.format;
  texture.resolution = header.grid.resolution;
  texture.layers = header.frames;
  texture.supercompression = kind.supercompression;
  // Row 0 is the top of the picture, as in every image file.
  texture.texts = {{"KTXorientation", "rd"}, {"KTXwriter", "Windloom " WINDLOOM_VERSION}};
  const TargetFrame target(header);
  for (const auto& [name, text] : flowFacts(header, target)) texture.texts.emplace_back("windloom." + name, text);
  if (kind.format == TextureFormat::Bc5) {
    // Of a fixed length, so that the file's size is known before its full scale is.
    std::string vmax = shortest(target.fullScale());
    vmax.resize(16, ' ');
    texture.texts.emplace_back("windloom.vmax", vmax);
  }
  std::sort(texture.texts.begin(), texture.texts.end());  // as the format wants it
  return texture;
}

class Ktx2Writer final : public FrameWriter {
 public:
  Ktx2Writer(const BakeHeader& header, const Ktx2Kind& kind, std::string name, AtomicFile file)
      : m_pixels(header, kind.format),
        m_kind(kind),
        m_texture(textureOf(header, kind)),
        m_name(std::move(name)),
        m_file(std::move(file)) {
    if (kind.supercompression == Supercompression::Zstd) {
      m_zstd.emplace(ktx2LevelBytes(m_texture), [this](std::string_view packed) {
        m_stored += packed.size();
        return m_file.write(packed);
      });
    }
  }

  /// With zstd the length of the level isn't known yet and comes in finish().
  Status begin() { return m_file.write(ktx2Header(m_texture, ktx2LevelBytes(m_texture))); }

  Status add(int, std::span<const glm::vec2> cells) override {
    const std::string_view bytes = m_pixels.of(cells);
    return m_zstd ? m_zstd->write(bytes) : m_file.write(bytes);
  }

  Result<std::vector<BakedFile>> finish() override {
    if (m_zstd) {
      if (Status packed = m_zstd->finish(); !packed) return packed.error();
      if (Status written = m_file.overwrite(0, ktx2Header(m_texture, m_stored)); !written) return written.error();
    }
    if (Status finished = m_file.finish(Sync::Later); !finished) return finished.error();
    m_pixels.warn();
    return std::vector<BakedFile>{{m_name,
                                   "flow",
                                   std::string(encodingOf(m_kind.format)),
                                   {{"layout", m_texture.layers > 1 ? "array" : "image"},
                                    {"frames", m_texture.layers},
                                    {"channels", channelsOf(m_kind.format)},
                                    {"units", m_pixels.target().unit()}}}};
  }

 private:
  TexturePixels m_pixels;
  Ktx2Kind m_kind;
  Ktx2Texture m_texture;
  std::string m_name;
  AtomicFile m_file;
  std::uint64_t m_stored = 0;  // of the level, where it is packed
  std::optional<ZstdStream> m_zstd;
};

std::uint64_t fileBytes(const BakeHeader& header, TextureFormat format) {
  const Ktx2Texture texture = textureOf(header, {format, Supercompression::None, ""});
  return ktx2Header(texture, 0).size() + ktx2LevelBytes(texture);
}

OpenedWriter openKtx2(const BakeHeader& header, const std::filesystem::path& folder, const Ktx2Kind& kind) {
  const std::string name = stemOf(header.track, kind.stem) + ".ktx2";
  Result<AtomicFile> file = AtomicFile::create(folder / name);
  if (!file) return file.error();
  auto writer = std::make_unique<Ktx2Writer>(header, kind, name, std::move(*file));
  if (Status begun = writer->begin(); !begun) return begun.error();
  return std::unique_ptr<FrameWriter>(std::move(writer));
}

}  // namespace

std::uint64_t ktx2Bytes(const BakeHeader& header) {
  return fileBytes(header, TextureFormat::Rg16f);
}

std::uint64_t ktx2RgbaBytes(const BakeHeader& header) {
  return fileBytes(header, TextureFormat::Rgba16f);
}

std::uint64_t ktx2Bc5Bytes(const BakeHeader& header) {
  return fileBytes(header, TextureFormat::Bc5);
}

std::string ktx2Warning(const BakeHeader& header) {
  if (header.frames <= kMaxTextureSlices) return {};
  return "most GPUs take at most " + std::to_string(kMaxTextureSlices) + " layers in a texture array, not " +
         std::to_string(header.frames);
}

OpenedWriter openKtx2Writer(const BakeHeader& header, const std::filesystem::path& folder) {
  return openKtx2(header, folder, {TextureFormat::Rg16f, Supercompression::None, "wind"});
}

OpenedWriter openKtx2RgbaWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openKtx2(header, folder, {TextureFormat::Rgba16f, Supercompression::None, "wind-rgba"});
}

OpenedWriter openKtx2Bc5Writer(const BakeHeader& header, const std::filesystem::path& folder) {
  return openKtx2(header, folder, {TextureFormat::Bc5, Supercompression::None, "flow-bc5"});
}

OpenedWriter openKtx2ZstdWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openKtx2(header, folder, {TextureFormat::Rg16f, Supercompression::Zstd, "wind-zstd"});
}

}  // namespace windloom
