#include "engine/io/plant_texture.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/io/image.hpp"

namespace windloom::gltf {
namespace fs = std::filesystem;
namespace {

// Pixels repeated around each picture of several, so that smaller mip levels don't mix them.
constexpr int kRim = 8;

std::string pointerOf(int image) {
  std::string pointer = "/images/";
  pointer += std::to_string(image);
  return pointer;
}

/// Width and height from a JPEG's frame header; 0 where there is none.
glm::ivec2 jpegSize(const std::vector<unsigned char>& bytes) {
  std::size_t at = 2;
  while (at + 9 < bytes.size() && bytes[at] == 0xff) {
    const unsigned kind = bytes[at + 1];
    const bool frame = kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (frame) return {bytes[at + 7] * 256 + bytes[at + 8], bytes[at + 5] * 256 + bytes[at + 6]};
    at += 2u + bytes[at + 2] * 256u + bytes[at + 3];
  }
  return glm::ivec2(0);
}

/// Whether no Huffman table (the segment at `at` holds some) has more than the 256 codes that there can be.
bool tablesFit(const std::vector<unsigned char>& bytes, std::size_t at, std::size_t end) {
  constexpr std::size_t kHead = 17;  // its number, then how many codes there are of each length
  while (at < std::min(end, bytes.size())) {
    std::size_t codes = 0;
    for (std::size_t i = 1; i < kHead && at + i < bytes.size(); ++i) codes += bytes[at + i];
    if (codes > 256) return false;
    at += kHead + codes;
  }
  return true;
}

/// What speaks against giving a picture to the library that decodes JPEG; empty where nothing does. The library writes
/// beyond its tables where one is too long (stb_image before 2.29), and passes over all pixels for every scan, of which
/// a progressive picture has about ten and one made to last any number, of ten bytes each. So the segments are looked
/// at first, one by one up to the end of the picture.
std::string jpegProblem(const std::vector<unsigned char>& bytes) {
  std::size_t scans = 0;
  for (std::size_t at = 0; at + 3 < bytes.size();) {
    if (bytes[at++] != 0xff) continue;
    while (at + 2 < bytes.size() && bytes[at] == 0xff) ++at;
    const unsigned kind = bytes[at++];
    if (kind == 0xd9) return {};
    if (kind == 0x00 || kind == 0x01 || (kind >= 0xd0 && kind <= 0xd8)) continue;  // no segment: coded picture
    if (at + 1 >= bytes.size()) return {};
    const std::size_t length = bytes[at] * 256u + bytes[at + 1];
    if (kind == 0xc4 && !tablesFit(bytes, at + 2, at + length)) return "is a damaged JPEG picture";
    if (kind == 0xda && ++scans > kMaxJpegScans)
      return "is a JPEG picture of more than " + std::to_string(kMaxJpegScans) + " scans: export it as a plain one";
    at += std::max<std::size_t>(length, 2);
  }
  return {};
}

Image toRgba(const Image& from) {
  if (from.channels == 4) return from;
  Image to(from.width, from.height, 4);
  for (int y = 0; y < from.height; ++y) {
    for (int x = 0; x < from.width; ++x) {
      const std::uint8_t* in = from.at(x, y);
      std::uint8_t* out = to.at(x, y);
      for (int c = 0; c < 3; ++c) out[c] = from.channels == 1 ? in[0] : in[c];
      out[3] = 255;
    }
  }
  return to;
}

bool isJpeg(const std::vector<unsigned char>& bytes) {
  return bytes.size() > 3 && bytes[0] == 0xff && bytes[1] == 0xd8;
}

/// Width and height as the picture's header says, which may be a lie; 0 where there is no header.
glm::i64vec2 sizeInHeader(const std::vector<unsigned char>& bytes) {
  if (isJpeg(bytes)) return jpegSize(bytes);
  if (bytes.size() < 24 || bytes[0] != 0x89 || bytes[1] != 'P') return glm::i64vec2(0);
  const auto sideAt = [&](std::size_t at) {
    return std::int64_t{bytes[at]} << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
  };
  return {sideAt(16), sideAt(20)};
}

Result<Image> decodeJpeg(const std::vector<unsigned char>& bytes, const fs::path& file, const std::string& pointer) {
  const auto bad = [&](const std::string& text) {
    return makeError(ErrorKind::BadInput, file.string(), pointer, text);
  };
  const glm::ivec2 size = jpegSize(bytes);
  if (size.x <= 0 || size.y <= 0) return bad("is a damaged JPEG picture");
  if (const std::string problem = jpegProblem(bytes); !problem.empty()) return bad(problem);
  tinygltf::Image decoded;
  std::string problem, warning;
  const bool good = tinygltf::LoadImageData(&decoded, 0, &problem, &warning, 0, 0, bytes.data(),
                                            static_cast<int>(bytes.size()), nullptr);
  const auto wanted = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4;
  if (!good || decoded.width != size.x || decoded.height != size.y || decoded.image.size() != wanted)
    return bad("is a damaged JPEG picture");
  Image image(size.x, size.y, 4);
  image.pixels.assign(decoded.image.begin(), decoded.image.end());
  return image;
}

/// `pixelsLeft`: how many more the plant's pictures may have.
Result<Image> readPicture(const tinygltf::Model& model, int index, const fs::path& file, std::int64_t& pixelsLeft) {
  const std::string pointer = pointerOf(index);
  const auto bad = [&](const std::string& text) {
    return makeError(ErrorKind::BadInput, file.string(), pointer, text);
  };
  if (index < 0 || static_cast<std::size_t>(index) >= model.images.size())
    return refuse(file, "has a texture whose picture is not there");
  const tinygltf::Image& source = model.images[static_cast<std::size_t>(index)];
  const std::vector<unsigned char>& bytes = source.image;
  if (bytes.empty()) {
    return bad(source.uri.empty() ? "is an empty picture"
                                  : "refers to the picture '" + source.uri + "', which is not beside it");
  }
  const glm::i64vec2 size = sizeInHeader(bytes);
  if (std::max(size.x, size.y) > kMaxPictureSide)
    return bad("has more than " + std::to_string(kMaxPictureSide) + " pixels a side");
  pixelsLeft -= size.x * size.y;
  if (pixelsLeft < 0)
    return bad("makes more than " + std::to_string(kMaxPicturePixels >> 20) + " million pixels in all pictures");
  if (isJpeg(bytes)) return decodeJpeg(bytes, file, pointer);
  if (size.x <= 0) return bad("is a picture that can't be read, expected PNG or JPEG");
  Result<Image> image = decodePng(bytes, file.string(), pointer);
  if (!image) return image.error();
  return toRgba(*image);
}

/// Means of factor x factor pixels, colours counted by their alpha so that what is cut away doesn't bleed in.
Image smaller(const Image& from, int factor) {
  Image to(std::max(1, from.width / factor), std::max(1, from.height / factor), 4);
  for (int y = 0; y < to.height; ++y) {
    for (int x = 0; x < to.width; ++x) {
      double sum[3] = {}, plain[3] = {}, alpha = 0;
      int count = 0;
      for (int v = y * factor; v < std::min((y + 1) * factor, from.height); ++v) {
        for (int u = x * factor; u < std::min((x + 1) * factor, from.width); ++u, ++count) {
          const std::uint8_t* in = from.at(u, v);
          for (int c = 0; c < 3; ++c) {
            sum[c] += static_cast<double>(in[c]) * in[3];
            plain[c] += in[c];
          }
          alpha += in[3];
        }
      }
      std::uint8_t* out = to.at(x, y);
      for (int c = 0; c < 3; ++c)
        out[c] = static_cast<std::uint8_t>(std::lround(alpha > 0 ? sum[c] / alpha : plain[c] / count));
      out[3] = static_cast<std::uint8_t>(std::lround(alpha / count));
    }
  }
  return to;
}

glm::mat3 transformOf(const tinygltf::TextureInfo& info) {
  const auto found = info.extensions.find("KHR_texture_transform");
  if (found == info.extensions.end() || !found->second.IsObject()) return glm::mat3(1.0f);
  const tinygltf::Value& value = found->second;
  const auto pair = [&](const char* key, glm::vec2 otherwise) {
    if (!value.Has(key) || !value.Get(key).IsArray() || value.Get(key).ArrayLen() != 2) return otherwise;
    return glm::vec2(value.Get(key).Get(0).GetNumberAsDouble(), value.Get(key).Get(1).GetNumberAsDouble());
  };
  const glm::vec2 offset = pair("offset", glm::vec2(0.0f)), scale = pair("scale", glm::vec2(1.0f));
  const auto turn = static_cast<float>(value.Has("rotation") ? value.Get("rotation").GetNumberAsDouble() : 0.0);
  const float c = std::cos(turn), s = std::sin(turn);
  // Column by column: scaled, turned, moved (the extension's README).
  return {glm::vec3(scale.x * c, -scale.x * s, 0.0f), glm::vec3(scale.y * s, scale.y * c, 0.0f),
          glm::vec3(offset, 1.0f)};
}

/// A picture and how its alpha counts.
struct Layer {
  Image image;
  glm::ivec2 place{0};
};

void putInto(Image& all, const Layer& layer, int rim) {
  for (int y = -rim; y < layer.image.height + rim; ++y) {
    for (int x = -rim; x < layer.image.width + rim; ++x) {
      const std::uint8_t* in =
          layer.image.at(std::clamp(x, 0, layer.image.width - 1), std::clamp(y, 0, layer.image.height - 1));
      std::copy(in, in + 4, all.at(layer.place.x + x, layer.place.y + y));
    }
  }
}

/// Stacks the layers; where they get too large all are made smaller by the same factor.
Image stack(std::vector<Layer>& layers) {
  const int rim = layers.size() > 1 ? kRim : 0;
  int wide = 0, high = 0;
  for (const Layer& layer : layers) {
    wide = std::max(wide, layer.image.width);
    high += layer.image.height;
  }
  const int room = kMaxPlantTexture - 2 * rim * static_cast<int>(layers.size());
  const int factor = std::max({1, (wide + room - 1) / room, (high + room - 1) / room});
  if (factor > 1) {
    for (Layer& layer : layers) layer.image = smaller(layer.image, factor);
  }
  wide = high = 0;
  for (Layer& layer : layers) {
    layer.place = {rim, high + rim};
    wide = std::max(wide, layer.image.width + 2 * rim);
    high += layer.image.height + 2 * rim;
  }
  Image all(wide, high, 4);
  for (const Layer& layer : layers) putInto(all, layer, rim);
  return all;
}

class Packer {
 public:
  Packer(const tinygltf::Model& model, const fs::path& file) : m_model(model), m_file(file) {}

