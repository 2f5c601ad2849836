#include "engine/bake/fill_template.hpp"

#include "engine/core/contract.hpp"

namespace windloom {
namespace {

bool isKey(std::string_view text) {
  if (text.empty()) return false;
  for (const char c : text) {
    if (!((c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_')) return false;
  }
  return true;
}

void replaceKeys(std::string_view line, const TemplateValues& values, std::string& out) {
  while (!line.empty()) {
    const std::size_t at = line.find('@');
    out += line.substr(0, at);
    if (at == std::string_view::npos) return;
    const std::size_t end = line.find('@', at + 1);
    const std::string_view key = end == std::string_view::npos ? "" : line.substr(at + 1, end - at - 1);
    if (!isKey(key)) {
      out += '@';
      line.remove_prefix(at + 1);
      continue;
    }
    const auto value = values.find(key);
    WL_REQUIRE(value != values.end(), "every key of a template has a value");
    out += value->second;
    line.remove_prefix(end + 1);
  }
}

}  // namespace

std::string fillTemplate(std::string_view text, const TemplateValues& values) {
  constexpr std::string_view kIf = "@if ", kEnd = "@end";
  std::string out;
  int depth = 0, hiddenFrom = 0;  // hiddenFrom: the depth at which lines began to be left out; 0: shown
  while (!text.empty()) {
    const std::size_t newline = text.find('\n');
    const std::string_view line = text.substr(0, newline);
    text.remove_prefix(newline == std::string_view::npos ? text.size() : newline + 1);
    if (line.starts_with(kIf)) {
      ++depth;
      const auto value = values.find(line.substr(kIf.size()));
      const bool shown = value != values.end() && !value->second.empty() && value->second != "0";
      if (hiddenFrom == 0 && !shown) hiddenFrom = depth;
    } else if (line == kEnd) {
      if (hiddenFrom == depth) hiddenFrom = 0;
      --depth;
    } else if (hiddenFrom == 0) {
      replaceKeys(line, values, out);
      out += '\n';
    }
  }
  WL_REQUIRE(depth == 0, "every @if has its @end");
  return out;
}

}  // namespace windloom
