#include "engine/bake/writers.hpp"
#include "engine/io/npy.hpp"

namespace windloom {
namespace {

class NpyWriter final : public FrameWriter {
 public:
  NpyWriter(NpyStream stream, std::string name) : m_stream(std::move(stream)), m_name(std::move(name)) {}

  Status add(int, std::span<const glm::vec2> cells) override {
    static_assert(sizeof(glm::vec2) == 2 * sizeof(float));
    return m_stream.write({&cells.data()->x, cells.size() * 2});
  }

  Result<std::vector<BakedFile>> finish() override {
    if (Status finished = m_stream.finish(); !finished) return finished.error();
    return std::vector<BakedFile>{{m_name, "field", "float32"}};
  }

 private:
  NpyStream m_stream;
  std::string m_name;
};

}  // namespace

Result<std::unique_ptr<FrameWriter>> openNpyWriter(const BakeHeader& header, const std::filesystem::path& folder) {
  const std::vector<std::size_t> shape = {static_cast<std::size_t>(header.frames),
                                          static_cast<std::size_t>(header.grid.resolution.y),
                                          static_cast<std::size_t>(header.grid.resolution.x), 2};
  const std::string name = stemOf(header.track, "wind") + ".npy";
  Result<NpyStream> stream = NpyStream::create(folder / name, shape);
  if (!stream) return stream.error();
  return std::unique_ptr<FrameWriter>(std::make_unique<NpyWriter>(std::move(*stream), name));
}

}  // namespace windloom
