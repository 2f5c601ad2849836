#include "engine/runtime/checksum.h"

/* Sixteen bytes at a time through sixteen tables (the slicing arrangement of Kounavis and Berry, A Systematic
 * Approach to Building High Performance Software-based CRC Generators, 2005). The tables are made for each call:
 * 4096 steps, little beside a pack's size, and no shared state that threads would have to agree on. Few bytes go
 * bit by bit. */

enum { kSlices = 16, kWorthTables = 1024 };

static uint32_t bits_of_byte(uint32_t value) {
  for (int bit = 0; bit < 8; ++bit) value = value >> 1 ^ (0xEDB88320u & (0u - (value & 1u)));
  return value;
}

static void make_tables(uint32_t tables[kSlices][256]) {
  for (uint32_t i = 0; i < 256; ++i) tables[0][i] = bits_of_byte(i);
  for (int slice = 1; slice < kSlices; ++slice) {
    for (uint32_t i = 0; i < 256; ++i) {
      const uint32_t before = tables[slice - 1][i];
      tables[slice][i] = before >> 8 ^ tables[0][before & 0xff];
    }
  }
}

static uint32_t word_at(const unsigned char* at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

/* What four bytes do to the checksum when `behind` others of the sixteen follow them. */
static uint32_t slice(uint32_t tables[kSlices][256], uint32_t word, int behind) {
  return tables[behind + 3][word & 0xff] ^ tables[behind + 2][word >> 8 & 0xff] ^
         tables[behind + 1][word >> 16 & 0xff] ^ tables[behind][word >> 24];
}

uint32_t windloom_checksum_plain(uint32_t checksum, const void* bytes, size_t size) {
  const unsigned char* at = bytes;
  uint32_t crc = ~checksum;
  if (size >= kWorthTables) {
    uint32_t tables[kSlices][256];
    make_tables(tables);
    for (; size >= 16; size -= 16, at += 16) {
      crc = slice(tables, crc ^ word_at(at), 12) ^ slice(tables, word_at(at + 4), 8) ^
            slice(tables, word_at(at + 8), 4) ^ slice(tables, word_at(at + 12), 0);
    }
  }
  for (; size > 0; --size, ++at) crc = crc >> 8 ^ bits_of_byte((crc ^ *at) & 0xff);
  return ~crc;
}

uint32_t windloom_checksum(uint32_t checksum, const void* bytes, size_t size) {
  if (size >= 64 && windloom_has_folded_checksum()) {
    const size_t folded = size & ~(size_t)15;
    checksum = windloom_checksum_folded(checksum, bytes, folded);
    bytes = (const unsigned char*)bytes + folded;
    size -= folded;
  }
  return windloom_checksum_plain(checksum, bytes, size);
}
