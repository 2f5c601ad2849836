#include "engine/core/atomic_file.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

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

}  // namespace windloom
