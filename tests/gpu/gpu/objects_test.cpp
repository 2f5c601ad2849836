#include <array>
#include <cstring>
#include <numeric>
#include <vector>

#include "engine/gpu/buffer.hpp"
#include "engine/gpu/debug_group.hpp"
#include "engine/gpu/framebuffer.hpp"
#include "engine/gpu/memory.hpp"
#include "engine/gpu/pass_state.hpp"
#include "engine/gpu/readback.hpp"
#include "engine/gpu/texture.hpp"
#include "engine/gpu/timer.hpp"
#include "engine/gpu/vertex_array.hpp"
#include "tests/gpu/gpu_test.hpp"

namespace windloom::gpu {
namespace {

class GpuBuffer : public windloom::testing::GpuTest {};
class GpuTexture : public windloom::testing::GpuTest {};
class GpuFramebuffer : public windloom::testing::GpuTest {};
class GpuReadback : public windloom::testing::GpuTest {};
class GpuTiming : public windloom::testing::GpuTest {};

std::vector<float> ramp(std::size_t count) {
  std::vector<float> values(count);
  std::iota(values.begin(), values.end(), 1.0f);
  return values;
}

TEST_F(GpuBuffer, GivesBackWhatWasWritten) {
  const std::vector<float> values = ramp(37);
  auto buffer = Buffer::create<float>("round trip", values, BufferUse::Dynamic);
  ASSERT_TRUE(buffer.ok()) << buffer.error().text();
  const std::array<float, 2> patch = {-1.0f, -2.0f};
  buffer->write<float>(patch, 4 * sizeof(float));
  std::vector<float> back(37);
  buffer->read(back.data(), 37 * sizeof(float));
  EXPECT_EQ(back[3], 4.0f);
  EXPECT_EQ(back[4], -1.0f);
  EXPECT_EQ(back[5], -2.0f);
  EXPECT_EQ(back[36], 37.0f);
}

TEST_F(GpuBuffer, StartsAsZerosWithoutData) {
  auto buffer = Buffer::create("zeros", 10, BufferUse::Static);
  ASSERT_TRUE(buffer.ok());
  std::array<unsigned char, 10> back;
  back.fill(7);
  buffer->read(back.data(), back.size());
  EXPECT_EQ(back, (std::array<unsigned char, 10>{}));
}

TEST_F(GpuBuffer, MovingLeavesOneOwner) {
  auto made = Buffer::create("moved", 16, BufferUse::Static);
  ASSERT_TRUE(made.ok());
  Buffer first = std::move(*made);
  const GLuint name = first.name();
  {
    Buffer second = std::move(first);
    EXPECT_EQ(second.name(), name);
    EXPECT_EQ(first.name(), 0u);
  }
  EXPECT_EQ(glIsBuffer(name), GL_FALSE);
}

TEST_F(GpuTexture, GivesBackWhatWasUploaded) {
  const std::vector<float> values = ramp(7 * 5 * 2);
  auto texture = Texture::create2D("round trip", {7, 5}, GL_RG32F, {.filter = Filter::Nearest});
  ASSERT_TRUE(texture.ok()) << texture.error().text();
  texture->upload(GL_RG, GL_FLOAT, values.data());
  std::vector<float> back(values.size());
  texture->read(GL_RG, GL_FLOAT, back.data(), back.size() * sizeof(float));
  EXPECT_EQ(back, values);
  texture->clear();
  texture->read(GL_RG, GL_FLOAT, back.data(), back.size() * sizeof(float));
  EXPECT_EQ(back, std::vector<float>(values.size(), 0.0f));
}

TEST_F(GpuTexture, ArrayLayersAndVolumeSlicesKeepTheirOrder) {
  auto array = Texture::createArray("layers", {2, 2}, 3, GL_R32F);
  auto volume = Texture::create3D("volume", {2, 2, 3}, GL_R32F);
  ASSERT_TRUE(array.ok() && volume.ok());
  for (Texture* texture : {&*array, &*volume}) {
    for (int layer = 0; layer < 3; ++layer) {
      const std::vector<float> values(4, static_cast<float>(layer));
      texture->uploadLayer(layer, GL_RED, GL_FLOAT, values.data());
    }
    std::vector<float> back(12);
    texture->read(GL_RED, GL_FLOAT, back.data(), back.size() * sizeof(float));
    EXPECT_EQ(back[0], 0.0f);
    EXPECT_EQ(back[5], 1.0f);
    EXPECT_EQ(back[11], 2.0f);
  }
}

TEST_F(GpuTexture, RefusesASizeOverTheLimit) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  const auto texture = Texture::create2D("too large", {limit + 1, 4}, GL_R8);
  ASSERT_FALSE(texture.ok());
  EXPECT_EQ(texture.error().kind, ErrorKind::Machine);
  EXPECT_NE(texture.error().text().find("too large"), std::string::npos);
}

TEST_F(GpuTexture, KnowsItsBytes) {
  const auto bytesOf = [](const Result<Texture>& texture) { return texture.ok() ? texture->bytes() : 0u; };
  EXPECT_EQ(bytesOf(Texture::create2D("size", {30, 20}, GL_RG32F)), 30u * 20u * 8u);
  EXPECT_EQ(bytesOf(Texture::create2D("size", {8, 4}, GL_R16F, {.levels = 0})), (32u + 8u + 2u + 1u) * 2u);
  EXPECT_EQ(bytesOf(Texture::createArray("size", {8, 4}, 3, GL_RGBA8, {.levels = 2})), (32u + 8u) * 3u * 4u);
  EXPECT_EQ(bytesOf(Texture::create3D("size", {8, 8, 8}, GL_RGBA16F, {.levels = 2})), (512u + 64u) * 8u);
  EXPECT_EQ(bytesOf(Texture::createMultisampled("size", {16, 16}, GL_DEPTH_COMPONENT32F, 4)), 256u * 4u * 4u);
}

class GpuMemory : public windloom::testing::GpuTest {};

TEST_F(GpuMemory, CountsBuffersAndTexturesByTheirLabel) {
  const std::size_t before = bytesInUse();
  {
    auto one = Buffer::create("memory test one", 1000, BufferUse::Static);
    auto two = Buffer::create("memory test two", 24, BufferUse::Dynamic);
    auto picture = Texture::create2D("memory test picture", {10, 10}, GL_RGBA8);
    ASSERT_TRUE(one.ok() && two.ok() && picture.ok());
    EXPECT_EQ(bytesInUse("memory test"), 1424u);
    EXPECT_EQ(bytesInUse("memory test t"), 24u);
    EXPECT_EQ(bytesInUse("memory tests"), 0u);
    EXPECT_EQ(bytesByLabel().at("memory test one"), 1000u);
    EXPECT_EQ(bytesByLabel().count("memory tests"), 0u);
    EXPECT_EQ(bytesInUse(), before + 1424u);
    const Buffer moved = std::move(*one);
    EXPECT_EQ(bytesInUse("memory test one"), 1000u) << "still one buffer";
    *picture = Texture();
    EXPECT_EQ(bytesInUse("memory test p"), 0u);
    EXPECT_EQ(bytesByLabel().count("memory test picture"), 0u);
    auto another = Buffer::create("memory test one", 500, BufferUse::Static);
    ASSERT_TRUE(another.ok());
    *two = std::move(*another);
    EXPECT_EQ(bytesInUse("memory test"), 1500u) << "what it replaced is gone";
  }
  EXPECT_EQ(bytesInUse("memory test"), 0u);
  EXPECT_EQ(bytesInUse(), before);
}

TEST_F(GpuFramebuffer, ResolvesSamplesAndReadsTopRowFirst) {
  auto many = Framebuffer::create("many", {4, 2}, {.colour = GL_RGBA8, .samples = 4});
  auto one = Framebuffer::create("one", {4, 2}, {.colour = GL_RGBA8});
  ASSERT_TRUE(many.ok() && one.ok());
  many->clearColour({0, 0, 1, 1});
  many->clearDepth(0.25f);
  apply({.framebuffer = many->name(), .viewport = {0, 0, 4, 2}, .scissor = glm::ivec4(0, 0, 4, 1)});
  const float red[] = {1, 0, 0, 1};
  glClearBufferfv(GL_COLOR, 0, red);
  many->resolveTo(*one);
  const std::vector<unsigned char> pixels = one->readRgba8();
  EXPECT_EQ(pixels[0], 0);  // top: blue
  EXPECT_EQ(pixels[2], 255);
  EXPECT_EQ(pixels[16], 255);  // bottom: red
  EXPECT_EQ(pixels[18], 0);
  std::vector<float> depths(8);
  one->depth().read(GL_DEPTH_COMPONENT, GL_FLOAT, depths.data(), depths.size() * sizeof(float));
  EXPECT_FLOAT_EQ(depths[5], 0.25f);
}

TEST_F(GpuReadback, BringsTheNewestAndDropsRequestsWhenFull) {
  auto buffer = Buffer::create("source", 4, BufferUse::Dynamic);
  auto ring = ReadbackRing::create("ring", 4, 2);
  ASSERT_TRUE(buffer.ok() && ring.ok());
  const auto send = [&](float value, long tag) {
    buffer->write(&value, sizeof value);
    return ring->request(*buffer, 0, sizeof value, tag);
  };
  EXPECT_TRUE(send(1.0f, 1));
  EXPECT_TRUE(send(2.0f, 2));
  EXPECT_FALSE(send(3.0f, 3));
  const auto arrival = ring->finish();
  ASSERT_TRUE(arrival.has_value());
  EXPECT_EQ(arrival->tag, 2);
  EXPECT_EQ(*reinterpret_cast<const float*>(arrival->bytes.data()), 2.0f);
  EXPECT_FALSE(ring->poll().has_value());
  EXPECT_TRUE(send(4.0f, 4));
  glFinish();
  const auto next = ring->poll();
  ASSERT_TRUE(next.has_value());
  EXPECT_EQ(next->tag, 4);
}

TEST_F(GpuReadback, ReadsTextures) {
  const std::vector<float> values = ramp(6);
  auto texture = Texture::create2D("source", {3, 2}, GL_R32F);
  auto ring = ReadbackRing::create("ring", 6 * sizeof(float));
  ASSERT_TRUE(texture.ok() && ring.ok());
  texture->upload(GL_RED, GL_FLOAT, values.data());
  ASSERT_TRUE(ring->request(*texture, GL_RED, GL_FLOAT, 9));
  const auto arrival = ring->finish();
  ASSERT_TRUE(arrival.has_value());
  EXPECT_EQ(0, std::memcmp(arrival->bytes.data(), values.data(), arrival->bytes.size()));
}

TEST_F(GpuTiming, NamesStagesInOrderAndMeasuresThem) {
  GpuTimer timer(2);
  EXPECT_TRUE(timer.stages().empty());
  auto buffer = Buffer::create("work", 1 << 20, BufferUse::Static);
  ASSERT_TRUE(buffer.ok());
  for (int frame = 0; frame < 5; ++frame) {
    const DebugGroup group("timed work");
    timer.beginFrame();
    timer.stage("clear");
    buffer->clear();
    timer.stage("nothing");
    timer.endFrame();
  }
  timer.finish();
  ASSERT_EQ(timer.stages().size(), 2u);
  EXPECT_EQ(timer.stages()[0].first, "clear");
  EXPECT_EQ(timer.stages()[1].first, "nothing");
  EXPECT_NEAR(timer.stages()[0].second + timer.stages()[1].second, timer.totalMs(), 1e-6);
  EXPECT_GE(timer.totalMs(), 0.0);
}

}  // namespace
}  // namespace windloom::gpu
