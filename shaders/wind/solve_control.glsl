// Ending the pressure solve on the GPU: once converged, the remaining dispatches of the step have no work-groups. Needs
// block.glsl and a buffer `control`.

layout(std140, binding = WIND_UBO_LEVELS) uniform LevelsBlock { WindLevel allLevels[WIND_MAX_LEVELS]; };

// `run`: the passes of the cycles; `again`: the first pass once more.
void setDispatches(bool run, bool again) {
  for (int l = 0; l < wind.ownLevels; ++l) {
    control.groups[4 * l] = run ? uint(allLevels[l].groupsX) : 0u;
    control.groups[4 * l + 1] = uint(allLevels[l].groupsZ);
    control.groups[4 * l + 2] = 1u;
  }
  control.groups[4 * WIND_COMMAND_FIRST] = again ? uint(allLevels[0].groupsX) : 0u;
  control.groups[4 * WIND_COMMAND_FIRST + 1] = uint(allLevels[0].groupsZ);
  control.groups[4 * WIND_COMMAND_FIRST + 2] = 1u;
  const int tail = 4 * WIND_COMMAND_TAIL;
  control.groups[tail] = run ? 1u : 0u;
  control.groups[tail + 1] = 1u;
  control.groups[tail + 2] = 1u;
}
