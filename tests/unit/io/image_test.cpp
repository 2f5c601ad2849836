#include "engine/io/image.hpp"

#include <gtest/gtest.h>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {
namespace fs = std::filesystem;

class ImageFile : public ::testing::Test {
 protected:
  std::string refusal(std::string_view bytes) const {
    EXPECT_TRUE(writeFileAtomically(m_folder / "bad.png", bytes));
    const Result<Image> image = readPng(m_folder / "bad.png");
    if (image) return "accepted";
    EXPECT_EQ(image.error().kind, ErrorKind::BadInput);
    return image.error().text();
  }
  TemporaryFolder m_temporary;
  const fs::path m_folder = m_temporary.path();
};

template <class Sample>
BasicImage<Sample> testCard(int width, int height, int channels) {
  BasicImage<Sample> image(width, height, channels);
  unsigned state = 12345;
  for (Sample& sample : image.pixels) sample = static_cast<Sample>((state = state * 1664525u + 1013904223u) >> 13);
  return image;
}

TEST_F(ImageFile, KeepsEverySampleOfEachKind) {
  for (const int channels : {1, 3, 4}) {
    const auto eight = testCard<std::uint8_t>(7, 5, channels);
    ASSERT_TRUE(writePng(m_folder / "a.png", eight));
    const Result<Image> back = readPng(m_folder / "a.png");
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(back->channels, channels);
    EXPECT_EQ(back->width, 7);
    EXPECT_EQ(back->height, 5);
    EXPECT_EQ(back->pixels, eight.pixels);

    const auto sixteen = testCard<std::uint16_t>(3, 9, channels);
    ASSERT_TRUE(writePng(m_folder / "b.png", sixteen));
    const Result<Image16> back16 = readPng16(m_folder / "b.png");
    ASSERT_TRUE(back16) << back16.error().text();
    EXPECT_EQ(back16->pixels, sixteen.pixels);
  }
}

TEST_F(ImageFile, BringsSamplesToTheAskedDepth) {
  Image16 deep(2, 1, 1);
  deep.pixels = {65535, 0x8080};
  ASSERT_TRUE(writePng(m_folder / "deep.png", deep));
  EXPECT_EQ(readPng(m_folder / "deep.png")->pixels, (std::vector<std::uint8_t>{255, 128}));
  Image flat(2, 1, 1);
  flat.pixels = {255, 128};
  ASSERT_TRUE(writePng(m_folder / "flat.png", flat));
  EXPECT_EQ(readPng16(m_folder / "flat.png")->pixels, (std::vector<std::uint16_t>{65535, 0x8080}));
}

TEST_F(ImageFile, RefusesWhatIsNoPng) {
  EXPECT_NE(refusal("").find("is not a PNG file"), std::string::npos);
  EXPECT_NE(refusal("JFIF, not a PNG at all").find("is not a PNG file"), std::string::npos);
  EXPECT_EQ(readPng(m_folder / "none.png").error().kind, ErrorKind::BadInput);
}

TEST_F(ImageFile, RefusesEveryCut) {
  ASSERT_TRUE(writePng(m_folder / "a.png", testCard<std::uint8_t>(16, 16, 4)));
  const std::string bytes = readFile(m_folder / "a.png").value();
  for (std::size_t length = 8; length < bytes.size(); length += 13) {
    EXPECT_NE(refusal(std::string_view(bytes).substr(0, length)).find("damaged PNG"), std::string::npos) << length;
  }
}

TEST_F(ImageFile, RefusesAFlippedByteInTheData) {
  ASSERT_TRUE(writePng(m_folder / "a.png", testCard<std::uint8_t>(16, 16, 4)));
  std::string bytes = readFile(m_folder / "a.png").value();
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x10);
  EXPECT_NE(refusal(bytes).find("damaged PNG"), std::string::npos);
}

TEST_F(ImageFile, RefusesASmallFileThatClaimsToBeHuge) {
  // 10000 x 10000 RGBA with a right checksum of the header and next to no data.
  const unsigned char header[] = {0x89, 'P',  'N',  'G', '\r', '\n', 0x1a, '\n', 0, 0, 0, 13, 'I',  'H',  'D',  'R', 0,
                                  0,    0x27, 0x10, 0,   0,    0x27, 0x10, 8,    6, 0, 0, 0,  0xba, 0x4e, 0x62, 0x27};
  std::string bytes(reinterpret_cast<const char*>(header), sizeof header);
  bytes.append("\0\0\0\x0aIDAT", 8).append(10, '\0').append(4, '\0');
  EXPECT_NE(refusal(bytes).find("damaged PNG"), std::string::npos);
}

TEST_F(ImageFile, SaysWhereItCannotWrite) {
  const Status status = writePng(m_folder / "none" / "a.png", testCard<std::uint8_t>(2, 2, 3));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::Machine);
  EXPECT_NE(status.error().text().find("a.png"), std::string::npos);
}

}  // namespace windloom
