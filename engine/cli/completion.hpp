#pragma once
// Scripts that complete the command line of a program in a shell, made from its options.

#include <string>

#include "engine/cli/program_help.hpp"

namespace windloom::cli {

/// For bash 4 or newer; needs nothing of the bash-completion package, which finds it by the program's name.
std::string bashCompletion(const ProgramHelp& program);
/// An autoloaded function of zsh, to be stored as _PROGRAM in a folder of $fpath.
std::string zshCompletion(const ProgramHelp& program);

}  // namespace windloom::cli
