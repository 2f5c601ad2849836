#include "editor/core/export_choices.hpp"

#include <algorithm>
#include <cmath>

namespace windloom::editor {
namespace {

constexpr std::string_view kFolderPrefix = "export.folder ";

/// The same list of fields for reading and for writing.
template <class Visitor, class Choices>
void visitNumbers(Visitor visit, Choices& c) {
  visit("export.from", c.from, kFromRange);
  visit("export.warmUp", c.warmUp, kWarmUpRange);
  visit("export.seconds", c.seconds, kSecondsRange);
  visit("export.fps", c.fps, kFpsRange);
  visit("export.width", c.resolution.x, kSideRange);
  visit("export.height", c.resolution.y, kSideRange);
  visit("export.fullScale", c.fullScale, kFullScaleRange);
  visit("export.layers", c.layers, kLayersRange);
  visit("export.top", c.top, kTopRange);
  visit("export.reference", c.reference, kReferenceRange);
  visit("export.roughness", c.roughness, kRoughnessRange);
}

template <class Visitor, class Choices>
void visitSwitches(Visitor visit, Choices& c) {
  visit("export.ownWarmUp", c.ownWarmUp);
  visit("export.loop", c.loop);
  visit("export.ownResolution", c.ownResolution);
  visit("export.uvFlow", c.uvFlow);
  visit("export.ownFullScale", c.ownFullScale);
  visit("export.response", c.response);
  visit("export.graph", c.graph);
  visit("export.sidecars", c.sidecars);
  visit("export.again", c.again);
}

std::set<std::string, std::less<>> namesIn(std::string_view text) {
  std::set<std::string, std::less<>> names;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    if (end > 0) names.emplace(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return names;
}

}  // namespace

ExportChoices exportChoices(const Preferences& preferences) {
  ExportChoices choices;
  visitNumbers(
      [&](const char* name, auto& value, const ChoiceRange& range) {
        using Number = std::remove_reference_t<decltype(value)>;
        const double kept = preferences.number(name, static_cast<double>(value));
        if (kept >= range.min && kept <= range.max) value = static_cast<Number>(kept);
      },
      choices);
  visitSwitches([&](const char* name, bool& on) { on = preferences.number(name, on ? 1 : 0) != 0; }, choices);
  choices.preset = preferences.text("export.preset", choices.preset);
  if (preferences.texts.contains("export.formats")) choices.formats = namesIn(preferences.texts.at("export.formats"));
  return choices;
}

void keepExportChoices(Preferences& preferences, const ExportChoices& choices) {
  visitNumbers([&](const char* name, const auto& value,
                   const ChoiceRange&) { preferences.numbers[name] = static_cast<double>(value); },
               choices);
  visitSwitches([&](const char* name, bool on) { preferences.numbers[name] = on ? 1 : 0; }, choices);
  preferences.texts["export.preset"] = choices.preset;
  std::string formats;
  for (const std::string& name : choices.formats) formats += (formats.empty() ? "" : ",") + name;
  preferences.texts["export.formats"] = formats;
}

std::string exportFolder(const Preferences& preferences, const std::string& project) {
  return preferences.text(std::string(kFolderPrefix) + project, "");
}

void keepExportFolder(Preferences& preferences, const std::string& project, const std::string& folder) {
  std::erase_if(preferences.texts, [&](const auto& entry) {
    if (!entry.first.starts_with(kFolderPrefix)) return false;
    const std::string of = entry.first.substr(kFolderPrefix.size());
    const auto& recent = preferences.recentFiles;
    return of == project || std::find(recent.begin(), recent.end(), of) == recent.end();
  });
  if (!folder.empty()) preferences.texts[std::string(kFolderPrefix) + project] = folder;
}

}  // namespace windloom::editor
