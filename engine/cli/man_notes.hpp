#pragma once
// What manual pages say beside the options: exit status, environment, files, examples.

#include <span>
#include <string_view>

namespace windloom::cli {

struct ManEntry {
  std::string_view term, text;
};

/// A section of terms and their meaning on the pages whose name is `page` ("windloom", "windloom-bake"); a page ending
/// in * means all that begin so.
struct ManSection {
  std::string_view page, title;
  std::span<const ManEntry> entries;
};

/// In the order of a page.
std::span<const ManSection> manSections();

}  // namespace windloom::cli
