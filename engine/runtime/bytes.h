#ifndef WINDLOOM_RUNTIME_BYTES_H
#define WINDLOOM_RUNTIME_BYTES_H
/* Little-endian bytes to numbers, on a machine of any byte order. */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

static inline uint32_t read_u32(const unsigned char* at) {
  return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static inline uint64_t read_u64(const unsigned char* at) {
  return read_u32(at) | (uint64_t)read_u32(at + 4) << 32;
}

static inline float read_f32(const unsigned char* at) {
  const uint32_t bits = read_u32(at);
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static inline double read_f64(const unsigned char* at) {
  const uint64_t bits = read_u64(at);
  double value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

#endif
