// Files outside a project's folder: the editor opens the project without them, asks, and remembers only what was
// allowed.

#include <fstream>

#include "editor/core/autosave.hpp"
#include "editor_bench.hpp"
#include "engine/core/file.hpp"
#include "engine/io/image.hpp"
#include "engine/io/project_json.hpp"

namespace windloom::editor {
namespace {

/// A project whose ground lies in a folder beside its own.
struct Borrowed {
  Bench b;
  TempFolder folder;
  std::filesystem::path file = folder / "project" / "a.wind.json";

  Borrowed() {
    EXPECT_TRUE(makeFolder(folder / "project"));
    EXPECT_TRUE(makeFolder(folder / "library"));
    EXPECT_TRUE(writePng(folder / "library" / "hills.png", Image(4, 4, 1)));
    std::ofstream(file) << R"({"format": "windloom-project", "version": 1,
      "terrain": {"kind": "heightmap", "file": "../library/hills.png"}})";
  }
  [[nodiscard]] bool read() const { return b.w.document.project().terrain->heights != nullptr; }
};

}  // namespace

TEST(OutsideFiles, AreAskedForAndLeftOutUntilThen) {
  Borrowed p;
  p.b.w.flow.requestOpen(p.file);
  EXPECT_EQ(p.b.w.flow.prompt(), Prompt::OutsideFiles);
  EXPECT_FALSE(p.read());
  ASSERT_EQ(p.b.w.document.missing().size(), 1u);
  EXPECT_EQ(p.b.w.document.missing()[0].pointer, "/terrain/file");
  p.b.w.flow.answerOutside(false);
  EXPECT_EQ(p.b.w.flow.prompt(), Prompt::None);
  EXPECT_FALSE(p.read());
  EXPECT_TRUE(p.b.w.preferences.outsideAllowed.empty());
  EXPECT_EQ(p.b.w.document.path(), p.file) << "the project is open all the same";
  EXPECT_FALSE(p.b.w.ownFile("../library/hills.png")) << "nor is it read by trying again";
}

TEST(OutsideFiles, AreReadWhenAllowedAndTheFolderIsRemembered) {
  Borrowed p;
  p.b.w.flow.requestOpen(p.file);
  p.b.w.flow.answerOutside(true);
  EXPECT_EQ(p.b.w.flow.prompt(), Prompt::None);
  EXPECT_TRUE(p.read());
  EXPECT_EQ(p.b.w.preferences.outsideAllowed, std::vector<std::string>{(p.folder / "project").string()});
  ASSERT_TRUE(writePreferences(p.folder / "preferences.json", p.b.w.preferences));
  const Preferences again = readPreferences(p.folder / "preferences.json");
  EXPECT_EQ(again.outsideFor(p.file), windloom::OutsideFiles::Allow);
  EXPECT_EQ(again.outsideFor(p.folder / "other" / "a.wind.json"), windloom::OutsideFiles::Refuse);
}

TEST(OutsideFiles, TheFileMenuAllowsThemAndTakesItBack) {
  Borrowed p;
  EXPECT_FALSE(p.b.w.actions.run("file.outside")) << "a project without a file has no folder";
  p.b.w.flow.requestOpen(p.file);
  p.b.w.flow.answerOutside(false);
  ASSERT_TRUE(p.b.w.actions.run("file.outside"));
  EXPECT_TRUE(p.read());
  EXPECT_TRUE(p.b.w.actions.find("file.outside")->checked());
  ASSERT_TRUE(p.b.w.actions.run("file.outside"));
  EXPECT_FALSE(p.read());
  EXPECT_TRUE(p.b.w.preferences.outsideAllowed.empty());
}

TEST(OutsideFiles, TheirNamesAreKeptBySaving) {
  Borrowed p;
  p.b.w.flow.requestOpen(p.file);
  p.b.w.flow.answerOutside(false);
  ASSERT_TRUE(p.b.w.document.save());
  EXPECT_EQ(loadProject(p.file, windloom::OutsideFiles::Allow)->project.terrain->file, "../library/hills.png");
  ASSERT_TRUE(makeFolder(p.folder / "else" / "where"));
  ASSERT_TRUE(p.b.w.document.saveAs(p.folder / "else" / "where" / "b.wind.json"));
  EXPECT_FALSE(std::filesystem::exists(p.folder / "else" / "library")) << "nothing is written outside, either";
}

