#include "engine/bake/publish.hpp"

#include <algorithm>
#include <system_error>
#include <unordered_map>
#include <unordered_set>

#include "engine/bake/bake_parts.hpp"
#include "engine/bake/manifest.hpp"
#include "engine/bake/work_folder.hpp"
#include "engine/core/atomic_file.hpp"
#include "engine/core/log.hpp"
#include "engine/io/sha256.hpp"

namespace windloom {
namespace fs = std::filesystem;
namespace {

constexpr const char* kManifest = "manifest.json";
constexpr const char* kFromParts = "from-parts";  // tells that the frames come from the folder of the parts

/// Where files of the older bake wait.
fs::path olderIn(const fs::path& work) {
  return work / "older";
}

Status move(const fs::path& from, const fs::path& to, const fs::path& about) {
  std::error_code ec;
  fs::rename(from, to, ec);
  if (!ec) return Done{};
  return makeError(ErrorKind::Machine, about.string(), {}, "can't write: " + ec.message());
}

Status moveAside(const fs::path& folder, const fs::path& work, const std::string& name) {
  std::error_code ec;
  if (!fs::exists(fs::symlink_status(folder / name, ec))) return Done{};
  return move(folder / name, olderIn(work) / name, folder / name);
}

/// Whether it is there as a bake left it. Fails where that can't be read.
Result<bool> hasSum(const fs::path& file, const std::string& sum) {
  std::error_code ec;
  if (!fs::is_regular_file(fs::symlink_status(file, ec))) return false;
  const Result<std::string> found = sha256OfFile(file);
  if (!found) return found.error();
  return *found == sum;
}

/// Second names ("NAME.bak") of files that no bake made, or that were changed since; they go again unless kept.
class Backups {
 public:
  Backups() = default;
  ~Backups() {
    std::error_code ignored;
    for (const fs::path& path : m_made) fs::remove(path, ignored);
  }
  Backups(const Backups&) = delete;
  Backups& operator=(const Backups&) = delete;

  Status add(const fs::path& file) {
    std::error_code ec;
    for (int number = 1;; ++number) {
      const fs::path backup = file.string() + ".bak" + (number > 1 ? std::to_string(number) : "");
      fs::create_hard_link(file, backup, ec);
      if (ec == std::errc::file_exists) {
        // Left by a bake that was killed.
        if (fs::equivalent(file, backup, ec)) return Done{};
        continue;
      }
      // Not every file system has links.
      if (ec) fs::copy(file, backup, fs::copy_options::copy_symlinks, ec);
      if (ec == std::errc::file_exists) continue;
      if (ec) return makeError(ErrorKind::Machine, file.string(), {}, "can't be kept as .bak: " + ec.message());
      m_made.push_back(backup);
      return Done{};
    }
  }

  void keep() {
    for (const fs::path& path : m_made)
      logWarning(path.string() + " keeps what lay in the place of a new file: no bake made it so");
    m_made.clear();
  }

