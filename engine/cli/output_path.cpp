#include "engine/cli/output_path.hpp"

#include <system_error>

namespace windloom::cli {

Status requireFolderOf(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  if (folder.empty()) return Done{};
  std::error_code failed;
  const std::filesystem::file_type type = std::filesystem::status(folder, failed).type();
  if (type == std::filesystem::file_type::not_found)
    return makeError(ErrorKind::BadInput, file.string(), {}, "the folder " + folder.string() + " doesn't exist");
  return Done{};  // other troubles are told by whoever writes
}

}  // namespace windloom::cli
