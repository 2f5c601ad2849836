#include "engine/runtime/checksum.h"

/* After Gopal, Ozturk, Guilford and others, Fast CRC Computation for Generic Polynomials Using PCLMULQDQ
 * Instruction, 2009: the message is folded onto its last 128 bits by multiplications with powers of x modulo the
 * polynomial, and those are reduced by Barrett's method. The constants are the reflected ones of the paper's example
 * for the polynomial of gzip. */

#if (defined(__GNUC__) || defined(__clang__)) && defined(__x86_64__) && !defined(WINDLOOM_PLAIN_C)

#include <immintrin.h>

#define WITH_FOLDING __attribute__((target("pclmul,sse4.1")))

int windloom_has_folded_checksum(void) {
  return __builtin_cpu_supports("pclmul") && __builtin_cpu_supports("sse4.1");
}

/* `value` moved on by the distance that `powers` stand for. */
WITH_FOLDING static __m128i fold(__m128i value, __m128i powers) {
  return _mm_xor_si128(_mm_clmulepi64_si128(value, powers, 0x00), _mm_clmulepi64_si128(value, powers, 0x11));
}

WITH_FOLDING static __m128i load(const unsigned char* at) {
  return _mm_loadu_si128((const __m128i*)(const void*)at);
}

/* 128 bits to the checksum's 32. */
WITH_FOLDING static uint32_t reduce(__m128i value, __m128i by_128) {
  const __m128i low_32 = _mm_setr_epi32(~0, 0, ~0, 0);
  const __m128i by_64 = _mm_cvtsi64_si128(0x0163cd6124);
  const __m128i barrett = _mm_set_epi64x(0x01f7011641, 0x01db710641);
  value = _mm_xor_si128(_mm_srli_si128(value, 8), _mm_clmulepi64_si128(value, by_128, 0x10));
  value = _mm_xor_si128(_mm_srli_si128(value, 4), _mm_clmulepi64_si128(_mm_and_si128(value, low_32), by_64, 0x00));
  __m128i quotient = _mm_clmulepi64_si128(_mm_and_si128(value, low_32), barrett, 0x10);
  quotient = _mm_clmulepi64_si128(_mm_and_si128(quotient, low_32), barrett, 0x00);
  return (uint32_t)_mm_extract_epi32(_mm_xor_si128(value, quotient), 1);
}

WITH_FOLDING uint32_t windloom_checksum_folded(uint32_t checksum, const void* bytes, size_t size) {
  const unsigned char* at = bytes;
  const __m128i by_512 = _mm_set_epi64x(0x01c6e41596, 0x0154442bd4);
  const __m128i by_128 = _mm_set_epi64x(0x00ccaa009e, 0x01751997d0);
  __m128i lanes[4];
  for (int i = 0; i < 4; ++i) lanes[i] = load(at + 16 * i);
  lanes[0] = _mm_xor_si128(lanes[0], _mm_cvtsi32_si128((int)~checksum));
  for (at += 64, size -= 64; size >= 64; at += 64, size -= 64) {
    for (int i = 0; i < 4; ++i) lanes[i] = _mm_xor_si128(fold(lanes[i], by_512), load(at + 16 * i));
  }
  __m128i value = lanes[0];
  for (int i = 1; i < 4; ++i) value = _mm_xor_si128(fold(value, by_128), lanes[i]);
  for (; size >= 16; at += 16, size -= 16) value = _mm_xor_si128(fold(value, by_128), load(at));
  return ~reduce(value, by_128);
}

#else

int windloom_has_folded_checksum(void) {
  return 0;
}

uint32_t windloom_checksum_folded(uint32_t checksum, const void* bytes, size_t size) {
  return windloom_checksum_plain(checksum, bytes, size);
}

#endif
