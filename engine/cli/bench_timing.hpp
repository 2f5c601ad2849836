#pragma once
// How the benchmark measures: medians of repeated runs under a time limit, on the CPU's clock or on the GPU's.

#include <functional>
#include <vector>

namespace windloom::cli {

/// Of at least one value.
double median(std::vector<double> values);

/// Milliseconds of `work` on the wall clock.
double wallMs(const std::function<void()>& work);

/// Milliseconds between the GPU reaching the commands of `work` and finishing them; waits. An OpenGL context must be
/// current.
double gpuMs(const std::function<void()>& work);

struct Measured {
  double median = 0, fastest = 0;
  int runs = 0;
};

struct RunLimits {
  int warmUps = 1, atLeast = 3, atMost = 30;
  double capSeconds = 20;  ///< no further run begins after this, warm-ups included; one always does
};

/// Calls `once`, which gives the number to keep, until the limits say stop; the warm-ups don't count.
Measured measure(const RunLimits& limits, const std::function<double()>& once);

}  // namespace windloom::cli