TEST(OutsideFiles, RescuedWorkIsHeldToTheSame) {
  Borrowed p;
  p.b.w.flow.requestOpen(p.file);
  Autosave autosave(p.folder / "side", "1");
  Edit edit{"Rename", {SetName{"renamed"}}, {}};
  ASSERT_TRUE(p.b.w.document.apply(edit));
  ASSERT_TRUE(autosave.writeNow(p.b.w.document));
  Document rescued;
  ASSERT_TRUE(restoreRescue(rescued, {autosave.sideFile(), p.file, {}}));
  EXPECT_EQ(rescued.project().terrain->heights, nullptr);
  ASSERT_TRUE(restoreRescue(rescued, {autosave.sideFile(), p.file, {}}, windloom::OutsideFiles::Allow));
  EXPECT_NE(rescued.project().terrain->heights, nullptr);
}

TEST(Preferences, TrustTheFolderThatThePathLeadsTo) {
  namespace fs = std::filesystem;
  TempFolder folder;
  ASSERT_TRUE(makeFolder(folder / "trusted"));
  ASSERT_TRUE(makeFolder(folder / "foreign" / "deep"));
  fs::create_directory_symlink(folder / "foreign" / "deep", folder / "trusted" / "link");
  fs::create_directory_symlink(folder / "trusted", folder / "same");
  Preferences preferences;
  preferences.setOutside(folder / "trusted" / "p.wind.json", windloom::OutsideFiles::Allow);
  EXPECT_EQ(preferences.outsideFor(folder / "trusted" / "link" / ".." / "p.wind.json"), windloom::OutsideFiles::Refuse)
      << "that file lies in foreign";
  EXPECT_EQ(preferences.outsideFor(folder / "trusted" / "link" / "p.wind.json"), windloom::OutsideFiles::Refuse);
  EXPECT_EQ(preferences.outsideFor(folder / "same" / "p.wind.json"), windloom::OutsideFiles::Allow);
  preferences.setOutside(folder / "same" / "p.wind.json", windloom::OutsideFiles::Refuse);
  EXPECT_TRUE(preferences.outsideAllowed.empty());
}

TEST(Preferences, ForgetTheOldestOfTooManyTrustedFolders) {
  Preferences preferences;
  for (std::size_t n = 0; n < kMaxTrusted + 5; ++n)
    preferences.setOutside("/p" + std::to_string(n) + "/a.wind.json", windloom::OutsideFiles::Allow);
  EXPECT_EQ(preferences.outsideAllowed.size(), kMaxTrusted);
  EXPECT_EQ(preferences.outsideFor("/p0/a.wind.json"), windloom::OutsideFiles::Refuse);
  EXPECT_EQ(preferences.outsideFor("/p9/b.wind.json"), windloom::OutsideFiles::Allow);
}

TEST(Preferences, AndKeymapAndRescueAreRefusedWhereTheyNestTooDeep) {
  TempFolder folder;
  const std::string deep = R"({"theme": "light", "later": )" + std::string(1'000'000, '[');
  std::ofstream(folder / "preferences.json") << deep;
  std::vector<std::string> warnings;
  EXPECT_EQ(readPreferences(folder / "preferences.json", &warnings).theme, Theme::Dark);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("nested deeper than 64 levels"), std::string::npos) << warnings[0];
  ActionTable actions;
  EXPECT_FALSE(actions.applyKeymap(deep));
  std::ofstream(folder / "a.rescue.json") << deep;
  EXPECT_TRUE(findRescues(folder.path()).empty());
}

TEST(Preferences, LimitsOfTheEditorsFilesAreAsDocumented) {
  const std::string page = readFile(WINDLOOM_DOCS "/limits.md").value();
  const auto row = [](const char* what, std::uint64_t value, const char* unit) {
    return std::string("| ") + what + " | " + std::to_string(value) + unit + " |";
  };
  for (const std::string& expected :
       {row("size of the preferences", kMaxPreferencesBytes >> 20, " MiB"), row("recent files", kMaxRecent, ""),
        row("folders whose projects may read files elsewhere", kMaxTrusted, ""),
        row("size of a rescue file", kMaxRescueBytes >> 20, " MiB")})
    EXPECT_NE(page.find(expected), std::string::npos) << expected;
}

}  // namespace windloom::editor
