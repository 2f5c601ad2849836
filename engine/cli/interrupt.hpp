#pragma once
// Ctrl+C during long work: the work ends at its next safe place instead of in the middle of a file.

namespace windloom::cli {

inline constexpr int kExitInterrupted = 130;  ///< what shells give for a program ended by Ctrl+C

/// From now on the first SIGINT or SIGTERM is only noted; a second one ends the program at once.
void noteInterrupts();

[[nodiscard]] bool interrupted();

}  // namespace windloom::cli
