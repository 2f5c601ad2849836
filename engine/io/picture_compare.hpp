#pragma once
// How alike two pictures are: structural similarity and brightness. Pictures hold sRGB values, 0..255.

#include "engine/io/image.hpp"

namespace windloom {

using FloatImage = BasicImage<float>;

/// The means of squares of `side` x `side` pixels: a picture with one `side`-th of the width and height, which must be
/// multiples of it. The encoded values are averaged, not the light, as the renderer averages its samples.
FloatImage boxFiltered(const Image& picture, int side);

/// Luma after ITU-R BT.601, one channel, 0..255, of a picture with at least three.
FloatImage lumaOf(const FloatImage& picture);

/// Relative luminance after BT.709 of the light behind the values, one channel, 0..1, of a picture with at least three.
FloatImage lightOf(const FloatImage& picture);

/// Mean of all samples.
double meanOf(const FloatImage& picture);

/// Mean structural similarity of two pictures of one channel and equal size, at least 11 x 11: 1 where they are the
/// same, around 0 where they have nothing in common. Wang, Bovik, Sheikh, Simoncelli, "Image quality assessment: from
/// error visibility to structural similarity", 2004: Gaussian windows of 11 x 11 with sigma 1.5 that lie wholly in the
/// picture, K1 = 0.01, K2 = 0.03, L = 255.
double meanSsim(const FloatImage& a, const FloatImage& b);

/// The largest difference of the means of `picture` and `reference` (one channel, equal size) over squares of `side`
/// pixels, as a part of the reference's mean there, or of its mean over the picture where that is more than tenfold.
/// Squares cut by an edge count with what they have.
double largestLocalError(const FloatImage& picture, const FloatImage& reference, int side);

}  // namespace windloom
