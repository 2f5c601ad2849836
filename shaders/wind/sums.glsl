// Sums over all cells in one dispatch: each work-group delivers its own, and the last to arrive adds them up, always in
// the same order. Before the include: SUM_COUNT values, of which the first SUM_ADDED are added and the others' greatest
// is taken; GROUP_SIZE; a shared float array `scratch` of at least SUM_COUNT * GROUP_SIZE; a buffer `control`.

layout(std430, binding = WIND_SSBO_SUMS) coherent buffer Sums { float groupSums[]; };
shared uint isLastGroup;

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

// Joined over the work-group, for all invocations.
void joinGroup(inout float sums[SUM_COUNT]) {
  barrier();
  for (int c = 0; c < SUM_COUNT; ++c) scratch[c * GROUP_SIZE + int(gl_LocalInvocationIndex)] = sums[c];
  barrier();
  joinScratch(GROUP_SIZE, 128);
  joinScratch(128, 8);
  joinScratch(8, 1);
  for (int c = 0; c < SUM_COUNT; ++c) sums[c] = scratch[c * GROUP_SIZE];
}

// True in all invocations of the work-group that arrives last; then the values are those of all groups.
bool joinAll(inout float sums[SUM_COUNT]) {
  joinGroup(sums);
  uint groups = gl_NumWorkGroups.x * gl_NumWorkGroups.y;
  if (gl_LocalInvocationIndex == 0u) {
    uint group = gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x;
    for (int c = 0; c < SUM_COUNT; ++c) groupSums[group * uint(SUM_COUNT) + uint(c)] = sums[c];
    memoryBarrierBuffer();
    isLastGroup = atomicAdd(control.arrived, 1u) + 1u == groups ? 1u : 0u;
  }
  barrier();
  if (isLastGroup == 0u) return false;
  memoryBarrierBuffer();
  for (int c = 0; c < SUM_COUNT; ++c) sums[c] = 0.0;
  for (uint m = gl_LocalInvocationIndex; m < groups; m += uint(GROUP_SIZE)) {
    for (int c = 0; c < SUM_COUNT; ++c) sums[c] = joined2(c, sums[c], groupSums[m * uint(SUM_COUNT) + uint(c)]);
  }
  joinGroup(sums);
  if (gl_LocalInvocationIndex == 0u) control.arrived = 0u;
  return true;
}
