#include "engine/io/asset_copy.hpp"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/core/file.hpp"
#include "engine/io/gltf_limits.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/sha256.hpp"
#include "engine/io/terrain_file.hpp"
#include "engine/model/asset_names.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

bool sameFile(const fs::path& a, const fs::path& b) {
  std::error_code failed;
  if (fs::equivalent(a, b, failed)) return true;
  if (fs::file_size(a, failed) != fs::file_size(b, failed) || failed) return false;
  const Result<std::string> first = sha256OfFile(a), second = sha256OfFile(b);
  return first && second && *first == *second;
}

bool isThere(const fs::path& path) {
  std::error_code failed;
  return fs::exists(fs::symlink_status(path, failed));
}

Status copyFile(const fs::path& from, const fs::path& to) {
  const Result<std::string> bytes = readFile(from, kMaxTerrainBytes);
  if (!bytes) return bytes.error();
  if (Status made = makeFolder(to.parent_path()); !made) return made;
  return writeFileAtomically(to, *bytes);
}

/// Where every one of the files is, or could be put without hiding another.
bool fits(const fs::path& from, const fs::path& to, const std::vector<std::string>& names) {
  return std::ranges::all_of(
      names, [&](const std::string& name) { return !isThere(to / name) || sameFile(from / name, to / name); });
}

/// That every one of the files, links in the folder followed, would lie below `top`, and so would the folders made for
/// it: a project that came from elsewhere may hold links to anywhere.
Status staysBelow(const fs::path& top, const fs::path& to, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (liesBelow((to / name).parent_path(), top)) continue;
    return makeError(ErrorKind::BadInput, (to / name).string(), {},
                     "lies behind a link that leads out of the project's folder: nothing is copied there");
  }
  return Done{};
}

Status copyAll(const fs::path& from, const fs::path& to, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (isThere(to / name)) continue;
    if (Status copied = copyFile(from / name, to / name); !copied) return copied;
  }
  return Done{};
}

std::string decodeUri(const std::string& uri) {
  std::string text;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      return at < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[at]));
    };
    if (uri[i] == '%' && digit(i + 1) && digit(i + 2)) {
      text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// The path of `file` below `folder`; empty where it lies elsewhere.
std::string pathBelow(const fs::path& file, const fs::path& folder) {
  std::error_code failed;
  const fs::path relative = fs::weakly_canonical(file, failed).lexically_relative(fs::weakly_canonical(folder, failed));
  if (failed || relative.empty() || *relative.begin() == "..") return {};
  return relative.generic_string();
}

/// The JSON of a glTF file, which stands alone or as the first chunk of a binary one, whatever the file is called.
std::string_view jsonOf(std::string_view bytes) {
  constexpr std::size_t kHeader = 12, kChunkHeader = 8;
  if (!bytes.starts_with("glTF") || bytes.size() < kHeader + kChunkHeader) return bytes;
  std::uint32_t length = 0;  // little endian, as the file is
  std::memcpy(&length, bytes.data() + kHeader, sizeof length);
  return bytes.substr(kHeader + kChunkHeader, length);
}

std::string numbered(const std::string& stem, int number) {
  return number == 1 ? stem : stem + "-" + std::to_string(number);
}

}  // namespace

std::vector<std::string> assetFiles(const Project& project) {
  std::vector<std::string> files;
  for (AssetName& name : assetNames(project)) {
    if (std::ranges::find(files, name.file) == files.end()) files.push_back(std::move(name.file));
  }
  return files;
}

