#include "editor/app/user_folders.hpp"

#include <gtest/gtest.h>
#include <pwd.h>
#include <unistd.h>

#include <cstdlib>

namespace windloom::editor {
namespace {

/// Begins without what the user of the test has set.
class UserFolders : public ::testing::Test {
 protected:
  UserFolders() {
    for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"}) ::unsetenv(variable);
  }
};

}  // namespace

TEST_F(UserFolders, AreWhereTheVariablesSay) {
  ::setenv("HOME", "/home/me", 1);
  EXPECT_EQ(preferencesFile(), "/home/me/.config/windloom/preferences.json");
  EXPECT_EQ(autosaveFolder(), "/home/me/.local/state/windloom/autosave");
  ::setenv("XDG_CONFIG_HOME", "/c", 1);
  ::setenv("XDG_STATE_HOME", "/s", 1);
  EXPECT_EQ(preferencesFile(), "/c/windloom/preferences.json");
  EXPECT_EQ(stateFolder(), "/s/windloom");
}

TEST_F(UserFolders, AreNeverInTheFolderTheEditorIsStartedIn) {
  const passwd* entry = ::getpwuid(::geteuid());
  const std::filesystem::path home = entry ? entry->pw_dir : "";
  const auto expected = home.empty() ? home : home / ".config/windloom/preferences.json";
  EXPECT_EQ(preferencesFile(), expected);
  for (const char* relative : {"", ".", "here"}) {
    ::setenv("HOME", relative, 1);
    ::setenv("XDG_CONFIG_HOME", relative, 1);
    EXPECT_EQ(preferencesFile(), expected) << relative;
  }
}

TEST_F(UserFolders, AreNoneForAUserWithoutAHome) {
  constexpr uid_t kNobodyKnows = 54321;
  if (::geteuid() != 0 || ::getpwuid(kNobodyKnows)) GTEST_SKIP() << "only root can become such a user";
  const auto none = [] {
    if (::seteuid(kNobodyKnows) != 0) std::_Exit(2);
    std::_Exit(preferencesFile().empty() && stateFolder().empty() && autosaveFolder().empty() ? 0 : 1);
  };
  EXPECT_EXIT(none(), ::testing::ExitedWithCode(0), "");
}

}  // namespace windloom::editor
