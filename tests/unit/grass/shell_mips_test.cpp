// Levels of shell textures keep cover, colour and blades.
#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/grass/shell_fixture.hpp"

namespace windloom {
namespace {

using namespace testing;

struct Case {
  const char* name;
  std::function<ShellTexture()> make;
};

ShellTexture meadow(float density, int seed, int texels = 256) {
  return makeShellTexture(grassOf(density, seed), smallShell(texels), {});
}

ShellTexture varied(float taper, float thickness, float curve, float clumping) {
  ShellSettings shell = smallShell();
  shell.taper = taper;
  shell.thickness = thickness;
  shell.heightCurve = curve;
  GrassSettings grass = grassOf(400.0f, 5);
  grass.clumping = clumping;
  grass.dryness = 0.8f;
  return makeShellTexture(grass, shell, {});
}

ShellTexture ofPicture(int width, int height, const std::function<glm::u8vec4(int, int)>& pixel) {
  return shellTextureOf(pictureOf(width, height, pixel), grassOf(100.0f), smallShell());
}

std::vector<Case> cases() {
  std::vector<Case> list;
  for (const int seed : {1, 7, 1234}) {
    list.push_back({"meadow", [seed] { return meadow(100.0f, seed); }});
    list.push_back({"thin meadow", [seed] { return meadow(4.0f, seed); }});
    list.push_back({"dense meadow", [seed] { return meadow(1500.0f, seed); }});
    list.push_back({"closed meadow", [seed] { return meadow(8000.0f, seed); }});
    list.push_back(
        {"species", [seed] { return makeShellTexture(grassOf(300.0f, seed), smallShell(), threeSpecies()); }});
  }
  list.push_back({"usual size", [] { return meadow(100.0f, 3, 1024); }});
  list.push_back({"usual size, dense", [] { return meadow(700.0f, 3, 1024); }});
  list.push_back({"smallest", [] { return meadow(300.0f, 3, 64); }});
  list.push_back({"cones", [] { return varied(1.0f, 1.0f, 1.0f, 1.0f); }});
  list.push_back({"cylinders", [] { return varied(0.0f, 0.2f, 3.0f, 0.0f); }});
  const auto byte = [](std::uint32_t value) { return static_cast<std::uint8_t>(value & 255u); };
  list.push_back({"noise", [byte] {
                    return ofPicture(256, 256, [byte](int x, int y) {
                      const std::uint32_t hash = noise(x, y);
                      return glm::u8vec4(byte(hash), byte(hash >> 8), byte(hash >> 16), byte(hash >> 24));
                    });
                  }});
  list.push_back({"slope", [byte] {
                    return ofPicture(300, 200, [byte](int x, int y) {
                      const auto u = static_cast<std::uint32_t>(x), v = static_cast<std::uint32_t>(y);
                      return glm::u8vec4(byte(v), byte(u / 2), 40, byte(u * 255 / 299));
                    });
                  }});
  list.push_back({"black and white stripes", [] {
                    return ofPicture(256, 256, [](int x, int y) {
                      const auto light = static_cast<std::uint8_t>((x / 3) % 2 == 0 ? 255 : 0);
                      return glm::u8vec4(light, light, light, (y / 5) % 2 == 0 ? 255 : 0);
                    });
                  }});
  return list;
}

TEST(ShellMips, KeepCoverAtEveryHeight) {
  for (const Case& at : cases()) {
    const ShellTexture texture = at.make();
    for (const ShellLevel& level : texture.levels) {
      for (int code = 0; code < 255; ++code) {
        const float wanted = coverAbove(texture, texture.levels.front(), code),
                    cover = coverAbove(texture, level, code);
        ASSERT_NEAR(cover, wanted, 0.02f) << at.name << ", side " << level.side << ", code " << code;
        if (wanted > 0.25f) {
          ASSERT_NEAR(cover, wanted, 0.02f * wanted) << at.name << ", side " << level.side << ", code " << code;
        }
      }
    }
  }
}

TEST(ShellMips, KeepTheMeanColour) {
  for (const Case& at : cases()) {
    const ShellTexture texture = at.make();
    for (const ShellLevel& level : texture.levels) {
      if (shellCover(level, 0.0f, 1.0f) == 0.0f) continue;
      const glm::vec3 mean = shellMeanColour(level);
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(mean[c], texture.meanColour[c], 0.02f * texture.meanColour[c])
            << at.name << ", side " << level.side;
      }
    }
  }
}

TEST(ShellMips, ShowBladesThatStandWhereTheyAreShown) {
  for (const Case& at : cases()) {
    const ShellTexture texture = at.make();
    const ShellLevel& first = texture.levels.front();
    for (const ShellLevel& level : texture.levels) {
      const int width = first.side / level.side;
      for (int y = 0; y < level.side; ++y) {
        for (int x = 0; x < level.side; ++x) {
          const glm::u8vec4 form = level.form[static_cast<std::size_t>(y * level.side + x)];
          ASSERT_LE(form.r, form.g);
          if (form.r == 0) continue;
          bool found = false;
          for (int i = 0; i < width * width && !found; ++i) {
            const int u = x * width + i % width, v = y * width + i / width;
            found = bladeOf(first.form[static_cast<std::size_t>(v * first.side + u)]) == bladeOf(form);
          }
          ASSERT_TRUE(found) << at.name << ", side " << level.side << " at " << x << ", " << y;
        }
      }
    }
  }
}

TEST(ShellMips, KeepWhatIsWhere) {
  // Grass on the left only, high at the top.
  const ShellTexture texture = ofPicture(256, 256, [](int x, int y) {
    const bool grown = x < 128 && noise(x / 2, y / 2) % 3 == 0;
    return glm::u8vec4(90, 120, 30, grown ? (y < 128 ? 240 : 60) : 0);
  });
  for (const ShellLevel& level : texture.levels) {
    int grown[2][2] = {{0, 0}, {0, 0}}, elsewhere = 0;
    for (int y = 0; y < level.side; ++y) {
      for (int x = 0; x < level.side; ++x) {
        const int red = level.form[static_cast<std::size_t>(y * level.side + x)].r;
        if (red > 0) ++grown[2 * x / level.side][red > 128 ? 0 : 1];
        if (red > 128 && 2 * y >= level.side) ++elsewhere;
      }
    }
    EXPECT_EQ(grown[1][0] + grown[1][1], 0) << "side " << level.side;
    // What chance makes too few of is taken from the next lower ones.
    EXPECT_LE(elsewhere, 0.03 * grown[0][0] + 1) << "side " << level.side;
    EXPECT_NEAR(grown[0][0], grown[0][1], 0.15 * grown[0][0] + 2) << "side " << level.side;
  }
}

TEST(ShellMips, KeepTheMixOfBlades) {
  // Wide and thin blades alike: none dies out with distance, and ranks stay even.
  const ShellTexture texture = makeShellTexture(grassOf(600.0f, 2), smallShell(1024), threeSpecies());
  const auto partsOf = [](const ShellLevel& level) {
    glm::dvec4 sums(0.0);  // of blades: all, ranks, whole heights, lights of roots
    for (std::size_t i = 0; i < level.form.size(); ++i) {
      if (level.form[i].r > 0) sums += glm::dvec4(1.0, level.form[i].b, level.form[i].g, level.colour[i].a);
    }
    return sums / sums.x;
  };
  const glm::dvec4 first = partsOf(texture.levels.front());
  for (const ShellLevel& level : texture.levels) {
    const double chance = 1.0 / level.side;  // of the mean of so many texels
    const glm::dvec4 parts = partsOf(level);
    EXPECT_NEAR(parts.y, first.y, 4.0 * 75.0 * chance + 1.0) << "side " << level.side;
    EXPECT_NEAR(parts.z, first.z, 4.0 * 60.0 * chance + 1.0) << "side " << level.side;
    EXPECT_NEAR(parts.w, first.w, 4.0 * 30.0 * chance + 1.0) << "side " << level.side;
  }
}

TEST(ShellMips, BareGroundHasTheColoursOfItsNearestBlade) {
  for (const float density : {4.0f, 100.0f}) {
    const ShellTexture texture = meadow(density, 11);
    for (const ShellLevel& level : texture.levels) {
      if (shellCover(level, 0.0f, 1.0f) == 0.0f) continue;
      // Of a texel with a blade beside it: those of one of the blades beside it.
      const int mask = level.side - 1;
      for (int y = 0; y < level.side; ++y) {
        for (int x = 0; x < level.side; ++x) {
          const auto at = [&](int u, int v) { return static_cast<std::size_t>((v & mask) * level.side + (u & mask)); };
          const std::size_t i = at(x, y);
          if (level.form[i].r > 0) continue;
          bool near = false, same = false;
          for (const std::size_t other : {at(x + 1, y), at(x - 1, y), at(x, y + 1), at(x, y - 1)}) {
            near = near || level.form[other].r > 0;
            const bool alike = level.colour[other] == level.colour[i] && level.form[other].g == level.form[i].g &&
                               bladeOf(level.form[other]) == bladeOf(level.form[i]);
            same = same || alike;
          }
          ASSERT_TRUE(same) << (near ? "beside a blade" : "on open ground") << ", side " << level.side;
        }
      }
    }
  }
}

TEST(ShellMips, EachIsHalfAsWideDownToTheLeast) {
  for (const int texels : {64, 256, 1024}) {
    const ShellTexture texture = meadow(100.0f, 1, texels);
    int side = texels;
    for (const ShellLevel& level : texture.levels) {
      EXPECT_EQ(level.side, side);
      EXPECT_EQ(level.form.size(), static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
      EXPECT_EQ(level.colour.size(), level.form.size());
      side /= 2;
    }
    EXPECT_EQ(2 * side, kShellLeastSide);
  }
}

TEST(ShellMips, TakeLessThan32MiB) {
  ShellSettings shell = fullShell();
  shell.texels = 1024;
  std::size_t bytes = 0;
  for (const ShellLevel& level : makeShellTexture(grassOf(700.0f), shell, {}).levels) {
    bytes += sizeof(glm::u8vec4) * (level.form.size() + level.colour.size());
  }
  EXPECT_LE(bytes, 12u << 20);
}

}  // namespace
}  // namespace windloom
