#include "engine/bake/write_behind.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

namespace windloom {
namespace {

/// Notes what it is given; is never called by two threads.
class Notes final : public FrameWriter {
 public:
  Status add(int frame, std::span<const glm::vec2> cells) override {
    EXPECT_FALSE(m_inside.exchange(true)) << "one thread at a time";
    if (slow) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    frames.push_back(frame);
    sum += cells[0].x;
    m_inside = false;
    if (frame == failAt) return makeError(ErrorKind::Machine, "disk full");
    return Done{};
  }
  Result<std::vector<BakedFile>> finish() override { return std::vector<BakedFile>{}; }

  bool slow = false;
  int failAt = -1;
  std::vector<int> frames;
  float sum = 0;

 private:
  std::atomic<bool> m_inside = false;
};

WriteBehind::Cells cellsOf(float value) {
  return std::make_shared<const std::vector<glm::vec2>>(4, glm::vec2(value));
}

}  // namespace

TEST(WriteBehind, GivesEveryWriterAllItsFramesInOrder) {
  std::vector<Notes> writers(7);
  WriteBehind behind(writers.size());
  for (int frame = 0; frame < 50; ++frame) {
    const WriteBehind::Cells cells = cellsOf(1.0f);
    for (std::size_t w = 0; w < writers.size(); ++w) ASSERT_TRUE(behind.add(w, writers[w], frame, cells));
  }
  ASSERT_TRUE(behind.finish());
  for (const Notes& writer : writers) {
    ASSERT_EQ(writer.frames.size(), 50u);
    for (int frame = 0; frame < 50; ++frame) EXPECT_EQ(writer.frames[static_cast<std::size_t>(frame)], frame);
    EXPECT_EQ(writer.sum, 50.0f);
  }
}

TEST(WriteBehind, TellsTheFirstFailureAndWritesNoMore) {
  std::vector<Notes> writers(2);
  writers[0].failAt = 3;
  WriteBehind behind(writers.size());
  bool failed = false;
  for (int frame = 0; frame < 1000 && !failed; ++frame) {
    const WriteBehind::Cells cells = cellsOf(1.0f);
    for (std::size_t w = 0; w < 2; ++w) failed = failed || !behind.add(w, writers[w], frame, cells);
  }
  EXPECT_TRUE(failed);
  const Status status = behind.finish();
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().text(), "disk full");
  EXPECT_EQ(writers[0].frames.size(), 4u);
}

TEST(WriteBehind, WaitsRatherThanPileUpFrames) {
  Notes writer;
  writer.slow = true;
  std::vector<std::weak_ptr<const std::vector<glm::vec2>>> alive;
  WriteBehind behind(1);
  for (int frame = 0; frame < 40; ++frame) {
    const WriteBehind::Cells cells = cellsOf(0.0f);
    alive.emplace_back(cells);
    ASSERT_TRUE(behind.add(0, writer, frame, cells));
    const auto waiting = std::ranges::count_if(alive, [](const auto& kept) { return !kept.expired(); });
    EXPECT_LE(waiting, 7) << "the queue, the one being written, and the caller's";
  }
  EXPECT_TRUE(behind.finish());
}

TEST(WriteBehind, DropsWhatIsLeftWhenItGoes) {
  Notes writer;
  writer.slow = true;
  {
    WriteBehind behind(1);
    for (int frame = 0; frame < 4; ++frame) ASSERT_TRUE(behind.add(0, writer, frame, cellsOf(0.0f)));
  }
  EXPECT_LT(writer.frames.size(), 4u);
}

}  // namespace windloom
