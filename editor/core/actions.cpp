#include "editor/core/actions.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "engine/io/json_document.hpp"

namespace windloom::editor {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// How well the typed letters match, higher is better; negative: not at all.
int matchScore(const std::string& text, const std::string& typed) {
  if (text.starts_with(typed)) return 1000;
  const std::size_t at = text.find(typed);
  if (at != std::string::npos) return text[at - 1] == ' ' || text[at - 1] == '.' ? 800 : 600;
  // Letters in order; a letter that begins a word counts more.
  int score = 0;
  std::size_t place = 0;
  for (const char letter : typed) {
    const std::size_t found = text.find(letter, place);
    if (found == std::string::npos) return -1;
    score += found == 0 || text[found - 1] == ' ' || text[found - 1] == '.' ? 20 : 1;
    place = found + 1;
  }
  return score;
}

/// One entry of a keymap: a text or an array of texts. Nothing where it is neither or no shortcut.
std::optional<std::vector<Shortcut>> readShortcuts(const JsonDocument& entry) {
  std::vector<Shortcut> shortcuts;
  const JsonDocument list = entry.is_array() ? entry : JsonDocument::array({entry});
  for (const JsonDocument& item : list) {
    if (!item.is_string()) return std::nullopt;
    const auto shortcut = parseShortcut(item.get_ref<const std::string&>());
    if (!shortcut) return std::nullopt;
    shortcuts.push_back(*shortcut);
  }
  return shortcuts;
}

}  // namespace

void ActionTable::add(Action action) {
  WL_REQUIRE(find(action.id) == nullptr, "two actions have the same id");
  WL_REQUIRE(static_cast<bool>(action.run), "an action does something");
  for (const std::vector<Shortcut>& others : m_defaults) {
    for (const Shortcut& shortcut : action.shortcuts) {
      WL_REQUIRE(std::find(others.begin(), others.end(), shortcut) == others.end(),
                 "two actions have the same default shortcut");
    }
  }
  m_defaults.push_back(action.shortcuts);
  m_actions.push_back(std::move(action));
}

const Action* ActionTable::find(std::string_view id) const {
  const auto found = std::find_if(m_actions.begin(), m_actions.end(), [&](const Action& a) { return a.id == id; });
  return found == m_actions.end() ? nullptr : &*found;
}

bool ActionTable::enabled(std::string_view id) const {
  const Action* action = find(id);
  return action && (!action->enabled || action->enabled());
}

bool ActionTable::checked(std::string_view id) const {
  const Action* action = find(id);
  return action && action->checked && action->checked();
}

std::string ActionTable::label(std::string_view id) const {
  const Action* action = find(id);
  if (!action) return {};
  return action->dynamicLabel ? action->dynamicLabel() : action->label;
}

std::string ActionTable::shortcutText(std::string_view id) const {
  const Action* action = find(id);
  return action && !action->shortcuts.empty() ? toText(action->shortcuts.front()) : std::string();
}

std::string ActionTable::tooltip(std::string_view id) const {
  const Action* action = find(id);
  if (!action) return {};
  const std::string shortcut = shortcutText(id);
  return label(id) + (shortcut.empty() ? "" : " (" + shortcut + ")") +
         (action->help.empty() ? "" : ": " + action->help);
}

bool ActionTable::run(std::string_view id) {
  const Action* action = find(id);
  if (!action || (action->enabled && !action->enabled())) return false;
  // A copy: the action may add others and so move the table.
  const auto work = action->run;
  work();
  return true;
}

bool ActionTable::dispatch(const KeyPress& press) {
  const Shortcut pressed{press.key, press.modifiers};
  for (const Action& action : m_actions) {
    const auto& own = action.shortcuts;
    if (std::find(own.begin(), own.end(), pressed) == own.end()) continue;
    if (action.enabled && !action.enabled()) continue;
    // A held key that does not repeat is still this action's: it must not fall through to another.
    if (press.repeat && !action.repeats) return true;
    const auto work = action.run;
    work();
    return true;
  }
  return false;
}

std::vector<std::string> ActionTable::search(std::string_view text) const {
  const std::string typed = lower(text);
  std::vector<std::pair<int, const Action*>> found;
  for (const Action& action : m_actions) {
    if (action.enabled && !action.enabled()) continue;
    const int score = typed.empty() ? 0
                                    : std::max({matchScore(lower(action.label), typed),
                                                matchScore(lower(action.category + " " + action.label), typed) / 2,
                                                matchScore(action.id, typed) / 3});
    if (score > 0 || typed.empty()) found.emplace_back(score, &action);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> ids;
  ids.reserve(found.size());
  for (const auto& [score, action] : found) ids.push_back(action->id);
  return ids;
}

Status ActionTable::applyKeymap(std::string_view json) {
  const Result<JsonDocument> parsed = parseJsonDocument(json, {});
  const JsonDocument map = parsed ? *parsed : JsonDocument();
  if (!map.is_object()) return makeError(ErrorKind::BadInput, "the keymap is not a JSON object");
  Error error{ErrorKind::BadInput, {}};
  for (const auto& [id, entry] : map.items()) {
    const auto found =
        std::find_if(m_actions.begin(), m_actions.end(), [&, &name = id](const Action& a) { return a.id == name; });
    if (found == m_actions.end()) {
      error.problems.push_back({"", "/" + id, "there is no such action"});
      continue;
    }
    auto shortcuts = readShortcuts(entry);
    if (!shortcuts) {
      error.problems.push_back({"", "/" + id, "expected a shortcut such as \"Ctrl+Shift+K\" or an array of them"});
      continue;
    }
    found->shortcuts = std::move(*shortcuts);
  }
  if (!error.problems.empty()) return error;
  return Done{};
}

std::string ActionTable::keymapJson() const {
  nlohmann::ordered_json map = nlohmann::ordered_json::object();
  for (std::size_t i = 0; i < m_actions.size(); ++i) {
    if (m_actions[i].shortcuts == m_defaults[i]) continue;
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Shortcut& shortcut : m_actions[i].shortcuts) list.push_back(toText(shortcut));
    map[m_actions[i].id] = std::move(list);
  }
  return map.dump(2);
}

std::vector<std::string> ActionTable::conflicts() const {
  std::map<Shortcut, std::string> users;
  std::map<Shortcut, int> counts;
  for (const Action& action : m_actions) {
    for (const Shortcut& shortcut : action.shortcuts) {
      std::string& names = users[shortcut];
      names += (names.empty() ? "" : ", ") + action.id;
      ++counts[shortcut];
    }
  }
  std::vector<std::string> lines;
  for (const auto& [shortcut, names] : users) {
    if (counts[shortcut] > 1) lines.push_back(toText(shortcut) + ": " + names);
  }
  return lines;
}

}  // namespace windloom::editor
