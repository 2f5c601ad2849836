/* The reading side of the live link; live_format.h has the layout.
 *
 * The object is read with pread() and not mapped: whoever may write to it may also cut it short, and touching a mapped
 * page that is gone ends a program, while a read merely comes back short. It costs the same, since each field is
 * copied once anyway. Systems whose shared memory can't be read like that have no live link. */
#if !defined(_WIN32) && !defined(_GNU_SOURCE)
#define _GNU_SOURCE /* flock, pread, shm_open */
#endif

#include "engine/runtime/pack.h"

#include <stdlib.h>

#if defined(__linux__) || defined(__FreeBSD__)

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdatomic.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/runtime/live_format.h"
#include "engine/runtime/windpack_format.h"

/* A field is overtaken by four others only where this program was stopped in the middle. */
enum { kAttempts = 8 };

struct windloom_live {
  int object;
  uint64_t newest;     /* number of the field in `field` */
  windloom_pack field; /* of one frame; width 0 before the first */
  void* incoming;      /* as large as field.cells */
};

static int read_at(const windloom_live* live, uint64_t at, void* to, size_t bytes) {
  ssize_t got;
  do {
    got = pread(live->object, to, bytes, (off_t)at);
  } while (got < 0 && errno == EINTR);
  return got == (ssize_t)bytes;
}

/* The writer's lock goes with its process, however it ends. */
static int writer_is_gone(const windloom_live* live) {
  if (flock(live->object, LOCK_SH | LOCK_NB) != 0) return 0;
  flock(live->object, LOCK_UN);
  return 1;
}

static windloom_status check_object(const windloom_live* live) {
  unsigned char header[WINDLIVE_HEADER_BYTES];
  struct stat found;
  if (fstat(live->object, &found) != 0 || !read_at(live, 0, header, sizeof header)) return WINDLOOM_NO_LIVE_FIELD;
  if (memcmp(header, WINDLIVE_MAGIC, 8) != 0) return WINDLOOM_NO_LIVE_FIELD;
  uint32_t numbers[4]; /* version, slots, bytes of a slot, ended */
  memcpy(numbers, header + WINDLIVE_AT_VERSION, sizeof numbers);
  if (numbers[0] > WINDLIVE_VERSION) return WINDLOOM_NEWER_VERSION;
  if (numbers[0] != WINDLIVE_VERSION || numbers[1] != WINDLIVE_SLOTS || numbers[2] != WINDLIVE_SLOT_BYTES ||
      found.st_size != (off_t)WINDLIVE_BYTES) {
    return WINDLOOM_DAMAGED;
  }
  return numbers[3] != 0 || writer_is_gone(live) ? WINDLOOM_NO_LIVE_FIELD : WINDLOOM_OK;
}

/* Opens the object and takes the memory. */
static windloom_status open_object(const char* name, windloom_live* live) {
  char path[WINDLIVE_MAX_NAME + 2] = "/";
  const size_t length = strlen(name);
  if (length == 0 || length > WINDLIVE_MAX_NAME || strchr(name, '/') != NULL) return WINDLOOM_NO_LIVE_FIELD;
  memcpy(path + 1, name, length + 1);
  live->object = shm_open(path, O_RDONLY | O_CLOEXEC, 0);
  if (live->object < 0) return WINDLOOM_NO_LIVE_FIELD;
  const windloom_status status = check_object(live);
  if (status != WINDLOOM_OK) return status;
  const size_t bytes = WINDLIVE_SLOT_BYTES - WINDLIVE_SLOT_HEADER_BYTES;
  live->field.cells = malloc(bytes);
  live->incoming = malloc(bytes);
  return live->field.cells != NULL && live->incoming != NULL ? WINDLOOM_OK : WINDLOOM_OUT_OF_MEMORY;
}

windloom_live* windloom_live_open(const char* name, windloom_status* status) {
  windloom_live* live = calloc(1, sizeof *live);
  windloom_status result = WINDLOOM_OUT_OF_MEMORY;
  if (live != NULL) {
    live->object = -1;
    result = open_object(name != NULL ? name : WINDLIVE_DEFAULT_NAME, live);
  }
  if (status != NULL) *status = result;
  if (result == WINDLOOM_OK) return live;
  windloom_live_close(live);
  return NULL;
}

