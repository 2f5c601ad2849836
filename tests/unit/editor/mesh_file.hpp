#pragma once
// A small glTF file.

#include <cstdint>
#include <cstring>
#include <string>

namespace windloom::testing {

/// A pyramid with a square foot of 0.4 m and so high, as a .glb file.
inline std::string meshFile(float heightM) {
  const float positions[] = {-0.2f, 0, -0.2f, 0.2f, 0, -0.2f, 0.2f, 0, 0.2f, -0.2f, 0, 0.2f, 0, heightM, 0};
  const std::uint16_t indices[] = {0, 2, 1, 0, 3, 2, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
  std::string bytes(sizeof positions + sizeof indices, '\0');
  std::memcpy(bytes.data(), positions, sizeof positions);
  std::memcpy(bytes.data() + sizeof positions, indices, sizeof indices);
  const std::string high = std::to_string(heightM), whole = std::to_string(bytes.size());
  std::string text = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3", "min": [-0.2, 0, -0.2],
                   "max": [0.2, )" +
                     high + R"(, 0.2]},
                  {"bufferView": 1, "componentType": 5123, "count": 18, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 60}, {"buffer": 0, "byteOffset": 60, "byteLength": 36}],
    "buffers": [{"byteLength": )" +
                     whole + "}]}";
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t value) {
    const auto n = static_cast<std::uint32_t>(value);
    return std::string(reinterpret_cast<const char*>(&n), 4);
  };
  return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + bytes.size()) + number(text.size()) + "JSON" + text +
         number(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

}  // namespace windloom::testing
