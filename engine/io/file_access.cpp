#include "engine/io/file_access.hpp"

#include <algorithm>
#include <system_error>

#include "engine/model/asset_names.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

constexpr const char* kHowToAllow = "files outside the project's folder are read only where you allow it";

}  // namespace

FileAccess accessOf(const fs::path& projectFile, OutsideFiles outside) {
  const fs::path folder = projectFile.parent_path();
  return {folder.empty() ? fs::path(".") : folder, outside};
}

bool liesBelow(const fs::path& path, const fs::path& folder) {
  std::error_code failed;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, failed), failed);
  if (failed) return false;
  const fs::path top = fs::weakly_canonical(fs::absolute(folder, failed), failed);
  if (failed) return false;
  const fs::path relative = whole.lexically_relative(top);
  return !relative.empty() && *relative.begin() != "..";
}

bool mayRead(const FileAccess& access, const fs::path& path) {
  return access.outside == OutsideFiles::Allow || liesBelow(path, access.folder);
}

Result<fs::path> findAsset(const fs::path& projectFile, const std::string& name, OutsideFiles outside) {
  const fs::path path = projectFile.parent_path() / fs::path(name);
  if (outside == OutsideFiles::Allow) return path;
  const auto refuse = [&](const std::string& why) {
    return makeError(ErrorKind::BadInput, "found '" + name + "', " + why + ": " + kHowToAllow);
  };
  if (const std::string_view reason = outsideReason(name); !reason.empty()) return refuse(std::string(reason));
  if (!mayRead(accessOf(projectFile, outside), path)) return refuse("a link that leads out of the project's folder");
  return path;
}

bool namesFilesOutside(const Project& project, const fs::path& projectFile) {
  return std::ranges::any_of(assetNames(project), [&](const AssetName& name) {
    return !findAsset(projectFile, name.file, OutsideFiles::Refuse).ok();
  });
}

}  // namespace windloom
