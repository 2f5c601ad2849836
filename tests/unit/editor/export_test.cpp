#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "editor/core/export_choices.hpp"
#include "editor/core/folder_opener.hpp"
#include "editor/core/repeat_after_edit.hpp"
#include "editor/core/size_text.hpp"
#include "editor/core/speed_histogram.hpp"
#include "editor_bench.hpp"

namespace windloom::editor {

TEST(SizeText, HasThreeDigitsAndTheUnitOfDisks) {
  EXPECT_EQ(bytesText(0), "0 bytes");
  EXPECT_EQ(bytesText(999), "999 bytes");
  EXPECT_EQ(bytesText(1000), "1.0 kB");
  EXPECT_EQ(bytesText(16'777'216), "16.8 MB");
  EXPECT_EQ(bytesText(99'960'000), "100 MB");
  EXPECT_EQ(bytesText(999'600'000), "1.0 GB");
  EXPECT_EQ(bytesText(5e15), "5000 TB");
  EXPECT_EQ(bytesText(-3), "0 bytes");
}

TEST(SizeText, TellsTimesRoundedUp) {
  EXPECT_EQ(durationText(0.2), "1 s");
  EXPECT_EQ(durationText(89), "89 s");
  EXPECT_EQ(durationText(90), "2 min");
  EXPECT_EQ(durationText(7210), "2 h 1 min");
  EXPECT_EQ(durationText(-1), "0 s");
}

TEST(ExportChoices, ComeBackFromThePreferencesFile) {
  TempFolder folder;
  ExportChoices chosen;
  chosen.preset = "unreal";
  chosen.formats = {"exr", "fga"};
  chosen.from = 1.5;
  chosen.ownWarmUp = true;
  chosen.warmUp = 0.5;
  chosen.fps = 30;
  chosen.loop = false;
  chosen.ownResolution = false;
  chosen.resolution = {128, 64};
  chosen.uvFlow = true;
  chosen.ownFullScale = true;
  chosen.fullScale = 20;
  chosen.layers = 16;
  chosen.roughness = 0.1;
  chosen.response = chosen.graph = true;
  chosen.sidecars = false;
  chosen.again = true;
  Preferences preferences;
  keepExportChoices(preferences, chosen);
  ASSERT_TRUE(writePreferences(folder / "p.json", preferences));
  std::vector<std::string> warnings;
  EXPECT_EQ(exportChoices(readPreferences(folder / "p.json", &warnings)), chosen);
  EXPECT_TRUE(warnings.empty());
}

TEST(ExportChoices, NoFormatsStayNoFormats) {
  Preferences preferences;
  ExportChoices none;
  none.formats.clear();
  keepExportChoices(preferences, none);
  EXPECT_TRUE(exportChoices(preferences).formats.empty());
  EXPECT_FALSE(exportChoices(Preferences{}).formats.empty());
}

TEST(ExportChoices, ValuesOutOfRangeAreLeftOut) {
  TempFolder folder;
  std::ofstream(folder / "p.json") << R"({"numbers": {"export.fps": 1e9, "export.width": -4, "export.seconds": 7},
    "texts": {"export.preset": 3, "export.formats": ",png,,fga"}})";
  std::vector<std::string> warnings;
  const ExportChoices read = exportChoices(readPreferences(folder / "p.json", &warnings));
  EXPECT_EQ(warnings.size(), 1u);  // the preset
  EXPECT_EQ(read.fps, ExportChoices{}.fps);
  EXPECT_EQ(read.resolution, ExportChoices{}.resolution);
  EXPECT_EQ(read.seconds, 7);
  EXPECT_EQ(read.preset, ExportChoices{}.preset);
  EXPECT_EQ(read.formats, (std::set<std::string, std::less<>>{"fga", "png"}));
}

TEST(ExportChoices, AFolderBelongsToItsProject) {
  Preferences preferences;
  preferences.usedFile("/a.wind.json");
  preferences.usedFile("/b.wind.json");
  keepExportFolder(preferences, "/a.wind.json", "/out/a");
  keepExportFolder(preferences, "/b.wind.json", "/out/b");
  EXPECT_EQ(exportFolder(preferences, "/a.wind.json"), "/out/a");
  EXPECT_EQ(exportFolder(preferences, "/c.wind.json"), "");
  preferences.forgetFile("/a.wind.json");
  keepExportFolder(preferences, "/b.wind.json", "");
  EXPECT_EQ(exportFolder(preferences, "/a.wind.json"), "") << "of a file that is not recent any more";
  EXPECT_EQ(exportFolder(preferences, "/b.wind.json"), "");
  EXPECT_TRUE(preferences.texts.empty());
}

TEST(SpeedHistogram, CountsWhatIsFasterThanTheFullScale) {
  std::vector<glm::vec2> cells(100, glm::vec2(3, 4));  // 5 m/s
  for (int i = 0; i < 10; ++i) cells[static_cast<std::size_t>(i)] = {0, -12};
  const SpeedHistogram histogram = speedHistogram(cells, 8);
  EXPECT_FLOAT_EQ(histogram.fastest, 12);
  EXPECT_FLOAT_EQ(histogram.top, 12);
  EXPECT_FLOAT_EQ(histogram.clipped, 0.1f);
  EXPECT_FLOAT_EQ(histogram.parts[10], 0.9f);  // 5 of 12 m/s in 24 bins
  EXPECT_FLOAT_EQ(histogram.parts[SpeedHistogram::kBins - 1], 0.1f);
}

