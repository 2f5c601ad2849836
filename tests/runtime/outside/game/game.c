/* game FILE: the wind at (1, 1), by every part of the library. */
#include <stdio.h>
#include <windloom_runtime.h>

int main(int argc, char** argv) {
  windloom_status status = WINDLOOM_CANNOT_READ;
  windloom_pack* pack = argc == 2 ? windloom_load_file(argv[1], &status) : NULL;
  if (pack == NULL) {
    puts(windloom_status_text(status));
    return 1;
  }
  float place[2] = {1.0f, 1.0f}, wind[2], many[2];
  windloom_sample(pack, place[0], place[1], 0.0, wind);
  windloom_sample_many(pack, place, 1, 0.0, many);
  printf("%g %g %d\n", (double)wind[0], (double)wind[1], many[0] == wind[0]);
  windloom_free(pack);

  windloom_follow* follow = windloom_follow_open(argv[1]);
  printf("follow %d\n", windloom_follow_poll(follow));
  windloom_follow_close(follow);

  windloom_live* live = windloom_live_open("windloom-nobody", &status);
  printf("live %d\n", live != NULL);
  windloom_live_close(live);
  return 0;
}
