#include <algorithm>

#include "engine/cli/completion.hpp"

namespace windloom::cli {
namespace {

// `cur` is the word under the cursor; where it follows "--option=" it is what stands behind the sign, which bash makes
// a word of its own.
constexpr const char* kHelpers = R"(
@_words() {
  COMPREPLY=($(compgen -W "$1" -- "$cur"))
}

@_list() {
  local before=""
  [[ $cur == *,* ]] && before=${cur%,*},
  COMPREPLY=($(compgen -P "$before" -W "$1" -- "${cur##*,}"))
  compopt -o nospace 2>/dev/null
}

@_files() {
  local IFS=$'\n'
  compopt -o filenames 2>/dev/null
  COMPREPLY=($(compgen -d -- "$cur") $([[ $1 == / ]] || compgen -f -X "!*$1" -- "$cur"))
}
)";

constexpr const char* kBegin = R"(
@() {
  local cur=${COMP_WORDS[COMP_CWORD]} option=${COMP_WORDS[COMP_CWORD-1]} verb="" i
  COMPREPLY=()
  if [[ $cur == = ]]; then
    cur=""
  elif [[ $option == = ]]; then
    option=${COMP_WORDS[COMP_CWORD-2]}
  fi
)";

std::string replaced(std::string text, const std::string& name) {
  for (std::size_t at = text.find('@'); at != std::string::npos; at = text.find('@', at + name.size()))
    text.replace(at, 1, name);
  return text;
}

std::string joined(const std::vector<std::string>& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// What completes a value; empty where nothing can be offered.
std::string offerOf(const OptionHelp& option, const std::string& function) {
  switch (option.kind) {
    case ValueKind::Choice:
      return function + (option.commas ? "_list" : "_words") + " \"" + joined(option.choices, " ") + "\"";
    case ValueKind::File:
      return function + "_files \"" + option.suffix + "\"";
    case ValueKind::Folder:
      return function + "_files /";
    case ValueKind::Word:
    case ValueKind::None:
      break;
  }
  return ":";
}

/// Completes the words of one verb; `indent` stands before each line.
std::string bodyOf(const ProgramHelp& help, const std::string& function, const std::string& indent) {
  std::string out = indent + "case $option in\n";
  std::vector<std::string> names;
  std::string place;
  for (const OptionHelp& option : help.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
    if (option.names.empty() && place.empty()) place = offerOf(option, function);
    if (option.names.empty() || option.kind == ValueKind::None || option.valueMayMiss) continue;
    out += indent + "  " + joined(option.names, " | ") + ") " + offerOf(option, function) + "; return ;;\n";
  }
  out += indent + "esac\n";
  out += indent + "if [[ $cur == -* ]]; then\n";
  out += indent + "  " + function + "_words \"" + joined(names, " ") + "\"\n";
  if (!place.empty() && place != ":") out += indent + "else\n" + indent + "  " + place + "\n";
  return out + indent + "fi\n";
}

}  // namespace

std::string bashCompletion(const ProgramHelp& program) {
  std::string function = "_" + program.name;
  std::replace(function.begin(), function.end(), '-', '_');
  std::string out = "# bash completion of " + program.name + ", made from its own options by `windloom docs`.\n";
  out += replaced(kHelpers, function) + replaced(kBegin, function);
  if (program.verbs.empty()) {
    out += bodyOf(program, function, "  ");
  } else {
    out += "  for ((i = 1; i < COMP_CWORD; ++i)); do\n";
    out += "    [[ ${COMP_WORDS[i]} != -* ]] && { verb=${COMP_WORDS[i]}; break; }\n  done\n";
    std::vector<std::string> words;
    for (const ProgramHelp& verb : program.verbs) words.push_back(verb.name);
    for (const OptionHelp& option : program.options)
      words.insert(words.end(), option.names.begin(), option.names.end());
    out += "  case $verb in\n    \"\") " + function + "_words \"" + joined(words, " ") + "\" ;;\n";
    for (const ProgramHelp& verb : program.verbs)
      out += "    " + verb.name + ")\n" + bodyOf(verb, function, "      ") + "      ;;\n";
    out += "  esac\n";
  }
  return out + "}\n\ncomplete -F " + function + " " + program.name + "\n";
}

}  // namespace windloom::cli
