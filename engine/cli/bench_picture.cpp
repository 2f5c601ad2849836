// How good the picture is that thinning draws: beside one in which every blade is drawn, four times as many pixels.
#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/cli/bench_project.hpp"
#include "engine/cli/bench_views.hpp"
#include "engine/io/picture_compare.hpp"

namespace windloom::cli {
namespace {

constexpr int kSquare = 16;      // pixels of the compared pictures: where brightness is looked at locally
constexpr double kMoment = 3.0;  // s: flutter is somewhere in its course

struct Shown {
  Image image;
  long long drawn = 0;  // blades
};

Image rounded(const FloatImage& picture) {
  Image image(picture.width, picture.height, picture.channels);
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = static_cast<std::uint8_t>(std::lround(picture.pixels[i]));
  return image;
}

/// Grey where they agree; four times the difference around it.
Image differenceOf(const FloatImage& picture, const FloatImage& reference) {
  FloatImage result = picture;
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = std::clamp(128.0f + 4.0f * (picture.pixels[i] - reference.pixels[i]), 0.0f, 255.0f);
  return rounded(result);
}

struct PictureBench {
  const BenchSetup& setup;
  FrameRenderer& renderer;
  gpu::Framebuffer target, large;  // with thinning; every blade
  std::vector<BenchRow> rows;

  Status add(const BenchMeadow& meadow) {
    const Project project = benchMeadow(meadow.metres, meadow.density);
    const FieldSettings& field = *project.field;
    const GridMapping grid = makeGridMapping(field.centre, field.size, field.resolution);
    const Result<gpu::Texture> wind = benchWhirls(grid);
    if (!wind) return wind.error();
    for (const BenchShot& shot : benchShots(meadow.metres)) {
      if (!setup.views.empty() && std::find(setup.views.begin(), setup.views.end(), shot.name) == setup.views.end())
        continue;
      if (Status added = addShot(meadow, shot, project, {wind->name(), grid}); !added) return added;
    }
    return Done{};
  }

  Result<Shown> shoot(const FrameInput& input, const gpu::Framebuffer& to) {
    to.clearColour({1.0f, 0.0f, 1.0f, 0.0f});
    renderer.render(input);
    glFinish();
    const FrameStats stats = renderer.render(input);  // the number of blades comes with a later frame
    const std::vector<unsigned char> rgba = to.readRgba8();
    if (rgba[3] == 0) return makeError(ErrorKind::Machine, "the picture wasn't drawn (see the log)");
    return Shown{rgbOf(to), stats.bladesDrawn};
  }

  Status addShot(const BenchMeadow& meadow, const BenchShot& shot, const Project& project, const WindTexture& wind) {
    FrameInput input = benchFrame(project, wind, shot.camera, target);
    input.time = kMoment;
    const Result<Shown> seen = shoot(input, target);
    if (!seen) return seen.error();
    input.size = large.size();
    input.framebuffer = large.name();
    input.quality = {.detail = 1.0f, .thinning = false, .culling = true, .still = true};
    const Result<Shown> every = shoot(input, large);
    if (!every) {
      rows.push_back({{"view", shot.name}, {"blades", meadow.name}, {"note", every.error().text()}});
      return Done{};
    }
    const FloatImage picture = boxFiltered(seen->image, 2), reference = boxFiltered(every->image, 4);
    const FloatImage light = lightOf(picture), expected = lightOf(reference);
    const FloatImage luma = lumaOf(picture), expectedLuma = lumaOf(reference);
    rows.push_back({{"view", shot.name},
                    {"blades", meadow.name},
                    {"ssim", meanSsim(luma, expectedLuma)},
                    {"brightness %", 100 * meanOf(light) / meanOf(expected)},
                    {"sRGB %", 100 * meanOf(luma) / meanOf(expectedLuma)},
                    {"worst square %", 100 * largestLocalError(light, expected, kSquare)},
                    {"drawn", seen->drawn},
                    {"of", every->drawn}});
    return savePictures(meadow.name + " " + shot.name, picture, reference);
  }

  [[nodiscard]] Status savePictures(std::string name, const FloatImage& picture, const FloatImage& reference) const {
    if (setup.pictures.empty()) return Done{};
    std::replace(name.begin(), name.end(), ' ', '-');
    const std::filesystem::path folder(setup.pictures);
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
      return makeError(ErrorKind::Machine, "can't make the folder " + folder.string() + ": " + failed.message());
    if (Status saved = writePng(folder / (name + "-lod.png"), rounded(picture)); !saved) return saved;
    if (Status saved = writePng(folder / (name + "-every.png"), rounded(reference)); !saved) return saved;
    return writePng(folder / (name + "-difference.png"), differenceOf(picture, reference));
  }
};

}  // namespace

Result<std::vector<BenchRow>> benchPicture(const BenchSetup& setup) {
  if (setup.context == nullptr) return std::vector<BenchRow>{};
  const bool quick = setup.size == BenchSize::Quick;
  const bool software = setup.context->info().software;
  glm::ivec2 size = setup.picture.value_or(quick      ? glm::ivec2(160, 90)
                                           : software ? glm::ivec2(640, 360)
                                                      : glm::ivec2(1920, 1080));
  size -= size % 2;  // halved below
  Result<std::unique_ptr<FrameRenderer>> renderer = FrameRenderer::create(*setup.context, *setup.shaders);
  if (!renderer) return renderer.error();
  Result<gpu::Framebuffer> target = benchTarget(size), large = benchTarget(2 * size);
  if (!target) return target.error();
  if (!large) return large.error();
  std::vector<BenchMeadow> meadows;
  // Every one of seven million blades takes minutes on a software renderer.
  const std::vector<int> own = software ? std::vector{1} : std::vector{1, 7, 100};
  for (const int millions : setup.blades.empty() ? own : setup.blades) meadows.push_back(benchMeadowOf(millions));
  if (quick) meadows = {{"2 k", 10, 20}};
  PictureBench bench{setup, **renderer, std::move(*target), std::move(*large), {}};
  for (const BenchMeadow& meadow : meadows) {
    if (Status added = bench.add(meadow); !added) return added.error();
  }
  return std::move(bench.rows);
}

}  // namespace windloom::cli
