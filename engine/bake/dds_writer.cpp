// DDS textures: the frames of a recording as an array or a volume.

#include "engine/bake/dds_header.hpp"
#include "engine/bake/writers.hpp"
#include "engine/core/atomic_file.hpp"

namespace windloom {
namespace {

struct DdsKind {
  TextureFormat format;
  TextureShape shape;
  const char* stem;
};

class DdsWriter final : public FrameWriter {
 public:
  DdsWriter(const BakeHeader& header, const DdsKind& kind, std::string name, AtomicFile file)
      : m_pixels(header, kind.format),
        m_kind(kind),
        m_frames(header.frames),
        m_name(std::move(name)),
        m_file(std::move(file)) {}

  Status add(int, std::span<const glm::vec2> cells) override { return m_file.write(m_pixels.of(cells)); }

  Result<std::vector<BakedFile>> finish() override {
    if (Status finished = m_file.finish(Sync::Later); !finished) return finished.error();
    m_pixels.warn();
    return std::vector<BakedFile>{{m_name,
                                   "flow",
                                   std::string(encodingOf(m_kind.format)),
                                   {{"layout", m_kind.shape == TextureShape::Array ? "array" : "volume"},
                                    {"frames", m_frames},
                                    {"channels", channelsOf(m_kind.format)},
                                    {"units", m_pixels.target().unit()}}}};
  }

 private:
  TexturePixels m_pixels;
  DdsKind m_kind;
  int m_frames;
  std::string m_name;
  AtomicFile m_file;
};

std::uint64_t fileBytes(const BakeHeader& header, TextureFormat format) {
  const std::string start = ddsHeader(format, TextureShape::Array, header.grid.resolution, header.frames);
  return start.size() + textureBytes(format, header.grid.resolution) * static_cast<std::uint64_t>(header.frames);
}

OpenedWriter openDds(const BakeHeader& header, const std::filesystem::path& folder, const DdsKind& kind) {
  const glm::ivec2 resolution = header.grid.resolution;
  if (std::string refusal = ddsRefusal(kind.shape, resolution, header.frames); !refusal.empty()) {
    return makeError(ErrorKind::BadInput, refusal);
  }
  const std::string name = stemOf(header.track, kind.stem) + ".dds";
  Result<AtomicFile> file = AtomicFile::create(folder / name);
  if (!file) return file.error();
  if (Status written = file->write(ddsHeader(kind.format, kind.shape, resolution, header.frames)); !written) {
    return written.error();
  }
  return std::unique_ptr<FrameWriter>(std::make_unique<DdsWriter>(header, kind, name, std::move(*file)));
}

}  // namespace

std::uint64_t ddsBytes(const BakeHeader& header) {
  return fileBytes(header, TextureFormat::Rg16f);
}

std::uint64_t ddsRgbaBytes(const BakeHeader& header) {
  return fileBytes(header, TextureFormat::Rgba16f);
}

std::uint64_t ddsBc5Bytes(const BakeHeader& header) {
  return fileBytes(header, TextureFormat::Bc5);
}

std::string ddsArrayRefusal(const BakeHeader& header) {
  return ddsRefusal(TextureShape::Array, header.grid.resolution, header.frames);
}

std::string ddsVolumeRefusal(const BakeHeader& header) {
  return ddsRefusal(TextureShape::Volume, header.grid.resolution, header.frames);
}

OpenedWriter openDdsWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openDds(header, folder, {TextureFormat::Rg16f, TextureShape::Array, "wind"});
}

OpenedWriter openDdsRgbaWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openDds(header, folder, {TextureFormat::Rgba16f, TextureShape::Array, "wind-rgba"});
}

OpenedWriter openDdsBc5Writer(const BakeHeader& header, const std::filesystem::path& folder) {
  return openDds(header, folder, {TextureFormat::Bc5, TextureShape::Array, "flow-bc5"});
}

OpenedWriter openDdsVolumeWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  return openDds(header, folder, {TextureFormat::Rg16f, TextureShape::Volume, "wind-volume"});
}

}  // namespace windloom
