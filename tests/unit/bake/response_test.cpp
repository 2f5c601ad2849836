#include "engine/bake/response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "shaders/shared/blade_deformation.h"

namespace windloom {
namespace {

struct Motion {
  double bend = 0, speed = 0;
};

/// The oscillator by many steps of Runge and Kutta: nothing of the closed form.
Motion integrated(double frequency, double damping, Motion at, double seconds,
                  const std::function<double(double)>& target) {
  const double w = 2 * std::numbers::pi * frequency;
  const auto rate = [&](Motion m, double t) {
    return Motion{m.speed, -2 * damping * w * m.speed - w * w * (m.bend - target(t))};
  };
  const auto moved = [](Motion m, Motion r, double h) { return Motion{m.bend + h * r.bend, m.speed + h * r.speed}; };
  constexpr int kSteps = 20'000;
  const double h = seconds / kSteps;
  for (int n = 0; n < kSteps; ++n) {
    const double t = n * h;
    const Motion a = rate(at, t), b = rate(moved(at, a, h / 2), t + h / 2), c = rate(moved(at, b, h / 2), t + h / 2),
                 d = rate(moved(at, c, h), t + h);
    at.bend += h / 6 * (a.bend + 2 * b.bend + 2 * c.bend + d.bend);
    at.speed += h / 6 * (a.speed + 2 * b.speed + 2 * c.speed + d.speed);
  }
  return at;
}

Motion stepped(const OscillatorStep& step, Motion at, double before, double after) {
  const auto sum = [&](const std::array<float, 4>& f) {
    return static_cast<double>(f[0]) * at.bend + static_cast<double>(f[1]) * at.speed +
           static_cast<double>(f[2]) * before + static_cast<double>(f[3]) * after;
  };
  return {sum(step.bend), sum(step.speed)};
}

}  // namespace

TEST(OscillatorStep, IsTheSolutionForEveryDamping) {
  for (const float damping : {0.0f, 0.1f, 0.3f, 0.9999f, 1.0f, 1.0001f, 2.0f, 5.0f}) {
    for (const double seconds : {0.01, 1.0 / 30, 0.4, 3.0}) {
      const Motion begin{0.3, -1.1};
      const Motion wanted = integrated(1.5, static_cast<double>(damping), begin, seconds,
                                       [&](double t) { return 0.2 + 0.5 * t / seconds; });
      const Motion found = stepped(oscillatorStep(1.5f, damping, seconds), begin, 0.2, 0.7);
      EXPECT_NEAR(found.bend, wanted.bend, 2e-6) << "damping " << damping << ", " << seconds << " s";
      EXPECT_NEAR(found.speed, wanted.speed, 2e-5) << "damping " << damping << ", " << seconds << " s";
    }
  }
}

TEST(OscillatorStep, FollowsAnEvenTargetOneLagBehind) {
  // After long the bend is the target where it was 2 d / w seconds ago.
  const double rate = 0.25, seconds = 60, w = 2 * std::numbers::pi * 2.5;
  const Motion found = stepped(oscillatorStep(2.5f, 0.25f, seconds), {}, 0, rate * seconds);
  EXPECT_NEAR(found.bend, rate * (seconds - 2 * 0.25 / w), 1e-5);
  EXPECT_NEAR(found.speed, rate, 1e-5);
}

TEST(OscillatorStep, StaysExactForTinyAndHugeTimes) {
  const Motion still = stepped(oscillatorStep(0.3f, 0.1f, 1e-6), {0.5, 2.0}, 0, 1);
  EXPECT_NEAR(still.bend, 0.5, 1e-5);
  EXPECT_NEAR(still.speed, 2.0, 1e-4);
  for (const float damping : {0.1f, 1.0f, 9.0f}) {
    const Motion late = stepped(oscillatorStep(2.5f, damping, 1e5), {0.5, 2.0}, 0.7, 0.7);
    EXPECT_NEAR(late.bend, 0.7, 1e-6);
    EXPECT_NEAR(late.speed, 0.0, 1e-6);
  }
}

TEST(PlantResponse, RestsInTheFirstWindAsTheMeadowBends) {
  const std::vector<glm::vec2> wind = {{0, 0}, {3, 4}, {-40, 30}};
  PlantResponse response(wind.size());
  response.advance(wind, 0.0);
  for (int c = 0; c < 4; ++c) {
    const PlantClass& plants = plantClasses()[static_cast<std::size_t>(c)];
    for (std::size_t i = 0; i < wind.size(); ++i) {
      const float size = shared::saturateBend(plants.bend * glm::length(wind[i]), kSteadyBendLimit);
      const glm::vec2 wanted = size > 0 ? wind[i] / glm::length(wind[i]) * size : glm::vec2(0);
      EXPECT_NEAR(glm::length(response.bend(c)[i] - wanted), 0.0f, 1e-6f) << plants.name;
      EXPECT_LT(glm::length(response.bend(c)[i]), kSteadyBendLimit);
    }
  }
  const std::vector<glm::vec2> before(response.bend(2).begin(), response.bend(2).end());
  response.advance(wind, 1.0 / 30);
  for (std::size_t i = 0; i < wind.size(); ++i)
    EXPECT_NEAR(glm::length(response.bend(2)[i] - before[i]), 0.0f, 1e-6f) << "steady wind moves nothing";
}

TEST(PlantResponse, LeansSofterPlantsFurtherAndSwingsStifferOnesSlower) {
  for (std::size_t c = 1; c < 4; ++c) {
    EXPECT_LT(plantClasses()[c].bend, plantClasses()[c - 1].bend);
    EXPECT_LT(plantClasses()[c].frequency, plantClasses()[c - 1].frequency);
  }
}

TEST(PlantResponse, ComesToRestInASteadyWind) {
  PlantResponse response(1);
  response.advance(std::vector<glm::vec2>{{0, 0}}, 0);
  const std::vector<glm::vec2> wind = {{5, -2}};
  for (int n = 0; n < 3000; ++n) response.advance(wind, 1.0 / 30);
  for (int c = 0; c < 4; ++c) {
    const glm::vec2 wanted = steadyBend(plantClasses()[static_cast<std::size_t>(c)], wind[0]);
    EXPECT_NEAR(glm::length(response.bend(c)[0] - wanted), 0.0f, 1e-6f);
  }
}

TEST(OscillatorStep, NeverGainsEnergyAroundAFixedTarget) {
  for (const float damping : {0.0f, 0.1f, 1.0f, 3.0f}) {
    for (const double seconds : {1e-4, 0.03, 0.7, 12.0}) {
      const OscillatorStep step = oscillatorStep(1.5f, damping, seconds);
      const double w = 2 * std::numbers::pi * 1.5;
      for (int n = 0; n < 16; ++n) {
        const Motion before{std::cos(n * 0.4), w * std::sin(n * 0.4)};  // energy w^2, all phases
        const Motion after = stepped(step, before, 0, 0);
        EXPECT_LE(after.speed * after.speed + w * w * after.bend * after.bend, w * w * (1 + 1e-5));
      }
    }
  }
}

TEST(PlantResponse, SwingsOutWhenTheWindStops) {
  const std::vector<glm::vec2> still = {{0, 0}};
  for (int c = 0; c < 4; ++c) {
    PlantResponse response(1);
    response.advance(std::vector<glm::vec2>{{12, 0}}, 0);
    response.advance(still, 1e-3);
    const double period = 1 / static_cast<double>(plantClasses()[static_cast<std::size_t>(c)].frequency);
    float last = 10, least = 0;
    for (int swing = 0; swing < 8; ++swing) {
      float greatest = 0;
      for (int n = 0; n < 40; ++n) {
        response.advance(still, period / 40);
        greatest = std::max(greatest, std::abs(response.bend(c)[0].x));
        least = std::min(least, response.bend(c)[0].x);
      }
      EXPECT_LT(greatest, 0.75f * last);
      last = greatest;
    }
    EXPECT_LT(least, -0.01f) << "it swings through";
    EXPECT_EQ(response.bend(c)[0].y, 0.0f);
  }
}

TEST(PlantResponse, GivesNearlyTheSameForAnySplittingOfTheTime) {
  const auto windAt = [](double t) { return glm::vec2(4 + 3 * std::sin(1.3 * t), 2 * std::cos(0.7 * t)); };
  std::array<std::vector<glm::vec2>, 2> ends;
  for (int fine = 0; fine < 2; ++fine) {
    PlantResponse response(1);
    const int steps = fine == 1 ? 2000 : 100;
    for (int n = 0; n <= steps; ++n)
      response.advance(std::vector<glm::vec2>{windAt(5.0 * n / steps)}, n == 0 ? 0 : 5.0 / steps);
    for (int c = 0; c < 4; ++c) ends[static_cast<std::size_t>(fine)].push_back(response.bend(c)[0]);
  }
  for (std::size_t c = 0; c < 4; ++c) EXPECT_NEAR(glm::length(ends[0][c] - ends[1][c]), 0.0f, 1e-3f);
}

TEST(PlantResponse, FollowsAFineIntegrationOfAGust) {
  const auto windAt = [](double t) { return 6 * std::exp(-(t - 1) * (t - 1) / 0.1); };
  PlantResponse response(1);
  constexpr int kSteps = 240;
  for (int n = 0; n <= kSteps; ++n)
    response.advance(std::vector<glm::vec2>{{windAt(2.0 * n / kSteps), 0}}, n == 0 ? 0 : 2.0 / kSteps);
  for (int c = 0; c < 4; ++c) {
    const PlantClass& plants = plantClasses()[static_cast<std::size_t>(c)];
    const auto target = [&](double t) {
      const double x = static_cast<double>(plants.bend) * windAt(t), limit = static_cast<double>(kSteadyBendLimit);
      return x / std::sqrt(1 + x * x / limit / limit);
    };
    const Motion wanted = integrated(static_cast<double>(plants.frequency), static_cast<double>(plants.damping),
                                     {target(0), 0}, 2, target);
    EXPECT_NEAR(response.bend(c)[0].x, wanted.bend, 3e-4) << plants.name;
  }
}

TEST(PlantResponse, DoesNotMoveInNoTime) {
  PlantResponse response(1);
  response.advance(std::vector<glm::vec2>{{3, 0}}, 0);
  const glm::vec2 before = response.bend(0)[0];
  response.advance(std::vector<glm::vec2>{{-9, 2}}, 0);
  EXPECT_EQ(response.bend(0)[0], before);
}

TEST(PlantResponse, CountsDoNotDependOnNeighboursOrChunks) {
  constexpr std::size_t kCells = 5000;  // more than two chunks, not a whole number of them
  PlantResponse many(kCells), one(1);
  for (int n = 0; n < 20; ++n) {
    std::vector<glm::vec2> wind(kCells);
    for (std::size_t i = 0; i < kCells; ++i)
      wind[i] = {std::sin(0.01f * static_cast<float>(i) + static_cast<float>(n)), 0.5f};
    many.advance(wind, 0.04);
    one.advance(std::span(wind).subspan(4321, 1), 0.04);
  }
  for (int c = 0; c < 4; ++c) EXPECT_EQ(many.bend(c)[4321], one.bend(c)[0]);
}

}  // namespace windloom
