#include <gtest/gtest.h>

#include <cmath>

#include "engine/bake/frame_writer.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

constexpr const char* kFormats[] = {"exr",        "png16", "atlas",     "dds",      "dds-rgba", "dds-bc5",
                                    "dds-volume", "ktx2",  "ktx2-rgba", "ktx2-bc5", "ktx2-zstd"};

BakeHeader header(glm::ivec2 resolution, int frames) {
  BakeHeader made;
  made.grid = makeGridMapping({1, 2}, {20, 10}, resolution);
  made.frames = frames;
  made.last = frames - 1;
  made.fullScale = 12.345f;
  made.project = "Test";
  return made;
}

std::uint64_t bytesOf(const std::filesystem::path& folder) {
  std::uint64_t bytes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) bytes += entry.file_size();
  return bytes;
}

}  // namespace

TEST(TextureWriters, PromiseTheirSizeToTheByteOrAtMost) {
  for (const char* name : kFormats) {
    const WriterKind* kind = writerKindNamed(name);
    ASSERT_NE(kind, nullptr) << name;
    for (const glm::ivec2 resolution : {glm::ivec2(1, 1), glm::ivec2(5, 3), glm::ivec2(64, 48)}) {
      for (const int frames : {1, 3}) {
        const TemporaryFolder folder;
        BakeHeader told = header(resolution, frames);
        auto writer = kind->open(told, folder.path());
        ASSERT_TRUE(writer) << name;
        std::vector<glm::vec2> cells(static_cast<std::size_t>(resolution.x * resolution.y));
        for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = {std::sin(i * 0.7f) * 9, std::cos(i * 1.3f) * 8};
        for (int frame = 0; frame < frames; ++frame) ASSERT_TRUE((*writer)->add(frame, cells)) << name;
        const auto files = (*writer)->finish();
        ASSERT_TRUE(files) << name;
        EXPECT_EQ(static_cast<long>(files->size()), folder.entries()) << name;
        told.fullScale = 1;  // sizes are asked for before it is known
        if (kind->exactSize) {
          EXPECT_EQ(bytesOf(folder.path()), kind->bytes(told)) << name;
        }
        if (std::string(name) == "exr") {
          EXPECT_LE(bytesOf(folder.path()), kind->bytes(told));
        }
      }
    }
  }
}

TEST(TextureWriters, LeaveNothingUnlessFinished) {
  for (const char* name : kFormats) {
    if (writerKindNamed(name)->numbered) continue;
    const TemporaryFolder folder;
    {
      auto writer = writerKindNamed(name)->open(header({6, 4}, 2), folder.path());
      ASSERT_TRUE(writer) << name;
      ASSERT_TRUE((*writer)->add(0, std::vector<glm::vec2>(24)));
    }
    EXPECT_EQ(folder.entries(), 0) << name;
  }
}

TEST(TextureWriters, SayWhereTheyCantWrite) {
  for (const char* name : kFormats) {
    auto writer = writerKindNamed(name)->open(header({6, 4}, 1), "/nowhere");
    const Status failed = writer ? (*writer)->add(0, std::vector<glm::vec2>(24)) : Status(writer.error());
    ASSERT_FALSE(failed) << name;
    EXPECT_EQ(failed.error().kind, ErrorKind::Machine) << name;
    EXPECT_NE(failed.error().text().find("/nowhere/"), std::string::npos) << name;
  }
}

TEST(TextureWriters, RefuseWhatAFormatCantHoldWithTheWordsThatWereSaidBefore) {
  for (const char* name : {"dds", "dds-rgba", "dds-bc5", "dds-volume"}) {
    const WriterKind* kind = writerKindNamed(name);
    const TemporaryFolder folder;
    const BakeHeader many = header({2, 2}, 2049);
    const auto writer = kind->open(many, folder.path());
    ASSERT_FALSE(writer) << name;
    EXPECT_EQ(writer.error().kind, ErrorKind::BadInput);
    EXPECT_EQ(writer.error().problems.front().message, kind->refusal(many));
    EXPECT_EQ(folder.entries(), 0) << name;
    EXPECT_EQ(kind->refusal(header({2, 2}, 2048)), "");
  }
}

TEST(TextureWriters, OnlyKnowTheFullScaleWhereTheyCode) {
  for (const char* name : kFormats) {
    const std::string text = name;
    const bool coded = text == "png16" || text == "atlas" || text.ends_with("bc5");
    EXPECT_EQ(writerKindNamed(name)->need, coded ? SpeedNeed::Range : SpeedNeed::None) << name;
  }
}

TEST(TextureWriters, WarnOfMoreLayersThanMostGpusTake) {
  EXPECT_EQ(writerKindNamed("ktx2")->warning(header({2, 2}, 2048)), "");
  EXPECT_NE(writerKindNamed("ktx2")->warning(header({2, 2}, 2049)).find("2048 layers"), std::string::npos);
}

}  // namespace windloom
