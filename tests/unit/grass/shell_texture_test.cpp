// The blades that shell textures are cut through, and textures from pictures.
#include "engine/grass/shell_texture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <thread>

#include "engine/grass/shell_blades.hpp"
#include "engine/grass/shell_clumps.hpp"
#include "engine/grass/shell_colour.hpp"
#include "tests/unit/grass/shell_fixture.hpp"

namespace windloom {
namespace {

using namespace testing;

float coverOf(const ShellTexture& texture) {
  return texture.cover.front();
}

ShellTexture meadow(const std::function<void(GrassSettings&, ShellSettings&)>& change) {
  GrassSettings grass = grassOf(100.0f);
  ShellSettings shell = smallShell();
  change(grass, shell);
  return makeShellTexture(grass, shell, {});
}

TEST(ShellTexture, HasAsManyBladesAsAsked) {
  GrassSettings grass = grassOf(100.0f);
  ShellSettings shell;
  EXPECT_EQ(makeShellTexture(grass, shell, {}).blades, 100 * 8 * 16);
  shell.fullness = 2.0f;
  shell.tile = 3.0f;
  EXPECT_EQ(makeShellTexture(grass, shell, {}).blades, 100 * 2 * 9);
  // Flowers and hidden species take their share of the density, as in the instanced grass.
  std::vector<Species> species(2);
  species[0].shape = PlantShape::Daisy;
  species[0].weight = 1.0f;
  species[1].weight = 1.0f;
  EXPECT_EQ(makeShellTexture(grass, shell, species).blades, 1200);
  species[1].hidden = true;
  EXPECT_EQ(makeShellTexture(grass, shell, species).blades, 600);
}

TEST(ShellTexture, TexelsAreInOrder) {
  for (const int texels : {1, 64, 100, 400, 1024, 5000}) {
    const ShellTexture texture = meadow([&](GrassSettings&, ShellSettings& shell) { shell.texels = texels; });
    const ShellLevel& first = texture.levels.front();
    EXPECT_TRUE(first.side >= 64 && first.side <= 1024 && (first.side & (first.side - 1)) == 0);
    int highest = 0;
    for (const glm::u8vec4 form : first.form) {
      ASSERT_LE(form.r, form.g);
      ASSERT_LE(form.b, 254);
      ASSERT_GT(form.g, 0);
      highest = std::max<int>(highest, form.g);
    }
    EXPECT_GT(highest, 200) << "the tallest blades nearly reach the tallest height";
  }
  const auto sideFor = [](int texels) {
    return meadow([&](GrassSettings&, ShellSettings& shell) { shell.texels = texels; }).levels.front().side;
  };
  EXPECT_EQ(sideFor(300), 256);
  EXPECT_EQ(sideFor(400), 512);
}

TEST(ShellTexture, EachBladeHasItsWholeHeightSomewhere) {
  const ShellTexture texture = meadow([](GrassSettings& grass, ShellSettings& shell) {
    grass.density = 20.0f;
    shell.taper = 1.0f;
  });
  std::map<std::tuple<int, int, int>, int> highest;
  for (const glm::u8vec4 form : texture.levels.front().form) {
    int& red = highest[{form.g, form.b, form.a}];
    red = std::max<int>(red, form.r);
  }
  EXPECT_NEAR(static_cast<double>(highest.size()), static_cast<double>(texture.blades), 4.0);
  for (const auto& [blade, red] : highest) EXPECT_EQ(red, std::get<0>(blade));
}

TEST(ShellTexture, CoverFallsWithHeight) {
  const ShellTexture texture = meadow([](GrassSettings&, ShellSettings&) {});
  for (std::size_t i = 1; i < texture.cover.size(); ++i) EXPECT_LE(texture.cover[i], texture.cover[i - 1]);
  EXPECT_GT(texture.cover.front(), 0.05f);
  EXPECT_LT(texture.cover.back(), 0.02f);
  for (const int i : {0, 13, 40}) {
    EXPECT_EQ(texture.cover[static_cast<std::size_t>(i)],
              shellCover(texture.levels.front(), static_cast<float>(i) / kShellCovers, texture.heightCurve));
  }
  EXPECT_EQ(shellCover(texture.levels.front(), 1.0f, texture.heightCurve), 0.0f);
}

TEST(ShellTexture, SettingsChangeTheCover) {
  const float usual = coverOf(meadow([](GrassSettings&, ShellSettings&) {}));
  // 800 blades a square metre of 22 mm by 8.8 mm.
  EXPECT_NEAR(usual, 1.0f - std::exp(-0.785f * 800.0f * 0.022f * 0.0088f), 0.012f);
  const auto change = [&](auto&& what) { return coverOf(meadow(what)) / usual; };
  EXPECT_NEAR(change([](GrassSettings&, ShellSettings& shell) { shell.thickness = 0.8f; }), 1.9f, 0.15f);
  EXPECT_NEAR(change([](GrassSettings&, ShellSettings& shell) { shell.fullness = 16.0f; }), 1.9f, 0.15f);
  EXPECT_NEAR(change([](GrassSettings& grass, ShellSettings&) { grass.density = 50.0f; }), 0.52f, 0.05f);
  EXPECT_NEAR(change([](GrassSettings& grass, ShellSettings&) { grass.width = 0.044f; }), 3.3f, 0.4f);
}

TEST(ShellTexture, TaperThinsTheUpperPartOnly) {
  const auto coverAt = [](float taper, std::size_t part) {
    return meadow([&](GrassSettings& grass, ShellSettings& shell) {
             shell.taper = taper;
             grass.width = 0.05f;
             grass.heightVariation = 0.0f;
           })
        .cover[part];
  };
  EXPECT_NEAR(coverAt(0.0f, 48), coverAt(0.0f, 0), 1e-6f) << "a cylinder";
  // At half of the height half axes are 1 - taper 0.35 of those at the root, and blades overlap.
  EXPECT_NEAR(coverAt(1.0f, 32) / coverAt(1.0f, 0), 0.5f, 0.1f);
  EXPECT_NEAR(coverAt(0.6f, 32) / coverAt(0.6f, 0), 0.68f, 0.1f);
  EXPECT_LT(coverAt(1.0f, 60), 0.12f * coverAt(1.0f, 0));
  EXPECT_NEAR(coverAt(1.0f, 0), coverAt(0.0f, 0), 0.03f);
}

TEST(ShellTexture, CoverDoesntDependOnTheNumberOfTexels) {
  const auto cover = [](int texels) {
    return coverOf(meadow([&](GrassSettings& grass, ShellSettings& shell) {
      grass.density = 300.0f;
      shell.tile = 4.0f;
      shell.texels = texels;
    }));
  };
  const float fine = cover(1024);
  for (const int texels : {64, 128, 256, 512}) EXPECT_NEAR(cover(texels), fine, 0.15f * fine) << texels;
}

/// Mean difference of heights between neighbours across column (or row) `at` and the next.
double differenceAcross(const ShellLevel& level, int at, bool columns) {
  double sum = 0;
  for (int i = 0; i < level.side; ++i) {
    const int next = (at + 1) % level.side;
    const auto red = [&](int line) -> int {
      return level.form[static_cast<std::size_t>(columns ? i * level.side + line : line * level.side + i)].r;
    };
    sum += std::abs(red(at) - red(next));
  }
  return sum / level.side;
}

TEST(ShellTexture, WrapsAroundWithoutASeam) {
  const ShellTexture texture = makeShellTexture(grassOf(300.0f), ShellSettings{}, {});
  for (std::size_t n = 0; n < 3; ++n) {
    const ShellLevel& level = texture.levels[n];
    for (const bool columns : {false, true}) {
      double mean = 0, square = 0;
      for (int at = 0; at < level.side - 1; ++at) {
        const double difference = differenceAcross(level, at, columns);
        mean += difference / (level.side - 1);
        square += difference * difference / (level.side - 1);
      }
      EXPECT_NEAR(differenceAcross(level, level.side - 1, columns), mean, 4.0 * std::sqrt(square - mean * mean))
          << "side " << level.side;
    }
  }
}

TEST(ShellTexture, BladesGoOnOverTheEdges) {
  // One blade a third of the tile wide: as large wherever it stands.
  std::map<long long, int> seen;
  for (int seed = 1; seed <= 12; ++seed) {
    GrassSettings grass = grassOf(0.0f, seed);
    grass.width = 0.33f;
    ShellSettings shell = smallShell();
    shell.thickness = 1.0f;
    const ShellTexture texture = makeShellTexture(grass, shell, {});
    EXPECT_EQ(texture.blades, 1);
    EXPECT_NEAR(coverOf(texture), 0.085f, 0.045f) << "seed " << seed;
    // Each texel of the same blade.
    std::set<std::tuple<int, int>> blades;
    for (const glm::u8vec4 form : texture.levels.front().form) blades.insert(bladeOf(form));
    EXPECT_EQ(blades.size(), 1u);
  }
}

TEST(ShellTexture, ExtremesWork) {
  EXPECT_EQ(meadow([](GrassSettings& grass, ShellSettings&) { grass.density = 0.0f; }).blades, 1);
  EXPECT_EQ(meadow([](GrassSettings&, ShellSettings& shell) { shell.tile = 0.001f; }).blades, 1);
  const ShellTexture wide = meadow([](GrassSettings& grass, ShellSettings&) { grass.width = 1.0f; });
  EXPECT_GT(coverOf(wide), 0.99f);
  EXPECT_LT(wide.blades, 100) << "more of them would lie on one another";
  const ShellTexture thin = meadow([](GrassSettings& grass, ShellSettings& shell) {
    grass.width = 0.001f;
    shell.thickness = 0.05f;
  });
  EXPECT_GT(coverOf(thin), 0.0f);
  EXPECT_LT(coverOf(thin), 0.02f);
  const ShellTexture low = meadow([](GrassSettings& grass, ShellSettings&) { grass.height = 0.01f; });
  EXPECT_NEAR(low.tallestM, 0.0135f, 1e-5f);
}

TEST(ShellTexture, ManyBladesAreFewerAndWider) {
  GrassSettings grass = grassOf(20'000.0f);
  grass.width = 0.002f;
  ShellSettings shell;
  const ShellBlades many = growShellBlades(grass, shell, {}, 0.0001f);
  EXPECT_EQ(many.blades.size(), 400'000u);
  double area = 0;
  for (const ShellBlade& blade : many.blades) area += 3.14159265 * static_cast<double>(blade.radii.x * blade.radii.y);
  const double wanted = 20'000.0 * 8.0 * 16.0 * 3.14159265 * 0.001 * 0.0004;
  EXPECT_NEAR(area, wanted, 0.05 * wanted);
}

TEST(ShellTexture, IsTheSameEachTimeAndOnAnyThread) {
  const auto make = [] { return makeShellTexture(grassOf(200.0f, 42), smallShell(), threeSpecies()); };
  const ShellTexture once = make();
  EXPECT_TRUE(sameBytes(once, make()));
  ShellTexture other[2];
  std::thread first([&] { other[0] = make(); }), second([&] { other[1] = make(); });
  first.join();
  second.join();
  EXPECT_TRUE(sameBytes(once, other[0]));
  EXPECT_TRUE(sameBytes(once, other[1]));
  EXPECT_FALSE(sameBytes(once, makeShellTexture(grassOf(200.0f, 43), smallShell(), threeSpecies())));
}

TEST(ShellBlades, RanksAreEvenAndAnyPartCoversTheTile) {
  const ShellBlades grown = growShellBlades(grassOf(100.0f), ShellSettings{}, {}, 0.004f);
  std::array<int, 256> ranks{};
  for (const ShellBlade& blade : grown.blades) ++ranks[blade.rank];
  EXPECT_EQ(ranks[255], 0) << "all grow where all are kept";
  for (std::size_t i = 0; i < 255; ++i) EXPECT_NEAR(ranks[i], 12800.0 / 255.0, 1.0);
  // Blades of the lower half of ranks in an 8 x 8 raster: as many everywhere.
  std::array<int, 64> cells{};
  for (const ShellBlade& blade : grown.blades) {
    const glm::ivec2 cell(blade.root * 2.0f);
    if (blade.rank < 128) ++cells[static_cast<std::size_t>(cell.y * 8 + cell.x)];
  }
  for (const int count : cells) EXPECT_NEAR(count, 100, 4);
}

TEST(ShellBlades, HeightsAreSpreadAsTheMeadows) {
  const ShellBlades grown = growShellBlades(grassOf(100.0f), ShellSettings{}, {}, 0.004f);
  double mean = 0, least = 1e9, most = 0;
  for (const ShellBlade& blade : grown.blades) {
    const auto height = static_cast<double>(blade.height);
    mean += height / static_cast<double>(grown.blades.size());
    least = std::min(least, height);
    most = std::max(most, height);
  }
  EXPECT_NEAR(mean, 0.55, 0.02);
  EXPECT_GE(least, 0.55 * 0.65);
  EXPECT_LE(most, static_cast<double>(grown.tallestM));
  EXPECT_GT(most - least, 0.55 * 0.55);
  EXPECT_NEAR(grown.tallestM, 0.55f * 1.35f, 1e-5f);
}

/// How alike blades that stand within 0.1 m of each other are in height: 0 as any two, 1 the same.
double alikeness(float clumping) {
  GrassSettings grass = grassOf(20.0f);
  grass.clumping = clumping;
  const std::vector<ShellBlade> blades = growShellBlades(grass, ShellSettings{}, {}, 0.004f).blades;
  double mean = 0, variance = 0, together = 0;
  int pairs = 0;
  const auto height = [](const ShellBlade& blade) { return static_cast<double>(blade.height); };
  for (const ShellBlade& blade : blades) mean += height(blade) / static_cast<double>(blades.size());
  for (const ShellBlade& a : blades) {
    variance += (height(a) - mean) * (height(a) - mean) / static_cast<double>(blades.size());
    for (const ShellBlade& b : blades) {
      if (&a == &b || glm::distance(a.root, b.root) > 0.1f) continue;
      together += (height(a) - mean) * (height(b) - mean);
      ++pairs;
    }
  }
  return together / pairs / variance;
}

TEST(ShellBlades, ClumpsShareTheirHeight) {
  EXPECT_NEAR(alikeness(0.0f), 0.0, 0.05);
  EXPECT_GT(alikeness(1.0f), 0.3);
}

TEST(ShellClumps, AreEvenAndUnlikeTheirNeighbours) {
  for (const std::uint32_t seed : {1u, 2u, 3u, 99u}) {
    const ShellClumps clumps(4.0f, seed);
    const int cells = clumps.cells();
    ASSERT_EQ(cells, 5);
    std::vector<float> values;
    double together = 0, apart = 0;
    for (int i = 0; i < cells * cells; ++i) {
      const auto value = [&](int x, int y) {
        const int at = (y + cells) % cells * cells + (x + cells) % cells;
        return static_cast<double>(clumps.all()[static_cast<std::size_t>(at)].bright) - 0.5;
      };
      const int x = i % cells, y = i / cells;
      values.push_back(clumps.all()[static_cast<std::size_t>(i)].bright);
      together += value(x, y) * (value(x + 1, y) + value(x, y + 1)) / 2.0;
      apart += value(x, y) * value(x, y);
    }
    EXPECT_LT(together, -0.1 * apart) << "seed " << seed;
    std::ranges::sort(values);
    for (std::size_t n = 0; n < values.size(); ++n) {
      EXPECT_NEAR(values[n], (static_cast<double>(n) + 0.5) / 25.0, 0.021) << "seed " << seed;
    }
  }
}

TEST(ShellClumps, WrapAround) {
  const ShellClumps clumps(3.0f, 5);
  for (int i = 0; i < 40; ++i) {
    const glm::vec2 place(0.025f * static_cast<float>(i), 0.375f);
    EXPECT_EQ(&clumps.at(place), &clumps.at(place + glm::vec2(1.0f, -2.0f)));
  }
  EXPECT_EQ(ShellClumps(0.01f, 5).all().size(), 1u);
  EXPECT_EQ(ShellClumps(1000.0f, 5).cells(), 40);
}

TEST(ShellBlades, SpeciesShareTheTileByTheirWeights) {
  const std::vector<Species> species = threeSpecies();
  const ShellBlades grown = growShellBlades(grassOf(100.0f), ShellSettings{}, species, 0.001f);
  double tall = 0, low = 0;
  for (const ShellBlade& blade : grown.blades) {
    if (blade.colour.b > blade.colour.r) ++low;
    if (blade.height > 0.8f) ++tall;
  }
  const auto all = static_cast<double>(grown.blades.size());
  EXPECT_NEAR(low / all, 0.25 / 1.75, 0.02);
  EXPECT_NEAR(tall / all, 0.5 / 1.75, 0.02);
  EXPECT_NEAR(grown.tallestM, 1.2f * 1.3f, 1e-5f);
}

TEST(ShellBlades, DrynessLeansSomeToTheDryColour) {
  const auto redOverGreen = [](float dryness) {
    GrassSettings grass = grassOf(100.0f);
    grass.dryness = dryness;
    glm::vec3 sum(0.0f);
    for (const ShellBlade& blade : growShellBlades(grass, ShellSettings{}, {}, 0.004f).blades) sum += blade.colour;
    return sum.r / sum.g;
  };
  EXPECT_NEAR(redOverGreen(0.0f), 0.30f / 0.42f, 0.03f);
  EXPECT_GT(redOverGreen(0.5f), redOverGreen(0.25f));
  EXPECT_GT(redOverGreen(1.0f), 0.95f);
}

ShellTexture ofPicture(const GrassMap& picture) {
  return shellTextureOf(picture, grassOf(100.0f), smallShell());
}

TEST(ShellPicture, AnySizeBecomesATexture) {
  for (const glm::ivec2 size :
       {glm::ivec2(1), glm::ivec2(3, 5), glm::ivec2(2048, 7), glm::ivec2(300), glm::ivec2(1500, 2048)}) {
    const ShellTexture texture =
        ofPicture(pictureOf(size.x, size.y, [](int, int) { return glm::u8vec4(80, 140, 20, 200); }));
    ASSERT_EQ(texture.levels.front().side, 256);
    EXPECT_EQ(texture.blades, 1);
    for (const ShellLevel& level : texture.levels) {
      for (std::size_t i = 0; i < level.form.size(); ++i) {
        ASSERT_EQ(level.form[i].r, 200);
        ASSERT_EQ(level.form[i].g, 200);
        ASSERT_EQ(glm::u8vec3(level.colour[i]), glm::u8vec3(80, 140, 20));
      }
    }
    EXPECT_FLOAT_EQ(texture.tallestM, 0.55f * 1.35f);
    EXPECT_FLOAT_EQ(texture.tileM, 1.0f);
  }
}

TEST(ShellPicture, WhatHangsTogetherIsABlade) {
  // A bar over the left and right edge, one over the top and bottom edge, and one that touches it at a corner only.
  const ShellTexture texture = ofPicture(pictureOf(256, 256, [](int x, int y) {
    const bool across = (x < 8 || x >= 240) && y >= 100 && y < 110;
    const bool down = (y < 20 || y >= 250) && x >= 60 && x < 70;
    const bool corner = x >= 70 && x < 80 && y >= 20 && y < 30;
    const int high = across ? (x < 8 ? 50 : 150) : down ? 80 : corner ? 255 : 0;
    return glm::u8vec4(x, y, 0, high);
  }));
  EXPECT_EQ(texture.blades, 3);
  const auto form = [&](int x, int y) { return texture.levels.front().form[static_cast<std::size_t>(y * 256 + x)]; };
  EXPECT_EQ(form(3, 105).r, 50);
  EXPECT_EQ(form(3, 105).g, 150) << "the other half of it is higher";
  EXPECT_EQ(bladeOf(form(3, 105)), bladeOf(form(250, 105)));
  EXPECT_EQ(bladeOf(form(65, 5)), bladeOf(form(65, 253)));
  EXPECT_EQ(form(65, 5).g, 80);
  EXPECT_EQ(form(75, 25).g, 255);
  EXPECT_EQ(form(20, 105).r, 0);
  EXPECT_EQ(form(20, 105).g, 150) << "bare ground beside it";
  EXPECT_EQ(texture.levels.front().colour[105u * 256u + 250u].r, 250);
}

TEST(ShellPicture, ThinBladesAreKeptWhenItIsMadeSmaller) {
  const ShellTexture texture = ofPicture(pictureOf(1024, 1024, [](int x, int y) {
    return x % 64 == 13 && y % 64 == 21 ? glm::u8vec4(250, 10, 10, 180) : glm::u8vec4(0);
  }));
  EXPECT_EQ(texture.blades, 256);
  EXPECT_NEAR(texture.meanColour.r, 0.956f, 0.01f);
  std::array<int, 256> ranks{};
  for (const glm::u8vec4 form : texture.levels.front().form) {
    if (form.r > 0) ++ranks[form.b];
  }
  for (std::size_t i = 0; i < 255; ++i) EXPECT_NEAR(ranks[i], 256.0 / 255.0, 1.01);
}

TEST(ShellPicture, WithoutGrassIsBare) {
  const ShellTexture texture = ofPicture(pictureOf(40, 30, [](int, int) { return glm::u8vec4(10, 200, 30, 0); }));
  EXPECT_EQ(texture.blades, 0);
  EXPECT_EQ(coverOf(texture), 0.0f);
  for (const ShellLevel& level : texture.levels) {
    for (const glm::u8vec4 form : level.form) ASSERT_EQ(form.r, 0);
  }
  EXPECT_GT(texture.meanColour.g, texture.meanColour.r);
}

TEST(ShellColour, CodesAreTheNearestLight) {
  const SrgbCodes codes;
  for (int code = 0; code < 256; ++code) {
    const auto byte = static_cast<std::uint8_t>(code);
    EXPECT_EQ(codes.code(codes.linear(byte)), byte);
  }
  EXPECT_EQ(codes.code(-1.0f), 0);
  EXPECT_EQ(codes.code(7.0f), 255);
  EXPECT_NEAR(codes.linear(std::uint8_t{188}), 0.5f, 0.005f);
}

}  // namespace
}  // namespace windloom
