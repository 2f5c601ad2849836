#include "engine/runtime/checksum.h"

/* Eight bytes at a time through eight tables (the slicing-by-8 arrangement of Kounavis and Berry, A Systematic
 * Approach to Building High Performance Software-based CRC Generators, 2005). The tables are made for each call:
 * 2048 steps, nothing beside a pack's size, and no shared state that threads would have to agree on. */

enum { kSlices = 8 };

static void make_tables(uint32_t tables[kSlices][256]) {
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = value >> 1 ^ (0xEDB88320u & (0u - (value & 1u)));
    tables[0][i] = value;
  }
  for (uint32_t i = 0; i < 256; ++i) {
    for (int slice = 1; slice < kSlices; ++slice) {
      const uint32_t before = tables[slice - 1][i];
      tables[slice][i] = before >> 8 ^ tables[0][before & 0xff];
    }
  }
}

uint32_t windloom_checksum(uint32_t checksum, const void* bytes, size_t size) {
  uint32_t tables[kSlices][256];
  make_tables(tables);
  const unsigned char* at = bytes;
  uint32_t crc = ~checksum;
  for (; size >= 8; size -= 8, at += 8) {
    const uint32_t low = crc ^ ((uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24);
    crc = tables[7][low & 0xff] ^ tables[6][low >> 8 & 0xff] ^ tables[5][low >> 16 & 0xff] ^ tables[4][low >> 24] ^
          tables[3][at[4]] ^ tables[2][at[5]] ^ tables[1][at[6]] ^ tables[0][at[7]];
  }
  for (; size > 0; --size, ++at) crc = crc >> 8 ^ tables[0][(crc ^ *at) & 0xff];
  return ~crc;
}
