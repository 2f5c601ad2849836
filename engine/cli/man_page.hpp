#pragma once
// Manual pages (roff, macros man) of the programs, made from their options.

#include <string>
#include <vector>

#include "engine/cli/program_help.hpp"

namespace windloom::cli {

/// A file of the manual's section 1.
struct ManPage {
  std::string fileName;  ///< "windloom-bake.1"
  std::string text;
};

/// The page of the program, then one of each verb.
std::vector<ManPage> manPages(const ProgramHelp& program, const std::string& version);

}  // namespace windloom::cli
