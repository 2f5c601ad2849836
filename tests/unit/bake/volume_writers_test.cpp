#include <gtest/gtest.h>

#include <cstring>

#include "engine/bake/frame_writer.hpp"
#include "engine/core/file.hpp"
#include "engine/io/image.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

/// 2 x 1 cells of 1 m around (1, 0.5), two layers of 1 m.
BakeHeader smallHeader() {
  BakeHeader header;
  header.grid = makeGridMapping({1, 0.5f}, {2, 1}, {2, 1});
  header.profile = {.layers = 2, .top = 2, .reference = 0.5f, .roughness = 0.03f};
  header.fullScale = 4;
  return header;
}

/// Files of a format after frame 7 of `field`, with the folder they lie in.
struct Written {
  TemporaryFolder folder;
  std::vector<BakedFile> files;
  std::string bytes;  // of the first
};

void write(Written& out, const char* format, const BakeHeader& header, const std::vector<glm::vec2>& field) {
  const WriterKind* kind = writerKindNamed(format);
  ASSERT_NE(kind, nullptr);
  Result<std::unique_ptr<FrameWriter>> writer = kind->open(header, out.folder.path());
  ASSERT_TRUE(writer) << writer.error().text();
  const Status added = (*writer)->add(7, field);
  ASSERT_TRUE(added) << added.error().text();
  Result<std::vector<BakedFile>> files = (*writer)->finish();
  ASSERT_TRUE(files);
  out.files = *files;
  out.bytes = readFile(out.folder.path() / out.files.at(0).path).value();
  EXPECT_EQ(out.folder.entries(), static_cast<long>(out.files.size()));
}

const std::vector<glm::vec2> kField = {{1, 0}, {-2.5f, 0.00125f}};

template <class Number>
Number at(const std::string& bytes, std::size_t offset) {
  Number value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

}  // namespace

TEST(FgaWriter, WritesPlainNumbersInUnrealsOrder) {
  BakeHeader header = smallHeader();
  header.preset = Preset::Unity;  // doesn't matter
  Written out;
  write(out, "fga", header, kField);
  EXPECT_EQ(out.files[0].path, "wind.0007.fga");
  EXPECT_EQ(out.bytes, "2,1,2,\n0,0,0,\n200,100,200,\n100,0,0,\n-250,0.125,0,\n136.9173,0,0,\n-342.2932,0.1711,0\n");
}

TEST(FgaWriter, AveragesWhatUnrealRefuses) {
  BakeHeader header = smallHeader();
  header.grid = makeGridMapping({0, 0}, {256, 1}, {256, 1});
  header.profile.layers = 1;
  std::vector<glm::vec2> field(256, {1, 0});
  field[1].x = 3;
  Written out;
  write(out, "fga", header, field);
  EXPECT_TRUE(out.bytes.starts_with("128,1,1,\n-12800,-50,0,\n12800,50,100,\n200,0,0,\n100,0,0,\n"));
  EXPECT_FALSE(writerKindNamed("fga")->warning(header).empty());
  EXPECT_TRUE(writerKindNamed("fga")->warning(smallHeader()).empty());
}

TEST(FgaWriter, CutsTilesThatAreAsEqualAsPossible) {
  BakeHeader header = smallHeader();
  header.grid = makeGridMapping({0, 0}, {130, 2}, {130, 2});
  header.profile.layers = 1;
  std::vector<glm::vec2> field(260, {1, 0});
  field[65 + 130] = {0, 7};  // the first cell of the second tile's second row
  Written out;
  write(out, "fga-tiles", header, field);
  ASSERT_EQ(out.files.size(), 2u);
  EXPECT_EQ(out.files[0].path, "wind_t0_t0.0007.fga");
  EXPECT_EQ(out.files[1].path, "wind_t1_t0.0007.fga");
  EXPECT_EQ(out.files[1].details["tile"], (nlohmann::ordered_json{1, 0}));
  EXPECT_TRUE(out.bytes.starts_with("65,2,1,\n-6500,-100,0,\n0,100,100,\n"));
  const std::string second = readFile(out.folder.path() / out.files[1].path).value();
  EXPECT_TRUE(second.starts_with("65,2,1,\n0,-100,0,\n6500,100,100,\n"));
  EXPECT_EQ(std::count(second.begin(), second.end(), '\n'), 3 + 130);
  std::size_t line = 0;
  for (int n = 0; n < 3 + 65; ++n) line = second.find('\n', line) + 1;
  EXPECT_EQ(second.substr(line, 9), "0,700,0,\n");
}

