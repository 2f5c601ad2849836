#pragma once
// What every program of ours does first.

namespace windloom {

/// Call it before any file is opened. Standard streams that the caller closed are taken by /dev/null, so that no
/// project gets their number and the text that was meant for them; writing to them fails as before. A file beyond the
/// limit on file sizes is a failed write from here on, not the program's end.
void prepareProcess();

}  // namespace windloom
