/* Batches on x86-64 processors with AVX2 and F16C: places and weights of eight points at a time, then for each point
 * four loads of two neighbouring cells. (Gather instructions were left aside: processors differ by a factor of ten in
 * what those cost.) Same operations in the same order as sample.c, so the results are the same bits. */
#include "engine/runtime/pack.h"

#if (defined(__GNUC__) || defined(__clang__)) && defined(__x86_64__) && !defined(WINDLOOM_PLAIN_C)

#include <cpuid.h>
#include <float.h>
#include <immintrin.h>

#define FAST __attribute__((target("avx2,f16c")))

int windloom_has_fast_batches(void) {
  unsigned a, b, c = 0, d;
  /* Compilers' __builtin_cpu_supports doesn't know F16C everywhere; that of AVX2 asks the system, too. */
  return __builtin_cpu_supports("avx2") && __get_cpuid(1, &a, &b, &c, &d) && (c & bit_F16C) != 0;
}

/* One axis of the field. */
typedef struct axis {
  __m256 low, scale, count, last;
  int wrap;
} axis;

FAST static inline axis make_axis(float low, float scale, int count, windloom_edge edge) {
  axis a;
  a.low = _mm256_set1_ps(low);
  a.scale = _mm256_set1_ps(scale);
  a.count = _mm256_set1_ps((float)count);
  a.last = _mm256_set1_ps((float)(count - 1));
  a.wrap = edge == WINDLOOM_WRAP;
  return a;
}

/* World to cells, within 0 and `count` (wrapped) or `last` (clamped). */
FAST static inline __m256 to_cells(const axis* a, __m256 position) {
  const __m256 magnitude = _mm256_andnot_ps(_mm256_set1_ps(-0.0f), position);
  position = _mm256_and_ps(position, _mm256_cmp_ps(magnitude, _mm256_set1_ps(FLT_MAX), _CMP_LE_OQ));
  __m256 at = _mm256_sub_ps(_mm256_mul_ps(_mm256_sub_ps(position, a->low), a->scale), _mm256_set1_ps(0.5f));
  const __m256 zero = _mm256_setzero_ps();
  if (!a->wrap) return _mm256_min_ps(_mm256_max_ps(at, zero), a->last);
  const __m256 turns = _mm256_floor_ps(_mm256_div_ps(at, a->count));
  at = _mm256_sub_ps(at, _mm256_mul_ps(turns, a->count));
  const __m256 inside = _mm256_and_ps(_mm256_cmp_ps(at, zero, _CMP_GE_OQ), _mm256_cmp_ps(at, a->count, _CMP_LT_OQ));
  return _mm256_and_ps(at, inside);
}

/* Of eight points: numbers of the first of two neighbouring cells in the near and the far row, and weights. */
typedef struct eight {
  int near[8], far[8];
  float x[8], z[8];
  int seam; /* one of them lies in the seam of columns that repeat, whose two cells aren't neighbours */
} eight;

/* Whether all could be placed: none in the seam. */
FAST static inline int place(const axis* ax, const axis* az, int width, const float* positions, eight* points) {
  const __m256 a = _mm256_loadu_ps(positions), b = _mm256_loadu_ps(positions + 8);
  /* x0 x1 x4 x5 x2 x3 x6 x7 to ascending numbers. */
  const __m256i order = _mm256_setr_epi32(0, 1, 4, 5, 2, 3, 6, 7);
  const __m256 px = _mm256_permutevar8x32_ps(_mm256_shuffle_ps(a, b, 0x88), order);
  const __m256 pz = _mm256_permutevar8x32_ps(_mm256_shuffle_ps(a, b, 0xdd), order);
  const __m256 x = to_cells(ax, px), z = to_cells(az, pz);
  __m256i column = _mm256_cvttps_epi32(x);
  const __m256i end = _mm256_cvttps_epi32(ax->last);
  const __m256i at_end = _mm256_cmpeq_epi32(column, end);
  if (ax->wrap) {
    if (!_mm256_testz_si256(at_end, at_end)) return 0;
  } else {
    column = _mm256_add_epi32(column, at_end); /* the last column is the second one of the last two, with all weight */
  }
  const __m256i row = _mm256_cvttps_epi32(z), rows_end = _mm256_cvttps_epi32(az->last);
  const __m256i beyond = _mm256_cmpgt_epi32(_mm256_add_epi32(row, _mm256_set1_epi32(1)), rows_end);
  const __m256i next = _mm256_add_epi32(row, _mm256_set1_epi32(1));
  const __m256i far = _mm256_blendv_epi8(next, az->wrap ? _mm256_setzero_si256() : row, beyond);
  const __m256i stride = _mm256_set1_epi32(width);
  _mm256_storeu_si256((__m256i*)(void*)points->near, _mm256_add_epi32(_mm256_mullo_epi32(row, stride), column));
  _mm256_storeu_si256((__m256i*)(void*)points->far, _mm256_add_epi32(_mm256_mullo_epi32(far, stride), column));
  _mm256_storeu_ps(points->x, _mm256_sub_ps(x, _mm256_cvtepi32_ps(column)));
  _mm256_storeu_ps(points->z, _mm256_sub_ps(z, _mm256_cvtepi32_ps(row)));
  return 1;
}

