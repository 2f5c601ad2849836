#include "engine/bake/frame_spool.hpp"

#include <gtest/gtest.h>

#include "tests/temporary_folder.hpp"

namespace windloom {
namespace {

std::vector<glm::vec2> frameOf(int n) {
  std::vector<glm::vec2> frame(50);
  for (std::size_t i = 0; i < frame.size(); ++i) frame[i] = {static_cast<float>(n), static_cast<float>(i)};
  return frame;
}

}  // namespace

TEST(FrameSpool, GivesBackFramesFromMemoryAndFromItsFile) {
  const TemporaryFolder folder;
  FrameSpool spool(50, folder.path(), 3 * 50 * sizeof(glm::vec2) + 7);  // three frames fit
  for (int n = 0; n < 8; ++n) ASSERT_TRUE(spool.add(frameOf(n)));
  EXPECT_EQ(spool.frames(), 8);
  EXPECT_EQ(folder.entries(), 0) << "the file has no name";
  std::vector<glm::vec2> frame;
  for (const int n : {7, 0, 3, 2, 5}) {
    ASSERT_TRUE(spool.read(n, frame));
    EXPECT_EQ(frame, frameOf(n));
  }
}

TEST(FrameSpool, SaysWhereItCannotWrite) {
  FrameSpool spool(50, "no/such/folder", 0);
  const Status status = spool.add(frameOf(0));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().kind, ErrorKind::Machine);
  EXPECT_NE(status.error().text().find("no/such/folder"), std::string::npos);
}

}  // namespace windloom
