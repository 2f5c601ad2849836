#include "engine/core/atomic_file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace {
bool linksFail = false;
}

/// In place of the C library's: as on a file system without links, where a test wants that.
extern "C" int link(const char* from, const char* to) noexcept {
  if (!linksFail) return ::linkat(AT_FDCWD, from, AT_FDCWD, to, 0);
  errno = EPERM;
  return -1;
}

namespace windloom {

TEST(AtomicFile, OverwritesWhatWasWrittenAndGoesOnAtTheEnd) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "file";
  AtomicFile file = std::move(AtomicFile::create(path).value());
  ASSERT_TRUE(file.write("0123456789"));
  ASSERT_TRUE(file.overwrite(2, "ab"));
  ASSERT_TRUE(file.write("!"));
  EXPECT_FALSE(std::filesystem::exists(path));
  ASSERT_TRUE(file.finish(Sync::Later));
  EXPECT_EQ(readFile(path).value(), "01ab456789!");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, LeavesNothingWithoutFinish) {
  const TemporaryFolder folder;
  {
    AtomicFile file = std::move(AtomicFile::create(folder.path() / "file").value());
    ASSERT_TRUE(file.write("half"));
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(AtomicFile, WritesAWholeFileInOneCall) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileUnsynced(folder.path() / "a", "all of it"));
  EXPECT_EQ(readFile(folder.path() / "a").value(), "all of it");
  const Status failed = writeFileUnsynced(folder.path() / "missing" / "a", "x");
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().kind, ErrorKind::Machine);
}

TEST(AtomicFile, TheNextWriteClearsWhatAKilledOneLeftAndNothingElse) {
  const TemporaryFolder folder;
  const auto make = [&](const std::string& name) {
    std::ofstream(folder.path() / name) << "x";
    return folder.path() / name;
  };
  const auto left = make(".mine.abc123.windloom"), backup = make(".mine.bak.Abc12Z.windloom");
  const auto held = make(".mine.held00.windloom"), other = make(".yours.abc123.windloom");
  const auto users = {make("mine.abc123"), make(".mine.abc12.windloom"), make(".mine.abc12-.windloom"),
                      make(".mine.abc123.windloom.txt"), make("mine.abc123.windloom")};
  const int lock = ::open(held.c_str(), O_RDONLY | O_CLOEXEC);
  ASSERT_EQ(::flock(lock, LOCK_EX), 0);
  ASSERT_TRUE(writeFileAtomically(folder.path() / "mine", "bytes", Backup::KeepOne));
  using std::filesystem::exists;
  EXPECT_FALSE(exists(left));
  EXPECT_FALSE(exists(backup));
  EXPECT_TRUE(exists(held)) << "its writer is at work";
  EXPECT_TRUE(exists(other));
  for (const auto& file : users) EXPECT_TRUE(exists(file)) << file;
  ::close(lock);
  clearLeftTemporaries(folder.path());
  EXPECT_FALSE(exists(held));
  EXPECT_FALSE(exists(other));
  for (const auto& file : users) EXPECT_TRUE(exists(file)) << file;
}

TEST(AtomicFile, RefusesToReplaceWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const Status status = writeFileAtomically(pipe, "bytes");
  ASSERT_FALSE(status);
  EXPECT_NE(status.error().text().find("no regular file"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, TakesTheLongestNamesThatThereAre) {
  const TemporaryFolder folder;
  const auto path = folder.path() / std::string(255, 'n');
  ASSERT_TRUE(writeFileAtomically(path, "old"));
  ASSERT_TRUE(writeFileAtomically(path, "new", Backup::KeepOne)) << "though no backup can have a name";
  EXPECT_EQ(readFile(path).value(), "new");
  EXPECT_EQ(folder.entries(), 1);
}

TEST(AtomicFile, BackupIsNotWrittenThroughALinkWhereItHasToBeCopied) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const auto path = folder.path() / "mine", backup = folder.path() / "mine.bak", victim = folder.path() / "victim";
  ASSERT_TRUE(writeFileAtomically(path, "old", Backup::None, 0640));
  ASSERT_TRUE(writeFileAtomically(victim, "precious"));
  fs::create_symlink(victim, backup);
  linksFail = true;
  const Status written = writeFileAtomically(path, "new", Backup::KeepOne);
  linksFail = false;
  ASSERT_TRUE(written);
  EXPECT_EQ(readFile(path).value(), "new");
  EXPECT_EQ(readFile(victim).value(), "precious");
  EXPECT_FALSE(fs::is_symlink(backup));
  EXPECT_EQ(readFile(backup).value(), "old");
  EXPECT_EQ(fs::status(backup).permissions(), static_cast<fs::perms>(0640));
  EXPECT_EQ(folder.entries(), 3);
}

TEST(AtomicFile, HasTheAccessRightsThatWereAskedForFromTheStart) {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const auto path = folder.path() / "mine";
  ASSERT_TRUE(writeFileAtomically(path, "for all"));
  ::chmod(path.c_str(), 0644);
  ASSERT_TRUE(writeFileAtomically(path, "for me", Backup::None, kOwnersFile));
  EXPECT_EQ(fs::status(path).permissions(), static_cast<fs::perms>(0600)) << "an older file's rights don't count";
  const mode_t before = ::umask(0);
  const Status made = makeFolder(folder.path() / "a" / "b", kOwnersFolder);
  ::umask(before);
  ASSERT_TRUE(made);
  for (const char* name : {"a", "a/b"})
    EXPECT_EQ(fs::status(folder.path() / name).permissions(), static_cast<fs::perms>(0700)) << name;
  EXPECT_TRUE(makeFolder(folder.path() / "a" / "c" / "")) << "a name that ends with a slash";
  EXPECT_FALSE(makeFolder(path / "below a file"));
  EXPECT_FALSE(makeFolder(path));
  EXPECT_FALSE(makeFolder(""));
}

}  // namespace windloom
