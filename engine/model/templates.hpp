#pragma once
// Projects to start from. Each is valid, has something to look at and at least the cameras "hero" (low
// over the grass) and "top". The samples under projects/ are templates written to files.

#include <span>
#include <string_view>

#include "engine/model/project.hpp"

namespace windloom {

struct ProjectTemplate {
  std::string_view name;     ///< as given to `windloom new --template`
  std::string_view title;    ///< for menus
  std::string_view summary;  ///< one sentence
  Project (*make)() = nullptr;
};

/// In the order of menus; the first is the one taken when none is named.
std::span<const ProjectTemplate> projectTemplates();

/// The template with this name, or null.
const ProjectTemplate* findTemplate(std::string_view name);

}  // namespace windloom
