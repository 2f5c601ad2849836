// Preloaded into a program, makes chosen system calls of it fail, stop half way, or be its last one, and writes down the
// calls that touch a chosen folder.
//
// FAULTS_FOLDER  only calls on paths in this folder count, and on descriptors that were opened in it
// FAULTS_CALLS   names of calls that count, between commas; every known one without it
// FAULTS_AT      the number of the call to hit, from 1; 0: none
// FAULTS_DO      "kill", "short" (half of the bytes are written), or an error by its name: ENOSPC
// FAULTS_AGAIN   1: all later ones, too
// FAULTS_LOG     every counted call becomes a line there: number, call, result, paths
//
// The program may call faults_disarm(): nothing happens from there on.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

enum { kDescriptors = 4096 };

static struct {
  int ready, at, again, disarmed, count, log, kill, half, error;
  char folder[PATH_MAX];
  const char* calls;
  char* paths[kDescriptors];  // of descriptors in the folder
} state = {.log = -1};
static pthread_mutex_t guard = PTHREAD_MUTEX_INITIALIZER;

static const struct {
  const char* name;
  int number;
} kErrors[] = {{"ENOSPC", ENOSPC}, {"EACCES", EACCES}, {"EIO", EIO},       {"EDQUOT", EDQUOT}, {"EINTR", EINTR},
               {"EROFS", EROFS},   {"EMFILE", EMFILE}, {"ENOMEM", ENOMEM}, {"EPERM", EPERM},   {"EMLINK", EMLINK}, {"EBADF", EBADF}, {"ENOLCK", ENOLCK}};

static int numberOf(const char* name) {
  const char* text = getenv(name);
  return text ? atoi(text) : 0;
}