Result<std::vector<std::string>> assetCompanions(const fs::path& file, const FileAccess& access) {
  std::vector<std::string> names;
  if (terrainKindOf(file) != TerrainKind::Mesh) return names;
  const Result<std::string> text = readFile(file, kMaxTerrainBytes);
  if (!text) return text.error();
  if (Status within = checkJsonExtent(jsonOf(*text), gltf::kMaxValues, file.string()); !within) return within.error();
  const FileAccess reach{access.folder.empty() ? fs::absolute(file).parent_path() : access.folder, access.outside};
  // With sorted keys: JsonDocument compares each key with all before it, and here is no limit to them.
  const auto document = nlohmann::json::parse(jsonOf(*text), nullptr, false);
  if (!document.is_object())
    return makeError(ErrorKind::BadInput, file.string(), {}, "is no glTF file: it holds no JSON object");
  std::set<std::string> known;
  for (const char* list : {"buffers", "images"}) {
    const auto entries = document.find(list);
    if (entries == document.end() || !entries->is_array()) continue;
    for (const nlohmann::json& entry : *entries) {
      const auto uri = entry.is_object() ? entry.find("uri") : entry.end();
      if (!entry.is_object() || uri == entry.end() || !uri->is_string()) continue;
      const std::string& address = uri->get_ref<const std::string&>();
      if (address.starts_with("data:")) continue;
      const std::string name = decodeUri(address);
      if (!known.insert(name).second) continue;
      if (known.size() > gltf::kMaxFiles) {
        return makeError(ErrorKind::BadInput, file.string(), {},
                         "refers to more than " + std::to_string(gltf::kMaxFiles) + " other files");
      }
      const bool legal = name.find(':') == name.npos && assetFileProblem(name).empty() && outsideReason(name).empty();
      if (!legal || !mayRead(reach, file.parent_path() / name)) {
        return makeError(ErrorKind::BadInput, file.string(), std::string("/") + list,
                         "refers to '" + address + "', expected files in its own folder: export it as one .glb file");
      }
      names.push_back(name);
    }
  }
  return names;
}

Result<std::string> bringAsset(const fs::path& file, const fs::path& projectFolder) {
  if (const std::string inside = pathBelow(file, projectFolder); !inside.empty()) return inside;
  Result<std::vector<std::string>> companions = assetCompanions(file);
  if (!companions) return companions.error();
  const fs::path from = file.parent_path();
  for (const std::string& name : *companions) {
    if (!isThere(from / name))
      return makeError(ErrorKind::BadInput, file.string(), {}, "refers to '" + name + "', which is not beside it");
  }
  const bool alone = companions->empty();
  const std::string stem = file.stem().string(), ending = file.extension().string();
  for (int number = 1; number < 1000; ++number) {
    const std::string name = numbered(stem, number);
    const fs::path folder = alone ? fs::path("assets") : fs::path("assets") / name;
    const fs::path target = folder / (alone ? name + ending : stem + ending);
    for (const auto& names : {*companions, std::vector{target.filename().string()}}) {
      if (Status below = staysBelow(projectFolder, projectFolder / folder, names); !below) return below.error();
    }
    if (isThere(projectFolder / target) && !sameFile(file, projectFolder / target)) continue;
    if (!fits(from, projectFolder / folder, *companions)) continue;
    // The file itself last: where it is, all of it is.
    if (Status copied = copyAll(from, projectFolder / folder, *companions); !copied) return copied.error();
    if (!isThere(projectFolder / target)) {
      if (Status copied = copyFile(file, projectFolder / target); !copied) return copied.error();
    }
    return target.generic_string();
  }
  return makeError(ErrorKind::BadInput, file.string(), {}, "can't be copied: too many files have its name in assets/");
}

Status copyAssetsAlong(const std::vector<std::string>& files, const fs::path& fromFolder, const fs::path& toFolder,
                       OutsideFiles outside) {
  std::error_code failed;
  if (fs::equivalent(fromFolder, toFolder, failed)) return Done{};
  std::vector<std::string> names;  // below either folder
  for (const std::string& file : files) {
    if (file.empty() || !outsideReason(file).empty() || !isThere(fromFolder / file)) continue;
    if (!mayRead({fromFolder, outside}, fromFolder / file)) continue;
    const fs::path folder = fs::path(file).parent_path();
    if (const Result<std::vector<std::string>> companions = assetCompanions(fromFolder / file, {fromFolder, outside})) {
      for (const std::string& name : *companions) {
        if (isThere(fromFolder / folder / name)) names.push_back((folder / name).generic_string());
      }
    }
    names.push_back(file);
  }
  for (const std::string& name : names) {
    if (isThere(toFolder / name) && !sameFile(fromFolder / name, toFolder / name)) {
      return makeError(ErrorKind::BadInput, (toFolder / name).string(), {},
                       "is another file than the one that the project uses: save into another folder, or move it away");
    }
  }
  if (Status below = staysBelow(toFolder, toFolder, names); !below) return below;
  return copyAll(fromFolder, toFolder, names);
}

}  // namespace windloom
