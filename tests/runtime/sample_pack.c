/* Loads a wind pack and prints the wind: sample_pack FILE X Z TIME [X Z TIME ...], one "vx vz" a line. With FILE alone
 * it prints what the header says. Exit status 1 and the reason where it can't be loaded. */
#include <stdio.h>
#include <stdlib.h>

#include "engine/runtime/windloom_runtime.h"

int main(int argc, char** argv) {
  if (argc < 2 || (argc - 2) % 3 != 0) {
    fprintf(stderr, "usage: sample_pack FILE [X Z TIME ...]\n");
    return 2;
  }
  windloom_status status;
  windloom_pack* pack = windloom_load_file(argv[1], &status);
  if (pack == NULL) {
    fprintf(stderr, "%s: %s\n", argv[1], windloom_status_text(status));
    return 1;
  }
  if (argc == 2) {
    const windloom_info info = windloom_get_info(pack);
    printf("%d %d %d %.9g %.9g %.9g %.9g %.9g %.9g %.17g %d %d %d\n", info.width, info.height, info.frames,
           (double)info.min_x, (double)info.min_z, (double)info.max_x, (double)info.max_z, (double)info.fps,
           (double)info.max_speed, info.start, info.loop, info.edge_x == WINDLOOM_WRAP, info.edge_z == WINDLOOM_WRAP);
  }
  for (int i = 2; i + 2 < argc; i += 3) {
    float velocity[2];
    windloom_sample(pack, strtof(argv[i], NULL), strtof(argv[i + 1], NULL), strtod(argv[i + 2], NULL), velocity);
    printf("%.9g %.9g\n", (double)velocity[0], (double)velocity[1]);
  }
  windloom_free(pack);
  return 0;
}
