/* The one file that differs between windloom_runtime and windloom_runtime_zstd. */
#include "engine/runtime/pack.h"

#ifdef WINDLOOM_RUNTIME_ZSTD

#include <zstd.h>

int windloom_can_decompress(void) {
  return 1;
}

int windloom_decompress(const void* stored, size_t stored_bytes, void* data, size_t data_bytes) {
  /* Into the whole destination at once: zstd needs no window of its own then, however large the input says it is. */
  return ZSTD_decompress(data, data_bytes, stored, stored_bytes) == data_bytes;
}

#else

int windloom_can_decompress(void) {
  return 0;
}

int windloom_decompress(const void* stored, size_t stored_bytes, void* data, size_t data_bytes) {
  (void)stored;
  (void)stored_bytes;
  (void)data;
  (void)data_bytes;
  return 0;
}

#endif
