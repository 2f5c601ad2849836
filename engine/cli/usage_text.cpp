#include "engine/cli/usage_text.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <numeric>
#include <optional>
#include <utility>

#include "engine/cli/program_help.hpp"

namespace windloom::cli {
namespace {

using Words = std::vector<std::string>;

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_option_opts(const CLI::Option* option) const override {
    std::string text = CLI::Formatter::make_option_opts(option);
    const std::size_t dots = text.find(" ...");
    if (!option->get_allow_extra_args() && dots != std::string::npos) text.erase(dots, 4);
    return text;
  }
};

/// How many letters must be put in, left out, changed or swapped with their neighbour.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> twoBefore, before(b.size() + 1), row(b.size() + 1);
  std::iota(before.begin(), before.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t k = 1; k <= b.size(); ++k) {
      row[k] = std::min({before[k] + 1, row[k - 1] + 1, before[k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
        row[k] = std::min(row[k], twoBefore[k - 2] + 1);
    }
    twoBefore = std::exchange(before, row);
  }
  return before.back();
}

/// "; did you mean NAME?", or nothing where none is near.
std::string suggestion(const std::string& found, const Words& names) {
  constexpr std::size_t kLongest = 40;  // of a word that is compared; ours are shorter
  if (found.size() > kLongest) return {};
  const std::string* best = nullptr;
  std::size_t least = 0;
  for (const std::string& name : names) {
    if (name.size() < 3) continue;  // near to everything short
    const std::size_t shared = std::min(found.size(), name.size());
    const bool begins = shared >= 4 && found.compare(0, shared, name, 0, shared) == 0;  // --output, --out
    const std::size_t distance = editDistance(found, name);
    if (!begins && distance > std::max<std::size_t>(1, name.size() / 3)) continue;
    if (best == nullptr || distance < least) {
      best = &name;
      least = distance;
    }
  }
  return best == nullptr ? "" : "; did you mean " + *best + "?";
}

std::string joined(const Words& words, const char* between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

/// As one would type it into a shell.
std::string shellWord(const std::string& word) {
  const bool plainWord = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) != 0 || c >= 0x80 || std::string_view("._-+/,:=@%").find(char(c)) != std::string_view::npos;
  });
  if (plainWord) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

bool isOption(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

Words optionNames(const ProgramHelp& help) {
  Words names;
  for (const OptionHelp& option : help.options) names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

Words verbNames(const ProgramHelp& help) {
  Words names;
  for (const ProgramHelp& verb : help.verbs) names.push_back(verb.name);
  return names;
}

bool isProject(const std::string& word) {
  std::error_code failed;
  return word.ends_with(".wind.json") || std::filesystem::is_regular_file(word, failed);
}

std::string unknownOption(const std::string& word, const Words& names) {
  const std::string name = word.substr(0, word.find('='));
  return "no option " + name + suggestion(name, names);
}

/// A word in front of the verb, or in its place.
std::string strayBeforeVerb(const ProgramHelp& program, const CLI::App* verb, const std::string& word) {
  if (isOption(word)) {
    const std::string name = word.substr(0, word.find('='));
    if (verb != nullptr && verb->get_option_no_throw(name) != nullptr)
      return name + " stands behind the verb: " + program.name + " " + verb->get_name() + " ... " + name;
    return unknownOption(word, optionNames(program));
  }
  const Words verbs = verbNames(program);
  const std::string all = " Verbs: " + joined(verbs, ", ");
  if (isProject(word) && verb != nullptr)
    return "'" + word + "' stands before the verb: " + program.name + " " + verb->get_name() + " " + shellWord(word);
  if (isProject(word))
    return "'" + word + "' is no verb; to open it: " + program.name + " edit " + shellWord(word) + "." + all;
  const std::string meant = suggestion(word, verbs);
  return "'" + word + "' is no verb" + (meant.empty() ? "." : meant) + all;
}

/// "--format png png16" or "--format png, png16": values that should have been one word.
std::optional<std::string> tornList(const ProgramHelp& verb, const Words& words) {
  for (std::size_t i = 0; i + 2 < words.size(); ++i) {
    const auto option = std::ranges::find_if(verb.options, [&](const OptionHelp& known) {
      return known.commas && std::ranges::find(known.names, words[i]) != known.names.end();
    });
    if (option == verb.options.end()) continue;
    Words values;
    for (std::size_t k = i + 1; k < words.size() && !isOption(words[k]); ++k) {
      std::string value = words[k];
      const bool more = value.ends_with(',') || words[k - 1].ends_with(',');
      value.erase(0, value.find_first_not_of(','));
      while (value.ends_with(',')) value.pop_back();
      if (k > i + 1 && !more && std::ranges::find(option->choices, value) == option->choices.end()) break;
      if (!value.empty()) values.push_back(value);
    }
    if (values.size() < 2) continue;
    return words[i] + " takes one word: separate its values by commas without blanks, " + words[i] + " " +
           joined(values, ",");
  }
  return std::nullopt;
}

std::string strayWord(const ProgramHelp& help, const Words& stray, const Words& words) {
  const auto option = std::ranges::find_if(stray, isOption);
  if (option != stray.end()) return unknownOption(*option, optionNames(help));
  if (const auto torn = tornList(help, words)) return *torn;
  return "found '" + stray.front() + "', expected only options there";
}

/// What CLI11 calls "NAME is required".
std::string missingOption(const ProgramHelp& help, const std::string& name) {
  for (const OptionHelp& option : help.options) {
    const bool same = option.names.empty() ? CLI::detail::to_lower(option.value) == name
                                           : std::ranges::find(option.names, name) != option.names.end();
    if (!same) continue;
    if (option.names.empty()) return "expected " + option.value + ": " + option.text;
    return "expected " + name + (option.value.empty() ? "" : " " + option.value);
  }
  return name + " is required";
}

/// CLI11's sentence about how many words an option got.
std::string mismatch(const std::string& text) {
  const std::string name = text.substr(0, text.find(':'));
  const std::size_t type = text.find(" required ");
  if (text.ends_with(" missing") && type != std::string::npos) {
    std::string value = text.substr(type + 10, text.size() - type - 10 - 8);
    value = value.substr(0, value.find(':'));
    return name + ": expected " + (value.empty() ? "a value" : value) + " after it";
  }
  if (text.find(": At Most 1 required") != std::string::npos) return name + " can be given only once";
  return text;
}

Words withoutMarks(Words words) {
  std::erase(words, "--");
  return words;
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> helpFormatter() {
  return std::make_shared<HelpFormatter>();
}

std::string usageProblem(CLI::App& app, const CLI::ParseError& error, const Words& words) {
  const std::string text = error.what();
  const auto kind = static_cast<CLI::ExitCodes>(error.get_exit_code());
  if (kind == CLI::ExitCodes::ArgumentMismatch) return mismatch(text);
  const bool required = kind == CLI::ExitCodes::RequiredError;
  if (!required && kind != CLI::ExitCodes::ExtrasError) return text;
  const ProgramHelp program = describe(app);
  const auto chosen = app.get_subcommands();
  CLI::App* verb = chosen.empty() ? nullptr : chosen.front();
  const Words before = withoutMarks(app.remaining());
  if (!program.verbs.empty()) {
    if (!before.empty()) return strayBeforeVerb(program, verb, before.front());
    if (verb == nullptr) return "expected a verb: " + joined(verbNames(program), ", ");
  }
  const ProgramHelp help = verb != nullptr ? describe(*verb) : program;
  const Words stray = verb != nullptr ? withoutMarks(verb->remaining()) : before;
  // What is missing may be there under another name.
  if (!stray.empty() && (!required || std::ranges::any_of(stray, isOption))) return strayWord(help, stray, words);
  if (!required) return text;
  const std::size_t end = text.find(" is required");
  return end == std::string::npos ? text : missingOption(help, text.substr(0, end));
}

}  // namespace windloom::cli
