#include "engine/model/asset_names.hpp"

#include <algorithm>

namespace windloom {
namespace {

/// Calls `use` with each part between slashes; true where one of them gave true.
template <class Use>
bool anyPart(std::string_view file, Use use) {
  for (std::size_t start = 0; start <= file.size();) {
    const std::size_t end = std::min(file.find('/', start), file.size());
    if (use(file.substr(start, end - start))) return true;
    start = end + 1;
  }
  return false;
}

std::string listed(const char* list, std::size_t index) {
  return std::string(list).append("/").append(std::to_string(index)).append("/file");
}

}  // namespace

std::string assetFileProblem(std::string_view file) {
  if (file.empty()) return {};
  const auto refuse = [&](const char* why) {
    return "found '" + std::string(file) + "', " + why +
           ": expected a path below the project's folder with '/' between folders";
  };
  if (file.find('\\') != file.npos) return refuse("which holds a backslash");
  // The first part of an absolute path is empty.
  const std::string_view parts = file.front() == '/' ? file.substr(1) : file;
  if (anyPart(parts, [](std::string_view part) { return part.empty() || part == "."; }))
    return refuse("which has an empty part");
  return {};
}

std::string_view outsideReason(std::string_view file) {
  if (file.starts_with('/')) return "an absolute path";
  if (anyPart(file, [](std::string_view part) { return part == ".."; })) return "which leaves the project's folder";
  return {};
}

std::vector<AssetName> assetNames(const Project& project) {
  std::vector<AssetName> names;
  const auto add = [&](std::string pointer, const std::string& file) {
    if (!file.empty()) names.push_back({std::move(pointer), file});
  };
  add("/terrain/file", project.terrain->file);
  add("/grass/maps/density", project.grass->densityMap);
  add("/grass/maps/height", project.grass->heightMap);
  add("/grass/maps/colour", project.grass->colourMap);
  add("/shell/texture/file", project.shell->texture);
  const auto addAll = [&](const char* list, const auto& records) {
    for (std::size_t i = 0; i < records.size(); ++i) add(listed(list, i), records[i].file);
  };
  addAll("/species", *project.species);
  addAll("/colliders", *project.colliders);
  addAll("/surfaces", *project.surfaces);
  return names;
}

}  // namespace windloom
