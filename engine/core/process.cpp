#include "engine/core/process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

namespace windloom {

void prepareProcess() {
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream) {
    if (::fcntl(stream, F_GETFD) >= 0) continue;
    // The lowest free number is this stream's. Opened the wrong way round, so that using it still fails.
    static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
  ::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace windloom
