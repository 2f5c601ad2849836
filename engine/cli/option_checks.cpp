#include "engine/cli/option_checks.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <optional>

#include "engine/cli/words.hpp"
#include "engine/core/text.hpp"

namespace windloom::cli {
namespace {

std::optional<long> wholeNumber(const std::string& text) {
  long number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end) return std::nullopt;
  return number;
}

std::string joined(const std::vector<std::string>& names, const char* between) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : between) + name;
  return text;
}

std::string range(const std::string& type, const std::string& least, const std::string& most) {
  return type + " in [" + least + " - " + most + "]";
}

}  // namespace

CLI::Validator numberFrom(double least, double most) {
  return CLI::Validator(
      [least, most](const std::string& text) {
        const auto number = parseNumber(text);
        if (number && *number >= least && *number <= most) return std::string();
        return "found '" + text + "', expected a number from " + plain(least) + " to " + plain(most);
      },
      range("FLOAT", plain(least), plain(most)));
}

CLI::Validator wholeFrom(long least, long most) {
  return CLI::Validator(
      [least, most](std::string& text) {
        const auto number = wholeNumber(text);
        if (!number || *number < least || *number > most) {
          return "found '" + text + "', expected a whole number from " + std::to_string(least) + " to " +
                 std::to_string(most);
        }
        text = std::to_string(*number);
        return std::string();
      },
      range("INT", std::to_string(least), std::to_string(most)));
}

CLI::Validator oneOf(const std::vector<std::string>& names) {
  return CLI::Validator(
      [names](const std::string& text) {
        if (std::ranges::find(names, text) != names.end()) return std::string();
        return "found '" + text + "', expected one of " + joined(names, ", ");
      },
      "{" + joined(names, ",") + "}");
}

CLI::Validator pngName() {
  return CLI::Validator(
      [](const std::string& text) {
        std::string ending = std::filesystem::path(text).extension().string();
        std::ranges::transform(ending, ending.begin(),
                               [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
        if (ending == ".png") return std::string();
        return "found '" + text + "', expected a name that ends in .png";
      },
      "");
}

}  // namespace windloom::cli
