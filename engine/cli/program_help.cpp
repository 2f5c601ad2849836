#include "engine/cli/program_help.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace windloom::cli {
namespace {

/// CLI11 keeps nothing of ours beside an option but validators, so that is where the values are kept: in the name of
/// one that lets everything pass, and has no text in --help.
constexpr std::string_view kOffers = "offers:";

std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(at), text.size());
    if (end > 0) parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

std::vector<CLI::Validator*> validatorsOf(CLI::Option& option) {
  std::vector<CLI::Validator*> all;
  try {
    for (int i = 0;; ++i) all.push_back(option.get_validator(i));
  } catch (const CLI::OptionNotFound&) {  // how CLI11 says that there are no more
  }
  return all;
}

void addValues(CLI::Option& option, OptionHelp& help) {
  for (const CLI::Validator* validator : validatorsOf(option)) {
    const std::string name = validator->get_name(), text = validator->get_description();
    if (name.starts_with(kOffers)) help.choices = split(std::string_view(name).substr(kOffers.size()), ',');
    if (text.starts_with("{") && text.ends_with("}"))
      help.choices = split(std::string_view(text).substr(1, text.size() - 2), ',');
    if (const std::size_t in = text.find(" in ["); in != std::string::npos) {
      const std::vector<std::string> ends = split(std::string_view(text).substr(in + 5, text.size() - in - 6), ' ');
      if (ends.size() == 3) help.note = "From " + ends[0] + " to " + ends[2] + ".";
    }
  }
  if (help.choices.empty() && help.value.find('|') != std::string::npos) help.choices = split(help.value, '|');
}

ValueKind kindOf(const OptionHelp& help) {
  if (!help.choices.empty()) return ValueKind::Choice;
  if (help.value == "DIR" || help.value == "FOLDER") return ValueKind::Folder;
  const bool file = help.value.starts_with("FILE") || help.value.ends_with(".png") || help.value == "PNG";
  return file ? ValueKind::File : ValueKind::Word;
}

std::string namesOf(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) names.push_back(option->get_name());
  std::sort(names.begin(), names.end());  // CLI11 orders them by their place in memory
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void addNote(std::string& note, const std::string& sentence) {
  note += (note.empty() ? "" : " ") + sentence;
}

OptionHelp describe(CLI::Option& option) {
  OptionHelp help;
  for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  help.text = option.get_description();
  help.required = option.get_required();
  if (option.get_items_expected_max() == 0) {
    help.kind = ValueKind::None;
    return help;
  }
  const std::string type = option.get_type_name();
  help.value = help.names.empty() ? option.get_single_name() : type.substr(0, type.find(':'));
  std::transform(help.value.begin(), help.value.end(), help.value.begin(),
                 [&](unsigned char c) { return help.names.empty() ? char(std::toupper(c)) : char(c); });
  if (help.value == "TEXT" || help.value == "INT" || help.value == "UINT" || help.value == "FLOAT")
    help.value = help.value == "TEXT" ? "NAME" : "N";
  addValues(option, help);
  help.kind = kindOf(help);
  if (help.value == "FILE" && help.names.empty()) help.suffix = ".wind.json";
  if (help.kind == ValueKind::File && help.value.find('.') != std::string::npos)
    help.suffix = help.value.substr(help.value.find('.'));
  if (help.value == "PNG") help.suffix = ".png";
  help.valueMayMiss = option.get_items_expected_min() == 0;
  help.repeated = option.get_items_expected_max() > 1;
  help.commas = option.get_delimiter() == ',';
  if (!option.get_default_str().empty()) addNote(help.note, "Default: " + option.get_default_str() + ".");
  if (const std::string names = namesOf(option.get_needs()); !names.empty()) addNote(help.note, "Needs " + names + ".");
  if (const std::string names = namesOf(option.get_excludes()); !names.empty())
    addNote(help.note, "Not together with " + names + ".");
  return help;
}

}  // namespace

CLI::Option* offer(CLI::Option* option, const std::vector<std::string>& values) {
  std::string name(kOffers);
  for (const std::string& value : values) name += (name.size() == kOffers.size() ? "" : ",") + value;
  return option->check([](const std::string&) { return std::string(); }, "", name);
}

ProgramHelp describe(CLI::App& app) {
  ProgramHelp help{app.get_name(), app.get_description(), {}, app.get_footer(), {}};
  for (CLI::Option* option : app.get_options())
    if (!option->get_group().empty()) help.options.push_back(describe(*option));
  for (CLI::App* verb : app.get_subcommands([](CLI::App*) { return true; }))
    if (!verb->get_group().empty()) help.verbs.push_back(describe(*verb));
  return help;
}

}  // namespace windloom::cli
