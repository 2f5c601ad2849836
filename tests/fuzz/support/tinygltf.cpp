// The library that reads glTF files and the pictures in them, compiled here so that it is under attack, too.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_INCLUDE_JSON
#define TINYGLTF_NO_INCLUDE_STB_IMAGE
#define TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define STB_IMAGE_IMPLEMENTATION
// What it is told not to include comes first.
// clang-format off
#include <nlohmann/json.hpp>
#include <stb/stb_image.h>
#include <tiny_gltf.h>
// clang-format on
