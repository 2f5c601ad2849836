#include "engine/grass/rotors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/gpu/grass/grass_fixture.hpp"

namespace windloom {
namespace {

struct Felt {
  glm::vec3 air;    // at the place
  glm::vec3 later;  // at the height and moment
  glm::vec2 smooth, group;
};

class RotorsGpu : public testing::GrassPassTest {
 protected:
  /// xyz m, w s after `time`.
  std::vector<Felt> at(const std::vector<glm::vec4>& queries, double time) {
    gpu::Buffer asked = testing::taken(gpu::Buffer::create("test queries", std::span<const glm::vec4>(queries)));
    const std::size_t bytes = queries.size() * 3 * sizeof(glm::vec4);
    gpu::Buffer answers = testing::taken(gpu::Buffer::create("test answers", bytes, gpu::BufferUse::Static));
    gpu::Program& program = testProgram("rotor_air.comp");
    m_scene->bindFrame(time);
    asked.bindStorage(0);
    answers.bindStorage(1);
    program.dispatch(static_cast<int>(queries.size()));
    std::vector<glm::vec4> values(queries.size() * 3);
    answers.read(values.data(), bytes);
    std::vector<Felt> felt;
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const glm::vec4 winds = values[3 * i + 2];
      felt.push_back({values[3 * i], values[3 * i + 1], {winds.x, winds.y}, {winds.z, winds.w}});
    }
    return felt;
  }
};

Rotor rotorAt(glm::vec2 position, float speed = 12.0f) {
  Rotor rotor;
  rotor.id = 1;
  rotor.position = position;
  rotor.radius = 3.0f;
  rotor.speed = speed;
  return rotor;
}

std::vector<glm::vec4> places() {
  std::vector<glm::vec4> queries;
  for (int i = 0; i < 200; ++i) {
    const auto n = static_cast<float>(i);
    queries.emplace_back(9.0f * std::sin(1.7f * n), 0.01f * n, 9.0f * std::cos(2.9f * n), 0.013f * n - 1.0f);
  }
  queries.emplace_back(1.0f, 0.3f, -2.0f, 0.0f);  // right under the first rotor
  return queries;
}

TEST_F(RotorsGpu, BlowAsOnTheProcessor) {
  m_scene->rotors = {rotorAt({1.0f, -2.0f}), rotorAt({-4.0f, 3.0f}, 7.0f)};
  m_scene->blow({3.0f, -1.0f});
  const double time = 4321.7;
  const RotorBlock block = makeRotorBlock(m_scene->rotors, time);
  const std::vector<glm::vec4> queries = places();
  const std::vector<Felt> felt = at(queries, time);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const glm::vec2 place(queries[i].x, queries[i].z);
    const glm::vec3 ground = rotorAir(block, place, 0.0f);
    const glm::vec2 outwards(ground.x, ground.z);
    EXPECT_LT(glm::distance(felt[i].air, rotorAir(block, place, queries[i].y)), 1e-4f * 12.0f) << i;
    EXPECT_LT(glm::distance(felt[i].later, rotorAir(block, place, queries[i].y, queries[i].w)), 1e-4f * 12.0f) << i;
    // The field ends 8 m from its middle and is left slowly.
    if (std::max(std::abs(place.x), std::abs(place.y)) > 8.0f) continue;
    EXPECT_LT(glm::distance(felt[i].smooth, glm::vec2(3.0f, -1.0f) + outwards), 2e-3f) << i;
    EXPECT_LT(glm::distance(felt[i].group, glm::vec2(3.0f, -1.0f) + outwards), 2e-3f) << i;
  }
}

TEST_F(RotorsGpu, AddNothingWhereThereAreNone) {
  m_scene->blow({3.0f, -1.0f});
  Rotor muted = rotorAt({0.0f, 0.0f});
  muted.muted = true;
  m_scene->rotors = {muted};
  for (const Felt& felt : at({{2.0f, 1.0f, 0.5f, 0.0f}}, 1.0)) {
    EXPECT_EQ(felt.air, glm::vec3(0.0f));
    EXPECT_LT(glm::distance(felt.smooth, glm::vec2(3.0f, -1.0f)), 1e-4f);
    EXPECT_LT(glm::distance(felt.group, glm::vec2(3.0f, -1.0f)), 1e-4f);
  }
}

TEST_F(RotorsGpu, FollowTheGround) {
  m_scene->setSlope(0.25f);
  m_scene->rotors = {rotorAt({0.0f, 0.0f})};
  const RotorBlock block = makeRotorBlock(m_scene->rotors, 2.0);
  const glm::vec2 place(4.0f, 1.0f);  // the ground is 1 m high there
  const Felt felt = at({{place.x, 1.5f, place.y, 0.0f}}, 2.0).front();
  EXPECT_LT(glm::distance(felt.air, rotorAir(block, place, 0.5f)), 1.2e-3f);
}

}  // namespace
}  // namespace windloom
