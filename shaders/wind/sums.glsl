// Sums over all cells: each work-group of a pass delivers its own, and a pass of a single work-group (total.glsl) adds
// them up, always in the same order. Before the include: SUM_COUNT values, of which the first SUM_ADDED are added and
// the others' greatest is taken; GROUP_SIZE; a shared float array `scratch` of at least SUM_COUNT * GROUP_SIZE.

layout(std430, binding = WIND_SSBO_SUMS) buffer Sums { float groupSums[]; };

float joined2(int c, float a, float b) { return c < SUM_ADDED ? a + b : max(a, b); }

// Values c at scratch[c * GROUP_SIZE], `count` of each, are joined to `left` of each, a divisor of it.
void joinScratch(int count, int left) {
  for (int job = int(gl_LocalInvocationIndex); job < SUM_COUNT * left; job += GROUP_SIZE) {
    int c = job / left, at = c * GROUP_SIZE + job % left;
    float sum = scratch[at];
    for (int m = left; m < count; m += left) sum = joined2(c, sum, scratch[at + m]);
    scratch[at] = sum;
  }
  barrier();
}

// Joined over the work-group: value c stands in scratch[c * GROUP_SIZE].
void joinGroup(float sums[SUM_COUNT]) {
  barrier();
  for (int c = 0; c < SUM_COUNT; ++c) scratch[c * GROUP_SIZE + int(gl_LocalInvocationIndex)] = sums[c];
  barrier();
  joinScratch(GROUP_SIZE, 128);
  joinScratch(128, 8);
  joinScratch(8, 1);
}

void deliver(float sums[SUM_COUNT]) {
  joinGroup(sums);
  int c = int(gl_LocalInvocationIndex), group = int(gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x);
  if (c < SUM_COUNT) groupSums[group * SUM_COUNT + c] = scratch[c * GROUP_SIZE];
}