/* What a slot says about its field, as a pack's header would; 0 where it makes no sense. */
static int read_field_info(const unsigned char* slot, windloom_info* info) {
  uint32_t sides[2], flags;
  float bounds[5];
  memcpy(sides, slot + WINDLIVE_AT_WIDTH, sizeof sides);
  memcpy(bounds, slot + WINDLIVE_AT_MIN_X, sizeof bounds);
  memcpy(&flags, slot + WINDLIVE_AT_FLAGS, sizeof flags);
  memcpy(&info->start, slot + WINDLIVE_AT_TIME, sizeof info->start);
  if (sides[0] - 1u >= WINDLIVE_MAX_SIDE || sides[1] - 1u >= WINDLIVE_MAX_SIDE) return 0;
  for (int i = 0; i < 4; ++i) {
    if (!(fabsf(bounds[i]) <= WINDPACK_MAX_COORDINATE)) return 0;
  }
  if (!(bounds[0] < bounds[2] && bounds[1] < bounds[3] && bounds[4] >= 0.0f)) return 0;
  if (!isfinite(bounds[4]) || !isfinite(info->start)) return 0;
  info->width = (int)sides[0];
  info->height = (int)sides[1];
  info->frames = 1;
  info->min_x = bounds[0];
  info->min_z = bounds[1];
  info->max_x = bounds[2];
  info->max_z = bounds[3];
  info->max_speed = bounds[4];
  info->edge_x = (flags & WINDPACK_FLAG_WRAP_X) != 0 ? WINDLOOM_WRAP : WINDLOOM_CLAMP;
  info->edge_z = (flags & WINDPACK_FLAG_WRAP_Z) != 0 ? WINDLOOM_WRAP : WINDLOOM_CLAMP;
  info->reference_height = 2.0f;
  return 1;
}

/* Takes over field `number`; 0 where it was overwritten meanwhile or makes no sense. All numbers that sizes come from
 * are this function's own copies. */
static int take(windloom_live* live, uint64_t number) {
  const uint64_t at = WINDLIVE_HEADER_BYTES + number % WINDLIVE_SLOTS * WINDLIVE_SLOT_BYTES;
  unsigned char slot[WINDLIVE_SLOT_HEADER_BYTES];
  uint64_t before, after;
  windloom_info info = {0};
  if (!read_at(live, at + WINDLIVE_AT_SEQUENCE, &before, sizeof before) || before != 2 * number) return 0;
  atomic_thread_fence(memory_order_seq_cst);
  if (!read_at(live, at, slot, sizeof slot) || !read_field_info(slot, &info)) return 0;
  const size_t bytes = (size_t)info.width * (size_t)info.height * WINDLIVE_CELL_BYTES;
  if (!read_at(live, at + WINDLIVE_SLOT_HEADER_BYTES, live->incoming, bytes)) return 0;
  atomic_thread_fence(memory_order_seq_cst);
  if (!read_at(live, at + WINDLIVE_AT_SEQUENCE, &after, sizeof after) || after != before) return 0;
  if (!windloom_adopt_cells(live->incoming, bytes, 0)) return 0;
  void* last = live->field.cells;
  live->field.cells = live->incoming;
  live->incoming = last;
  windloom_prepare(&live->field, &info, 0);
  live->newest = number;
  return 1;
}

int windloom_live_update(windloom_live* live) {
  uint32_t ended = 0;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    uint64_t newest = 0;
    if (!read_at(live, WINDLIVE_AT_ENDED, &ended, sizeof ended)) return -1;
    if (!read_at(live, WINDLIVE_AT_NEWEST, &newest, sizeof newest)) return -1;
    if (newest == live->newest || newest == 0) break;
    atomic_thread_fence(memory_order_seq_cst);
    if (take(live, newest)) return 1;
  }
  return ended != 0 || writer_is_gone(live) ? -1 : 0;
}

windloom_info windloom_live_info(const windloom_live* live) {
  return live->field.info;
}

void windloom_live_sample(const windloom_live* live, float x, float z, float velocity[2]) {
  windloom_live_sample_many(live, (const float[2]){x, z}, 1, velocity);
}

void windloom_live_sample_many(const windloom_live* live, const float* positions, size_t count, float* velocities) {
  if (live->field.info.width > 0) {
    windloom_sample_many(&live->field, positions, count, 0.0, velocities);
  } else {
    memset(velocities, 0, 2 * count * sizeof *velocities);
  }
}

void windloom_live_close(windloom_live* live) {
  if (live == NULL) return;
  if (live->object >= 0) close(live->object);
  free(live->field.cells);
  free(live->incoming);
  free(live);
}

#else

windloom_live* windloom_live_open(const char* name, windloom_status* status) {
  (void)name;
  if (status != NULL) *status = WINDLOOM_NOT_HERE;
  return NULL;
}

/* Nobody has a link to call these with. */

int windloom_live_update(windloom_live* live) {
  (void)live;
  return -1;
}

windloom_info windloom_live_info(const windloom_live* live) {
  (void)live;
  const windloom_info none = {0};
  return none;
}

void windloom_live_sample(const windloom_live* live, float x, float z, float velocity[2]) {
  (void)live;
  (void)x;
  (void)z;
  velocity[0] = velocity[1] = 0.0f;
}

void windloom_live_sample_many(const windloom_live* live, const float* positions, size_t count, float* velocities) {
  (void)live;
  (void)positions;
  for (size_t i = 0; i < 2 * count; ++i) velocities[i] = 0.0f;
}

void windloom_live_close(windloom_live* live) {
  (void)live;
}

#endif
