#include "engine/bake/publish.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

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

}  // namespace
}  // namespace windloom