  Status add(int index) {
    PlantMaterial made;
    int layer = -1;
    if (index >= 0) {
      if (static_cast<std::size_t>(index) >= m_model.materials.size())
        return refuse(m_file, "refers to material " + std::to_string(index) + ", which is not there");
      const tinygltf::Material& material = m_model.materials[static_cast<std::size_t>(index)];
      const auto& factor = material.pbrMetallicRoughness.baseColorFactor;
      for (std::size_t c = 0; c < 4 && c < factor.size(); ++c)
        made.colour[static_cast<int>(c)] = static_cast<float>(std::clamp(factor[c], 0.0, 1.0));  // as glTF has it
      const bool opaque = material.alphaMode != "MASK" && material.alphaMode != "BLEND";
      takeCutoff(material, made);
      const tinygltf::TextureInfo& info = material.pbrMetallicRoughness.baseColorTexture;
      if (info.index >= 0) {
        Result<int> found = layerOf(info.index, opaque);
        if (!found) return found.error();
        layer = *found;
        made.texCoord = info.texCoord;
        made.transform = transformOf(info);
      }
    }
    m_made.push_back(made);
    m_layerOf.push_back(layer);
    return Done{};
  }

  std::vector<PlantMaterial> finish(PlantMesh& mesh) {
    mesh.alphaCutoff = m_cutoff > 0.0f ? m_cutoff : 0.5f;
    if (m_layers.empty()) return m_made;
    // Triangles without a picture need white beside those with one.
    const bool white = std::ranges::find(m_layerOf, -1) != m_layerOf.end();
    if (white) {
      m_layers.push_back({Image(4, 4, 4), {}});
      std::ranges::fill(m_layers.back().image.pixels, std::uint8_t{255});
    }
    const Image all = stack(m_layers);
    const glm::vec2 size(all.width, all.height);
    for (std::size_t i = 0; i < m_made.size(); ++i) {
      const Layer& layer = m_layers[m_layerOf[i] >= 0 ? static_cast<std::size_t>(m_layerOf[i]) : m_layers.size() - 1];
      m_made[i].low = glm::vec2(layer.place) / size;
      m_made[i].size = glm::vec2(layer.image.width, layer.image.height) / size;
      m_made[i].alone = m_layers.size() == 1;
    }
    mesh.textureSize = {all.width, all.height};
    mesh.texture = all.pixels;
    return m_made;
  }

