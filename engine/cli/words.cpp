#include "engine/cli/words.hpp"

#include <charconv>

namespace windloom::cli {

namespace {

template <class Real>
std::string decimal(Real value) {
  char text[400];  // a double takes 343 at most
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed).ptr;
  return {text, end};
}

}  // namespace

std::string plain(float value) {
  return decimal(value);
}

std::string plain(double value) {
  return decimal(value);
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
  std::string text = std::to_string(count) + " ";
  text += count != 1 && !many.empty() ? many : one;
  if (count != 1 && many.empty()) text += "s";
  return text;
}

}  // namespace windloom::cli
