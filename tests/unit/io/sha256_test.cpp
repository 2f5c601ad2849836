#include "engine/io/sha256.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "engine/core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace windloom {

// The examples of FIPS 180-4 and of NIST's test vectors.
TEST(Sha256, GivesThePublishedDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, OfAFileIsThatOfItsBytesHoweverManyPiecesItHas) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 1u << 20, (1u << 20) + 1, 2'500'000u}) {
    std::string text;
    for (std::size_t i = 0; i < size; ++i) text += static_cast<char>(i * 7 + i / 251);
    ASSERT_TRUE(writeFileAtomically(folder.path() / "bytes", text));
    EXPECT_EQ(sha256OfFile(folder.path() / "bytes").value(), sha256(text)) << size;
  }
}

TEST(Sha256, SaysWhichFileCannotBeRead) {
  const Result<std::string> digest = sha256OfFile("no-such-file");
  ASSERT_FALSE(digest);
  EXPECT_EQ(digest.error().kind, ErrorKind::Machine);
}

TEST(Sha256, WaitsForNoPipe) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path() / "pipe").c_str(), 0600), 0);
  EXPECT_FALSE(sha256OfFile(folder.path() / "pipe"));
  EXPECT_FALSE(sha256OfFile("/dev/zero"));
}

}  // namespace windloom
