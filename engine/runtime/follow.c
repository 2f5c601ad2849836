/* Following a file that is replaced from time to time. */
#if !defined(_WIN32) && !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* fileno, st_mtim */
#endif
#if !defined(_WIN32) && !defined(_FILE_OFFSET_BITS)
#define _FILE_OFFSET_BITS 64
#endif
#if defined(__APPLE__) && !defined(_DARWIN_C_SOURCE)
#define _DARWIN_C_SOURCE /* st_mtimespec */
#endif

#include "engine/runtime/pack.h"

#ifndef _WIN32

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

/* What tells one file from another under the same name. A replaced file is another inode; one that was written over
 * has another time or size. */
typedef struct stamp {
  int there;
  long long seconds, nanoseconds, size;
  unsigned long long device, inode;
} stamp;

struct windloom_follow {
  char* path;
  stamp seen; /* of the last attempt to load */
  _Atomic(windloom_pack*) pack;
  windloom_pack* before; /* kept until the next change for threads that still sample it */
  windloom_status status;
  int failed; /* at the last attempt */
};

static stamp stamp_of(const struct stat* found) {
#ifdef __APPLE__
  const struct timespec changed = found->st_mtimespec;
#else
  const struct timespec changed = found->st_mtim;
#endif
  stamp s = {.there = 1};
  s.seconds = (long long)changed.tv_sec;
  s.nanoseconds = (long long)changed.tv_nsec;
  s.size = (long long)found->st_size;
  s.device = (unsigned long long)found->st_dev;
  s.inode = (unsigned long long)found->st_ino;
  return s;
}

static int same(const stamp* a, const stamp* b) {
  return a->there == b->there && a->seconds == b->seconds && a->nanoseconds == b->nanoseconds && a->size == b->size &&
         a->device == b->device && a->inode == b->inode;
}

/* A file that can't be loaded may still be being written, and its time of change is too coarse to tell every write
 * from the next: as long as it is that young it is tried again. */
static int may_be_unfinished(const windloom_follow* follow) {
  const long long age = (long long)time(NULL) - follow->seen.seconds;
  return follow->failed && follow->seen.there && age >= -2 && age <= 2;
}

windloom_follow* windloom_follow_open(const char* path) {
  windloom_follow* follow = calloc(1, sizeof *follow);
  if (follow == NULL) return NULL;
  const size_t size = path != NULL ? strlen(path) + 1 : 1;
  follow->path = malloc(size);
  if (follow->path == NULL) {
    free(follow);
    return NULL;
  }
  memcpy(follow->path, path != NULL ? path : "", size);
  atomic_init(&follow->pack, NULL);
  follow->status = WINDLOOM_CANNOT_READ;
  return follow;
}

/* The pack in the file as it is now, and the stamp of just that file. */
static windloom_pack* load(windloom_follow* follow) {
  FILE* file = fopen(follow->path, "rb");
  follow->status = WINDLOOM_CANNOT_READ;
  if (file == NULL) return NULL;
  struct stat found;
  windloom_pack* pack = NULL;
  if (fstat(fileno(file), &found) == 0) {
    follow->seen = stamp_of(&found);
    pack = windloom_load_stream(file, &follow->status);
  }
  fclose(file);
  return pack;
}

int windloom_follow_poll(windloom_follow* follow) {
  struct stat found;
  /* What isn't a plain file (a pipe) could make opening it wait. */
  const int there = stat(follow->path, &found) == 0 && S_ISREG(found.st_mode);
  const stamp now = there ? stamp_of(&found) : (stamp){0};
  const int changed = !same(&now, &follow->seen);
  if (!changed && !may_be_unfinished(follow)) return 0;
  follow->seen = now;
  windloom_pack* fresh = NULL;
  if (there) {
    fresh = load(follow);
  } else {
    follow->status = WINDLOOM_CANNOT_READ;
  }
  const int failed_again = follow->failed && !changed;
  follow->failed = fresh == NULL;
  if (fresh == NULL) return failed_again ? 0 : -1;
  windloom_free(follow->before);
  follow->before = atomic_load_explicit(&follow->pack, memory_order_relaxed);
  atomic_store_explicit(&follow->pack, fresh, memory_order_release);
  return 1;
}

const windloom_pack* windloom_follow_pack(const windloom_follow* follow) {
  return atomic_load_explicit(&((windloom_follow*)follow)->pack, memory_order_acquire);
}

windloom_status windloom_follow_status(const windloom_follow* follow) {
  return follow->status;
}

void windloom_follow_close(windloom_follow* follow) {
  if (follow == NULL) return;
  windloom_free(follow->before);
  windloom_free(atomic_load_explicit(&follow->pack, memory_order_relaxed));
  free(follow->path);
  free(follow);
}

#else

#include <stdlib.h>

struct windloom_follow {
  int told; /* that this system can't follow */
};

windloom_follow* windloom_follow_open(const char* path) {
  (void)path;
  return calloc(1, sizeof(windloom_follow));
}

int windloom_follow_poll(windloom_follow* follow) {
  const int told = follow->told;
  follow->told = 1;
  return told ? 0 : -1;
}

const windloom_pack* windloom_follow_pack(const windloom_follow* follow) {
  (void)follow;
  return NULL;
}

windloom_status windloom_follow_status(const windloom_follow* follow) {
  (void)follow;
  return WINDLOOM_NOT_HERE;
}

void windloom_follow_close(windloom_follow* follow) {
  free(follow);
}

#endif
