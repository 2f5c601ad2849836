// Ending the pressure solve on the GPU: once converged, the remaining dispatches of the step have no work-groups. Needs
// block.glsl and a buffer `control`.

layout(std140, binding = WIND_UBO_LEVELS) uniform LevelsBlock { WindLevel allLevels[WIND_MAX_LEVELS]; };

void setDispatch(int command, int x, int z) {
  control.groups[4 * command] = uint(x);
  control.groups[4 * command + 1] = uint(z);
  control.groups[4 * command + 2] = 1u;
}

// `run`: the passes of the cycles; `again`: the flux pass once more.
void setDispatches(bool run, bool again) {
  for (int l = 0; l < wind.ownLevels; ++l) {
    setDispatch(WIND_COMMAND_DOWN + l, run ? allLevels[l].downGroupsX : 0, allLevels[l].downGroupsZ);
    setDispatch(WIND_COMMAND_UP + l, run ? allLevels[l].upGroupsX : 0, allLevels[l].upGroupsZ);
  }
  setDispatch(WIND_COMMAND_TAIL, run ? 1 : 0, 1);
  setDispatch(WIND_COMMAND_FIRST, again ? wind.firstGroupsX : 0, wind.firstGroupsZ);
}
