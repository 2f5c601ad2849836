// Adds up what the work-groups of the pass before delivered, in a pass of a single work-group. Needs sums.glsl.

uniform int sumGroups;  // how many delivered

// The values of all; in every invocation.
void addUp(out float total[SUM_COUNT]) {
  for (int c = 0; c < SUM_COUNT; ++c) total[c] = 0.0;
  for (int m = int(gl_LocalInvocationIndex); m < sumGroups; m += GROUP_SIZE) {
    for (int c = 0; c < SUM_COUNT; ++c) total[c] = joined2(c, total[c], groupSums[m * SUM_COUNT + c]);
  }
  joinGroup(total);
  for (int c = 0; c < SUM_COUNT; ++c) total[c] = scratch[c * GROUP_SIZE];
}
