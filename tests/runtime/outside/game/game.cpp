// game FILE: the wind at (1, 1), by every part of the library.
#include <cstdio>
#include <windloom_runtime.hpp>

using namespace windloom::runtime;

int main(int argc, char** argv) {
  const WindPack pack = argc == 2 ? WindPack::load(argv[1]) : WindPack();
  if (!pack) {
    std::puts(windloom_status_text(pack.status()));
    return 1;
  }
  const Velocity wind = pack.sample(1.0f, 1.0f, 0.0);
  const float place[2] = {1.0f, 1.0f};
  float many[2];
  pack.sampleMany(place, 1, 0.0, many);
  std::printf("%g %g %d\n", static_cast<double>(wind.x), static_cast<double>(wind.z), many[0] == wind.x);
  FollowedPack followed(argv[1]);
  std::printf("follow %d\n", followed.poll());
  std::printf("live %d\n", static_cast<int>(static_cast<bool>(LiveField::open("windloom-nobody"))));
  return followed.pack().heightFactor(2.0f) > 0.99f ? 0 : 1;
}
