// Where a streamline or a wind vector stands, and how streamlines are kept (std430).
#ifndef WINDLOOM_SHARED_FLOW_SEED_H
#define WINDLOOM_SHARED_FLOW_SEED_H
#include "shaders/shared/language.h"
WL_SHARED_BEGIN

#define FLOW_LINE_POINTS 14

struct FlowSeed {
  vec4 place;  // x, z, spacing to the next seeds, m; how visible it is, 0..1
  uint key;    // the same for the same place of the world
  uint unused0, unused1, unused2;
};

WL_SHARED_END
#ifdef __cplusplus
static_assert(sizeof(windloom::shared::FlowSeed) == 32, "std430 layout");
#endif
#endif
