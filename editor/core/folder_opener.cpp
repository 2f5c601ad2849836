#include "editor/core/folder_opener.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace windloom::editor {
namespace {

Error cantShow(const std::filesystem::path& folder, const std::string& why) {
  return makeError(ErrorKind::Machine, folder.string(), {}, "can't be shown: " + why);
}

/// The exit statuses of xdg-open(1).
std::string meaningOf(int status) {
  if (!WIFEXITED(status)) return "xdg-open was ended by a signal";
  switch (WEXITSTATUS(status)) {
    case 2:
      return "it doesn't exist";
    case 3:
      return "no file manager was found";
    default:
      return "xdg-open ended with " + std::to_string(WEXITSTATUS(status));
  }
}

}  // namespace

Status FolderOpener::open(const std::filesystem::path& folder) {
  std::error_code failed;
  std::string path = std::filesystem::absolute(folder, failed).string();
  if (failed) return cantShow(folder, failed.message());
  std::string program = "xdg-open";
  char* const arguments[] = {program.data(), path.data(), nullptr};
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  // What it prints doesn't belong into the editor's log.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  pid_t child = 0;
  const int failure = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, arguments, environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return cantShow(folder, failure == ENOENT ? "xdg-open is not installed" : std::strerror(failure));
  m_children.push_back({child, folder});
  return Done{};
}

std::optional<Error> FolderOpener::poll() {
  std::optional<Error> problem;
  std::erase_if(m_children, [&](const Child& child) {
    int status = 0;
    if (::waitpid(child.process, &status, WNOHANG) == 0) return false;
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) problem = cantShow(child.folder, meaningOf(status));
    return true;
  });
  return problem;
}

}  // namespace windloom::editor
