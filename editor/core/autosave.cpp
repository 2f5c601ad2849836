#include "editor/core/autosave.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <new>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/core/atomic_file.hpp"
#include "engine/core/file.hpp"
#include "engine/core/log.hpp"
#include "engine/core/out_of_memory.hpp"
#include "engine/io/assets.hpp"
#include "engine/io/json_document.hpp"
#include "engine/io/project_json.hpp"
#include "engine/io/terrain_file.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kFormat = "windloom-rescue";
constexpr std::string_view kSuffix = ".rescue.json";

fs::path lockOf(const fs::path& sideFile) {
  return sideFile.string() + ".lock";
}

/// The file locked for this process, or -1 where another one has it.
int lockFile(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, kOwnersFile);
  if (descriptor < 0) return -1;
  struct stat found {};
  // Another editor may have met it before it was locked, and cleared it away.
  if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &found) == 0 && found.st_nlink > 0)
    return descriptor;
  ::close(descriptor);
  return -1;
}

/// Locks that killed editors left without a side file: nothing is to be rescued there.
void clearLeftLocks(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const fs::path path = it->path();
    const std::string lockSuffix = std::string(kSuffix) + ".lock";
    std::error_code ignored;
    if (!path.string().ends_with(lockSuffix)) continue;
    const int descriptor = ::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
    if (descriptor < 0) continue;
    const fs::path sideFile = fs::path(path).replace_extension();
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && !fs::exists(sideFile, ignored)) ::unlink(path.c_str());
    ::close(descriptor);
  }
}

bool ownerRuns(const fs::path& sideFile) {
  const int descriptor = ::open(lockOf(sideFile).c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  ::close(descriptor);
  return locked;
}

std::string localTime() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  if (!::localtime_r(&now, &parts)) return {};
  char text[32];
  return std::string(text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts));
}

struct SideFile {
  Rescue rescue;
  std::string project;
};

std::optional<std::string> textIn(const JsonDocument& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_string()) return std::nullopt;
  return found->get_ref<const std::string&>();
}

Result<SideFile> readSideFile(const fs::path& path) {
  const Result<std::string> bytes = readFile(path, kMaxRescueBytes);
  if (!bytes) return bytes.error();
  const Result<JsonDocument> parsed = parseJsonDocument(*bytes, path.string());
  const JsonDocument json = parsed ? *parsed : JsonDocument();
  const Error broken = makeError(ErrorKind::BadInput, path.string(), {}, "is not a rescue file");
  if (!json.is_object() || textIn(json, "format") != kFormat) return broken;
  const auto original = textIn(json, "original"), savedAt = textIn(json, "savedAt"), project = textIn(json, "project");
  if (!original || !savedAt || !project) return broken;
  return SideFile{{path, *original, *savedAt}, *project};
}

}  // namespace

Autosave::Autosave(fs::path folder, std::string session) : m_folder(std::move(folder)), m_session(std::move(session)) {
  keepReserve();
  claimFile();
  clearLeftTemporaries(m_folder);
  clearLeftLocks(m_folder);
}

/// A name of its own. Without one (the disk is full or away) the next write tries again.
void Autosave::claimFile() {
  std::error_code ignored;
  if (m_folder.empty() || !makeFolder(m_folder, kOwnersFolder)) return;
  for (int number = 1; number < 100; ++number) {
    std::string name = m_session;
    if (number > 1) name.append(1, '-').append(std::to_string(number));
    const fs::path file = m_folder / name.append(kSuffix);
    if (fs::exists(file, ignored)) continue;
    m_lock = lockFile(lockOf(file));
    if (m_lock < 0) continue;
    m_file = file;
    m_lockFile = lockOf(file);
    return;
  }
}

Autosave::~Autosave() {
  static_cast<void>(wait());
  if (m_lock >= 0) ::close(m_lock);
}