TEST(SpeedHistogram, ReachesToTheFullScaleAndTakesStillOrNoAir) {
  const std::vector<glm::vec2> slow(9, glm::vec2(1, 0));
  const SpeedHistogram histogram = speedHistogram(slow, 24);
  EXPECT_FLOAT_EQ(histogram.top, 24);
  EXPECT_FLOAT_EQ(histogram.clipped, 0);
  EXPECT_FLOAT_EQ(histogram.parts[1], 1);
  EXPECT_FLOAT_EQ(speedHistogram(std::vector<glm::vec2>(4, glm::vec2(0)), 2).parts[0], 1);
  EXPECT_FLOAT_EQ(speedHistogram({}, 2).clipped, 0);
}

TEST(SpeedHistogram, SamplesHugeFieldsEvenly) {
  std::vector<glm::vec2> cells(3'000'000, glm::vec2(1, 0));
  for (std::size_t i = 0; i < cells.size() / 4; ++i) cells[i] = {9, 0};
  EXPECT_NEAR(speedHistogram(cells, 5).clipped, 0.25f, 1e-4f);
}

TEST(RepeatAfterEdit, ComesOnceSomeTimeAfterTheLastEdit) {
  RepeatAfterEdit repeat;
  EXPECT_FALSE(repeat.due(5, 0)) << "nothing was done yet";
  repeat.doneAt(5);
  EXPECT_FALSE(repeat.due(5, 100)) << "nothing changed";
  EXPECT_FALSE(repeat.due(6, 101));
  EXPECT_FALSE(repeat.due(7, 102.5)) << "a second edit";
  EXPECT_FALSE(repeat.due(7, 104.4));
  EXPECT_TRUE(repeat.due(7, 104.6));
  EXPECT_FALSE(repeat.due(7, 120)) << "only once";
  EXPECT_FALSE(repeat.due(8, 121));
  repeat.forget();
  EXPECT_FALSE(repeat.due(8, 140));
}

namespace {

/// An xdg-open of our own in `bin`, first in PATH while this lives; without a script PATH has only the empty folder.
class FakeDesktop {
 public:
  FakeDesktop(const std::filesystem::path& bin, const std::string& script) : m_path(std::getenv("PATH")) {
    std::filesystem::create_directory(bin);
    if (!script.empty()) {
      std::ofstream(bin / "xdg-open") << "#!/bin/sh\n" << script << "\n";
      ::chmod((bin / "xdg-open").c_str(), 0755);
    }
    ::setenv("PATH", (bin.string() + (script.empty() ? "" : ":" + m_path)).c_str(), 1);
  }
  ~FakeDesktop() { ::setenv("PATH", m_path.c_str(), 1); }
  FakeDesktop(const FakeDesktop&) = delete;
  FakeDesktop& operator=(const FakeDesktop&) = delete;

 private:
  std::string m_path;
};

/// What comes of it within some seconds; nothing where `done` came true before.
std::optional<Error> outcomeOf(FolderOpener& opener, const std::function<bool()>& done) {
  for (int i = 0; i < 1000; ++i) {
    if (auto error = opener.poll()) return error;
    if (done()) return std::nullopt;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "nothing came of it";
  return std::nullopt;
}

}  // namespace

TEST(FolderOpener, PassesThePathAsItIs) {
  TempFolder folder;
  const auto odd = folder / "a b; $(touch x) 'y'";
  std::filesystem::create_directory(odd);
  const auto told = folder / "told";
  FakeDesktop desktop(folder / "bin", "printf '%s' \"$1\" > '" + told.string() + ".part' && mv '" + told.string() +
                                          ".part' '" + told.string() + "'");
  FolderOpener opener;
  ASSERT_TRUE(opener.open(odd));
  EXPECT_FALSE(outcomeOf(opener, [&] { return std::filesystem::exists(told); }));
  std::ifstream in(told);
  std::string text;
  std::getline(in, text);
  EXPECT_EQ(text, odd.string());
}

TEST(FolderOpener, SaysWhatWentWrong) {
  TempFolder folder;
  FolderOpener opener;
  {
    FakeDesktop none(folder / "empty", "");
    const Status opened = opener.open("/tmp");
    ASSERT_FALSE(opened);
    EXPECT_NE(opened.error().text().find("not installed"), std::string::npos) << opened.error().text();
  }
  FakeDesktop failing(folder / "bin", "exit 3");
  ASSERT_TRUE(opener.open("/tmp"));
  const auto error = outcomeOf(opener, [] { return false; });
  ASSERT_TRUE(error);
  EXPECT_NE(error->text().find("no file manager"), std::string::npos) << error->text();
}

}  // namespace windloom::editor