 private:
  std::vector<fs::path> m_made;
};

/// What becomes of files that are in the folder, decided before anything is moved.
struct Decision {
  Backups backups;
  std::vector<std::string> gone;  ///< of the older bake, and not of the new one
};

Status decide(const Publication& p, const std::vector<ListedFile>& older, Decision& decision) {
  std::unordered_map<std::string_view, std::string_view> sums;
  for (const ListedFile& file : older) sums.emplace(file.path, file.sha256);
  for (std::size_t i = 0; i < p.files.size(); ++i) {
    const fs::path file = p.folder / p.files[i];
    std::error_code ec;
    if (!fs::exists(fs::symlink_status(file, ec))) continue;
    const auto listed = sums.find(p.files[i]);
    if (listed != sums.end()) {
      // Nobody edits frames, and to read them all would take its time.
      const Result<bool> same = i < p.frameFiles ? true : hasSum(file, std::string(listed->second));
      if (!same) return same.error();
      if (*same) continue;
    }
    if (Status kept = decision.backups.add(file); !kept) return kept;
  }
  const std::unordered_set<std::string_view> fresh(p.files.begin(), p.files.end());
  for (const ListedFile& file : older) {
    if (fresh.contains(file.path)) continue;
    // What was changed since is somebody's work.
    const Result<bool> same = hasSum(p.folder / file.path, file.sha256);
    if (!same) return same.error();
    if (*same) decision.gone.push_back(file.path);
  }
  return Done{};
}

/// Everything but the new manifest's own move.
Status moveFiles(const Publication& p, const std::vector<std::string>& gone) {
  if (Status made = makeFolder(olderIn(p.work)); !made) return made;
  if (p.frames != p.work) {
    if (Status noted = writeFileUnsynced(p.work / kFromParts, {}); !noted) return noted;
  }
  if (Status moved = moveAside(p.folder, p.work, kManifest); !moved) return moved;
  // From here on it is no bake, after a loss of power as well.
  for (const fs::path& place : {olderIn(p.work), p.folder}) {
    if (Status synced = syncFolder(place); !synced) return synced;
  }
  for (std::size_t i = 0; i < p.files.size(); ++i) {
    const std::string& name = p.files[i];
    if (Status moved = moveAside(p.folder, p.work, name); !moved) return moved;
    const fs::path& from = i < p.frameFiles ? p.frames : p.work;
    if (Status moved = move(from / name, p.folder / name, p.folder / name); !moved) return moved;
  }
  for (const std::string& name : gone) {
    if (Status moved = moveAside(p.folder, p.work, name); !moved) return moved;
  }
  return syncFolder(p.folder);
}

/// Undoes what moveFiles() did so far. It looks at what lies where, so that it serves after a kill as well, and after
/// one of its own. The folder may have come from anywhere: what leads out of it is left alone.
void takeBack(const fs::path& folder, const fs::path& work) {
  std::error_code ec;
  const fs::path older = olderIn(work);
  // A whole bake stands there: nothing was moved, or all was taken back already, by one that was killed before it could
  // clear up all of `work`.
  if (fs::exists(folder / kManifest, ec)) return;
  // Without its manifest it was published; without a place for older files nothing was moved.
  if (!fs::exists(work / kManifest, ec) || !isRealFolder(older)) return;
  const Result<std::vector<ListedFile>> files = filesOfManifest(work);
  if (!files) return;
  const fs::path frames = fs::exists(work / kFromParts, ec) ? partsFolder(folder, planOfManifest(work)) : work;
  for (const ListedFile& file : *files) {
    if (!isRealFolder(frames)) break;
    if (fs::exists(work / file.path, ec) || fs::exists(frames / file.path, ec)) continue;
    const Result<bool> moved = hasSum(folder / file.path, file.sha256);
    if (moved && *moved) fs::rename(folder / file.path, frames / file.path, ec);
  }
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(older, ec)) names.push_back(entry.path().filename());
  // The manifest comes last here, too.
  std::ranges::stable_partition(names, [](const fs::path& name) { return name != kManifest; });
  for (const fs::path& name : names) {
    fs::rename(older / name, folder / name, ec);
    if (ec) return;  // no manifest over what isn't whole
  }
}

}  // namespace

Result<std::uint64_t> publish(const Publication& p) {
  const Result<std::vector<ListedFile>> older = filesOfManifest(p.folder);
  if (!older) return older.error();
  std::error_code ec;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < p.files.size(); ++i) {
    const fs::path target = p.folder / p.files[i];
    if (fs::is_directory(target, ec))
      return makeError(ErrorKind::Machine, target.string(), {}, "can't write: a folder is in the way");
    bytes += fs::file_size((i < p.frameFiles ? p.frames : p.work) / p.files[i], ec);
  }
  bytes += fs::file_size(p.work / kManifest, ec);
  Decision decision;
  if (Status decided = decide(p, *older, decision); !decided) return decided.error();
  Status done = moveFiles(p, decision.gone);
  if (done) done = move(p.work / kManifest, p.folder / kManifest, p.folder / kManifest);
  if (!done) {
    takeBack(p.folder, p.work);
    return done.error();
  }
  decision.backups.keep();
  if (const Status synced = syncFolder(p.folder); !synced) logWarning(synced.error().text());
  return bytes;
}

void clearLeftBakes(const fs::path& folder) {
  const Result<FolderLock> lock = FolderLock::take(folder, [] { return false; });
  if (!lock || !lock->held()) return;
  for (const WorkFolder& left : leftWorkFolders(folder)) {
    takeBack(folder, left.path());
    logInfo(folder.string() + ": cleared up after a bake that was killed");
  }
  const std::string plan = planOfManifest(folder);
  std::error_code ignored;
  if (!plan.empty()) fs::remove_all(partsFolder(folder, plan), ignored);
}

}  // namespace windloom