__attribute__((constructor)) static void start(void) {
  if (state.ready) return;
  const char* folder = getenv("FAULTS_FOLDER");
  const char* deed = getenv("FAULTS_DO");
  state.ready = 1;
  if (!folder) return;
  snprintf(state.folder, sizeof state.folder, "%s", folder);
  state.calls = getenv("FAULTS_CALLS");
  state.at = numberOf("FAULTS_AT");
  state.again = numberOf("FAULTS_AGAIN");
  state.kill = deed && strcmp(deed, "kill") == 0;
  state.half = deed && strcmp(deed, "short") == 0;
  for (size_t i = 0; deed && i < sizeof kErrors / sizeof kErrors[0]; ++i) {
    if (strcmp(deed, kErrors[i].name) == 0) state.error = kErrors[i].number;
  }
  const char* log = getenv("FAULTS_LOG");
  if (log) state.log = (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
}

void faults_disarm(void) { state.disarmed = 1; }

static int inFolder(const char* path) {
  const size_t length = strlen(state.folder);
  return path && length > 0 && strncmp(path, state.folder, length) == 0 && (path[length] == 0 || path[length] == '/');
}

static const char* pathOf(int descriptor) {
  return descriptor >= 0 && descriptor < kDescriptors ? state.paths[descriptor] : NULL;
}

/// The whole path of a name below a descriptor, as far as it is of interest; `name` itself else.
static const char* joined(int folder, const char* name, char* buffer) {
  const char* above = name && name[0] != '/' && folder != AT_FDCWD ? pathOf(folder) : NULL;
  if (!above) return name;
  snprintf(buffer, PATH_MAX, "%s/%s", above, name);
  return buffer;
}

static int counts(const char* call) {
  if (!state.calls) return 1;
  const char* found = strstr(state.calls, call);
  const size_t length = strlen(call);
  while (found) {
    if ((found == state.calls || found[-1] == ',') && (found[length] == 0 || found[length] == ',')) return 1;
    found = strstr(found + 1, call);
  }
  return 0;
}

enum { kGoOn = 0, kFail = 1, kHalf = 2 };

/// What shall become of a call. Kills here; sets errno where it shall fail. The guard is held.
static int judge(const char* call, const char* path) {
  start();
  if (!inFolder(path) || state.disarmed || !counts(call)) return kGoOn;
  const int number = ++state.count;
  const int hit = state.at > 0 && (number == state.at || (state.again && number > state.at));
  if (!hit) return kGoOn;
  if (state.kill) {
    syscall(SYS_kill, (int)getpid(), SIGKILL);
    for (;;) pause();
  }
  if (state.half) return kHalf;
  if (!state.error) return kGoOn;
  errno = state.error;
  return kFail;
}

/// A line for the log, of a call that counted.
static void tell(const char* call, const char* first, const char* second, long result) {
  if (state.log < 0 || state.disarmed || (!inFolder(first) && !inFolder(second))) return;
  const int kept = errno;
  char line[3 * PATH_MAX];
  const int length = snprintf(line, sizeof line, "%d\t%s\t%ld\t%s\t%s\n", state.count, call, result, first ? first : "",
                              second ? second : "");
  syscall(SYS_write, state.log, line, (size_t)length);
  errno = kept;
}

static void remember(long descriptor, const char* path) {
  if (descriptor < 0 || descriptor >= kDescriptors) return;
  free(state.paths[descriptor]);
  state.paths[descriptor] = path && inFolder(path) ? strdup(path) : NULL;
}

static const char* orNone(const char* path) { return path ? path : ""; }

static int openAny(int folder, const char* name, int flags, mode_t mode) {
  char buffer[PATH_MAX];
  pthread_mutex_lock(&guard);
  const char* path = joined(folder, name, buffer);
  long result = -1;
  if (judge("open", orNone(path)) != kFail) {
    result = syscall(SYS_openat, folder, name, flags, mode);
    remember(result, path);
    tell(flags & (O_CREAT | O_TRUNC) ? "create" : "open", path, NULL, result);
  }
  pthread_mutex_unlock(&guard);
  return (int)result;
}

#define OPEN_MODE                                      \
  mode_t mode = 0;                                     \
  if (flags & O_CREAT) {                               \
    va_list rest;                                      \
    va_start(rest, flags);                             \
    mode = va_arg(rest, mode_t);                       \
    va_end(rest);                                      \
  }

int open(const char* path, int flags, ...) { OPEN_MODE return openAny(AT_FDCWD, path, flags, mode); }
int open64(const char* path, int flags, ...) { OPEN_MODE return openAny(AT_FDCWD, path, flags, mode); }
int openat(int at, const char* path, int flags, ...) { OPEN_MODE return openAny(at, path, flags, mode); }
int openat64(int at, const char* path, int flags, ...) { OPEN_MODE return openAny(at, path, flags, mode); }
int creat(const char* path, mode_t mode) { return openAny(AT_FDCWD, path, O_CREAT | O_WRONLY | O_TRUNC, mode); }

/// Fills the six X before the last `suffix` bytes; another try gives another name.
static void fill(char* name, int suffix, unsigned try) {
  static const char kLetters[] = "abcdefghijklmnopqrstuvwxyz0123456789";
  unsigned long dice = (unsigned long)getpid() * 2654435761u + try * 40503u + (unsigned long)state.count;
  char* at = name + strlen(name) - suffix - 6;
  for (int i = 0; i < 6; ++i, dice /= 36) at[i] = kLetters[dice % 36];
}

int mkostemps(char* name, int suffix, int flags) {
  for (unsigned try = 0; try < 1000; ++try) {
    fill(name, suffix, try);
    const int made = openAny(AT_FDCWD, name, flags | O_RDWR | O_CREAT | O_EXCL, 0600);
    if (made >= 0 || errno != EEXIST) return made;
  }
  return -1;
}
int mkostemp(char* name, int flags) { return mkostemps(name, 0, flags); }
int mkostemp64(char* name, int flags) { return mkostemps(name, 0, flags); }
int mkostemps64(char* name, int suffix, int flags) { return mkostemps(name, suffix, flags); }
int mkstemp(char* name) { return mkostemps(name, 0, 0); }
int mkstemp64(char* name) { return mkostemps(name, 0, 0); }

/// A call on one or two paths.
static int onPaths(const char* call, const char* first, const char* second, long number, long a, long b, long c, long d,
                   long e) {
  pthread_mutex_lock(&guard);
  long result = -1;
  const char* counted = inFolder(first) || !second ? first : second;
  if (judge(call, orNone(counted)) != kFail) {
    result = syscall(number, a, b, c, d, e);
    tell(call, first, second, result);
  }
  pthread_mutex_unlock(&guard);
  return (int)result;
}

int mkdirat(int at, const char* path, mode_t mode) {
  char buffer[PATH_MAX];
  return onPaths("mkdir", joined(at, path, buffer), NULL, SYS_mkdirat, at, (long)path, mode, 0, 0);
}
int mkdir(const char* path, mode_t mode) { return mkdirat(AT_FDCWD, path, mode); }
char* mkdtemp(char* name) {
  for (unsigned try = 0; try < 1000; ++try) {
    fill(name, 0, try);
    if (mkdir(name, 0700) == 0) return name;
    if (errno != EEXIST) break;
  }
  return NULL;
}
int renameat2(int from, const char* a, int to, const char* b, unsigned flags) {
  char first[PATH_MAX], second[PATH_MAX];
  return onPaths("rename", joined(from, a, first), joined(to, b, second), SYS_renameat2, from, (long)a, to, (long)b,
                 flags);
}
int renameat(int from, const char* a, int to, const char* b) { return renameat2(from, a, to, b, 0); }
int rename(const char* a, const char* b) { return renameat2(AT_FDCWD, a, AT_FDCWD, b, 0); }
int linkat(int from, const char* a, int to, const char* b, int flags) {
  char first[PATH_MAX], second[PATH_MAX];
  return onPaths("link", joined(from, a, first), joined(to, b, second), SYS_linkat, from, (long)a, to, (long)b, flags);
}
int link(const char* a, const char* b) { return linkat(AT_FDCWD, a, AT_FDCWD, b, 0); }
int unlinkat(int at, const char* path, int flags) {
  char buffer[PATH_MAX];
  return onPaths(flags & AT_REMOVEDIR ? "rmdir" : "unlink", joined(at, path, buffer), NULL, SYS_unlinkat, at, (long)path,
                 flags, 0, 0);
}
int unlink(const char* path) { return unlinkat(AT_FDCWD, path, 0); }
int rmdir(const char* path) { return unlinkat(AT_FDCWD, path, AT_REMOVEDIR); }
int remove(const char* path) {
  const int done = unlink(path);
  return done != 0 && errno == EISDIR ? rmdir(path) : done;
}

/// A call on a descriptor that moves no bytes.
static int onDescriptor(const char* call, int descriptor, long number, long a, long b) {
  pthread_mutex_lock(&guard);
  const char* path = pathOf(descriptor);
  long result = -1;
  if (!path || judge(call, path) != kFail) {
    result = syscall(number, descriptor, a, b);
    if (path) tell(call, path, NULL, result);
  }
  pthread_mutex_unlock(&guard);
  return (int)result;
}

int fsync(int d) { return onDescriptor("fsync", d, SYS_fsync, 0, 0); }
int fdatasync(int d) { return onDescriptor("fsync", d, SYS_fdatasync, 0, 0); }
int syncfs(int d) { return onDescriptor("syncfs", d, SYS_syncfs, 0, 0); }
int ftruncate(int d, off_t length) { return onDescriptor("ftruncate", d, SYS_ftruncate, length, 0); }
int ftruncate64(int d, off_t length) { return onDescriptor("ftruncate", d, SYS_ftruncate, length, 0); }
int fchmod(int d, mode_t mode) { return onDescriptor("fchmod", d, SYS_fchmod, mode, 0); }
int flock(int d, int how) { return onDescriptor("flock", d, SYS_flock, how, 0); }

/// The number is free afterwards, whatever is told of it.
int close(int d) {
  pthread_mutex_lock(&guard);
  char* path = d >= 0 && d < kDescriptors ? state.paths[d] : NULL;
  const int verdict = path ? judge("close", path) : kGoOn;
  const int code = errno;
  long result = syscall(SYS_close, d);
  if (path) {
    tell("close", path, NULL, result);
    remember(d, NULL);
  }
  if (verdict == kFail) {
    errno = code;
    result = -1;
  }
  pthread_mutex_unlock(&guard);
  return (int)result;
}

int fcntl(int d, int what, ...) {
  va_list rest;
  va_start(rest, what);
  const long argument = va_arg(rest, long);
  va_end(rest);
  pthread_mutex_lock(&guard);
  const long result = syscall(SYS_fcntl, d, what, argument);
  if (what == F_DUPFD || what == F_DUPFD_CLOEXEC) remember(result, pathOf(d));
  pthread_mutex_unlock(&guard);
  return (int)result;
}
int fcntl64(int d, int what, ...) {
  va_list rest;
  va_start(rest, what);
  const long argument = va_arg(rest, long);
  va_end(rest);
  return fcntl(d, what, argument);
}

/// Part of `size`, which is not nothing.
static size_t shorter(int verdict, size_t size) { return verdict == kHalf && size > 1 ? size / 2 : size; }

static ssize_t moveBytes(const char* call, int counted, size_t size, long number, long a, long b, long c, long d) {
  pthread_mutex_lock(&guard);
  const char* path = pathOf(counted);
  const int verdict = path ? judge(call, path) : kGoOn;
  pthread_mutex_unlock(&guard);
  if (verdict == kFail) return -1;
  size = shorter(verdict, size);
  const ssize_t result = number == SYS_sendfile          ? syscall(number, a, b, c, size)
                         : number == SYS_copy_file_range ? syscall(number, a, b, c, d, size, 0)
                                                         : syscall(number, a, b, size, c);
  if (path) {
    pthread_mutex_lock(&guard);
    tell(call, path, NULL, result);
    pthread_mutex_unlock(&guard);
  }
  return result;
}

ssize_t write(int d, const void* bytes, size_t size) {
  return moveBytes("write", d, size, SYS_write, d, (long)bytes, 0, 0);
}
ssize_t pwrite(int d, const void* bytes, size_t size, off_t at) {
  return moveBytes("write", d, size, SYS_pwrite64, d, (long)bytes, at, 0);
}
ssize_t pwrite64(int d, const void* bytes, size_t size, off_t at) { return pwrite(d, bytes, size, at); }
ssize_t sendfile(int to, int from, off_t* at, size_t size) {
  return moveBytes("write", to, size, SYS_sendfile, to, from, (long)at, 0);
}
ssize_t sendfile64(int to, int from, off_t* at, size_t size) { return sendfile(to, from, at, size); }
ssize_t writev(int d, const struct iovec* parts, int count) {
  ssize_t all = 0;
  for (int i = 0; i < count; ++i) {
    const ssize_t n = write(d, parts[i].iov_base, parts[i].iov_len);
    if (n < 0) return all > 0 ? all : n;
    all += n;
    if ((size_t)n < parts[i].iov_len) break;
  }
  return all;
}
int posix_fallocate(int d, off_t at, off_t length) {
  pthread_mutex_lock(&guard);
  const char* path = pathOf(d);
  int result = -1;
  if (!path || judge("fallocate", path) != kFail) result = (int)syscall(SYS_fallocate, d, 0, at, length);
  const int code = errno;
  pthread_mutex_unlock(&guard);
  return result == 0 ? 0 : code;
}
int posix_fallocate64(int d, off_t at, off_t length) { return posix_fallocate(d, at, length); }
int shm_open(const char* name, int flags, mode_t mode) {
  char path[PATH_MAX];
  snprintf(path, sizeof path, "/dev/shm%s%s", name[0] == '/' ? "" : "/", name);
  return openAny(AT_FDCWD, path, flags | O_NOFOLLOW | O_CLOEXEC, mode);
}
