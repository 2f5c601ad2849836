/* The wind at a place and a moment. */
#include <math.h>

#include "engine/runtime/cell_rows.h"
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

/* The cells around a place and a moment: two columns of four rows, early near, early far, late near, late far. */
typedef struct corners {
  size_t low[4], high[4]; /* numbers of cells */
  float rows[4], x;       /* weights of the rows, and of the high column */
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
  const size_t low = (size_t)x.low, high = (size_t)x.high;
  const float before = 1.0f - t->weight, nearer = 1.0f - z.weight;
  const corners c = {{early + near + low, early + far + low, late + near + low, late + far + low},
                     {early + near + high, early + far + high, late + near + high, late + far + high},
                     {before * nearer, before * z.weight, t->weight * nearer, t->weight * z.weight},
                     x.weight};
  return c;
}

static inline void sample_halves(const windloom_pack* pack, const corners* c, float velocity[2]) {
  const uint32_t* cells = pack->cells;
  sum_of_rows(row_of_halves(cells, c->low[0], c->high[0]), row_of_halves(cells, c->low[1], c->high[1]),
              row_of_halves(cells, c->low[2], c->high[2]), row_of_halves(cells, c->low[3], c->high[3]), c->rows, c->x,
              WINDLOOM_HALF_SCALE, velocity);
}

static inline void sample_floats(const windloom_pack* pack, const corners* c, float velocity[2]) {
  const float* cells = pack->cells;
  sum_of_rows(row_of_floats(cells, c->low[0], c->high[0]), row_of_floats(cells, c->low[1], c->high[1]),
              row_of_floats(cells, c->low[2], c->high[2]), row_of_floats(cells, c->low[3], c->high[3]), c->rows, c->x,
              1.0f, velocity);
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
