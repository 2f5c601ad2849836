// A plant as its first mode of swaying: one damped oscillator per direction, as in
//   E. de Langre, "Effects of wind on plants", Annual Review of Fluid Mechanics 40, 2008 (frequencies of plants),
//   C. Py, E. de Langre, B. Moulia, "A frequency lock-in mechanism in the interaction between wind and crop canopies",
//     Journal of Fluid Mechanics 568, 2006 (stalks as oscillators: some 2.5 Hz for wheat, 1 Hz for alfalfa),
//   J. R. Moore, D. A. Maguire, "Natural sway frequencies and damping ratios of trees", Trees 18, 2004 (tenths of a Hz;
//     plants in leaf lose a good part of their swing to the air each time).
// Rounded to plain numbers; what plants of one class share is a choice. The steady bend saturates as the meadow's
// blades do.

#include "engine/bake/response.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

// Soft: the meadow's own blades lean 0.06 / (1 - 0.75 / 2) rad per m/s (arcSteadyBend).
constexpr std::array<PlantClass, 4> kClasses = {{{"bend-soft", 0.1f, 2.5f, 0.25f},
                                                 {"bend-limber", 0.06f, 1.5f, 0.2f},
                                                 {"bend-firm", 0.03f, 1.0f, 0.15f},
                                                 {"bend-stiff", 0.012f, 0.3f, 0.12f}}};

constexpr std::size_t kChunk = 2048;  // cells; what a chunk needs stays in the first cache

/// Numbers far below any bend become 0, since sums that fade away would end in slow denormal numbers.
inline float settled(float value) {
  constexpr float kTiny = 1e-20f;
  return (value + kTiny) - kTiny;
}

/// Factors that make targets of winds whose squared lengths are given.
void targetFactors(const PlantClass& plants, std::span<const float> squares, std::span<float> factors) {
  const float over = plants.bend / kSteadyBendLimit, overSquare = over * over;
  for (std::size_t i = 0; i < squares.size(); ++i) factors[i] = plants.bend / std::sqrt(1.0f + overSquare * squares[i]);
}

void squaresOf(std::span<const glm::vec2> wind, std::span<float> squares) {
  for (std::size_t i = 0; i < wind.size(); ++i) squares[i] = wind[i].x * wind[i].x + wind[i].y * wind[i].y;
}

}  // namespace

std::span<const PlantClass, 4> plantClasses() {
  return kClasses;
}

glm::vec2 steadyBend(const PlantClass& plants, glm::vec2 wind) {
  float square = 0, factor = 0;
  squaresOf({&wind, 1}, {&square, 1});
  targetFactors(plants, {&square, 1}, {&factor, 1});
  return wind * factor;
}

OscillatorStep oscillatorStep(float frequency, float damping, double seconds) {
  WL_REQUIRE(frequency > 0.0f && damping >= 0.0f && seconds > 0.0, "an oscillator swings and time passes");
  const double w = 2.0 * std::numbers::pi * static_cast<double>(frequency), d = static_cast<double>(damping),
               h = seconds;
  // Without a target the oscillator after h is bend * even + speed * odd, and -w^2 odd * bend + turned * speed.
  const double s = d * w, discriminant = 1.0 - d * d;
  double swing = 0, odd = 0;  // of cos(q h) and sin(q h) / q, both times exp(-s h)
  if (discriminant > 1e-8) {
    const double q = w * std::sqrt(discriminant), fade = std::exp(-s * h);
    swing = fade * std::cos(q * h);
    odd = fade * std::sin(q * h) / q;
  } else if (discriminant < -1e-8) {
    const double q = w * std::sqrt(-discriminant), slow = std::exp((q - s) * h), fast = std::exp(-(q + s) * h);
    swing = 0.5 * (slow + fast);
    odd = 0.5 * (slow - fast) / q;
  } else {
    swing = std::exp(-s * h);
    odd = h * swing;
  }
  const double even = swing + s * odd, turned = swing - s * odd, back = -w * w * odd;
  // A target that moves evenly is followed `lag` seconds behind.
  const double lag = 2.0 * d / w;
  const double last = 1.0 + (lag * (even - 1.0) - odd) / h, lastSpeed = (1.0 + back * lag - turned) / h;
  const auto row = [](double bend, double speed, double first, double end) {
    return std::array<float, 4>{static_cast<float>(bend), static_cast<float>(speed), static_cast<float>(first),
                                static_cast<float>(end)};
  };
  return {row(even, odd, 1.0 - even - last, last), row(back, turned, -back - lastSpeed, lastSpeed)};
}

