#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

namespace windloom {
namespace fs = std::filesystem;

class File : public ::testing::Test {
 protected:
  std::size_t entries() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), {})); }
  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
};

TEST_F(File, WritesAndReadsBack) {
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(writeFileAtomically(m_folder / "x", bytes));
  EXPECT_EQ(readFile(m_folder / "x").value(), bytes);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(File, KeepsOneBackupAndThePermissions) {
  ASSERT_TRUE(writeFileAtomically(m_folder / "x", "one", Backup::KeepOne));
  ::chmod((m_folder / "x").c_str(), 0640);
  ASSERT_TRUE(writeFileAtomically(m_folder / "x", "two", Backup::KeepOne));
  ASSERT_TRUE(writeFileAtomically(m_folder / "x", "three", Backup::KeepOne));
  EXPECT_EQ(readFile(m_folder / "x").value(), "three");
  EXPECT_EQ(readFile(m_folder / "x.bak").value(), "two");
  EXPECT_EQ(entries(), 2u);
  EXPECT_EQ(fs::status(m_folder / "x").permissions(), static_cast<fs::perms>(0640));
}

TEST_F(File, AFailedWriteLeavesNoRest) {
  // A folder in place of the target makes the last step, the rename, fail.
  ASSERT_TRUE(makeFolder(m_folder / "x" / "inside"));
  const Status status = writeFileAtomically(m_folder / "x", "bytes");
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::Machine);
  EXPECT_EQ(entries(), 1u);
}

TEST_F(File, SavingThroughALinkKeepsTheLink) {
  ASSERT_TRUE(writeFileAtomically(m_folder / "real", "old"));
  fs::create_symlink("real", m_folder / "link");
  ASSERT_TRUE(writeFileAtomically(m_folder / "link", "new"));
  EXPECT_TRUE(fs::is_symlink(m_folder / "link"));
  EXPECT_EQ(readFile(m_folder / "real").value(), "new");
}

TEST_F(File, RefusesMissingFilesFoldersAndGiants) {
  EXPECT_EQ(readFile(m_folder / "none").error().kind, ErrorKind::BadInput);
  EXPECT_EQ(readFile(m_folder).error().kind, ErrorKind::BadInput);
  ASSERT_TRUE(writeFileAtomically(m_folder / "x", std::string(100, 'a')));
  EXPECT_NE(readFile(m_folder / "x", 99).error().text().find("limit of 99"), std::string::npos);
}

}  // namespace windloom
