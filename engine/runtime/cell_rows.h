#ifndef WINDLOOM_RUNTIME_CELL_ROWS_H
#define WINDLOOM_RUNTIME_CELL_ROWS_H
/* The cells of two columns in one row of a frame, and the weighted sum of four such rows: with SSE2, which every x86-64
 * processor has, and in plain C. Both do the same operations in the same order, as sample_fast.c does.
 *
 * Nothing here is written as loops over arrays: compilers fill an array number by number and read it as vectors, for
 * which a processor waits until every earlier cache miss is over (170 in place of 90 ns a sample at places that no
 * cache holds). */

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* What a half's bits in a float's place lack: their exponent is 112 too low. The multiplication is exact, for subnormal
 * halves too. */
#define WINDLOOM_HALF_SCALE 5.192296858534828e33f /* 2^112 */

#if (defined(__SSE2__) || defined(_M_X64)) && !defined(WINDLOOM_PLAIN_C)

#include <emmintrin.h>

typedef __m128 cell_row; /* vx, vz of the low column, vx, vz of the high one */

static inline cell_row row_of_halves(const uint32_t* cells, size_t low, size_t high) {
  const __m128i both = _mm_unpacklo_epi32(_mm_cvtsi32_si128((int)cells[low]), _mm_cvtsi32_si128((int)cells[high]));
  const __m128i upper = _mm_unpacklo_epi16(_mm_setzero_si128(), both);
  return _mm_castsi128_ps(_mm_and_si128(_mm_srai_epi32(upper, 3), _mm_set1_epi32((int)0x8fffe000u)));
}

static inline cell_row row_of_floats(const float* cells, size_t low, size_t high) {
  const __m128 left = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i*)(const void*)(cells + 2 * low)));
  const __m128 right = _mm_castsi128_ps(_mm_loadl_epi64((const __m128i*)(const void*)(cells + 2 * high)));
  return _mm_movelh_ps(left, right);
}

/* Rows 0 and 2 are the near ones, 1 and 3 the far ones; `high` is the weight of the high column. */
static inline void sum_of_rows(cell_row r0, cell_row r1, cell_row r2, cell_row r3, const float weights[4], float high,
                               float scale, float velocity[2]) {
  const float low = 1.0f - high;
  const __m128 columns = _mm_mul_ps(_mm_setr_ps(low, low, high, high), _mm_set1_ps(scale));
  const __m128 nears = _mm_add_ps(_mm_mul_ps(r0, _mm_mul_ps(_mm_set1_ps(weights[0]), columns)),
                                  _mm_mul_ps(r2, _mm_mul_ps(_mm_set1_ps(weights[2]), columns)));
  const __m128 fars = _mm_add_ps(_mm_mul_ps(r1, _mm_mul_ps(_mm_set1_ps(weights[1]), columns)),
                                 _mm_mul_ps(r3, _mm_mul_ps(_mm_set1_ps(weights[3]), columns)));
  const __m128 sum =
      _mm_add_ps(_mm_add_ps(nears, _mm_movehl_ps(nears, nears)), _mm_add_ps(fars, _mm_movehl_ps(fars, fars)));
  _mm_storel_epi64((__m128i*)(void*)velocity, _mm_castps_si128(sum));
}

#else

typedef struct cell_row {
  float low_x, low_z, high_x, high_z;
} cell_row;

static inline float bits_as_float(uint32_t bits) {
  float value;
  memcpy(&value, &bits, sizeof value);
  return value;
}

static inline float first_half(uint32_t cell) {
  return bits_as_float((cell & 0x8000u) << 16 | (cell & 0x7fffu) << 13);
}

static inline float second_half(uint32_t cell) {
  return bits_as_float((cell & 0x80000000u) | (cell & 0x7fff0000u) >> 3);
}

static inline cell_row row_of_halves(const uint32_t* cells, size_t low, size_t high) {
  const cell_row row = {first_half(cells[low]), second_half(cells[low]), first_half(cells[high]),
                        second_half(cells[high])};
  return row;
}

static inline cell_row row_of_floats(const float* cells, size_t low, size_t high) {
  const cell_row row = {cells[2 * low], cells[2 * low + 1], cells[2 * high], cells[2 * high + 1]};
  return row;
}

/* a * wa + b * wb, and both columns of that. */
static inline float joined_x(cell_row a, float wa, cell_row b, float wb, float low, float high) {
  return (a.low_x * (wa * low) + b.low_x * (wb * low)) + (a.high_x * (wa * high) + b.high_x * (wb * high));
}

static inline float joined_z(cell_row a, float wa, cell_row b, float wb, float low, float high) {
  return (a.low_z * (wa * low) + b.low_z * (wb * low)) + (a.high_z * (wa * high) + b.high_z * (wb * high));
}

static inline void sum_of_rows(cell_row r0, cell_row r1, cell_row r2, cell_row r3, const float weights[4], float high,
                               float scale, float velocity[2]) {
  const float left = (1.0f - high) * scale, right = high * scale;
  velocity[0] =
      joined_x(r0, weights[0], r2, weights[2], left, right) + joined_x(r1, weights[1], r3, weights[3], left, right);
  velocity[1] =
      joined_z(r0, weights[0], r2, weights[2], left, right) + joined_z(r1, weights[1], r3, weights[3], left, right);
}

#endif

#endif