TEST(FgaWriter, KeepsMoreDigitsOfBends) {
  BakeHeader header = smallHeader();
  header.track = {"bend-soft", Quantity::Bend};
  Written out;
  write(out, "fga", header, {{0.1234567f, -0.00001f}, {0, -1e-9f}});
  EXPECT_EQ(out.files[0].path, "bend-soft-wind.0007.fga");
  EXPECT_TRUE(out.bytes.ends_with("200,\n0.123457,-0.00001,0,\n0,0,0,\n0.123457,-0.00001,0,\n0,0,0\n")) << out.bytes;
}

TEST(VfWriter, WritesTenBytesAndFloats) {
  Written out;
  write(out, "vf", smallHeader(), kField);
  EXPECT_EQ(out.files[0].path, "wind.0007.vf");
  ASSERT_EQ(out.bytes.size(), 10u + 12 * 4);
  EXPECT_EQ(out.bytes.substr(0, 4), "VF_V");
  EXPECT_EQ(at<std::uint16_t>(out.bytes, 4), 2);
  EXPECT_EQ(at<std::uint16_t>(out.bytes, 6), 2);
  EXPECT_EQ(at<std::uint16_t>(out.bytes, 8), 1);
  // Unity's x is ours negated, so the cells come in reverse; the first layer is at the reference height.
  EXPECT_EQ(at<float>(out.bytes, 10), 2.5f);
  EXPECT_EQ(at<float>(out.bytes, 14), 0.0f);
  EXPECT_EQ(at<float>(out.bytes, 18), 0.00125f);
  EXPECT_EQ(at<float>(out.bytes, 22), -1.0f);
  EXPECT_EQ(out.files[0].details["centre"], (nlohmann::ordered_json{-1.0, 1.0, 0.5}));
  EXPECT_EQ(out.files[0].details["size"], (nlohmann::ordered_json{2.0, 2.0, 1.0}));
  EXPECT_EQ(writerKindNamed("vf")->bytes(smallHeader()), out.bytes.size());
}

TEST(VfWriter, PutsThePlaceIntoVersion2) {
  BakeHeader header = smallHeader();
  header.preset = Preset::UnityNegZ;
  Written out;
  write(out, "vf2", header, kField);
  EXPECT_EQ(out.files[0].path, "wind-v2.0007.vf");
  ASSERT_EQ(out.bytes.size(), 77u + 12 * 4);
  EXPECT_EQ(out.bytes.substr(0, 7), std::string("VF2X\0\2\2", 7));
  const float wanted[16] = {2, 0, 0, 1, 0, 2, 0, 1, 0, 0, 1, -0.5f, 0, 0, 0, 1};
  for (std::size_t n = 0; n < 16; ++n) EXPECT_EQ(at<float>(out.bytes, 13 + 4 * n), wanted[n]) << n;
  EXPECT_EQ(at<float>(out.bytes, 77), 1.0f);
  EXPECT_EQ(at<float>(out.bytes, 77 + 12 + 8), -0.00125f);
  EXPECT_EQ(writerKindNamed("vf2")->bytes(header), out.bytes.size());
}

TEST(SlabWriter, HoldsWhatGodotDecodes) {
  BakeHeader header = smallHeader();
  header.preset = Preset::Unity;  // doesn't matter
  header.profile.layers = 1;
  Written out;
  write(out, "godot-slab", header, {{4, 0}, {0, -2}});
  EXPECT_EQ(out.files[0].path, "slab.0007.png");
  const Image image = readPng(out.folder.path() / out.files[0].path).value();
  ASSERT_EQ(image.width, 2);
  ASSERT_EQ(image.height, 1);
  ASSERT_EQ(image.channels, 3);
  // Zero is between two codes; neighbours take turns.
  const std::vector<std::uint8_t> wanted = {255, 127, 127, 128, 128, 64};
  EXPECT_EQ(image.pixels, wanted);
  EXPECT_EQ(out.files[0].details["strength"], 4.0);
}

