/* The cells of a pack, from the bytes of a file to numbers that can be used unchecked. */
#include <string.h>

#include "engine/runtime/bytes.h"
#include "engine/runtime/pack.h"

static int is_little_endian(void) {
  const uint32_t one = 1;
  unsigned char first;
  memcpy(&first, &one, 1);
  return first == 1;
}

int windloom_adopt_cells(void* cells, size_t bytes, int float_cells) {
  uint32_t* words = cells;
  const size_t count = bytes / sizeof *words;
  if (!is_little_endian()) {
    for (size_t i = 0; i < count; ++i) words[i] = read_u32((const unsigned char*)&words[i]);
  }
  /* Adding one to an exponent of all ones carries into the sign's place, which was empty. One plain loop each, so
   * that compilers make vector instructions of it. */
  const uint32_t exponents = float_cells ? 0x7f800000u : 0x7c007c00u;
  const uint32_t ones = float_cells ? 0x00800000u : 0x04000400u;
  uint32_t carried = 0;
  for (size_t i = 0; i < count; ++i) carried |= (words[i] & exponents) + ones;
  return (carried & (float_cells ? 0x80000000u : 0x80008000u)) == 0;
}
