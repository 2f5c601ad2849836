#include <cmath>

#include "tests/unit/bake/live_link_fixture.hpp"

namespace windloom {

TEST_F(LiveLinkTest, ShowsAGameTheFieldOfTheEditor) {
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
  const auto link = make();
  ASSERT_NE(link, nullptr);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live) << windloom_status_text(live.status());
  EXPECT_EQ(live.update(), 0);
  EXPECT_EQ(live.info().width, 0);
  EXPECT_EQ(live.sample(1, 1).x, 0.0f) << "calm before the first field";
  std::vector<glm::vec2> cells;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 6; ++i) cells.emplace_back(static_cast<float>(i) * 0.5f, static_cast<float>(-k) * 0.25f);
  }
  const GridMapping grid = makeGridMapping({5, -2}, {12, 8}, {6, 4});
  link->publish(grid, cells, 3.25, {.periodicX = true});
  EXPECT_EQ(live.update(), 1);
  EXPECT_EQ(live.update(), 0);
  const windloom_info info = live.info();
  EXPECT_EQ(info.width, 6);
  EXPECT_EQ(info.height, 4);
  EXPECT_EQ(info.frames, 1);
  EXPECT_EQ(info.fps, 0.0f);
  EXPECT_EQ(info.start, 3.25);
  EXPECT_EQ(info.min_x, -1.0f);
  EXPECT_EQ(info.max_z, 2.0f);
  EXPECT_FLOAT_EQ(info.max_speed, std::hypot(2.5f, 0.75f));
  EXPECT_EQ(info.edge_x, WINDLOOM_WRAP);
  EXPECT_EQ(info.edge_z, WINDLOOM_CLAMP);
  EXPECT_FLOAT_EQ(live.sample(2, -5).x, 0.5f);
  EXPECT_FLOAT_EQ(live.sample(2, 1).z, -0.75f);
  const float places[] = {2, -5, 4, 1};
  float wind[4];
  live.sampleMany(places, 2, wind);
  EXPECT_FLOAT_EQ(wind[0], 0.5f);
  EXPECT_FLOAT_EQ(wind[2], 1.0f);
}

TEST_F(LiveLinkTest, AveragesLargeFieldsDown) {
  const auto link = make();
  ASSERT_NE(link, nullptr);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  std::vector<glm::vec2> cells(std::size_t{1024} * 300);
  for (std::size_t i = 0; i < cells.size(); ++i) cells[i] = {i % 2 == 0 ? 1.0f : 3.0f, static_cast<float>(i / 1024)};
  link->publish(gridOf(1024, 300), cells, 1);
  ASSERT_EQ(live.update(), 1);
  EXPECT_EQ(live.info().width, LiveLink::kMaxSide);
  EXPECT_EQ(live.info().height, 300);
  EXPECT_FLOAT_EQ(live.info().max_x, 512.0f);
  EXPECT_FLOAT_EQ(live.sample(100.3f, 0).x, 2.0f) << "two columns make one";
  EXPECT_FLOAT_EQ(live.sample(0, -149.5f).z, 0.0f);
  EXPECT_FLOAT_EQ(live.sample(0, 149.5f).z, 299.0f);
}

TEST_F(LiveLinkTest, TellsTheEndAndKeepsTheLastField) {
  auto link = make();
  ASSERT_NE(link, nullptr);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live);
  publishStill(*link, 7);
  link.reset();
  EXPECT_EQ(live.update(), 1) << "the last field comes before the end";
  EXPECT_EQ(live.update(), -1);
  EXPECT_EQ(live.update(), -1);
  EXPECT_EQ(live.sample(0, 0).x, 7.0f);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD);
}

TEST_F(LiveLinkTest, RefusesASecondWriter) {
  const auto link = make();
  ASSERT_NE(link, nullptr);
  const auto refusal = [this] {
    const Result<std::unique_ptr<LiveLink>> second = LiveLink::create(m_name);
    return !second && second.error().kind == ErrorKind::Machine &&
           second.error().text().find("another program") != std::string::npos;
  };
  EXPECT_TRUE(refusal());
  EXPECT_EQ(statusOf(inAnotherProcess([&] { return refusal() ? 0 : 1; })), 0);
  LiveField live = LiveField::open(m_name);
  ASSERT_TRUE(live) << "the refused one did no harm";
  publishStill(*link, 3);
  EXPECT_EQ(live.update(), 1);
}

TEST_F(LiveLinkTest, RefusesNamesThatAreNone) {
  for (const std::string& name : {std::string(), std::string("a/b"), std::string(65, 'x'), std::string("a\0b", 3)}) {
    const auto link = LiveLink::create(name);
    ASSERT_FALSE(link);
    EXPECT_EQ(link.error().kind, ErrorKind::BadInput);
    EXPECT_FALSE(LiveField::open(name));
  }
}

TEST_F(LiveLinkTest, TakesOverFromAWriterThatWasKilled) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t writer = inAnotherProcess([&] {
    const auto link = make();
    publishStill(*link, 5);
    const char told = 'x';
    if (::write(ready[1], &told, 1) != 1) return 1;
    for (;;) ::pause();
  });
  char told = 0;
  ASSERT_EQ(::read(ready[0], &told, 1), 1);
  LiveField old = LiveField::open(m_name);
  ASSERT_TRUE(old);
  EXPECT_EQ(old.update(), 1);
  EXPECT_EQ(old.update(), 0);
  ::kill(writer, SIGKILL);
  ::waitpid(writer, nullptr, 0);
  EXPECT_EQ(old.update(), -1);
  EXPECT_EQ(old.sample(0, 0).x, 5.0f);
  EXPECT_EQ(LiveField::open(m_name).status(), WINDLOOM_NO_LIVE_FIELD) << "a stale object is no link";

  const auto link = make();
  ASSERT_NE(link, nullptr);
  publishStill(*link, 6);
  EXPECT_EQ(old.update(), -1) << "a link once ended stays so";
  LiveField fresh = LiveField::open(m_name);
  ASSERT_TRUE(fresh);
  EXPECT_EQ(fresh.update(), 1);
  EXPECT_EQ(fresh.sample(0, 0).x, 6.0f);
  ::close(ready[0]);
  ::close(ready[1]);
}

}  // namespace windloom
