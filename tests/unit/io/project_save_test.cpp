#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <limits>

#include "tests/temporary_folder.hpp"
#include "tests/unit/io/project_fixture.hpp"

namespace windloom {
namespace {

namespace fs = std::filesystem;

class SaveProject : public testing::Test {
 protected:
  void SetUp() override {
    ::umask(022);  // what one test reads as another user
    ::chmod(m_folder.c_str(), 0755);
  }
  void TearDown() override { ::chmod(m_folder.c_str(), 0755); }

  [[nodiscard]] fs::path file() const { return m_folder / "a.wind.json"; }
  [[nodiscard]] std::size_t filesInFolder() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
  }

  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
};

Project named(std::string name) {
  Project project;
  project.name = std::move(name);
  return project;
}

/// Root may write everywhere; another user may not.
class AsOrdinaryUser {
 public:
  AsOrdinaryUser() : m_wasRoot(::geteuid() == 0) {
    EXPECT_EQ(m_wasRoot ? ::seteuid(65534) : 0, 0);
  }
  ~AsOrdinaryUser() {
    EXPECT_EQ(m_wasRoot ? ::seteuid(0) : 0, 0);
  }

 private:
  bool m_wasRoot;
};

/// Files can't grow beyond so many bytes, as on a full disk.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &m_old);
    const rlimit small{bytes, m_old.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    m_handler = std::signal(SIGXFSZ, SIG_IGN);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &m_old);
    std::signal(SIGXFSZ, m_handler);
  }

 private:
  rlimit m_old{};
  void (*m_handler)(int) = nullptr;
};

}  // namespace

TEST_F(SaveProject, WritesWhatLoadReads) {
  ASSERT_TRUE(saveProject(named("one"), file()).ok());
  EXPECT_EQ(loadProject(file())->project.name, "one");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(SaveProject, KeepsOneBackup) {
  for (const char* name : {"one", "two", "three"}) ASSERT_TRUE(saveProject(named(name), file()).ok());
  EXPECT_EQ(loadProject(file())->project.name, "three");
  EXPECT_EQ(loadProject(file().string() + ".bak")->project.name, "two");
  EXPECT_EQ(filesInFolder(), 2u);
}

TEST_F(SaveProject, RefusesWhatIsNotFinite) {
  ASSERT_TRUE(saveProject(named("old"), file()).ok());
  Project project;
  AmbientWind ambient;
  ambient.speed = std::numeric_limits<float>::quiet_NaN();
  project.ambient = std::make_shared<AmbientWind>(ambient);
  const Status saved = saveProject(project, file());
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().kind, ErrorKind::BadInput);
  EXPECT_EQ(saved.error().problems[0].pointer, "/ambient/speed");
  EXPECT_EQ(saved.error().problems[0].file, file().string());
  EXPECT_EQ(loadProject(file())->project.name, "old");
}

TEST_F(SaveProject, AReadOnlyFolderIsAMessageAndTheOldFileStays) {
  ASSERT_TRUE(saveProject(named("old"), file()).ok());
  ASSERT_EQ(::chmod(m_folder.c_str(), 0555), 0);
  const AsOrdinaryUser user;
  const Status saved = saveProject(named("new"), file());
  ASSERT_FALSE(saved.ok());
  EXPECT_EQ(saved.error().kind, ErrorKind::Machine);
  EXPECT_NE(saved.error().text().find(file().string()), std::string::npos);
  EXPECT_EQ(loadProject(file())->project.name, "old");
  EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(SaveProject, AFullDiskIsAMessageAndTheOldFileStays) {
  ASSERT_TRUE(saveProject(named("old"), file()).ok());
  {
    const SmallDisk disk(512);
    const Status saved = saveProject(named("new"), file());
    ASSERT_FALSE(saved.ok());
    EXPECT_EQ(saved.error().kind, ErrorKind::Machine);
  }
  EXPECT_EQ(loadProject(file())->project.name, "old");
  EXPECT_EQ(filesInFolder(), 1u);
}

}  // namespace windloom