TEST(SlabWriter, PilesLayersFromTheLowestRowAndSlicesFromTheTopLeft) {
  BakeHeader header = smallHeader();
  header.grid = makeGridMapping({0, 0}, {2, 6}, {2, 6});
  std::vector<glm::vec2> field(12, {0, 0});
  field[2 * 4] = {4, 0};  // slice 4
  Written out;
  write(out, "godot-slab", header, field);
  const nlohmann::ordered_json& details = out.files[0].details;
  EXPECT_EQ(details["slices"], (nlohmann::ordered_json{2, 3}));
  EXPECT_EQ(details["import"]["slices/vertical"], 3);
  const float upper = header.profile.at(1.5f);  // the strength is that of the faster layer
  EXPECT_NEAR(details["strength"].get<float>(), 4 * upper, 1e-5f);
  const Image image = readPng(out.folder.path() / out.files[0].path).value();
  ASSERT_EQ(image.width, 4);
  ASSERT_EQ(image.height, 6);
  EXPECT_EQ(*image.at(0, 5), 255);
  EXPECT_EQ(*image.at(0, 4), std::lround((0.5f / upper + 0.5f) * 255));
  EXPECT_LE(std::abs(*image.at(2, 5) - 127.5), 0.5);
}

TEST(SlabWriter, FillsEveryPlaceForAnyNumberOfSlices) {
  for (const int slices : {1, 7, 12, 100, 251}) {
    BakeHeader header = smallHeader();
    header.grid = makeGridMapping({0, 0}, {4, 4}, {3, slices});
    Written out;
    write(out, "godot-slab", header, std::vector<glm::vec2>(static_cast<std::size_t>(3 * slices), glm::vec2(1)));
    const auto place = out.files[0].details["slices"];
    EXPECT_EQ(place[0].get<int>() * place[1].get<int>(), slices);
    EXPECT_LE(std::max(place[0].get<int>(), place[1].get<int>()), 256);
  }
}

class VdbWriter : public testing::Test {
 protected:
  void SetUp() override {
    if (!writerKindNamed("vdb")->missing.empty()) GTEST_SKIP() << writerKindNamed("vdb")->missing;
  }
};

TEST_F(VdbWriter, GivesTheSameBytesForTheSameWind) {
  Written first, second, other;
  write(first, "vdb", smallHeader(), kField);
  write(second, "vdb", smallHeader(), kField);
  write(other, "vdb", smallHeader(), {{1, 0}, {-2, 0}});
  EXPECT_EQ(first.files[0].path, "wind_0007.vdb");
  EXPECT_EQ(first.bytes, second.bytes);
  EXPECT_NE(first.bytes.substr(21, 36), other.bytes.substr(21, 36)) << "other content has another id";
}

TEST(VdbWriterLimit, RefusesMoreVoxelsThanFit) {
  const TemporaryFolder folder;
  BakeHeader header;
  header.grid = makeGridMapping({0, 0}, {100, 100}, {1000, 1000});
  header.profile.top = 8;
  const auto writer = writerKindNamed("vdb")->open(header, folder.path());
  ASSERT_FALSE(writer);
  EXPECT_NE(writer.error().text().find("1000 x 80 x 1000"), std::string::npos) << writer.error().text();
  EXPECT_NE(writerKindNamed("vdb")->refusal(header).find("32 million"), std::string::npos);
}

TEST(VolumeWriters, TakeTheSmallestGrids) {
  for (const char* format : {"fga", "fga-tiles", "vf", "vf2", "vdb", "godot-slab"}) {
    if (!writerKindNamed(format)->missing.empty()) continue;
    for (const glm::ivec2 cells : {glm::ivec2(1, 1), glm::ivec2(1, 7), glm::ivec2(5, 1)}) {
      for (const int layers : {1, 3}) {
        BakeHeader header = smallHeader();
        header.grid = makeGridMapping({0, 0}, cells, cells);
        header.profile.layers = layers;
        Written out;
        write(out, format, header, std::vector<glm::vec2>(static_cast<std::size_t>(cells.x * cells.y), glm::vec2(1)));
        ASSERT_EQ(out.files.size(), 1u) << format;
        EXPECT_GT(out.bytes.size(), 20u) << format;
      }
    }
  }
}

TEST(VolumeWriters, SayWhenTheDiskDoesNotTakeTheFile) {
  for (const char* format : {"fga", "fga-tiles", "vf", "vf2", "vdb", "godot-slab"}) {
    if (!writerKindNamed(format)->missing.empty()) continue;
    const auto writer = writerKindNamed(format)->open(smallHeader(), "/nonexistent/folder");
    ASSERT_TRUE(writer);
    const Status added = (*writer)->add(0, kField);
    ASSERT_FALSE(added) << format;
    EXPECT_EQ(added.error().kind, ErrorKind::Machine);
    EXPECT_NE(added.error().text().find("/nonexistent/folder"), std::string::npos) << added.error().text();
  }
}

}  // namespace windloom
