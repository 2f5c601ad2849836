#pragma once
// Sizes of files and lengths of time as people read them.

#include <string>

namespace windloom::editor {

/// "640 bytes", "12.3 MB", "456 GB": thousands as disks count them, three digits or so. Negative counts as 0.
std::string bytesText(double bytes);

/// "40 s", "3 min", "2 h 5 min": rounded up. Negative counts as 0.
std::string durationText(double seconds);

}  // namespace windloom::editor
