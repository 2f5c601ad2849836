#include "editor/core/preferences.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <system_error>

#include "engine/core/file.hpp"
#include "engine/io/json_document.hpp"

namespace windloom::editor {
namespace fs = std::filesystem;
using nlohmann::ordered_json;
namespace {

/// Reads values one by one; what has the wrong type is noted and left at its default.
class Reader {
 public:
  Reader(const ordered_json& object, std::vector<std::string>* warnings) : m_object(object), m_warnings(warnings) {}

  template <class Take>
  void read(const char* key, const char* expected, Take take) {
    const auto found = m_object.find(key);
    if (found != m_object.end() && !take(*found)) warn(std::string(key) + ": expected " + expected);
  }
  void warn(std::string text) {
    if (m_warnings) m_warnings->push_back("preferences: " + std::move(text));
  }

 private:
  const ordered_json& m_object;
  std::vector<std::string>* m_warnings;
};

bool takeScale(const ordered_json& value, float& scale) {
  if (!value.is_number()) return false;
  const double number = value.get<double>();
  if (number != 0.0 && !(number >= 0.5 && number <= 4.0)) return false;
  scale = static_cast<float>(number);
  return true;
}

bool takePaths(const ordered_json& value, std::size_t most, std::vector<std::string>& paths) {
  if (!value.is_array()) return false;
  for (const ordered_json& path : value) {
    if (!path.is_string()) return false;
    if (paths.size() < most) paths.push_back(path.get_ref<const std::string&>());
  }
  return true;
}

bool takeNumbers(const ordered_json& value, std::map<std::string, double>& numbers) {
  if (!value.is_object()) return false;
  bool all = true;
  for (const auto& [name, number] : value.items()) {
    const bool fine = number.is_number() && std::isfinite(number.get<double>());
    if (fine) numbers[name] = number.get<double>();
    all = all && fine;
  }
  return all;
}

bool takeTexts(const ordered_json& value, std::map<std::string, std::string>& texts) {
  if (!value.is_object()) return false;
  bool all = true;
  for (const auto& [name, text] : value.items()) {
    if (text.is_string()) texts[name] = text.get<std::string>();
    all = all && text.is_string();
  }
  return all;
}

bool takeTheme(const ordered_json& value, Theme& theme) {
  if (value != "dark" && value != "light") return false;
  theme = value == "light" ? Theme::Light : Theme::Dark;
  return true;
}

fs::path absolutePath(const fs::path& path) {
  std::error_code failed;
  const fs::path absolute = fs::absolute(path, failed);
  return failed ? path : absolute.lexically_normal();
}

/// That of a project file, links followed as the system follows them: "link/.." is not where the link stands. Empty
/// where that can't be told.
std::string trueFolder(const fs::path& projectFile) {
  std::error_code failed;
  const fs::path absolute = fs::absolute(projectFile, failed);
  if (failed) return {};
  const fs::path folder = fs::weakly_canonical(absolute.parent_path(), failed);
  return failed ? std::string() : folder.string();
}

}  // namespace

double Preferences::number(const std::string& name, double fallback) const {
  const auto found = numbers.find(name);
  return found == numbers.end() ? fallback : found->second;
}

std::string Preferences::text(const std::string& name, const std::string& fallback) const {
  const auto found = texts.find(name);
  return found == texts.end() ? fallback : found->second;
}

void Preferences::usedFile(const fs::path& path) {
  forgetFile(path);
  recentFiles.push_back(absolutePath(path).string());
  std::rotate(recentFiles.begin(), recentFiles.end() - 1, recentFiles.end());
  if (recentFiles.size() > kMaxRecent) recentFiles.resize(kMaxRecent);
}

void Preferences::forgetFile(const fs::path& path) {
  std::erase(recentFiles, absolutePath(path).string());
}

OutsideFiles Preferences::outsideFor(const fs::path& projectFile) const {
  const std::string folder = trueFolder(projectFile);
  const bool allowed = !folder.empty() && std::ranges::find(outsideAllowed, folder) != outsideAllowed.end();
  return allowed ? OutsideFiles::Allow : OutsideFiles::Refuse;
}

void Preferences::setOutside(const fs::path& projectFile, OutsideFiles outside) {
  const std::string folder = trueFolder(projectFile);
  std::erase(outsideAllowed, folder);
  if (outside == OutsideFiles::Refuse || folder.empty()) return;
  if (outsideAllowed.size() >= kMaxTrusted) outsideAllowed.erase(outsideAllowed.begin());
  outsideAllowed.push_back(folder);
}

Preferences readPreferences(const fs::path& path, std::vector<std::string>* warnings) {
  Preferences preferences;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return preferences;
  const Result<std::string> bytes = readFile(path, kMaxPreferencesBytes);
  const Result<ordered_json> parsed = bytes ? parseJsonDocument(*bytes, path.string()) : bytes.error();
  const ordered_json json = parsed ? *parsed : ordered_json();
  Reader reader(json, warnings);
  if (!parsed) reader.warn(parsed.error().text() + "; the defaults are used");
  if (!json.is_object()) {
    if (parsed) reader.warn(path.string() + " is not a JSON object, the defaults are used");
    return preferences;
  }
  reader.read("theme", "\"dark\" or \"light\"", [&](const auto& v) { return takeTheme(v, preferences.theme); });
  reader.read("interfaceScale", "0 or a number from 0.5 to 4",
              [&](const auto& v) { return takeScale(v, preferences.interfaceScale); });
  reader.read("recentFiles", "an array of paths",
              [&](const auto& v) { return takePaths(v, kMaxRecent, preferences.recentFiles); });
  reader.read("outsideAllowed", "an array of folders",
              [&](const auto& v) { return takePaths(v, kMaxTrusted, preferences.outsideAllowed); });
  reader.read("keymap", "an object", [&](const auto& v) {
    if (v.is_object()) preferences.keymap = v.dump();
    return v.is_object();
  });
  reader.read("numbers", "an object of numbers", [&](const auto& v) { return takeNumbers(v, preferences.numbers); });
  reader.read("texts", "an object of texts", [&](const auto& v) { return takeTexts(v, preferences.texts); });
  reader.read("firstRunHintSeen", "true or false", [&](const auto& v) {
    if (v.is_boolean()) preferences.firstRunHintSeen = v.template get<bool>();
    return v.is_boolean();
  });
  return preferences;
}

Status writePreferences(const fs::path& path, const Preferences& preferences) {
  ordered_json json;
  json["theme"] = preferences.theme == Theme::Light ? "light" : "dark";
  json["interfaceScale"] = static_cast<double>(preferences.interfaceScale);
  json["recentFiles"] = preferences.recentFiles;
  json["outsideAllowed"] = preferences.outsideAllowed;
  const Result<ordered_json> keymap = parseJsonDocument(preferences.keymap, "keymap");
  json["keymap"] = keymap && keymap->is_object() ? *keymap : ordered_json::object();
  ordered_json numbers = ordered_json::object();
  for (const auto& [name, value] : preferences.numbers) {
    if (std::isfinite(value)) numbers[name] = value;
  }
  json["numbers"] = std::move(numbers);
  json["texts"] = preferences.texts;
  json["firstRunHintSeen"] = preferences.firstRunHintSeen;
  if (path.has_parent_path()) {
    const Status made = makeFolder(path.parent_path());
    if (!made) return made;
  }
  // A path may hold bytes that are no UTF-8.
  return writeFileAtomically(path, json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

}  // namespace windloom::editor
