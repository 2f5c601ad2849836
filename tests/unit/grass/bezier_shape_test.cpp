// Outlines of Bezier blades: Jahrmann & Wimmer, 2017, eq. 22-24, against the equations written out here in double.
#include "shaders/shared/bezier_shape.h"

#include <gtest/gtest.h>

#include <cmath>

namespace windloom {
namespace {

using shared::bezierOutline;
using shared::dandelionOutline;
using shared::foldDepth;
using shared::widthCorrection;

template <class Test>
void overBlade(const Test& test) {
  for (int i = 0; i <= 20; ++i) {
    for (int k = 0; k <= 20; ++k) test(static_cast<float>(i) / 20.0f, static_cast<float>(k) / 20.0f);
  }
}

TEST(BezierShape, FollowsTheOutlinesOfThePaper) {
  overBlade([](float u, float v) {
    const double a = static_cast<double>(u), b = static_cast<double>(v);
    EXPECT_NEAR(static_cast<double>(bezierOutline(BEZIER_FORM_QUAD, u, v, 0.5f)), a, 1e-6);
    EXPECT_NEAR(static_cast<double>(bezierOutline(BEZIER_FORM_TRIANGLE, u, v, 0.5f)), a + b / 2 - a * b, 1e-6);
    EXPECT_NEAR(static_cast<double>(bezierOutline(BEZIER_FORM_QUADRATIC, u, v, 0.5f)), a - a * b * b, 1e-6);
    for (const double tau : {0.0, 0.3, 0.8}) {
      const double tip = 0.5 + (a - 0.5) * (1 - std::max(b - tau, 0.0) / (1 - tau));
      EXPECT_NEAR(static_cast<double>(bezierOutline(BEZIER_FORM_TRIANGLE_TIP, u, v, static_cast<float>(tau))), tip,
                  1e-6);
    }
  });
}

TEST(BezierShape, PointedFormsEndInAPoint) {
  for (const unsigned form : {BEZIER_FORM_TRIANGLE, BEZIER_FORM_QUADRATIC, BEZIER_FORM_TRIANGLE_TIP}) {
    EXPECT_NEAR(bezierOutline(form, 0.0f, 1.0f, 0.4f), bezierOutline(form, 1.0f, 1.0f, 0.4f), 1e-6f) << form;
    EXPECT_NEAR(foldDepth(0.5f, 1.0f, 0.0f), 0.0f, 1e-6f) << "the fold fades there";
  }
}

TEST(BezierShape, FoldIsTheOneOfThePaperWhereTheBladeIsWhole) {
  overBlade([](float u, float v) {
    const double paper = 0.5 - std::abs(static_cast<double>(u) - 0.5) * (1 - static_cast<double>(v));
    EXPECT_NEAR(static_cast<double>(foldDepth(u, v, 1.0f)), paper, 1e-6);
  });
}

TEST(BezierShape, NoSpikeOfADandelionIsLostAtAnyDetail) {
  // A strip has rows at the multiples of 1 / (2 spikes) of the head; between two notches there must be a point.
  for (const int spikes : {3, 8}) {
    int points = 0;
    for (int row = 1; row < 2 * spikes; ++row) {
      const auto half = [&](int at) {
        const float v = BEZIER_HEAD + (1.0f - BEZIER_HEAD) * static_cast<float>(at) / static_cast<float>(2 * spikes);
        return dandelionOutline(1.0f, v, static_cast<float>(spikes), 25.0f) - 0.5f;
      };
      if (half(row) > half(row - 1) && half(row) > half(row + 1)) ++points;
    }
    EXPECT_EQ(points, spikes);
  }
}

TEST(BezierShape, DandelionsAreSymmetricAndStalksThin) {
  overBlade([](float u, float v) {
    const float left = dandelionOutline(u, v, 8.0f, 25.0f), right = dandelionOutline(1.0f - u, v, 8.0f, 25.0f);
    EXPECT_NEAR(left + right, 1.0f, 1e-5f);
    if (v < BEZIER_HEAD) {
      EXPECT_LE(std::abs(left - 0.5f), 0.5f * BEZIER_STALK + 1e-6f);
    }
  });
}

TEST(BezierShape, CoverIsTheAreaOfTheOutline) {
  for (const unsigned form :
       {BEZIER_FORM_QUAD, BEZIER_FORM_TRIANGLE, BEZIER_FORM_QUADRATIC, BEZIER_FORM_TRIANGLE_TIP}) {
    double area = 0;
    for (int k = 0; k < 1000; ++k) {
      const float v = (static_cast<float>(k) + 0.5f) / 1000.0f;
      area += static_cast<double>(bezierOutline(form, 1.0f, v, 0.3f) - bezierOutline(form, 0.0f, v, 0.3f)) / 1000.0;
    }
    EXPECT_NEAR(static_cast<double>(shared::bezierCover(form, 0.3f)), area, 1e-3) << form;
  }
}

TEST(BezierShape, NarrowBladesBecomeQuadsAndWideOnesStayThemselves) {
  EXPECT_FLOAT_EQ(widthCorrection(0.5f, 1.0f, 2.0f), 1.0f);
  EXPECT_FLOAT_EQ(widthCorrection(1.0f, 1.0f, 2.0f), 1.0f);
  EXPECT_FLOAT_EQ(widthCorrection(2.0f, 1.0f, 2.0f), 0.25f) << "Phi = 1/2";
  EXPECT_FLOAT_EQ(widthCorrection(3.0f, 1.0f, 2.0f), 0.0f);
  EXPECT_FLOAT_EQ(widthCorrection(0.5f, 1.0f, 0.0f), 1.0f) << "no span: a step";
}

}  // namespace
}  // namespace windloom
