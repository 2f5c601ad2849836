#include <algorithm>

#include "engine/cli/completion.hpp"

namespace windloom::cli {
namespace {

/// Within single quotes.
std::string quoted(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out;
}

/// The explanation of an option stands in brackets.
std::string explained(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == '\\') out += '\\';
    out += c;
  }
  return quoted(out);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// ":NAME:what completes it".
std::string valueOf(const OptionHelp& option) {
  std::string message = option.value, action = " ";
  for (char& c : message)
    if (c == ':') c = ' ';
  if (option.kind == ValueKind::Choice && option.commas)
    action = std::string(" _values -s , value ").append(joined(option.choices));  // the space: called as it stands
  else if (option.kind == ValueKind::Choice)
    action = std::string("(").append(joined(option.choices)).append(")");
  else if (option.kind == ValueKind::File)
    action = option.suffix.empty() ? "_files" : "_files -g \"*" + option.suffix + "\"";
  else if (option.kind == ValueKind::Folder)
    action = "_files -/";
  return (option.valueMayMiss ? "::" : ":") + quoted(message) + ":" + action;
}

std::string specOf(const OptionHelp& option) {
  if (option.names.empty()) return std::string("'") + (option.repeated ? "*" : "") + valueOf(option) + "'";
  const bool value = option.kind != ValueKind::None;
  const bool last = option.names.back() == "--help" || option.names.back() == "--version";
  const std::string before = last ? "(- *)" : option.repeated ? "*" : "(" + joined(option.names) + ")";
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ",") + name + (!value ? "" : name.starts_with("--") ? "=" : "+");
  // GCC 12 warns about text + string for no reason.
  if (option.names.size() > 1) names = std::string("'{").append(names).append("}'");
  return "'" + before + names + "[" + explained(option.text) + "]" + (value ? valueOf(option) : "") + "'";
}

std::string argumentsOf(const ProgramHelp& help, const std::string& indent, const std::string& more) {
  std::string out = indent + "_arguments -S" + (more.empty() ? "" : " -C");
  for (const OptionHelp& option : help.options) out += " \\\n" + indent + "  " + specOf(option);
  return out + more + "\n";
}

}  // namespace

std::string zshCompletion(const ProgramHelp& program) {
  std::string function = "_" + program.name;
  std::string out = "#compdef " + program.name + "\n# Made from the program's own options by `windloom docs`.\n\n";
  out += function + "() {\n";
  if (program.verbs.empty()) {
    out += argumentsOf(program, "  ", "");
  } else {
    out += "  local context state state_descr line\n  typeset -A opt_args\n";
    out += argumentsOf(program, "  ", " \\\n    '1:verb:->verb' \\\n    '*::argument:->rest'");
    out += "  case $state in\n    verb)\n      local -a verbs\n      verbs=(\n";
    for (const ProgramHelp& verb : program.verbs) out += "        '" + verb.name + ":" + quoted(verb.summary) + "'\n";
    out += "      )\n      _describe verb verbs\n      ;;\n    rest)\n      case $line[1] in\n";
    for (const ProgramHelp& verb : program.verbs)
      out += "        " + verb.name + ")\n" + argumentsOf(verb, "          ", "") + "          ;;\n";
    out += "      esac\n      ;;\n  esac\n";
  }
  return out + "}\n\n" + function + " \"$@\"\n";
}

}  // namespace windloom::cli
