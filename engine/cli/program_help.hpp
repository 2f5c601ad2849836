#pragma once
// What a program's command line offers, as plain text: made from its options (CLI11), read by the writers of manual
// pages and shell completion. So these can't say anything that --help doesn't.

#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace windloom::cli {

/// What a shell may offer for a value.
enum class ValueKind {
  None,    ///< a flag: there is no value
  Word,    ///< something to type: a number, a size, a name
  Choice,  ///< one of `choices`
  File,    ///< any file, or one that ends in `suffix`
  Folder,
};

struct OptionHelp {
  std::vector<std::string> names;  ///< "-t", "--template"; empty: a positional
  std::string value;               ///< what stands for it in the usage: "NAME", "FILE"
  std::string text;                ///< one sentence
  std::string note;                ///< range, default and what it goes with; "" where there is nothing to say
  ValueKind kind = ValueKind::Word;
  std::vector<std::string> choices;
  std::string suffix;  ///< of files: ".wind.json"
  bool required = false;
  bool valueMayMiss = false;
  bool repeated = false;  ///< takes several, one after the other
  bool commas = false;    ///< takes several with commas between them
};

struct ProgramHelp {
  std::string name;     ///< "windloom", or "bake" of a verb
  std::string summary;  ///< one line
  std::vector<OptionHelp> options;
  std::string footer;
  std::vector<ProgramHelp> verbs;  ///< without those that --help doesn't list
};

/// Names the values that shells offer for an option which checks its values itself. `option` is given back.
CLI::Option* offer(CLI::Option* option, const std::vector<std::string>& values);

/// The program or verb with all that --help lists.
ProgramHelp describe(CLI::App& app);

}  // namespace windloom::cli