 private:
  /// One cutoff serves the whole mesh: materials with another one scale their alpha to it.
  void takeCutoff(const tinygltf::Material& material, PlantMaterial& made) {
    if (material.alphaMode != "MASK" && material.alphaMode != "BLEND") {
      made.colour.a = 1.0f;
      return;
    }
    const float cutoff =
        material.alphaMode == "MASK" ? std::clamp(static_cast<float>(material.alphaCutoff), 0.01f, 1.0f) : 0.5f;
    if (m_cutoff <= 0.0f) m_cutoff = cutoff;
    made.colour.a *= m_cutoff / cutoff;
  }

  Result<int> layerOf(int texture, bool opaque) {
    if (static_cast<std::size_t>(texture) >= m_model.textures.size())
      return refuse(m_file, "refers to texture " + std::to_string(texture) + ", which is not there");
    const int source = m_model.textures[static_cast<std::size_t>(texture)].source;
    const auto known = m_known.find({source, opaque});
    if (known != m_known.end()) return known->second;
    Result<Image> image = readPicture(m_model, source, m_file, m_pixelsLeft);
    if (!image) return image.error();
    if (opaque) {
      for (std::size_t i = 3; i < image->pixels.size(); i += 4) image->pixels[i] = 255;
    }
    m_layers.push_back({std::move(*image), {}});
    const int layer = static_cast<int>(m_layers.size()) - 1;
    m_known[{source, opaque}] = layer;
    return layer;
  }

  const tinygltf::Model& m_model;
  const fs::path& m_file;
  std::vector<PlantMaterial> m_made;
  std::vector<int> m_layerOf;
  std::vector<Layer> m_layers;
  std::map<std::pair<int, bool>, int> m_known;
  float m_cutoff = 0.0f;
  std::int64_t m_pixelsLeft = kMaxPicturePixels;
};

}  // namespace

Result<std::vector<PlantMaterial>> packMaterials(const tinygltf::Model& model, const std::vector<int>& used,
                                                 const fs::path& file, PlantMesh& mesh) {
  if (used.size() > kMaxMaterials)
    return refuse(file, "uses more than " + std::to_string(kMaxMaterials) + " materials");
  Packer packer(model, file);
  for (const int index : used) {
    if (Status added = packer.add(index); !added) return added.error();
  }
  return packer.finish(mesh);
}

}  // namespace windloom::gltf
