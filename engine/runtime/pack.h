#ifndef WINDLOOM_RUNTIME_PACK_H
#define WINDLOOM_RUNTIME_PACK_H
/* What the library's files share; no part of its interface.
 *
 * WINDLOOM_PLAIN_C leaves out everything that is there for certain processors only, as on all others. */

#include <stdint.h>
#include <stdio.h>

#include "engine/runtime/windloom_runtime.h"

struct windloom_pack {
  windloom_info info;
  float cells_per_m_x, cells_per_m_z;
  float height_scale; /* 1 / ln(1 + reference height / roughness); 0: no profile */
  int float_cells;    /* 1: cells of two floats, else of two halves */
  int fast_batches;   /* this processor has what sample_fast.c needs */
  void* cells;        /* frame after frame, z ascending: vx, vz; as uint32_t vx lies in the low half */
};

/* What a header says about the bytes behind it. */
typedef struct windpack_layout {
  uint32_t header_bytes;
  uint32_t cell_bytes;
  uint64_t data_bytes; /* of all cells, decompressed */
  int compressed;
} windpack_layout;

/* The size of the shorter header, enough to tell how long the header is. */
#define WINDPACK_FIRST_BYTES 80u

/* Checks the header of a file of `file_bytes`, of which `bytes` holds the first `got` (as many as a header has, or the
 * whole file); nothing else was looked at yet. */
windloom_status windloom_read_header(const unsigned char* bytes, size_t got, uint64_t file_bytes, windloom_info* info,
                                     windpack_layout* layout);

/* Fills in what sampling wants to know beside the info. */
void windloom_prepare(windloom_pack* pack, const windloom_info* info, int float_cells);

/* Turns `bytes` of little-endian halves or floats into this machine's; 0 where one isn't finite. */
int windloom_adopt_cells(void* cells, size_t bytes, int float_cells);

int windloom_can_decompress(void);
/* Decompresses `stored_bytes` into exactly `data_bytes`; 0 where they give anything else. Writes nothing outside,
 * whatever the input is. Only where windloom_can_decompress(). */
int windloom_decompress(const void* stored, size_t stored_bytes, void* data, size_t data_bytes);

/* As windloom_load_file, from a file that is open at its start. */
windloom_pack* windloom_load_stream(FILE* file, windloom_status* status);

/* Two neighbours of a moment and the weight of the second. */
typedef struct windloom_moment {
  int low, high;
  float weight;
} windloom_moment;

void windloom_sample_plain(const windloom_pack* pack, const windloom_moment* moment, const float* positions,
                           size_t count, float* velocities);

int windloom_has_fast_batches(void);
/* Samples the first places, in steps of eight; how many. Only where windloom_has_fast_batches() and the field has two
 * columns at least. Bit for bit what the plain code gives. */
size_t windloom_sample_fast(const windloom_pack* pack, const windloom_moment* moment, const float* positions,
                            size_t count, float* velocities);

#endif
