#include "engine/runtime/windloom_runtime.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "engine/runtime/checksum.h"
#include "engine/runtime/windpack_format.h"

struct windloom_pack {
  windloom_info info;
  float cells_per_m_x, cells_per_m_z;
  uint32_t* cells; /* vx in the low half, vz in the high half; z ascending, frame after frame */
};

/* Bytes to numbers, on a machine of any byte order. */

static uint32_t read_u32(const unsigned char* at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static uint64_t read_u64(const unsigned char* at) {
  return read_u32(at) | (uint64_t)read_u32(at + 4) << 32;
}

static float read_f32(const unsigned char* at) {
  const uint32_t bits = read_u32(at);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static double read_f64(const unsigned char* at) {
  const uint64_t bits = read_u64(at);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

/* Loading. */

static windloom_status check_numbers(const windloom_info* info) {
  const float corners[4] = {info->min_x, info->min_z, info->max_x, info->max_z};
  for (int i = 0; i < 4; ++i) {
    if (!(fabsf(corners[i]) <= WINDPACK_MAX_COORDINATE)) return WINDLOOM_DAMAGED;
  }
  if (!(info->min_x < info->max_x) || !(info->min_z < info->max_z)) return WINDLOOM_DAMAGED;
  if (!(info->fps > 0.0f && info->fps <= 1e6f)) return WINDLOOM_DAMAGED;
  if (!(info->max_speed >= 0.0f && info->max_speed <= 65504.0f)) return WINDLOOM_DAMAGED;
  return isfinite(info->start) ? WINDLOOM_OK : WINDLOOM_DAMAGED;
}

/* Reads the first WINDPACK_HEADER_BYTES; `cells` gets the number of cells of all frames. */
static windloom_status parse_header(const unsigned char* bytes, windloom_info* info, uint64_t* cells) {
  if (memcmp(bytes, WINDPACK_MAGIC, 8) != 0) return WINDLOOM_NOT_A_PACK;
  if (read_u32(bytes + WINDPACK_AT_ENDIAN_MARK) != WINDPACK_ENDIAN_MARK) return WINDLOOM_DAMAGED;
  const uint32_t version = read_u32(bytes + WINDPACK_AT_VERSION);
  if (version > WINDPACK_VERSION) return WINDLOOM_NEWER_VERSION;
  const uint32_t flags = read_u32(bytes + WINDPACK_AT_FLAGS);
  if (version == 0 || (flags & ~WINDPACK_FLAGS_KNOWN) != 0 || read_u64(bytes + WINDPACK_AT_RESERVED) != 0) {
    return WINDLOOM_DAMAGED;
  }
  const uint32_t width = read_u32(bytes + WINDPACK_AT_WIDTH);
  const uint32_t height = read_u32(bytes + WINDPACK_AT_HEIGHT);
  const uint32_t frames = read_u32(bytes + WINDPACK_AT_FRAMES);
  if (width == 0 || height == 0 || frames == 0) return WINDLOOM_DAMAGED;
  if (width > WINDPACK_MAX_SIDE || height > WINDPACK_MAX_SIDE || frames > WINDPACK_MAX_FRAMES)
    return WINDLOOM_TOO_LARGE;
  *cells = (uint64_t)width * height * frames;
  if (*cells * WINDPACK_BYTES_PER_CELL > WINDPACK_MAX_DATA_BYTES) return WINDLOOM_TOO_LARGE;
  if (*cells * WINDPACK_BYTES_PER_CELL > SIZE_MAX / 2) return WINDLOOM_TOO_LARGE;
  if (read_u64(bytes + WINDPACK_AT_DATA_BYTES) != *cells * WINDPACK_BYTES_PER_CELL) return WINDLOOM_DAMAGED;
  info->width = (int)width;
  info->height = (int)height;
  info->frames = (int)frames;
  info->min_x = read_f32(bytes + WINDPACK_AT_MIN_X);
  info->min_z = read_f32(bytes + WINDPACK_AT_MIN_Z);
  info->max_x = read_f32(bytes + WINDPACK_AT_MAX_X);
  info->max_z = read_f32(bytes + WINDPACK_AT_MAX_Z);
  info->fps = read_f32(bytes + WINDPACK_AT_FPS);
  info->max_speed = read_f32(bytes + WINDPACK_AT_MAX_SPEED);
  info->start = read_f64(bytes + WINDPACK_AT_START);
  info->loop = (flags & WINDPACK_FLAG_LOOP) != 0;
  info->edge_x = (flags & WINDPACK_FLAG_WRAP_X) != 0 ? WINDLOOM_WRAP : WINDLOOM_CLAMP;
  info->edge_z = (flags & WINDPACK_FLAG_WRAP_Z) != 0 ? WINDLOOM_WRAP : WINDLOOM_CLAMP;
  return check_numbers(info);
}

static windloom_pack* make_pack(const windloom_info* info, uint64_t cells) {
  windloom_pack* pack = malloc(sizeof *pack);
  if (pack == NULL) return NULL;
  pack->info = *info;
  pack->cells_per_m_x = (float)info->width / (info->max_x - info->min_x);
  pack->cells_per_m_z = (float)info->height / (info->max_z - info->min_z);
  pack->cells = malloc((size_t)cells * sizeof *pack->cells);
  if (pack->cells == NULL) {
    free(pack);
    return NULL;
  }
  return pack;
}

/* Checks the values, which still lie in the file's byte order in `pack->cells`, and turns them over. */
static windloom_status adopt_cells(windloom_pack* pack, uint64_t cells, const unsigned char* header,
                                   uint32_t checksum) {
  uint32_t found = windloom_checksum(0, header, WINDPACK_HEADER_BYTES);
  found = windloom_checksum(found, pack->cells, (size_t)cells * sizeof *pack->cells);
  if (found != checksum) return WINDLOOM_DAMAGED;
  uint32_t infinite = 0;
  for (uint64_t i = 0; i < cells; ++i) {
    const uint32_t cell = read_u32((const unsigned char*)&pack->cells[i]);
    infinite |= (uint32_t)((cell & 0x7c00u) == 0x7c00u) | (uint32_t)((cell & 0x7c000000u) == 0x7c000000u);
    pack->cells[i] = cell;
  }
  return infinite == 0 ? WINDLOOM_OK : WINDLOOM_DAMAGED;
}

/* A pack whose cells are still to be filled, from the header and the size of the whole file. */
static windloom_status begin_pack(const unsigned char* header, uint64_t file_bytes, windloom_pack** pack,
                                  uint64_t* cells) {
  windloom_info info = {0};
  const windloom_status status = parse_header(header, &info, cells);
  if (status != WINDLOOM_OK) return status;
  if (file_bytes != WINDPACK_HEADER_BYTES + *cells * WINDPACK_BYTES_PER_CELL + WINDPACK_CHECKSUM_BYTES) {
    return WINDLOOM_CUT_SHORT;
  }
  *pack = make_pack(&info, *cells);
  return *pack != NULL ? WINDLOOM_OK : WINDLOOM_OUT_OF_MEMORY;
}

static windloom_pack* end_load(windloom_pack* pack, windloom_status result, windloom_status* status) {
  if (status != NULL) *status = result;
  if (result == WINDLOOM_OK) return pack;
  windloom_free(pack);
  return NULL;
}

/* Too few bytes for a header: no pack at all, or the start of one? */
static windloom_status status_of_stub(const unsigned char* bytes, size_t size) {
  const size_t compared = size < 8 ? size : 8;
  return size > 0 && memcmp(bytes, WINDPACK_MAGIC, compared) == 0 ? WINDLOOM_CUT_SHORT : WINDLOOM_NOT_A_PACK;
}

windloom_pack* windloom_load_memory(const void* bytes, size_t size, windloom_status* status) {
  const unsigned char* at = bytes;
  if (bytes == NULL || size < WINDPACK_HEADER_BYTES) {
    return end_load(NULL, bytes == NULL ? WINDLOOM_CANNOT_READ : status_of_stub(at, size), status);
  }
  windloom_pack* pack = NULL;
  uint64_t cells = 0;
  windloom_status result = begin_pack(at, size, &pack, &cells);
  if (result == WINDLOOM_OK) {
    const size_t data_bytes = (size_t)cells * WINDPACK_BYTES_PER_CELL;
    memcpy(pack->cells, at + WINDPACK_HEADER_BYTES, data_bytes);
    result = adopt_cells(pack, cells, at, read_u32(at + WINDPACK_HEADER_BYTES + data_bytes));
  }
  return end_load(pack, result, status);
}

/* Size of a file in bytes, or -1; leaves the position at the start. */
static long long file_size(FILE* file) {
  if (fseek(file, 0, SEEK_END) != 0) return -1;
  const long size = ftell(file);
  return fseek(file, 0, SEEK_SET) == 0 ? size : -1;
}

windloom_pack* windloom_load_file(const char* path, windloom_status* status) {
  FILE* file = path != NULL ? fopen(path, "rb") : NULL;
  if (file == NULL) return end_load(NULL, WINDLOOM_CANNOT_READ, status);
  unsigned char header[WINDPACK_HEADER_BYTES];
  unsigned char checksum[WINDPACK_CHECKSUM_BYTES];
  windloom_pack* pack = NULL;
  uint64_t cells = 0;
  windloom_status result = WINDLOOM_CANNOT_READ;
  const long long size = file_size(file);
  if (size >= 0) {
    const size_t got = fread(header, 1, sizeof header, file);
    if (ferror(file)) {
      result = WINDLOOM_CANNOT_READ;
    } else if (got < sizeof header) {
      result = status_of_stub(header, got);
    } else {
      result = begin_pack(header, (uint64_t)size, &pack, &cells);
    }
  }
  if (result == WINDLOOM_OK) {
    const int whole = fread(pack->cells, WINDPACK_BYTES_PER_CELL, (size_t)cells, file) == cells &&
                      fread(checksum, 1, sizeof checksum, file) == sizeof checksum;
    result = whole ? adopt_cells(pack, cells, header, read_u32(checksum)) : WINDLOOM_CANNOT_READ;
  }
  fclose(file);
  return end_load(pack, result, status);
}

void windloom_free(windloom_pack* pack) {
  if (pack == NULL) return;
  free(pack->cells);
  free(pack);
}

const char* windloom_status_text(windloom_status status) {
  switch (status) {
    case WINDLOOM_OK:
      return "The wind pack is loaded.";
    case WINDLOOM_CANNOT_READ:
      return "The file can't be read.";
    case WINDLOOM_NOT_A_PACK:
      return "The file is not a wind pack.";
    case WINDLOOM_NEWER_VERSION:
      return "The wind pack was written by a newer version of Windloom.";
    case WINDLOOM_TOO_LARGE:
      return "The wind pack claims to be larger than any may be.";
    case WINDLOOM_CUT_SHORT:
      return "The wind pack has another length than its header says.";
    case WINDLOOM_DAMAGED:
      return "The wind pack is damaged.";
    case WINDLOOM_OUT_OF_MEMORY:
      return "There is not enough memory for the wind pack.";
    case WINDLOOM_NEEDS_ZSTD:
      return "The wind pack is compressed and this library was built without zstd.";
    case WINDLOOM_NO_LIVE_FIELD:
      return "No editor shares a live field of that name.";
    case WINDLOOM_NOT_HERE:
      return "This system has no shared memory.";
  }
  return "Unknown status.";
}

windloom_info windloom_get_info(const windloom_pack* pack) {
  return pack->info;
}

void windloom_set_edges(windloom_pack* pack, windloom_edge x, windloom_edge z) {
  pack->info.edge_x = x;
  pack->info.edge_z = z;
}

/* Sampling. */

/* Two neighbours of a continuous coordinate and the weight of the second. */
typedef struct neighbours {
  int low, high;
  float weight;
} neighbours;

/* As floor(), which is a call into the C library on a machine without an instruction for it. */
static inline double whole_below(double value) {
  if (!(value > -9e15 && value < 9e15)) return value;
  const double cut = (double)(long long)value;
  return cut > value ? cut - 1.0 : cut;
}

static inline neighbours along(float at, int count, windloom_edge edge) {
  neighbours n;
  if (edge == WINDLOOM_WRAP) {
    const float size = (float)count;
    at -= (float)whole_below((double)(at / size)) * size;
    if (!(at >= 0.0f && at < size)) at = 0.0f; /* rounding at the seam, or out of all measure */
    n.low = (int)at;
    n.high = n.low + 1 < count ? n.low + 1 : 0;
  } else {
    const float last = (float)(count - 1);
    at = at > 0.0f ? at : 0.0f;
    at = at < last ? at : last;
    n.low = (int)at;
    n.high = n.low + 1 < count ? n.low + 1 : n.low;
  }
  n.weight = at - (float)n.low;
  return n;
}

static inline neighbours frames_at(const windloom_pack* pack, double time) {
  const int count = pack->info.frames;
  const double last = pack->info.loop ? count : count - 1;
  if (!isfinite(time)) time = 0.0;
  double at = time * (double)pack->info.fps;
  if (pack->info.loop) {
    at -= whole_below(at / last) * last;
    if (!(at >= 0.0 && at < last)) at = 0.0; /* rounding at the seam, or out of all measure */
  }
  if (!(at > 0.0)) at = 0.0;
  if (at > last) at = last;
  neighbours n;
  n.low = (int)at;
  n.high = n.low + 1;
  if (n.high >= count) n.high = pack->info.loop ? 0 : n.low;
  n.weight = (float)(at - n.low);
  return n;
}

/* The weighted sum of eight finite half floats. Shifting a half's bits into a float's place leaves the
 * exponent 112 too low; the multiplication puts that right and is exact for subnormal halves too. Written
 * as loops over eight so that compilers make vector instructions of it. */
static inline float weighted_sum(const uint32_t halves[8], const float weights[8]) {
  uint32_t bits[8];
  float values[8];
  for (int i = 0; i < 8; ++i) bits[i] = (halves[i] & 0x8000u) << 16 | (halves[i] & 0x7fffu) << 13;
  memcpy(values, bits, sizeof values);
  for (int i = 0; i < 8; ++i) values[i] *= 5.192296858534828e33f * weights[i]; /* 2^112 */
  return ((values[0] + values[4]) + (values[1] + values[5])) + ((values[2] + values[6]) + (values[3] + values[7]));
}

static inline void sample_between(const windloom_pack* pack, const neighbours* t, float px, float pz,
                                  float velocity[2]) {
  const windloom_info* info = &pack->info;
  px = isfinite(px) ? px : 0.0f;
  pz = isfinite(pz) ? pz : 0.0f;
  const neighbours x = along((px - info->min_x) * pack->cells_per_m_x - 0.5f, info->width, info->edge_x);
  const neighbours z = along((pz - info->min_z) * pack->cells_per_m_z - 0.5f, info->height, info->edge_z);
  const size_t frame_cells = (size_t)info->width * (size_t)info->height;
  const uint32_t* rows[4];
  rows[0] = pack->cells + (size_t)t->low * frame_cells + (size_t)z.low * (size_t)info->width;
  rows[1] = pack->cells + (size_t)t->low * frame_cells + (size_t)z.high * (size_t)info->width;
  rows[2] = pack->cells + (size_t)t->high * frame_cells + (size_t)z.low * (size_t)info->width;
  rows[3] = pack->cells + (size_t)t->high * frame_cells + (size_t)z.high * (size_t)info->width;
  const float early = 1.0f - t->weight;
  const float row_weights[4] = {early * (1.0f - z.weight), early * z.weight, t->weight * (1.0f - z.weight),
                                t->weight * z.weight};
  uint32_t cells[8], other[8];
  float weights[8];
  for (int i = 0; i < 4; ++i) {
    cells[2 * i] = rows[i][x.low];
    cells[2 * i + 1] = rows[i][x.high];
    weights[2 * i] = row_weights[i] * (1.0f - x.weight);
    weights[2 * i + 1] = row_weights[i] * x.weight;
  }
  for (int i = 0; i < 8; ++i) other[i] = cells[i] >> 16;
  velocity[0] = weighted_sum(cells, weights);
  velocity[1] = weighted_sum(other, weights);
}

void windloom_sample(const windloom_pack* pack, float x, float z, double time, float velocity[2]) {
  const neighbours t = frames_at(pack, time);
  sample_between(pack, &t, x, z, velocity);
}

void windloom_sample_many(const windloom_pack* pack, const float* positions, size_t count, double time,
                          float* velocities) {
  const neighbours t = frames_at(pack, time);
  for (size_t i = 0; i < count; ++i) {
    sample_between(pack, &t, positions[2 * i], positions[2 * i + 1], velocities + 2 * i);
  }
}
