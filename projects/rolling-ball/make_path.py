"""Writes the ball's keys into rolling-ball.wind.json: a lying eight at an even speed.

usage: make_path.py [FILE.wind.json]
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from collider_keys import put  # noqa: E402

HALF_X, HALF_Z = 6.5, 3.4  # m: the eight reaches so far from its middle
SPEED = 2.4                # m/s
KEYS = 48                  # a multiple of 8: the outermost places are keys, so the path turns exactly there
FINE = 200                 # pieces between two keys, to measure the way


def place(turn):
    return HALF_X * math.sin(turn), HALF_Z * math.sin(2 * turn)


def keys():
    made, way, last = [], 0.0, place(0)
    for i in range(KEYS * FINE + 1):
        here = place(2 * math.pi * i / (KEYS * FINE))
        way += math.dist(here, last)
        last = here
        if i % FINE == 0:
            made.append((way / SPEED, here[0], 0, here[1]))
    return made


def main():
    here = pathlib.Path(__file__).parent / "rolling-ball.wind.json"
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here
    made = keys()
    target.write_text(put(target.read_text(), "ball", made))
    print(f"{target}: {len(made)} keys, {made[-1][0]:.1f} s a round")


if __name__ == "__main__":
    main()
