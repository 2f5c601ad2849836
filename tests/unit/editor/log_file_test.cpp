#include "editor/core/log_file.hpp"

#include <gtest/gtest.h>

#include "editor_bench.hpp"
#include "engine/core/file.hpp"

namespace windloom::editor {

TEST(LogFile, HoldsNoLineThatATextForged) {
  TempFolder folder;
  {
    LogFile file(folder / "state");
    file.add(LogLevel::Warning,
             "can't open a\x1B[2J\n2026-01-01 00:00:00 1 error: forged\xC2\x9B"
             "31m.json");
    file.add(LogLevel::Info, "next");
  }
  const std::string text = readFile(folder / "state" / "log.txt").value();
  EXPECT_EQ(text.find('\x1B'), std::string::npos);
  EXPECT_NE(text.find("warning: can't open a\\x1B[2J\n    2026-01-01 00:00:00 1 error: forged\\xC2\\x9B31m.json\n"),
            std::string::npos)
      << text;
  namespace fs = std::filesystem;
  EXPECT_EQ(fs::status(folder / "state").permissions(), static_cast<fs::perms>(0700));
}

}  // namespace windloom::editor
