#pragma once
// Projects made for measuring.

#include <string>

#include "engine/core/result.hpp"
#include "engine/model/project.hpp"

namespace windloom::cli {

/// A square field of `cells` x `cells` cells of 0.1 m, default solver settings, a gusty ambient wind and `arrows`
/// arrows of 8 m spread over it, every one blowing, always the same.
Project benchProject(int cells, int arrows);

/// The same wind over a meadow: 10 arrows and gusts on `cells` x `cells` cells, `density` blades per square metre on a
/// field of `metres` x `metres`.
Project benchWindyMeadow(float metres, float density, int cells);

/// Grass of `density` blades per square metre on a field of `metres` x `metres`.
Project benchMeadow(float metres, float density);

/// The sample of this name, with what it refers to. Fails where samples aren't installed.
Result<Project> benchSample(const std::string& name);

}  // namespace windloom::cli
