#pragma once
// Small glTF files that tests build and break.

#include <cstring>
#include <string>
#include <vector>

namespace windloom::testing {

/// One primitive: parts of a buffer behind each other, named by accessors in the same order.
struct GltfBuilder {
  struct Part {
    std::string bytes;
    int componentType = 5126;
    std::size_t count = 0;
    std::string type;  ///< empty: no accessor, a picture
  };
  std::vector<Part> parts;
  std::string attributes, primitiveRest, materials, textures, images, nodes = R"({"mesh": 0})", sceneNodes = "0", extra;

  template <class T>
  int add(const std::vector<T>& values, int componentType, const std::string& type, std::size_t perElement) {
    Part part;
    part.bytes.resize(values.size() * sizeof(T));
    if (!values.empty()) std::memcpy(part.bytes.data(), values.data(), part.bytes.size());
    part.componentType = componentType;
    part.count = values.size() / perElement;
    part.type = type;
    parts.push_back(std::move(part));
    return static_cast<int>(parts.size()) - 1;
  }
  /// The index of its buffer view.
  int addPicture(const std::string& bytes) {
    parts.push_back({bytes, 0, 0, {}});
    return static_cast<int>(parts.size()) - 1;
  }
  void attribute(const std::string& name, int accessor) {
    attributes += (attributes.empty() ? "" : ", ") + ("\"" + name + "\": " + std::to_string(accessor));
  }

  [[nodiscard]] std::string glb() const {
    std::string data, views, accessors;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      data.resize((data.size() + 3) / 4 * 4, '\0');
      views += (i > 0 ? "," : "") + (R"({"buffer": 0, "byteOffset": )" + std::to_string(data.size())) +
               R"(, "byteLength": )" + std::to_string(parts[i].bytes.size()) + "}";
      // Pictures come last, so that accessors and views have the same numbers.
      if (!parts[i].type.empty()) {
        accessors += (accessors.empty() ? "" : ",") + (R"({"bufferView": )" + std::to_string(i)) +
                     R"(, "componentType": )" + std::to_string(parts[i].componentType) + R"(, "count": )" +
                     std::to_string(parts[i].count) + R"(, "type": ")" + parts[i].type + "\"}";
      }
      data += parts[i].bytes;
    }
    data.resize((data.size() + 3) / 4 * 4, '\0');
    std::string text = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [)" + sceneNodes +
                       R"(]}], "nodes": [)" + nodes + R"(], "meshes": [{"primitives": [{"attributes": {)" + attributes +
                       "}" + primitiveRest + R"(}]}], "accessors": [)" + accessors + R"(], "bufferViews": [)" + views +
                       R"(], "buffers": [{"byteLength": )" + std::to_string(data.size()) + "}]";
    if (!materials.empty()) text += R"(, "materials": [)" + materials + "]";
    if (!textures.empty()) text += R"(, "textures": [)" + textures + "]";
    if (!images.empty()) text += R"(, "images": [)" + images + "]";
    text += extra + "}";
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const auto number = [](std::size_t value) {
      const auto n = static_cast<std::uint32_t>(value);
      return std::string(reinterpret_cast<const char*>(&n), 4);
    };
    return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + data.size()) + number(text.size()) + "JSON" + text +
           number(data.size()) + std::string("BIN\0", 4) + data;
  }
};

/// A triangle of 1 m, standing; indexed.
inline GltfBuilder standingTriangle() {
  GltfBuilder builder;
  builder.attribute("POSITION", builder.add<float>({0, 0, 0, 1, 0, 0, 0, 2, 0}, 5126, "VEC3", 3));
  builder.add<std::uint16_t>({0, 1, 2}, 5123, "SCALAR", 1);
  builder.primitiveRest = R"(, "indices": 1)";
  return builder;
}

}  // namespace windloom::testing