/* vx, vz of a cell and of the next one. */
FAST static inline __m128 pair_at(const void* frame, int cell, int float_cells) {
  if (float_cells) return _mm_loadu_ps((const float*)frame + 2 * (size_t)cell);
  return _mm_cvtph_ps(_mm_loadl_epi64((const __m128i*)(const void*)((const uint32_t*)frame + (size_t)cell)));
}

/* One point: both rows of both frames, weighted; near and far rows are added up apart, as sample.c does. */
FAST static inline void blend(const void* early, const void* late, int float_cells, const eight* points, int n,
                              float late_weight, float velocity[2]) {
  const float x = points->x[n], z = points->z[n], before = 1.0f - late_weight, near = 1.0f - z;
  const __m128 columns = _mm_setr_ps(1.0f - x, 1.0f - x, x, x);
  const __m128 w0 = _mm_mul_ps(_mm_set1_ps(before * near), columns), w1 = _mm_mul_ps(_mm_set1_ps(before * z), columns);
  const __m128 w2 = _mm_mul_ps(_mm_set1_ps(late_weight * near), columns);
  const __m128 w3 = _mm_mul_ps(_mm_set1_ps(late_weight * z), columns);
  const __m128 v0 = _mm_mul_ps(pair_at(early, points->near[n], float_cells), w0);
  const __m128 v1 = _mm_mul_ps(pair_at(early, points->far[n], float_cells), w1);
  const __m128 v2 = _mm_mul_ps(pair_at(late, points->near[n], float_cells), w2);
  const __m128 v3 = _mm_mul_ps(pair_at(late, points->far[n], float_cells), w3);
  const __m128 nears = _mm_add_ps(v0, v2), fars = _mm_add_ps(v1, v3);
  const __m128 sum =
      _mm_add_ps(_mm_add_ps(nears, _mm_movehl_ps(nears, nears)), _mm_add_ps(fars, _mm_movehl_ps(fars, fars)));
  _mm_storel_epi64((__m128i*)(void*)velocity, _mm_castps_si128(sum));
}

/* The field of a pack at a moment. */
typedef struct field {
  axis x, z;
  int width;
  const char *early, *late; /* frames */
} field;

FAST static inline field make_field(const windloom_pack* pack, const windloom_moment* t, size_t cell_bytes) {
  const windloom_info* info = &pack->info;
  const size_t frame_bytes = (size_t)info->width * (size_t)info->height * cell_bytes;
  field f;
  f.x = make_axis(info->min_x, pack->cells_per_m_x, info->width, info->edge_x);
  f.z = make_axis(info->min_z, pack->cells_per_m_z, info->height, info->edge_z);
  f.width = info->width;
  f.early = (const char*)pack->cells + (size_t)t->low * frame_bytes;
  f.late = (const char*)pack->cells + (size_t)t->high * frame_bytes;
  return f;
}

/* Places eight points and asks for their cells, which are needed only after the eight points before: at places that no
 * cache holds this takes 23 in place of 42 ns a point, at others 3.5 in place of 4. */
FAST static inline void prepare(const field* f, const float* positions, size_t cell_bytes, eight* points) {
  points->seam = !place(&f->x, &f->z, f->width, positions, points);
  if (points->seam) return;
  for (int n = 0; n < 8; ++n) {
    const size_t near = (size_t)points->near[n] * cell_bytes, far = (size_t)points->far[n] * cell_bytes;
    _mm_prefetch(f->early + near, _MM_HINT_T0);
    _mm_prefetch(f->early + far, _MM_HINT_T0);
    _mm_prefetch(f->late + near, _MM_HINT_T0);
    _mm_prefetch(f->late + far, _MM_HINT_T0);
  }
}

/* `float_cells` is a constant wherever this is called, so the compiler makes two functions of it. */
FAST static inline size_t sample_eights(const windloom_pack* pack, const windloom_moment* t, const float* positions,
                                        size_t count, float* velocities, int float_cells) {
  const size_t cell_bytes = float_cells ? 8u : 4u, eights = count / 8;
  const field f = make_field(pack, t, cell_bytes);
  eight points[2];
  if (eights > 0) prepare(&f, positions, cell_bytes, &points[0]);
  for (size_t e = 0; e < eights; ++e) {
    const eight* now = &points[e & 1];
    if (e + 1 < eights) prepare(&f, positions + 16 * (e + 1), cell_bytes, &points[(e + 1) & 1]);
    if (now->seam) {
      windloom_sample_plain(pack, t, positions + 16 * e, 8, velocities + 16 * e);
      continue;
    }
    for (int n = 0; n < 8; ++n) {
      blend(f.early, f.late, float_cells, now, n, t->weight, velocities + 2 * (8 * e + (size_t)n));
    }
  }
  return 8 * eights;
}

FAST size_t windloom_sample_fast(const windloom_pack* pack, const windloom_moment* moment, const float* positions,
                                 size_t count, float* velocities) {
  return pack->float_cells ? sample_eights(pack, moment, positions, count, velocities, 1)
                           : sample_eights(pack, moment, positions, count, velocities, 0);
}

#else

int windloom_has_fast_batches(void) {
  return 0;
}

size_t windloom_sample_fast(const windloom_pack* pack, const windloom_moment* moment, const float* positions,
                            size_t count, float* velocities) {
  (void)pack;
  (void)moment;
  (void)positions;
  (void)count;
  (void)velocities;
  return 0;
}

#endif
