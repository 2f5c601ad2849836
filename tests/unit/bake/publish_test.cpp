#include "engine/bake/publish.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <fstream>
#include <map>
#include <sstream>

#include "engine/bake/manifest.hpp"
#include "engine/io/sha256.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {
namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

void write(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << text;
}

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// A bake of these files, with a manifest that lists them.
void writeBake(const fs::path& folder, const Files& files) {
  std::string list;
  for (const auto& [name, text] : files) {
    write(folder / name, text);
    if (!list.empty()) list += ",";
    list += R"({"path": ")" + name + R"(", "sha256": ")" + sha256OfFile(folder / name).value() + R"("})";
  }
  write(folder / "manifest.json", R"({"format": "windpack", "files": [)" + list + "]}");
}

Files filesIn(const fs::path& folder) {
  Files files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().filename()] = read(entry.path());
  }
  return files;
}

class PublishTest : public testing::Test {
 protected:
  const TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path() / "out";
  const fs::path m_work = m_folder / ".bake.windloom.AbCdEf";  // of a program that was killed
};

TEST_F(PublishTest, TakesBackWhatWasHalfMoved) {
  writeBake(m_folder, {{"a", "old a"}, {"b", "old b"}});
  const Files before = filesIn(m_folder);
  writeBake(m_work, {{"a", "new a"}, {"b", "new b"}});
  fs::create_directories(m_work / "older");
  for (const char* name : {"manifest.json", "a"}) fs::rename(m_folder / name, m_work / "older" / name);
  fs::rename(m_work / "a", m_folder / "a");
  clearLeftBakes(m_folder);
  EXPECT_EQ(filesIn(m_folder), before);
  EXPECT_FALSE(fs::exists(m_work));
}

TEST_F(PublishTest, LeavesAWholeBakeAloneWhenClearingUpWasKilledItself) {
  // The same wind twice: the files taken back and those of the killed bake have the same bytes.
  writeBake(m_folder, {{"a", "same"}, {"b", "same too"}});
  const Files before = filesIn(m_folder);
  writeBake(m_work, {{"a", "same"}, {"b", "same too"}});
  fs::create_directories(m_work / "older");
  fs::remove(m_work / "b");
  clearLeftBakes(m_folder);
  EXPECT_EQ(filesIn(m_folder), before);
  EXPECT_FALSE(fs::exists(m_work));
}

TEST_F(PublishTest, AFirstBakeThatWasKilledLeavesNothing) {
  writeBake(m_work, {{"a", "new a"}, {"b", "new b"}});
  fs::create_directories(m_work / "older");
  fs::rename(m_work / "a", m_folder / "a");
  clearLeftBakes(m_folder);
  EXPECT_TRUE(filesIn(m_folder).empty());
}

/// A folder that came with somebody's archive, and others beside it that are none of a bake's business.
class HostileFolderTest : public PublishTest {
 protected:
  void SetUp() override {
    write(m_elsewhere / "precious", "work of years");
    fs::create_directories(m_folder);
  }
  void TearDown() override { EXPECT_EQ(filesIn(m_elsewhere), (Files{{"precious", "work of years"}})); }

  /// What bake() does to the folder.
  Result<std::uint64_t> bakeInto(const Files& files) {
    clearLeftBakes(m_folder);
    const fs::path work = m_temporary.path() / "work";
    writeBake(work, files);
    Publication publication{m_folder, work, work, {}, 1};
    for (const auto& [name, text] : files) publication.files.push_back(name);
    return publish(publication);
  }

  void writeManifest(const fs::path& folder, const std::string& inside) {
    write(folder / "manifest.json", R"({"format": "windpack", )" + inside + "}");
  }

  const fs::path m_elsewhere = m_temporary.path() / "elsewhere";
};

TEST_F(HostileFolderTest, APlanNamesNoOtherFolder) {
  for (const char* plan : {"x/../../elsewhere", "/../../elsewhere", "../elsewhere", "0123456789ABCDEF", ""}) {
    fs::create_directories(m_folder / ".parts-x");
    writeManifest(m_folder, std::string(R"("files": [], "plan": ")") + plan + "\"");
    clearLeftBakes(m_folder);
    EXPECT_TRUE(fs::exists(m_elsewhere / "precious")) << plan;
  }
}

