// The editor's preferences file and the keymap in it. Whatever the file holds, preferences come out that can be written
// and read again as they are.

#include <cmath>

#include "editor/core/actions.hpp"
#include "editor/core/preferences.hpp"
#include "tests/fuzz/support/fuzz_target.hpp"
#include "tests/fuzz/support/json_mutator.hpp"

using namespace windloom;
using namespace windloom::editor;
using fuzz::require;

namespace {

constexpr const char* kIds[] = {"edit.undo", "edit.redo", "tool.draw", "view.top", "file.save"};

ActionTable table() {
  ActionTable actions;
  Key key = Key::A;
  for (const char* id : kIds) {
    Action action{.id = id, .label = id, .category = "Edit", .help = ""};
    action.shortcuts = {{key, {}}};
    action.run = [] {};
    actions.add(std::move(action));
    key = static_cast<Key>(static_cast<int>(key) + 1);
  }
  return actions;
}

void tryKeymap(const std::string& keymap) {
  ActionTable actions = table();
  const Status applied = actions.applyKeymap(keymap);
  require(applied.ok() || !applied.error().text().empty(), "a refusal says why");
  const std::string kept = actions.keymapJson();
  ActionTable again = table();
  require(again.applyKeymap(kept).ok() && again.keymapJson() == kept, "a keymap is read as it was written");
  static_cast<void>(actions.conflicts());
}

bool same(const Preferences& a, const Preferences& b) {
  return a.theme == b.theme && a.interfaceScale == b.interfaceScale && a.recentFiles == b.recentFiles &&
         a.numbers == b.numbers && a.texts == b.texts && a.firstRunHintSeen == b.firstRunHintSeen;
}

const fuzz::JsonWords& words() {
  static const fuzz::JsonWords kWords{
      {"theme", "interfaceScale", "recentFiles", "keymap", "numbers", "texts", "firstRunHintSeen", "edit.undo",
       "edit.redo", "tool.draw", "view.top", "file.save", "window.width", "layout.left", "export.preset"},
      {"dark", "light", "/tmp/a.wind.json", "Ctrl+K", "Ctrl+Shift+Alt+F12", "Numpad 7", "Page Up", "Ctrl++", "+", "K",
       "ctrl+"}};
  return kWords;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fuzz::ScratchFolder folder;
  std::vector<std::string> warnings;
  Preferences read = readPreferences(folder.put("preferences.json", fuzz::asText(data, size)), &warnings);
  require(read.recentFiles.size() <= kMaxRecent, "recent files are few");
  require(read.interfaceScale == 0 || (read.interfaceScale >= 0.5f && read.interfaceScale <= 4.0f),
          "the scale is usable");
  tryKeymap(read.keymap);

  const std::filesystem::path copy = folder.path() / "copy.json";
  require(writePreferences(copy, read).ok(), "what was read can be written");
  warnings.clear();
  Preferences again = readPreferences(copy, &warnings);
  require(warnings.empty() && same(read, again), "what was written is read as it was");
  read.usedFile("a.wind.json");
  require(read.recentFiles.size() <= kMaxRecent, "recent files stay few");
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t maxSize,
                                               unsigned seed) {
  return fuzz::mutateJson(data, size, maxSize, seed, words());
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t firstSize,
                                                 const std::uint8_t* second, std::size_t secondSize, std::uint8_t* out,
                                                 std::size_t maxSize, unsigned seed) {
  return fuzz::crossJson(first, firstSize, second, secondSize, out, maxSize, seed);
}
