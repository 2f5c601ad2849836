/* The checks of a pack's first bytes, all before any memory is taken. docs/windpack.md has the layout. */
#include <math.h>
#include <string.h>

#include "engine/runtime/bytes.h"
#include "engine/runtime/pack.h"
#include "engine/runtime/windpack_format.h"

static int in_range(float value, float low, float high) {
  return value >= low && value <= high; /* no NaN is */
}

static windloom_status check_numbers(const windloom_info* info, int float_cells) {
  const float corners[4] = {info->min_x, info->min_z, info->max_x, info->max_z};
  for (int i = 0; i < 4; ++i) {
    if (!in_range(corners[i], -WINDPACK_MAX_COORDINATE, WINDPACK_MAX_COORDINATE)) return WINDLOOM_DAMAGED;
  }
  if (!(info->min_x < info->max_x) || !(info->min_z < info->max_z)) return WINDLOOM_DAMAGED;
  if (!(info->fps > 0.0f && info->fps <= 1e6f)) return WINDLOOM_DAMAGED;
  if (!in_range(info->max_speed, 0.0f, float_cells ? 3.4e38f : WINDPACK_MAX_HALF)) return WINDLOOM_DAMAGED;
  if (!in_range(info->reference_height, WINDPACK_MIN_REFERENCE_HEIGHT, WINDPACK_MAX_PROFILE_HEIGHT)) {
    return WINDLOOM_DAMAGED;
  }
  if (info->roughness != 0.0f && !in_range(info->roughness, WINDPACK_MIN_ROUGHNESS, WINDPACK_MAX_PROFILE_HEIGHT)) {
    return WINDLOOM_DAMAGED;
  }
  return isfinite(info->start) ? WINDLOOM_OK : WINDLOOM_DAMAGED;
}

/* Too few bytes for a header: no pack at all, or the start of one? */
static windloom_status status_of_stub(const unsigned char* bytes, size_t got) {
  const size_t compared = got < 8 ? got : 8;
  return got > 0 && memcmp(bytes, WINDPACK_MAGIC, compared) == 0 ? WINDLOOM_CUT_SHORT : WINDLOOM_NOT_A_PACK;
}

static windloom_status check_size(const unsigned char* bytes, uint64_t file_bytes, windpack_layout* layout) {
  const uint32_t width = read_u32(bytes + WINDPACK_AT_WIDTH);
  const uint32_t height = read_u32(bytes + WINDPACK_AT_HEIGHT);
  const uint32_t frames = read_u32(bytes + WINDPACK_AT_FRAMES);
  if (width == 0 || height == 0 || frames == 0) return WINDLOOM_DAMAGED;
  if (width > WINDPACK_MAX_SIDE || height > WINDPACK_MAX_SIDE || frames > WINDPACK_MAX_FRAMES)
    return WINDLOOM_TOO_LARGE;
  layout->data_bytes = (uint64_t)width * height * frames * layout->cell_bytes;
  if (layout->data_bytes > WINDPACK_MAX_DATA_BYTES || layout->data_bytes > SIZE_MAX / 2) return WINDLOOM_TOO_LARGE;
  if (read_u64(bytes + WINDPACK_AT_DATA_BYTES) != layout->data_bytes) return WINDLOOM_DAMAGED;
  const uint64_t around = layout->header_bytes + WINDPACK_CHECKSUM_BYTES;
  if (!layout->compressed) return file_bytes == around + layout->data_bytes ? WINDLOOM_OK : WINDLOOM_CUT_SHORT;
  /* What zstd can make of so many bytes: hardly more of bytes that don't pack, never less than the greatest factor. */
  const uint64_t most = layout->data_bytes + layout->data_bytes / 128 + 1024;
  if (file_bytes <= around || file_bytes - around > most) return WINDLOOM_CUT_SHORT;
  return (file_bytes - around) * WINDPACK_MAX_COMPRESSION >= layout->data_bytes ? WINDLOOM_OK : WINDLOOM_CUT_SHORT;
}

static void read_info(const unsigned char* bytes, uint32_t version, uint32_t flags, windloom_info* info) {
  info->width = (int)read_u32(bytes + WINDPACK_AT_WIDTH);
  info->height = (int)read_u32(bytes + WINDPACK_AT_HEIGHT);
  info->frames = (int)read_u32(bytes + WINDPACK_AT_FRAMES);
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
  info->quantity = version >= 2 ? (int)read_u32(bytes + WINDPACK_AT_QUANTITY) : 0;
  info->reference_height = version >= 2 ? read_f32(bytes + WINDPACK_AT_REFERENCE_HEIGHT) : 2.0f;
  info->roughness = version >= 2 ? read_f32(bytes + WINDPACK_AT_ROUGHNESS) : 0.0f;
}

windloom_status windloom_read_header(const unsigned char* bytes, size_t got, uint64_t file_bytes, windloom_info* info,
                                     windpack_layout* layout) {
  if (got < WINDPACK_FIRST_BYTES) return status_of_stub(bytes, got);
  if (memcmp(bytes, WINDPACK_MAGIC, 8) != 0) return WINDLOOM_NOT_A_PACK;
  if (read_u32(bytes + WINDPACK_AT_ENDIAN_MARK) != WINDPACK_ENDIAN_MARK) return WINDLOOM_DAMAGED;
  const uint32_t version = read_u32(bytes + WINDPACK_AT_VERSION);
  if (version > WINDPACK_VERSION) return WINDLOOM_NEWER_VERSION;
  if (version == 0) return WINDLOOM_DAMAGED;
  layout->header_bytes = version == 1 ? WINDPACK_V1_HEADER_BYTES : WINDPACK_HEADER_BYTES;
  if (got < layout->header_bytes) return WINDLOOM_CUT_SHORT;
  const uint32_t flags = read_u32(bytes + WINDPACK_AT_FLAGS);
  const uint32_t known = version == 1 ? WINDPACK_V1_FLAGS : WINDPACK_V2_FLAGS;
  if ((flags & ~known) != 0 || read_u64(bytes + WINDPACK_AT_RESERVED) != 0) return WINDLOOM_DAMAGED;
  if (version >= 2 && (read_u32(bytes + WINDPACK_AT_RESERVED_2) != 0 ||
                       read_u32(bytes + WINDPACK_AT_QUANTITY) > WINDPACK_QUANTITY_BEND)) {
    return WINDLOOM_DAMAGED;
  }
  const int float_cells = (flags & WINDPACK_FLAG_FLOAT32) != 0;
  layout->cell_bytes = float_cells ? WINDPACK_FLOAT_CELL_BYTES : WINDPACK_HALF_CELL_BYTES;
  layout->compressed = (flags & WINDPACK_FLAG_ZSTD) != 0;
  const windloom_status status = check_size(bytes, file_bytes, layout);
  if (status != WINDLOOM_OK) return status;
  read_info(bytes, version, flags, info);
  return check_numbers(info, float_cells);
}