Status Autosave::tick(const Document& document, double nowSeconds) {
  Status status = Done{};
  if (m_folder.empty()) return status;
  if (m_writing.done.valid()) {
    if (!document.dirty()) {
      m_writing.stale = true;
      m_writtenEdits = document.editCount();
    }
    if (m_writing.done.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return status;
    status = take();
  }
  if (!document.dirty() || !m_writtenEdits) {
    m_writtenEdits = document.editCount();
    m_firstEditAt.reset();
  }
  if (!document.dirty()) {
    removeFile();
    dropRescued(document.rescuedFrom());
    return status;
  }
  const std::uint64_t edits = document.editCount() - *m_writtenEdits;
  if (edits > 0 && !m_firstEditAt) m_firstEditAt = nowSeconds;
  const bool rescuedNow = document.rescuedFrom() != m_seenRescue && !document.rescuedFrom().empty();
  m_seenRescue = document.rescuedFrom();
  const bool late = m_firstEditAt && nowSeconds - *m_firstEditAt >= kAutosaveSeconds;
  if (!rescuedNow && !late && edits < kAutosaveEdits) return status;
  m_writtenEdits = document.editCount();
  m_firstEditAt.reset();
  begin(document);
  return status;
}

namespace {

/// The worker: a project is a value, so edits meanwhile don't reach it.
Status writeSideFile(const fs::path& file, const Project& project, const std::string& original) {
  return orOutOfMemory("the autosave", [&]() -> Status {
    nlohmann::ordered_json json;
    json["format"] = kFormat;
    json["original"] = original;
    json["savedAt"] = localTime();
    json["project"] = writeProject(project);
    const std::string text = json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    // The project may be one that only its owner may read.
    return writeFileAtomically(file, text, Backup::None, kOwnersFile);
  });
}

std::string originalOf(const Document& document) {
  std::error_code ignored;
  return document.path().empty() ? std::string() : fs::absolute(document.path(), ignored).string();
}

Error noFolder(const fs::path& folder) {
  if (folder.empty()) return makeError(ErrorKind::Machine, "can't autosave: there is no home folder");
  return makeError(ErrorKind::Machine, folder.string(), {}, "can't autosave: no file can be made in this folder");
}

// Large projects have a few MB of text, which is held about three times over while it is written.
constexpr std::size_t kReserveBytes = 16u << 20;

}  // namespace

void Autosave::begin(const Document& document) {
  m_writing.rescuedFrom = document.rescuedFrom();
  m_writing.stale = false;
  if (m_file.empty()) claimFile();
  try {
    if (!m_file.empty()) {
      m_writing.done =
          std::async(std::launch::async, writeSideFile, m_file, document.committed(), originalOf(document));
      return;
    }
  } catch (const std::system_error&) {  // no thread can be had: written here then
  }
  std::promise<Status> ended;
  ended.set_value(m_file.empty() ? noFolder(m_folder)
                                 : writeSideFile(m_file, document.committed(), originalOf(document)));
  m_writing.done = ended.get_future();
}

/// Touched by nobody, it costs no memory until the system has to promise some.
void Autosave::keepReserve() {
  if (!m_reserve) m_reserve.reset(new (std::nothrow) char[kReserveBytes]);
  if (m_lastWord.problems.empty()) m_lastWord = outOfMemory("the autosave");
}

Status Autosave::writeNow(const Document& document) noexcept {
  m_reserve.reset();
  try {
    const Status status = orOutOfMemory("the autosave", [&] { return writeHere(document); });
    keepReserve();
    return status;
  } catch (...) {
    return std::move(m_lastWord);  // nothing at all can be had, not even a message
  }
}

Status Autosave::writeHere(const Document& document) {
  static_cast<void>(wait());  // what it has to tell is older than this
  if (!document.dirty()) return Done{};
  if (m_file.empty()) claimFile();
  if (m_file.empty()) return noFolder(m_folder);
  const Status status = writeSideFile(m_file, document.committed(), originalOf(document));
  if (!status) return status;
  m_exists = true;
  m_writtenEdits = document.editCount();
  m_firstEditAt.reset();
  m_seenRescue = document.rescuedFrom();
  dropRescued(document.rescuedFrom());
  return status;
}

/// What a write that ended has to tell.
Status Autosave::take() {
  Status status = m_writing.done.get();
  m_exists = m_exists || status.ok();
  if (status) dropRescued(m_writing.rescuedFrom);
  if (m_writing.stale) removeFile();
  return status;
}

Status Autosave::wait() {
  return m_writing.done.valid() ? take() : Done{};
}

void Autosave::removeFile() {
  std::error_code ignored;
  if (m_exists) fs::remove(m_file, ignored);
  m_exists = false;
}

/// The work is in a file of this session now, or in the user's own.
void Autosave::dropRescued(const fs::path& rescued) {
  if (!rescued.empty() && rescued != m_dropped) discardRescue({rescued, {}, {}});
  m_dropped = rescued;
}

void Autosave::finish() {
  static_cast<void>(wait());
  std::error_code ignored;
  if (m_file.empty()) return;
  removeFile();
  fs::remove(m_lockFile, ignored);
}

std::vector<Rescue> findRescues(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, Rescue>> found;
  std::error_code failed;
  for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed)) {
    const fs::path path = it->path();
    if (!path.string().ends_with(kSuffix) || ownerRuns(path)) continue;
    Result<SideFile> file = readSideFile(path);
    std::error_code ignored;
    if (file) found.emplace_back(fs::last_write_time(path, ignored), std::move(file->rescue));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<Rescue> rescues;
  for (auto& [time, rescue] : found) rescues.push_back(std::move(rescue));
  return rescues;
}

Status restoreRescue(Document& document, const Rescue& rescue, OutsideFiles outside) {
  const Result<SideFile> file = readSideFile(rescue.sideFile);
  if (!file) return file.error();
  Result<LoadedProject> loaded = parseProject(file->project, rescue.sideFile.string());
  if (!loaded) return loaded.error();
  if (!rescue.original.empty()) {
    if (const Status terrain = loadTerrain(loaded->project, rescue.original, outside); !terrain)
      logWarning(terrain.error().text());
    if (const Status assets = loadAssets(loaded->project, rescue.original, outside); !assets)
      logWarning(assets.error().text());
  }
  document.recover(std::move(loaded->project), rescue.original, rescue.sideFile, outside);
  return Done{};
}

void discardRescue(const Rescue& rescue) {
  std::error_code ignored;
  fs::remove(rescue.sideFile, ignored);
  fs::remove(lockOf(rescue.sideFile), ignored);
}

std::vector<std::string> describeRescue(const Rescue& rescue) {
  const Result<SideFile> file = readSideFile(rescue.sideFile);
  if (!file) return {file.error().text()};
  const Result<LoadedProject> rescued = parseProject(file->project, rescue.sideFile.string());
  if (!rescued) return {rescued.error().text()};
  if (rescue.original.empty()) return describeChanges(Project{}, rescued->project);
  const Result<LoadedProject> original = loadProject(rescue.original);
  if (!original) return {original.error().text()};
  return describeChanges(original->project, rescued->project);
}

}  // namespace windloom::editor
