#pragma once
// A folder that a test fills and that goes with it.

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace windloom {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "windloom-test-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) m_path = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return m_path; }
  [[nodiscard]] long entries() const { return std::distance(std::filesystem::directory_iterator(m_path), {}); }

 private:
  std::filesystem::path m_path;
};

}  // namespace windloom
