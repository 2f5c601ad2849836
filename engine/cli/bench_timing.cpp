#include "engine/cli/bench_timing.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>

#include "engine/core/contract.hpp"

namespace windloom::cli {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

double median(std::vector<double> values) {
  WL_REQUIRE(!values.empty(), "a median needs a value");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

double wallMs(const std::function<void()>& work) {
  const auto start = Clock::now();
  work();
  return secondsSince(start) * 1e3;
}

double gpuMs(const std::function<void()>& work) {
  GLuint queries[2] = {};
  glCreateQueries(GL_TIMESTAMP, 2, queries);
  glQueryCounter(queries[0], GL_TIMESTAMP);
  work();
  glQueryCounter(queries[1], GL_TIMESTAMP);
  GLuint64 begin = 0, end = 0;
  glGetQueryObjectui64v(queries[0], GL_QUERY_RESULT, &begin);
  glGetQueryObjectui64v(queries[1], GL_QUERY_RESULT, &end);
  glDeleteQueries(2, queries);
  return static_cast<double>(end - begin) * 1e-6;
}

Measured measure(const RunLimits& limits, const std::function<double()>& once) {
  const auto start = Clock::now();
  std::vector<double> values;
  for (int run = 0; static_cast<int>(values.size()) < limits.atMost; ++run) {
    const double spent = secondsSince(start);
    // What a slow machine has no time to repeat still gives one number, warm or not.
    const bool late = spent > limits.capSeconds;
    if (late && !values.empty()) break;
    const double value = once();
    if (run >= limits.warmUps || spent > 0.5 * limits.capSeconds || late) values.push_back(value);
    const bool enough = static_cast<int>(values.size()) >= limits.atLeast;
    if (enough && secondsSince(start) > 0.5 * limits.capSeconds) break;
  }
  return {median(values), *std::min_element(values.begin(), values.end()), static_cast<int>(values.size())};
}

}  // namespace windloom::cli
