#include "engine/session/session.hpp"

#include <cmath>

#include "engine/gpu/framebuffer.hpp"
#include "tests/gpu/gpu_test.hpp"

namespace windloom {
namespace {

Project breezeProject(glm::ivec2 resolution) {
  Project project;
  FieldSettings field;
  field.size = {40.0f, 40.0f};
  field.resolution = resolution;
  project.field = std::make_shared<FieldSettings>(field);
  AmbientWind ambient;
  ambient.speed = 3.0f;
  project.ambient = std::make_shared<AmbientWind>(ambient);
  GrassSettings grass;
  grass.density = 10.0f;
  project.grass = std::make_shared<GrassSettings>(grass);
  WindGraph graph;
  graph.points.resize(2);
  graph.points[0].id = 1;
  graph.points[0].position = {0.0f, -12.0f};
  graph.points[1].id = 2;
  graph.points[1].position = {0.0f, 12.0f};
  Arrow arrow;
  arrow.id = 10;
  arrow.from = 1;
  arrow.to = 2;
  graph.arrows.push_back(arrow);
  project.graph = std::make_shared<WindGraph>(graph);
  return project;
}

class LiveSession : public testing::GpuTest {
 protected:
  std::unique_ptr<Session> open(const Project& project, Backend backend = Backend::Cpu,
                                LiveGrid grid = LiveGrid::Automatic) {
    SessionOptions options;
    options.context = &context();
    options.shaders = &shaders();
    options.backend = backend;
    options.liveGrid = grid;
    auto session = Session::create(project, options);
    EXPECT_TRUE(session.ok()) << session.error().text();
    return session.ok() ? std::move(*session) : nullptr;
  }
  void drawOnce(Session& session) {
    if (m_target.name() == 0) {
      auto made = gpu::Framebuffer::create("test picture", kSize, {.colour = GL_RGBA8, .depth = 0});
      ASSERT_TRUE(made.ok()) << made.error().text();
      m_target = std::move(*made);
    }
    Session::View view;
    view.size = kSize;
    view.camera.position = {0.0f, 2.0f, 10.0f};
    view.framebuffer = m_target.name();
    session.draw(view);
    glFinish();
  }
  void TearDown() override {
    m_target = {};
    GpuTest::TearDown();
  }
  static constexpr glm::ivec2 kSize{160, 90};
  gpu::Framebuffer m_target;
};

TEST_F(LiveSession, TimeGoesOnlyWhilePlaying) {
  const auto session = open(breezeProject({32, 32}));
  session->advance(0.2);
  EXPECT_EQ(session->time(), 0.0);
  session->play();
  session->advance(0.2);
  const double played = session->time();
  EXPECT_GT(played, 0.0);
  EXPECT_LE(played, 0.2 + 1e-6);
  session->pause();
  session->advance(0.2);
  EXPECT_EQ(session->time(), played);
  session->stepOnce();
  EXPECT_NEAR(session->time(), played + 1.0 / 60.0, 1e-6);
  session->restart();
  EXPECT_EQ(session->time(), 0.0);
}

TEST_F(LiveSession, SlowsTimeDownInsteadOfSpiralling) {
  const auto session = open(breezeProject({512, 512}), Backend::Cpu, LiveGrid::Full);
  session->play();
  for (int i = 0; i < 6; ++i) session->advance(5.0);
  EXPECT_LT(session->time(), 6.0) << "thirty seconds of wall time can't be caught up in six frames";
  EXPECT_LT(session->status().timeScale, 0.5);
}

TEST_F(LiveSession, AirBlowsAlongADrawnArrow) {
  const auto session = open(breezeProject({64, 64}));
  session->runTo(4.0);
  const glm::vec2 wind = session->windAt({0.0f, 6.0f});
  EXPECT_GT(wind.y, 3.0f);
}

TEST_F(LiveSession, TheWholeFieldComesFromBothBackends) {
  std::vector<glm::vec2> fields[2];
  for (const Backend backend : {Backend::Cpu, Backend::Gpu}) {
    const auto session = open(breezeProject({48, 32}), backend, LiveGrid::Full);
    EXPECT_EQ(session->field()->number, 0);
    session->runTo(1.0);
    session->askField();
    session->askField();
    glFinish();
    const std::shared_ptr<const FieldSnapshot> kept = session->field();
    const FieldSnapshot& field = *kept;
    ASSERT_EQ(field.number, 1) << "one step is read once";
    EXPECT_EQ(field.grid.resolution, glm::ivec2(48, 32));
    EXPECT_NEAR(field.time, 1.0, 1e-3);
    session->restart();
    session->askField();
    glFinish();
    EXPECT_EQ(session->field()->time, 0.0);
    session->runTo(1.0);
    session->askField();
    glFinish();
    EXPECT_EQ(session->field()->number, 3);
    fields[backend == Backend::Gpu] = session->field()->cells;
    EXPECT_EQ(field.number, 1) << "what is kept stays as it was";
  }
  ASSERT_EQ(fields[0].size(), 48u * 32u);
  ASSERT_EQ(fields[1].size(), 48u * 32u);
  for (std::size_t i = 0; i < fields[0].size(); ++i)
    ASSERT_NEAR(glm::distance(fields[0][i], fields[1][i]), 0, 0.02) << "cell " << i;
  EXPECT_GT(glm::length(fields[0][20 * 48 + 24]), 3.0f);
}

TEST_F(LiveSession, FieldsOnTheirWaySurviveAnotherGrid) {
  const auto session = open(breezeProject({48, 32}), Backend::Gpu, LiveGrid::Full);
  for (int i = 0; i < 6; ++i) {  // more than may be on their way
    session->stepOnce();
    session->askField();
  }
  Project other = breezeProject({24, 40});
  ASSERT_TRUE(session->setProject(other).ok());
  session->stepOnce();
  session->askField();
  glFinish();
  EXPECT_EQ(session->field()->grid.resolution, glm::ivec2(24, 40));
  EXPECT_EQ(session->field()->cells.size(), 24u * 40u);
}

TEST_F(LiveSession, AMovedPointChangesTheWindWhileTimeGoesOn) {
  Project project = breezeProject({64, 64});
  const auto session = open(project);
  session->runTo(3.0);
  WindGraph graph = *project.graph;
  graph.points[0].position = {0.0f, 12.0f};
  graph.points[1].position = {0.0f, -12.0f};
  project.graph = std::make_shared<WindGraph>(graph);
  ASSERT_TRUE(session->setProject(project).ok());
  EXPECT_GT(session->time(), 2.9);
  session->runTo(6.0);
  EXPECT_LT(session->windAt({0.0f, 0.0f}).y, -2.0f);
}

TEST_F(LiveSession, KeepsTheLastProjectWhenTheNewOneIsWrong) {
  const Project good = breezeProject({32, 32});
  const auto session = open(good);
  session->runTo(0.5);
  Project bad = good;
  WindGraph graph = *good.graph;
  graph.arrows[0].to = 99;
  bad.graph = std::make_shared<WindGraph>(graph);
  EXPECT_FALSE(session->setProject(bad).ok());
  session->runTo(1.0);
  EXPECT_NEAR(session->time(), 1.0, 0.02);
  drawOnce(*session);
}

TEST_F(LiveSession, RunsOnACoarserGridOnTheCpuAndSaysSo) {
  const auto session = open(breezeProject({600, 300}));
  EXPECT_EQ(session->status().backend, Backend::Cpu);
  EXPECT_EQ(session->status().liveResolution, glm::ivec2(256, 128));
  EXPECT_EQ(session->status().projectResolution, glm::ivec2(600, 300));
  session->runTo(0.1);
  ASSERT_TRUE(session->setLiveGrid(LiveGrid::Full).ok());
  EXPECT_EQ(session->status().liveResolution, glm::ivec2(600, 300));
  EXPECT_NEAR(session->time(), 0.1, 1e-6) << "time and air go on";
  EXPECT_NEAR(session->windAt({-15.0f, 0.0f}).x, 3.0f, 0.5f);
}

TEST_F(LiveSession, LeavesTheProjectsGridOnAGpuThatIsTooSlowForIt) {
  const auto session = open(breezeProject({96, 96}), Backend::Gpu);
  ASSERT_NE(session, nullptr);
  EXPECT_EQ(session->status().liveResolution, glm::ivec2(96, 96));
  for (int i = 0; i < 50; ++i) {
    session->stepOnce();
    glFinish();
  }
  // A software renderer takes longer than real time for any grid.
  EXPECT_EQ(session->status().liveResolution, context().info().software ? glm::ivec2(64, 64) : glm::ivec2(96, 96));
  ASSERT_TRUE(session->setLiveGrid(LiveGrid::Full).ok());
  EXPECT_EQ(session->status().liveResolution, glm::ivec2(96, 96));
}

TEST_F(LiveSession, ANewFieldTakesEffect) {
  Project project = breezeProject({64, 64});
  const auto session = open(project);
  FieldSettings field = *project.field;
  field.resolution = {48, 96};
  project.field = std::make_shared<FieldSettings>(field);
  ASSERT_TRUE(session->setProject(project).ok());
  EXPECT_EQ(session->status().liveResolution, glm::ivec2(48, 96));
  drawOnce(*session);
}

TEST_F(LiveSession, AnswersForTheGpusWindWithoutWaiting) {
  const auto session = open(breezeProject({64, 64}), Backend::Gpu, LiveGrid::Full);
  ASSERT_NE(session, nullptr);
  EXPECT_EQ(session->windAt({0.0f, 6.0f}), glm::vec2(3.0f, 0.0f)) << "the ambient wind until an answer is there";
  session->runTo(2.5);
  for (int i = 0; i < 4; ++i) {
    (void)session->windAt({0.0f, 6.0f});
    drawOnce(*session);
  }
  EXPECT_GT(session->windAt({0.0f, 6.0f}).y, 2.0f);
}

TEST_F(LiveSession, CountsTheBladesItDraws) {
  const auto session = open(breezeProject({32, 32}));
  for (int i = 0; i < 4; ++i) drawOnce(*session);
  EXPECT_EQ(session->status().frame.bladesTotal, 16'000);
  EXPECT_GT(session->status().frame.bladesDrawn, 0);
}

TEST_F(LiveSession, SeeksInSlicesAndGivesTheSameWindAgain) {
  for (const Backend backend : {Backend::Cpu, Backend::Gpu}) {
    const auto session = open(breezeProject({32, 32}), backend);
    ASSERT_NE(session, nullptr);
    session->watch({{0.0f, 0.0f}});
    const auto arrive = [&](double target) {
      session->seek(target);
      int frames = 0;
      while (session->seeking() && ++frames < 5000) {
        EXPECT_LE(session->seeking()->part, 1.0f);
        EXPECT_NEAR(session->seeking()->target, target, 0.02);
        session->advance(1.0 / 30);
      }
      EXPECT_NEAR(session->time(), target, 0.02);
      glFinish();
    };
    arrive(1.5);
    std::vector<WindSample> first;
    for (int frame = 0; frame < 3; ++frame) {
      for (const WindSample& sample : session->takeSamples()) first.push_back(sample);
      glFinish();
    }
    ASSERT_FALSE(first.empty());
    arrive(0.5);
    session->takeSamples();
    arrive(1.5);
    std::vector<WindSample> second;
    for (int frame = 0; frame < 3; ++frame) {
      for (const WindSample& sample : session->takeSamples()) second.push_back(sample);
      glFinish();
    }
    ASSERT_FALSE(second.empty());
    EXPECT_GE(second.front().time, 0.49) << "from where it went back to";
    int compared = 0;
    for (const WindSample& sample : second) {
      for (const WindSample& before : first) {
        if (std::abs(before.time - sample.time) > 1e-6) continue;
        EXPECT_EQ(before.wind, sample.wind) << sample.time;
        ++compared;
      }
    }
    EXPECT_GT(compared, 0);
  }
}

void arrive(Session& session, double target) {
  session.seek(target);
  for (int frame = 0; session.seeking() && frame < 5000; ++frame) session.advance(1.0 / 30);
  EXPECT_NEAR(session.time(), target, 0.02);
}

TEST_F(LiveSession, TheBrushDoesNotReachIntoASeek) {
  const auto session = open(breezeProject({32, 32}));
  ASSERT_NE(session, nullptr);
  arrive(*session, 0.5);
  const glm::vec2 untouched = session->windAt({6.0f, 0.0f});
  session->restart();
  ArrowForce stroke{};
  stroke.from = {0, 0};
  stroke.to = {12, 0};
  stroke.direction = {1, 0};
  stroke.radius = 3;
  stroke.strength = 12;
  stroke.response = 0.05f;
  stroke.factor = 1;
  stroke.drive = ARROW_DRIVE_SPEED;
  session->setTransientForces(std::span(&stroke, 1));
  arrive(*session, 0.5);
  EXPECT_EQ(session->windAt({6.0f, 0.0f}), untouched);
  for (int step = 0; step < 10; ++step) session->stepOnce();
  EXPECT_GT(session->windAt({6.0f, 0.0f}).x, untouched.x + 2.0f) << "but into what is played";
}

TEST_F(LiveSession, ASeekKeepsItsTimeWhereTheTimeStepChanges) {
  Project project = breezeProject({64, 64});
  const auto session = open(project);
  ASSERT_NE(session, nullptr);
  session->seek(3600);
  session->advance(1.0 / 30);
  ASSERT_TRUE(session->seeking().has_value());
  FieldSettings field = *project.field;
  field.timeStep *= 2;
  project.field = std::make_shared<FieldSettings>(field);
  ASSERT_TRUE(session->setProject(project).ok());
  ASSERT_TRUE(session->seeking().has_value());
  EXPECT_NEAR(session->seeking()->target, 3600, 0.1);
}

TEST_F(LiveSession, ACancelledSeekStaysWhereItCameTo) {
  const auto session = open(breezeProject({64, 64}));
  ASSERT_NE(session, nullptr);
  session->play();
  session->seek(3600);
  session->advance(1.0 / 30);
  ASSERT_TRUE(session->seeking().has_value()) << "an hour doesn't fit into a frame";
  EXPECT_GT(session->time(), 0);
  session->cancelSeek();
  const double reached = session->time();
  session->advance(1.0 / 30);
  EXPECT_FALSE(session->seeking().has_value());
  EXPECT_FALSE(session->playing());
  EXPECT_EQ(session->time(), reached);
}

TEST_F(LiveSession, ALoopGoesBackToItsStart) {
  const auto session = open(breezeProject({32, 32}));
  ASSERT_NE(session, nullptr);
  session->setLoop({.in = 0.5, .out = 1.0, .on = true});
  session->play();
  double greatest = 0, leastAfter = 10;
  for (int frame = 0; frame < 120; ++frame) {
    session->advance(1.0 / 30);
    greatest = std::max(greatest, session->time());
    if (greatest > 0.9) leastAfter = std::min(leastAfter, session->time());
  }
  EXPECT_NEAR(greatest, 1.0, 0.06);
  EXPECT_NEAR(leastAfter, 0.5, 0.06);
  session->setLoop({.in = 2, .out = 1, .on = false});
  EXPECT_GT(session->loop().out, session->loop().in);
}

}  // namespace
}  // namespace windloom