PlantResponse::PlantResponse(std::size_t cells) : m_cells(cells), m_pool(std::make_unique<ThreadPool>()) {
  for (State& state : m_states) {
    for (std::vector<glm::vec2>* values : {&state.bend, &state.speed, &state.target}) values->assign(cells, {0, 0});
  }
}

void PlantResponse::restChunk(std::span<const glm::vec2> wind, std::size_t first, std::size_t end) {
  for (std::size_t n = 0; n < m_states.size(); ++n) {
    for (std::size_t i = first; i < end; ++i) {
      m_states[n].bend[i] = m_states[n].target[i] = steadyBend(kClasses[n], wind[i]);
    }
  }
}

void PlantResponse::advanceChunk(std::span<const glm::vec2> wind, const std::array<OscillatorStep, 4>& steps,
                                 std::size_t first, std::size_t end) {
  std::array<float, kChunk> squares, factors;
  const std::size_t count = end - first;
  const std::span<const glm::vec2> here = wind.subspan(first, count);
  squaresOf(here, squares);
  for (std::size_t n = 0; n < m_states.size(); ++n) {
    targetFactors(kClasses[n], std::span(squares).first(count), factors);
    const auto [b0, b1, b2, b3] = steps[n].bend;
    const auto [s0, s1, s2, s3] = steps[n].speed;
    glm::vec2* bend = m_states[n].bend.data() + first;
    glm::vec2* speed = m_states[n].speed.data() + first;
    glm::vec2* target = m_states[n].target.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
      for (int axis = 0; axis < 2; ++axis) {
        const float x = bend[i][axis], v = speed[i][axis], before = target[i][axis];
        const float after = here[i][axis] * factors[i];
        bend[i][axis] = settled(b0 * x + b1 * v + b2 * before + b3 * after);
        speed[i][axis] = settled(s0 * x + s1 * v + s2 * before + s3 * after);
        target[i][axis] = after;
      }
    }
  }
}

void PlantResponse::advance(std::span<const glm::vec2> wind, double seconds) {
  WL_REQUIRE(wind.size() == m_cells, "one wind for each cell");
  WL_REQUIRE(seconds >= 0.0, "time passes forwards");
  std::array<OscillatorStep, 4> steps{};
  for (std::size_t n = 0; n < steps.size(); ++n) {
    // In no time nothing moves, whatever is wanted.
    steps[n] = seconds > 0.0 ? oscillatorStep(kClasses[n].frequency, kClasses[n].damping, seconds)
                             : OscillatorStep{{1, 0, 0, 0}, {0, 1, 0, 0}};
  }
  const auto chunks = static_cast<int>((m_cells + kChunk - 1) / kChunk);
  m_pool->parallelFor(chunks, [&](int chunk) {
    const std::size_t first = static_cast<std::size_t>(chunk) * kChunk, end = std::min(first + kChunk, m_cells);
    m_begun ? advanceChunk(wind, steps, first, end) : restChunk(wind, first, end);
  });
  m_begun = true;
}

std::span<const glm::vec2> PlantResponse::bend(int plantClass) const {
  WL_REQUIRE(plantClass >= 0 && plantClass < 4, "there are four classes of plants");
  return m_states[static_cast<std::size_t>(plantClass)].bend;
}

}  // namespace windloom
