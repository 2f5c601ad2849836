#include "engine/cli/man_page.hpp"

#include <algorithm>
#include <cctype>

#include "engine/cli/man_notes.hpp"

namespace windloom::cli {
namespace {

/// Text as roff: what it would take for its own signs is escaped, and the hyphen of an option stays one that can be
/// copied.
std::string escaped(std::string_view text) {
  std::string out;
  bool option = false;  // within a word that begins with a hyphen
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool wordStart = i == 0 || std::string_view(" '(,=[").find(text[i - 1]) != std::string_view::npos;
    option = c == '-' && wordStart ? true : option && (std::isalnum(static_cast<unsigned char>(c)) || c == '-');
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-' && option) {
      out += "\\-";
    } else {
      if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
      out += c;
    }
  }
  return out;
}

// GCC 12 warns about text + string for no reason.
std::string bold(std::string_view text) {
  return std::string("\\fB").append(escaped(text)).append("\\fR");
}

std::string italic(std::string_view text) {
  return std::string("\\fI").append(escaped(text)).append("\\fR");
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

std::string dashed(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '-');
  return text;
}

std::string synopsisOf(const ProgramHelp& help, const std::string& command) {
  std::string line = bold(command);
  const auto add = [&line](const OptionHelp& option, const std::string& text) {
    line.append(option.required ? " " : " [").append(text).append(option.required ? "" : "]");
    if (option.repeated && option.names.empty()) line += "...";
  };
  for (const OptionHelp& option : help.options)
    if (option.required && !option.names.empty()) add(option, bold(option.names.back()) + " " + italic(option.value));
  line.append(" [").append(italic("OPTION")).append("]...");
  if (!help.verbs.empty()) line.append(" ").append(italic("VERB")).append(" ...");
  for (const OptionHelp& option : help.options)
    if (option.names.empty()) add(option, italic(option.value));
  return line + "\n";
}

std::string optionEntry(const OptionHelp& option) {
  std::string head;
  for (const std::string& name : option.names) head.append(head.empty() ? "" : ", ").append(bold(name));
  const std::string value = italic(option.value);
  if (option.kind != ValueKind::None && !option.names.empty())
    head.append(option.valueMayMiss ? " [" : " ").append(value).append(option.valueMayMiss ? "]" : "");
  if (option.names.empty()) head = value;
  std::string text = option.text;
  if (!text.empty() && std::string_view(".?!").find(text.back()) == std::string_view::npos) text += ".";
  if (option.required) text += " Must be given.";
  if (!option.note.empty()) text.append(" ").append(option.note);
  return ".TP\n" + head + "\n" + escaped(text) + "\n";
}

/// Paragraphs; "  term: text" becomes an entry of a list.
std::string footerText(std::string_view footer) {
  std::string out;
  bool inList = false;
  while (!footer.empty()) {
    const std::size_t end = std::min(footer.find('\n'), footer.size());
    const std::string_view line = footer.substr(0, end);
    footer.remove_prefix(std::min(end + 1, footer.size()));
    const std::size_t colon = line.find(": ");
    if (line.starts_with("  ") && colon != std::string_view::npos) {
      out += ".TP\n" + bold(line.substr(2, colon - 2)) + "\n" + escaped(line.substr(colon + 2)) + "\n";
      inList = true;
    } else if (!line.empty()) {
      if (!out.empty()) out += inList ? ".PP\n" : ".br\n";
      out += escaped(line) + "\n";
      inList = false;
    }
  }
  return out;
}

std::string notesOf(const std::string& page) {
  std::string out;
  for (const ManSection& section : manSections()) {
    const bool all = section.page.ends_with('*') && page.starts_with(section.page.substr(0, section.page.size() - 1));
    if (!all && section.page != page) continue;
    if (!section.title.empty()) out += ".SH " + std::string(section.title) + "\n";
    for (const ManEntry& entry : section.entries) out += ".TP\n" + bold(entry.term) + "\n" + escaped(entry.text) + "\n";
  }
  return out;
}

std::string pageOf(const ProgramHelp& help, const std::string& command, const std::string& version,
                   const std::string& seeAlso) {
  const std::string page = dashed(command);
  std::string out = ".TH " + upper(page) + " 1 \"\" \"windloom " + version + "\" \"Windloom\"\n";
  // Whoever looks for why the page says what it says should not edit it here.
  out += ".\\\" Made from the program's own options by `windloom docs`.\n";
  std::string summary = help.summary;
  // "Windloom: wind drawn ..." would name it twice.
  if (const std::size_t colon = summary.find(": ");
      colon == page.size() && upper(summary.substr(0, colon)) == upper(page))
    summary.erase(0, colon + 2);
  if (summary.ends_with('.')) summary.pop_back();
  out += ".SH NAME\n" + page + " \\- " + escaped(summary) + "\n";
  out += ".SH SYNOPSIS\n.nh\n.ad l\n" + synopsisOf(help, command) + ".ad b\n.hy\n";
  if (!help.verbs.empty()) {
    out += ".SH VERBS\n";
    for (const ProgramHelp& verb : help.verbs)
      out +=
          ".TP\n" + bold(verb.name) + "\n" + escaped(verb.summary) + ": see " + bold(page + "-" + verb.name) + "(1).\n";
  }
  out += ".SH OPTIONS\n";
  for (const OptionHelp& option : help.options) out += optionEntry(option);
  if (!help.footer.empty()) out += ".SH NOTES\n" + footerText(help.footer);
  out += notesOf(page);
  return out + ".SH SEE ALSO\n" + seeAlso;
}

std::string reference(const std::string& page) {
  return bold(page) + "(1)";
}

}  // namespace

std::vector<ManPage> manPages(const ProgramHelp& program, const std::string& version) {
  std::string all;
  for (const ProgramHelp& verb : program.verbs) all += reference(program.name + "-" + verb.name) + ", ";
  const std::string other = program.verbs.empty() ? "windloom" : "windloom-editor";
  std::vector<ManPage> pages{
      {program.name + ".1", pageOf(program, program.name, version, all + reference(other) + "\n")}};
  for (const ProgramHelp& entry : program.verbs) {
    ProgramHelp verb = entry;
    if (verb.footer == program.footer) verb.footer.clear();  // CLI11 hands it down; these pages have sections for it
    const std::string page = program.name + "-" + verb.name;
    pages.push_back({page + ".1", pageOf(verb, program.name + " " + verb.name, version,
                                         reference(program.name) + ", " + reference(other) + "\n")});
  }
  return pages;
}

}  // namespace windloom::cli
