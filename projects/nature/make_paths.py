"""Writes the two balls' keys into nature.wind.json: wavy ways back and forth across the hollow.

usage: make_paths.py [FILE.wind.json]
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from collider_keys import put  # noqa: E402

KEYS = 40
FINE = 100  # pieces between two keys, to measure the way
# Half the way along x and z, m; turns of the side sway; m/s.
BALLS = {"large ball": (6.5, 2.6, 1, 2.6), "small ball": (4.4, 3.6, 2, 2.1)}


def place(ball, turn):
    half_x, half_z, sway, _ = BALLS[ball]
    return half_x * math.sin(turn), half_z * math.sin(2 * turn + 0.7 * sway) - half_z * math.sin(0.7 * sway)


def keys(ball):
    made, way, last = [], 0.0, place(ball, 0)
    for i in range(KEYS * FINE + 1):
        here = place(ball, 2 * math.pi * i / (KEYS * FINE))
        way += math.dist(here, last)
        last = here
        if i % FINE == 0:
            made.append((way / BALLS[ball][3], here[0], 0, here[1]))
    return made


def main():
    here = pathlib.Path(__file__).parent / "nature.wind.json"
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here
    text = target.read_text()
    for ball in BALLS:
        made = keys(ball)
        text = put(text, ball, made)
        print(f"{target}: {ball}, {len(made)} keys, {made[-1][0]:.1f} s a round")
    target.write_text(text)


if __name__ == "__main__":
    main()
