/* Small questions to a loaded pack. */
#include "engine/runtime/pack.h"

#include <math.h>
#include <stdlib.h>

void windloom_free(windloom_pack* pack) {
  if (pack == NULL) return;
  free(pack->cells);
  free(pack);
}

const char* windloom_status_text(windloom_status status) {
  switch (status) {
    case WINDLOOM_OK:
      return "The wind pack is loaded.";
    case WINDLOOM_CANNOT_READ:
      return "The file can't be read.";
    case WINDLOOM_NOT_A_PACK:
      return "The file is not a wind pack.";
    case WINDLOOM_NEWER_VERSION:
      return "The wind pack was written by a newer version of Windloom.";
    case WINDLOOM_TOO_LARGE:
      return "The wind pack claims to be larger than any may be.";
    case WINDLOOM_CUT_SHORT:
      return "The wind pack has another length than its header says.";
    case WINDLOOM_DAMAGED:
      return "The wind pack is damaged.";
    case WINDLOOM_OUT_OF_MEMORY:
      return "There is not enough memory for the wind pack.";
    case WINDLOOM_NEEDS_ZSTD:
      return "The wind pack is compressed; link windloom_runtime_zstd to read it.";
    case WINDLOOM_NO_LIVE_FIELD:
      return "No editor shares a live field of that name.";
    case WINDLOOM_NOT_HERE:
      return "This system can't do that.";
  }
  return "Unknown status.";
}

windloom_info windloom_get_info(const windloom_pack* pack) {
  return pack->info;
}

void windloom_set_edges(windloom_pack* pack, windloom_edge x, windloom_edge z) {
  pack->info.edge_x = x;
  pack->info.edge_z = z;
}

void windloom_prepare(windloom_pack* pack, const windloom_info* info, int float_cells) {
  pack->info = *info;
  pack->cells_per_m_x = (float)info->width / (info->max_x - info->min_x);
  pack->cells_per_m_z = (float)info->height / (info->max_z - info->min_z);
  pack->height_scale = info->roughness > 0.0f ? 1.0f / log1pf(info->reference_height / info->roughness) : 0.0f;
  pack->float_cells = float_cells;
  pack->fast_batches = windloom_has_fast_batches() && info->width >= 2;
}

float windloom_height_factor(const windloom_pack* pack, float height) {
  if (!(pack->info.roughness > 0.0f)) return 1.0f;
  if (!(height > 0.0f)) return 0.0f;
  return log1pf(height / pack->info.roughness) * pack->height_scale;
}
