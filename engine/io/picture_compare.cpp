#include "engine/io/picture_compare.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

constexpr int kWindow = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = 0.01 * 255 * 0.01 * 255, kC2 = 0.03 * 255 * 0.03 * 255;

using Plane = BasicImage<double>;

template <class Of>
FloatImage channelOf(const FloatImage& picture, const Of& of) {
  WL_REQUIRE(picture.channels >= 3, "a picture in colour");
  FloatImage result(picture.width, picture.height, 1);
  for (std::size_t i = 0; i < result.pixels.size(); ++i)
    result.pixels[i] = of(picture.pixels.data() + i * static_cast<std::size_t>(picture.channels));
  return result;
}

float decodeSrgb(float value) {
  const float v = value / 255.0f;
  return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

std::array<double, kWindow> gaussian() {
  std::array<double, kWindow> weights{};
  for (int i = 0; i < kWindow; ++i) {
    const double x = (i - kWindow / 2) / kSigma;
    weights[static_cast<std::size_t>(i)] = std::exp(-0.5 * x * x);
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Weighted means of all windows of f(pixel of a, pixel of b) that lie in the picture, first along x, then along y.
template <class Of>
Plane windowMeans(const FloatImage& a, const FloatImage& b, const Of& of) {
  static const std::array<double, kWindow> kWeights = gaussian();
  Plane rows(a.width - kWindow + 1, a.height, 1), result(rows.width, a.height - kWindow + 1, 1);
  for (int y = 0; y < rows.height; ++y) {
    for (int x = 0; x < rows.width; ++x) {
      for (int i = 0; i < kWindow; ++i)
        *rows.at(x, y) += kWeights[static_cast<std::size_t>(i)] *
                          of(static_cast<double>(*a.at(x + i, y)), static_cast<double>(*b.at(x + i, y)));
    }
  }
  for (int y = 0; y < result.height; ++y) {
    for (int i = 0; i < kWindow; ++i) {
      for (int x = 0; x < result.width; ++x)
        *result.at(x, y) += kWeights[static_cast<std::size_t>(i)] * *rows.at(x, y + i);
    }
  }
  return result;
}

double meanOver(const FloatImage& picture, int left, int top, int right, int bottom) {
  double sum = 0;
  for (int y = top; y < bottom; ++y)
    sum = std::accumulate(picture.at(left, y), picture.at(left, y) + (right - left), sum);
  return sum / (static_cast<double>(right - left) * (bottom - top));
}

}  // namespace

FloatImage boxFiltered(const Image& picture, int side) {
  WL_REQUIRE(side > 0 && picture.width % side == 0 && picture.height % side == 0, "the squares fill the picture");
  FloatImage result(picture.width / side, picture.height / side, picture.channels);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      for (int c = 0; c < picture.channels; ++c) result.at(x / side, y / side)[c] += picture.at(x, y)[c];
    }
  }
  for (float& sample : result.pixels) sample /= static_cast<float>(side * side);
  return result;
}

FloatImage lumaOf(const FloatImage& picture) {
  return channelOf(picture, [](const float* rgb) { return 0.299f * rgb[0] + 0.587f * rgb[1] + 0.114f * rgb[2]; });
}

FloatImage lightOf(const FloatImage& picture) {
  return channelOf(picture, [](const float* rgb) {
    return 0.2126f * decodeSrgb(rgb[0]) + 0.7152f * decodeSrgb(rgb[1]) + 0.0722f * decodeSrgb(rgb[2]);
  });
}

double meanOf(const FloatImage& picture) {
  WL_REQUIRE(!picture.pixels.empty(), "a mean needs a value");
  return std::accumulate(picture.pixels.begin(), picture.pixels.end(), 0.0) /
         static_cast<double>(picture.pixels.size());
}

double meanSsim(const FloatImage& a, const FloatImage& b) {
  WL_REQUIRE(a.channels == 1 && b.channels == 1 && a.width == b.width && a.height == b.height,
             "pictures alike in size");
  WL_REQUIRE(a.width >= kWindow && a.height >= kWindow, "a window fits into the picture");
  const Plane meansA = windowMeans(a, b, [](double p, double) { return p; });
  const Plane meansB = windowMeans(a, b, [](double, double q) { return q; });
  const Plane squaresA = windowMeans(a, b, [](double p, double) { return p * p; });
  const Plane squaresB = windowMeans(a, b, [](double, double q) { return q * q; });
  const Plane products = windowMeans(a, b, [](double p, double q) { return p * q; });
  double sum = 0;
  for (std::size_t i = 0; i < meansA.pixels.size(); ++i) {
    const double p = meansA.pixels[i], q = meansB.pixels[i];
    const double variances = squaresA.pixels[i] - p * p + squaresB.pixels[i] - q * q;
    const double covariance = products.pixels[i] - p * q;
    sum += (2 * p * q + kC1) * (2 * covariance + kC2) / ((p * p + q * q + kC1) * (variances + kC2));
  }
  return sum / static_cast<double>(meansA.pixels.size());
}

double largestLocalError(const FloatImage& picture, const FloatImage& reference, int side) {
  WL_REQUIRE(side > 0 && picture.channels == 1 && reference.channels == 1, "one channel");
  WL_REQUIRE(picture.width == reference.width && picture.height == reference.height, "pictures alike in size");
  const double least = std::max(0.1 * meanOf(reference), 1e-9);
  double most = 0;
  for (int top = 0; top < picture.height; top += side) {
    for (int left = 0; left < picture.width; left += side) {
      const int right = std::min(left + side, picture.width), bottom = std::min(top + side, picture.height);
      const double expected = meanOver(reference, left, top, right, bottom);
      const double found = meanOver(picture, left, top, right, bottom);
      most = std::max(most, std::abs(found - expected) / std::max(expected, least));
    }
  }
  return most;
}

}  // namespace windloom
