#pragma once
// Projects made for measuring.

#include "engine/model/project.hpp"

namespace windloom::cli {

/// A square field of `cells` x `cells` cells of 0.1 m, default solver settings, a gusty ambient wind and `arrows`
/// arrows of 8 m spread over it, every one blowing, always the same.
Project benchProject(int cells, int arrows);

/// Grass of `density` blades per square metre on a field of `metres` x `metres`.
Project benchMeadow(float metres, float density);

}  // namespace windloom::cli
