/* The wind at a place and a moment. */
#include <math.h>
#include <string.h>

#include "engine/runtime/pack.h"

typedef windloom_moment neighbours; /* along any axis */

/* As floor(), which is a call into the C library on a machine without an instruction for it. */
static inline double whole_below(double value) {
  if (!(value > -9e15 && value < 9e15)) return value;
  const double cut = (double)(long long)value;
  return cut > value ? cut - 1.0 : cut;
}

static inline neighbours along(float at, int count, windloom_edge edge) {
  neighbours n;
  if (edge == WINDLOOM_WRAP) {
    const float size = (float)count;
    at -= (float)whole_below((double)(at / size)) * size;
    if (!(at >= 0.0f && at < size)) at = 0.0f; /* rounding at the seam, or out of all measure */
    n.low = (int)at;
    n.high = n.low + 1 < count ? n.low + 1 : 0;
  } else {
    const float last = (float)(count - 1);
    at = at > 0.0f ? at : 0.0f;
    at = at < last ? at : last;
    n.low = (int)at;
    n.high = n.low + 1 < count ? n.low + 1 : n.low;
  }
  n.weight = at - (float)n.low;
  return n;
}

static inline neighbours frames_at(const windloom_pack* pack, double time) {
  const int count = pack->info.frames;
  const double last = pack->info.loop ? count : count - 1;
  if (!isfinite(time)) time = 0.0;
  double at = time * (double)pack->info.fps;
  if (pack->info.loop) {
    at -= whole_below(at / last) * last;
    if (!(at >= 0.0 && at < last)) at = 0.0; /* rounding at the seam, or out of all measure */
  }
  if (!(at > 0.0)) at = 0.0;
  if (at > last) at = last;
  neighbours n;
  n.low = (int)at;
  n.high = n.low + 1;
  if (n.high >= count) n.high = pack->info.loop ? 0 : n.low;
  n.weight = (float)(at - n.low);
  return n;
}

/* The eight cells around a place and a moment: low x and high x of four rows, by cell number. */
typedef struct corners {
  size_t cells[8];
  float weights[8];
} corners;

static inline corners corners_at(const windloom_pack* pack, const neighbours* t, float px, float pz) {
  const windloom_info* info = &pack->info;
  px = isfinite(px) ? px : 0.0f;
  pz = isfinite(pz) ? pz : 0.0f;
  const neighbours x = along((px - info->min_x) * pack->cells_per_m_x - 0.5f, info->width, info->edge_x);
  const neighbours z = along((pz - info->min_z) * pack->cells_per_m_z - 0.5f, info->height, info->edge_z);
  const size_t width = (size_t)info->width, frame_cells = width * (size_t)info->height;
  const size_t early = (size_t)t->low * frame_cells, late = (size_t)t->high * frame_cells;
  const size_t near = (size_t)z.low * width, far = (size_t)z.high * width;
  const size_t rows[4] = {early + near, early + far, late + near, late + far};
  const float before = 1.0f - t->weight;
  const float row_weights[4] = {before * (1.0f - z.weight), before * z.weight, t->weight * (1.0f - z.weight),
                                t->weight * z.weight};
  corners c;
  for (int i = 0; i < 4; ++i) {
    c.cells[2 * i] = rows[i] + (size_t)x.low;
    c.cells[2 * i + 1] = rows[i] + (size_t)x.high;
    c.weights[2 * i] = row_weights[i] * (1.0f - x.weight);
    c.weights[2 * i + 1] = row_weights[i] * x.weight;
  }
  return c;
}

/* The order of the additions is that of sample_fast.c. */
static inline float sum_of(const float values[8]) {
  return ((values[0] + values[4]) + (values[1] + values[5])) + ((values[2] + values[6]) + (values[3] + values[7]));
}

/* The weighted sum of eight finite half floats. Shifting a half's bits into a float's place leaves the
 * exponent 112 too low; the multiplication puts that right and is exact for subnormal halves too. Written
 * as loops over eight so that compilers make vector instructions of it. */
static inline float weighted_halves(const uint32_t halves[8], const float weights[8]) {
  uint32_t bits[8];
  float values[8];
  for (int i = 0; i < 8; ++i) bits[i] = (halves[i] & 0x8000u) << 16 | (halves[i] & 0x7fffu) << 13;
  memcpy(values, bits, sizeof values);
  for (int i = 0; i < 8; ++i) values[i] *= 5.192296858534828e33f * weights[i]; /* 2^112 */
  return sum_of(values);
}

static inline void sample_halves(const windloom_pack* pack, const corners* c, float velocity[2]) {
  const uint32_t* cells = pack->cells;
  uint32_t low[8], high[8];
  for (int i = 0; i < 8; ++i) low[i] = cells[c->cells[i]];
  for (int i = 0; i < 8; ++i) high[i] = low[i] >> 16;
  velocity[0] = weighted_halves(low, c->weights);
  velocity[1] = weighted_halves(high, c->weights);
}

static inline void sample_floats(const windloom_pack* pack, const corners* c, float velocity[2]) {
  const float* cells = pack->cells;
  float vx[8], vz[8];
  for (int i = 0; i < 8; ++i) {
    vx[i] = cells[2 * c->cells[i]] * c->weights[i];
    vz[i] = cells[2 * c->cells[i] + 1] * c->weights[i];
  }
  velocity[0] = sum_of(vx);
  velocity[1] = sum_of(vz);
}

static inline void sample_between(const windloom_pack* pack, const neighbours* t, float x, float z, float velocity[2]) {
  const corners c = corners_at(pack, t, x, z);
  if (pack->float_cells) {
    sample_floats(pack, &c, velocity);
  } else {
    sample_halves(pack, &c, velocity);
  }
}

void windloom_sample(const windloom_pack* pack, float x, float z, double time, float velocity[2]) {
  const neighbours t = frames_at(pack, time);
  sample_between(pack, &t, x, z, velocity);
}

void windloom_sample_plain(const windloom_pack* pack, const windloom_moment* moment, const float* positions,
                           size_t count, float* velocities) {
  for (size_t i = 0; i < count; ++i) {
    sample_between(pack, moment, positions[2 * i], positions[2 * i + 1], velocities + 2 * i);
  }
}

void windloom_sample_many(const windloom_pack* pack, const float* positions, size_t count, double time,
                          float* velocities) {
  const neighbours t = frames_at(pack, time);
  const size_t done = pack->fast_batches ? windloom_sample_fast(pack, &t, positions, count, velocities) : 0;
  windloom_sample_plain(pack, &t, positions + 2 * done, count - done, velocities + 2 * done);
}
