"""Commands in documents that the test doesn't run as they stand, each with its reason. An entry that no command needs fails the test."""

# What must never be run here, whichever page says it: as patterns, with the reason. These may wait for their first command.
REFUSED = [
    (r"^(sudo|su|apt|apt-get|dpkg|dnf|pacman|debootstrap|chroot|mount|umount)\b", "needs root and changes the machine"),
    (r"^cmake --install (?!.*--component runtime)", "install_test installs so; here it would write into the build folder"),
    (r"(^|\s)/(usr|etc|opt)/", "speaks of what a package installs; package_test does"),
]

# (page, part of the command, reason): never run by this test.
NEVER = [
    ("CONTRIBUTING.md", "cmake --build build/test", "./test builds with the same preset"),
    ("docs/examples/leaves/README.md", "cmake -S docs/examples/leaves", "game_alone_test builds the game so"),
    ("docs/examples/leaves/README.md", "cmake --build out/leaves", "game_alone_test builds the game so"),
    ("docs/examples/leaves/README.md", "windloom-leaves --live", "waits for an editor; game_live_test plays with one"),
    ("docs/benchmarks.md", "tests/bench/window_bench.py", "takes minutes and needs a quiet machine"),
    ("docs/windpack.md", "cc game.c", "installed_library compiles a game so"),
    ("docs/install.md", "update-mime-database", "desktop_test does so with what was installed"),
    ("docs/tutorial.md", "~/leaves/windloom-leaves", "game_alone_test builds the game from an installed library"),
]

# The same, run in the long form only.
LONG = [
    ("docs/solver.md", "--target solver_pictures", "draws eight pictures at full resolution, minutes"),
    ("docs/benchmarks.md", "windloom bench live", "plays for a minute at least, whatever the size"),
    ("docs/benchmarks.md", "bench meadow grassland live picture", "includes the live scene"),
    ("docs/benchmarks.md", "windloom bench picture", "draws every blade of up to 100 million"),
    ("docs/benchmarks.md", "windloom bench shell", "layers of grass that fill the picture: slow without a graphics card"),
    ("docs/benchmarks.md", "bench export", "a minute even at its quick size"),
]
