#include "editor/core/refusal.hpp"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace windloom::editor {
namespace {

std::vector<std::string_view> segments(std::string_view pointer) {
  std::vector<std::string_view> parts;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    parts.push_back(pointer.substr(0, end));
    pointer.remove_prefix(end);
  }
  return parts;
}

bool isIndex(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// "graph/arrows/3/radius" as "The arrow's radius".
std::string subject(std::string_view pointer) {
  constexpr std::pair<std::string_view, std::string_view> kNouns[] = {
      {"points", "The point"},         {"arrows", "The arrow"},      {"signals", "The signal"},
      {"obstacles", "The obstacle"},   {"species", "The species"},   {"colliders", "The collider"},
      {"surfaces", "The surface"},     {"rotors", "The rotor"},      {"probes", "The probe"},
      {"cameras", "The camera"},       {"field", "The field"},       {"solver", "The solver"},
      {"ambient", "The ambient wind"}, {"terrain", "The terrain"},   {"grass", "The grass"},
      {"bezier", "The Bezier grass"},  {"shell", "The shell grass"}, {"name", "The name"}};
  std::vector<std::string_view> parts = segments(pointer);
  if (!parts.empty() && parts.front() == "graph") parts.erase(parts.begin());
  if (parts.empty()) return {};
  std::string noun;
  for (const auto& [key, text] : kNouns) {
    if (parts.front() == key) noun = text;
  }
  std::string rest;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    if (isIndex(parts[i])) continue;
    rest.append(rest.empty() ? "" : " ").append(parts[i] == "points" ? "outline" : parts[i]);
  }
  if (noun.empty()) return {};
  return rest.empty() ? noun : noun.append(noun.ends_with('s') ? "' " : "'s ").append(rest);
}

}  // namespace

std::string refusalText(const Error& error) {
  const Problem& problem = error.problems.front();
  std::string text = subject(problem.pointer);
  // Messages about a value begin with "found", those about a thing with its verb.
  if (!text.empty()) text.append(problem.message.starts_with("found") ? ": " : " ");
  text.append(problem.message);
  const std::size_t others = error.problems.size() - 1;
  if (others > 0)
    text.append(" (and ").append(std::to_string(others)).append(others == 1 ? " more problem)" : " more problems)");
  return text;
}

}  // namespace windloom::editor
