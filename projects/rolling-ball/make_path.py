"""Writes the ball's keys into rolling-ball.wind.json: a lying eight at an even speed.

usage: make_path.py [FILE.wind.json]
"""
import math
import pathlib
import re
import sys

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


def number(value):
    return f"{round(value, 4) + 0.0:.4f}".rstrip("0").rstrip(".")


def put(text, name, made):
    """The project's text with other keys for the collider of this name."""
    wanted = re.compile(rf'("name": "{name}",[^{{}}]*?"keys": )\[\s*\[.*?\]\s*\]', re.S)
    listed = ", ".join("[" + ", ".join(number(v) for v in key) + "]" for key in made)
    text, found = wanted.subn(lambda match: f"{match.group(1)}[{listed}]", text)
    if found != 1:
        raise SystemExit(f"there is no collider '{name}' with keys")
    return text


def main():
    here = pathlib.Path(__file__).parent / "rolling-ball.wind.json"
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here
    made = keys()
    target.write_text(put(target.read_text(), "ball", made))
    print(f"{target}: {len(made)} keys, {made[-1][0]:.1f} s a round")


if __name__ == "__main__":
    main()
