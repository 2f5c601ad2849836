#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
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

TEST_F(File, WaitsForNoPipeAndReadsNoDeviceOrSocket) {
  ASSERT_EQ(::mkfifo((m_folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(readFile(m_folder / "pipe").error().text().find("is a pipe or a device"), std::string::npos);
  EXPECT_NE(readFile("/dev/zero").error().text().find("is a pipe or a device"), std::string::npos);
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, (m_folder / "socket").c_str(), sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_NE(readFile(m_folder / "socket").error().text().find("is a socket"), std::string::npos);
  ::close(listener);
}

TEST_F(File, RefusesASparseGiantBeforeReadingIt) {
  ASSERT_TRUE(writeFileAtomically(m_folder / "x", ""));
  fs::resize_file(m_folder / "x", 1ull << 40);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_NE(readFile(m_folder / "x").error().text().find("limit of 268435456"), std::string::npos);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace windloom