TEST_F(HostileFolderTest, OlderFilesBehindALinkStayThere) {
  writeManifest(m_work, R"("files": [])");
  fs::create_directory_symlink("../../elsewhere", m_work / "older");
  clearLeftBakes(m_folder);
  EXPECT_TRUE(filesIn(m_folder).empty());
  EXPECT_FALSE(fs::exists(m_work));
}

TEST_F(HostileFolderTest, NothingIsMovedBehindALink) {
  write(m_folder / "planted", "run me");
  const std::string sum = sha256OfFile(m_folder / "planted").value();
  for (const char* plan : {"x/../../elsewhere", "0123456789abcdef"}) {
    writeManifest(m_work, R"("files": [{"path": "planted", "sha256": ")" + sum + R"("}], "plan": ")" + plan + "\"");
    write(m_work / "from-parts", "");
    fs::create_directories(m_work / "older");
    fs::create_directories(m_folder / ".parts-x");
    fs::remove(m_folder / ".parts-0123456789abcdef");
    fs::create_directory_symlink("../elsewhere", m_folder / ".parts-0123456789abcdef");
    clearLeftBakes(m_folder);
    EXPECT_FALSE(fs::exists(m_elsewhere / "planted")) << plan;
  }
}

TEST_F(HostileFolderTest, PipesAndDevicesThatAManifestListsAreNotRead) {
  ASSERT_EQ(::mkfifo((m_folder / "pipe").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", m_folder / "zero");
  fs::create_symlink("../elsewhere/precious", m_folder / "link");
  writeManifest(m_folder, R"("files": [{"path": "pipe", "sha256": "00"}, {"path": "zero", "sha256": "00"},
                             {"path": "link", "sha256": "00"}])");
  ASSERT_TRUE(bakeInto({{"a", "new"}}));
  EXPECT_TRUE(fs::exists(fs::symlink_status(m_folder / "pipe")));
}

TEST_F(HostileFolderTest, ANameThatEndsEarlyDeletesNoNewFile) {
  const std::string sum = sha256("new");
  writeManifest(m_folder, R"("files": [{"path": "a\u0000", "sha256": ")" + sum + R"("}, {"path": "a/", "sha256": ")" +
                              sum + R"("}])");
  ASSERT_TRUE(bakeInto({{"a", "new"}}));
  EXPECT_EQ(read(m_folder / "a"), "new");
}

TEST_F(HostileFolderTest, ManyNamesTakeNoTime) {
  std::string list;
  for (int n = 0; n < 100'000; ++n) list += R"({"path": "a)" + std::to_string(n % 50'000) + R"(", "sha256": "00"},)";
  writeManifest(m_folder, R"("files": [)" + list + "0]");
  EXPECT_EQ(filesOfManifest(m_folder)->size(), 50'000u);
}

TEST_F(PublishTest, KeepsWhatNoBakeMade) {
  writeBake(m_folder, {{"a", "old a"}, {"notes", "old notes"}, {"same", "same"}});
  write(m_folder / "notes", "changed by hand");
  write(m_folder / "wind", "of another program");
  write(m_folder / "wind.bak", "an older one of it");
  const Files fresh = {{"a", "new a"}, {"notes", "new notes"}, {"same", "same"}, {"wind", "new wind"}};
  writeBake(m_work, fresh);
  Publication publication{m_folder, m_work, m_work, {}, 1};
  for (const auto& [name, text] : fresh) publication.files.push_back(name);
  ASSERT_TRUE(publish(publication));
  Files after = filesIn(m_folder);
  after.erase("manifest.json");
  Files expected = fresh;
  expected["notes.bak"] = "changed by hand";
  expected["wind.bak"] = "an older one of it";
  expected["wind.bak2"] = "of another program";
  EXPECT_EQ(after, expected);
}

TEST_F(PublishTest, LeavesNoBackupWhenItFails) {
  writeBake(m_folder, {{"a", "old a"}});
  write(m_folder / "wind", "of another program");
  const Files before = filesIn(m_folder);
  writeBake(m_work, {{"a", "new a"}});
  // The second of the files isn't there to be moved.
  EXPECT_FALSE(publish({m_folder, m_work, m_work, {"a", "wind"}, 1}));
  EXPECT_EQ(filesIn(m_folder), before);
}

}  // namespace
}  // namespace windloom
