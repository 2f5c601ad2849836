/* Loading from memory and from a file. Both give the bytes to the same steps through a source that is read front to
 * back, so a pack in memory needs no second copy and one in a file no more memory than its cells. */
#if !defined(_WIN32) && !defined(_FILE_OFFSET_BITS)
#define _FILE_OFFSET_BITS 64
#endif
#if !defined(_WIN32) && !defined(_POSIX_C_SOURCE)
#define _POSIX_C_SOURCE 200809L /* fseeko */
#endif

#include <stdlib.h>
#include <string.h>

#include "engine/runtime/bytes.h"
#include "engine/runtime/checksum.h"
#include "engine/runtime/pack.h"
#include "engine/runtime/windpack_format.h"

/* What was measured: 16.8 MB load in the least time where a piece still lies in the second cache when it is looked at.
 */
enum { kPieceBytes = 256 * 1024 };

typedef struct source {
  const unsigned char* memory; /* NULL: read from the file */
  FILE* file;
  uint32_t checksum; /* of all bytes read so far */
} source;

static int read_bytes(source* from, void* to, size_t bytes) {
  if (from->memory != NULL) {
    memcpy(to, from->memory, bytes);
    from->memory += bytes;
  } else if (fread(to, 1, bytes, from->file) != bytes) {
    return 0;
  }
  from->checksum = windloom_checksum(from->checksum, to, bytes);
  return 1;
}

static windloom_status read_cells(source* from, windloom_pack* pack, size_t bytes) {
  unsigned char* cells = pack->cells;
  int finite = 1;
  for (size_t done = 0; done < bytes;) {
    const size_t piece = bytes - done < kPieceBytes ? bytes - done : kPieceBytes;
    if (!read_bytes(from, cells + done, piece)) return WINDLOOM_CANNOT_READ;
    finite &= windloom_adopt_cells(cells + done, piece, pack->float_cells);
    done += piece;
  }
  return finite ? WINDLOOM_OK : WINDLOOM_DAMAGED;
}

/* The four bytes behind everything. */
static windloom_status check_checksum(source* from) {
  const uint32_t found = from->checksum;
  unsigned char expected[WINDPACK_CHECKSUM_BYTES];
  if (!read_bytes(from, expected, sizeof expected)) return WINDLOOM_CANNOT_READ;
  return read_u32(expected) == found ? WINDLOOM_OK : WINDLOOM_DAMAGED;
}

/* The stored bytes are checked before any of them is decompressed, and memory for the cells is taken after that. */
static windloom_status read_compressed(source* from, windloom_pack* pack, size_t stored, size_t bytes) {
  if (!windloom_can_decompress()) return WINDLOOM_NEEDS_ZSTD;
  void* packed = malloc(stored);
  if (packed == NULL) return WINDLOOM_OUT_OF_MEMORY;
  windloom_status status = read_bytes(from, packed, stored) ? check_checksum(from) : WINDLOOM_CANNOT_READ;
  if (status == WINDLOOM_OK && (pack->cells = malloc(bytes)) == NULL) status = WINDLOOM_OUT_OF_MEMORY;
  if (status == WINDLOOM_OK && (!windloom_decompress(packed, stored, pack->cells, bytes) ||
                                !windloom_adopt_cells(pack->cells, bytes, pack->float_cells))) {
    status = WINDLOOM_DAMAGED;
  }
  free(packed);
  return status;
}

static windloom_status read_plain(source* from, windloom_pack* pack, size_t bytes) {
  pack->cells = malloc(bytes);
  if (pack->cells == NULL) return WINDLOOM_OUT_OF_MEMORY;
  const windloom_status cells = read_cells(from, pack, bytes);
  if (cells == WINDLOOM_CANNOT_READ) return cells;
  const windloom_status checksum = check_checksum(from);
  return checksum != WINDLOOM_OK ? checksum : cells;
}

/* Goes on behind the header. */
static int skip_header(source* from, const unsigned char* first, uint32_t header_bytes) {
  from->checksum = windloom_checksum(0, first, header_bytes);
  if (from->memory == NULL) return fseek(from->file, (long)header_bytes, SEEK_SET) == 0;
  from->memory += header_bytes;
  return 1;
}

static windloom_status read_pack(source* from, const unsigned char* first, size_t got, uint64_t file_bytes,
                                 windloom_pack** pack) {
  windloom_info info = {0};
  windpack_layout layout = {0};
  const windloom_status status = windloom_read_header(first, got, file_bytes, &info, &layout);
  if (status != WINDLOOM_OK) return status;
  if (!skip_header(from, first, layout.header_bytes)) return WINDLOOM_CANNOT_READ;
  *pack = calloc(1, sizeof **pack);
  if (*pack == NULL) return WINDLOOM_OUT_OF_MEMORY;
  windloom_prepare(*pack, &info, layout.cell_bytes == WINDPACK_FLOAT_CELL_BYTES);
  if (!layout.compressed) return read_plain(from, *pack, (size_t)layout.data_bytes);
  const uint64_t stored = file_bytes - layout.header_bytes - WINDPACK_CHECKSUM_BYTES;
  return read_compressed(from, *pack, (size_t)stored, (size_t)layout.data_bytes);
}

/* `pack` if the result is good. */
static windloom_pack* end_load(windloom_pack* pack, windloom_status result, windloom_status* status) {
  if (status != NULL) *status = result;
  if (result == WINDLOOM_OK) return pack;
  windloom_free(pack);
  return NULL;
}

windloom_pack* windloom_load_memory(const void* bytes, size_t size, windloom_status* status) {
  if (bytes == NULL) return end_load(NULL, WINDLOOM_CANNOT_READ, status);
  source from = {.memory = bytes};
  windloom_pack* pack = NULL;
  const windloom_status result = read_pack(&from, bytes, size, size, &pack);
  return end_load(pack, result, status);
}

/* Size of a file in bytes, or -1; leaves the position at the start. */
static long long file_size(FILE* file) {
#ifdef _WIN32
  if (_fseeki64(file, 0, SEEK_END) != 0) return -1;
  const long long size = _ftelli64(file);
#else
  if (fseeko(file, 0, SEEK_END) != 0) return -1;
  const long long size = (long long)ftello(file);
#endif
  return fseek(file, 0, SEEK_SET) == 0 ? size : -1;
}

windloom_pack* windloom_load_stream(FILE* file, windloom_status* status) {
  unsigned char first[WINDPACK_HEADER_BYTES];
  const long long size = file_size(file);
  const size_t got = size >= 0 ? fread(first, 1, sizeof first, file) : 0;
  if (size < 0 || ferror(file)) return end_load(NULL, WINDLOOM_CANNOT_READ, status);
  source from = {.file = file};
  windloom_pack* pack = NULL;
  const windloom_status result = read_pack(&from, first, got, (uint64_t)size, &pack);
  return end_load(pack, result, status);
}

windloom_pack* windloom_load_file(const char* path, windloom_status* status) {
  FILE* file = path != NULL ? fopen(path, "rb") : NULL;
  if (file == NULL) return end_load(NULL, WINDLOOM_CANNOT_READ, status);
  windloom_pack* pack = windloom_load_stream(file, status);
  fclose(file);
  return pack;
}
