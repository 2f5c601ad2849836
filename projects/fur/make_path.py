"""Writes the ball's keys into fur.wind.json: around the hare, close enough to brush its coat.

usage: make_path.py [FILE.wind.json]
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from collider_keys import put  # noqa: E402

HALF_X, HALF_Z = 0.78, 0.52  # m: the oval that it rolls
SECONDS = 7.0                # a round
KEYS = 32


def keys():
    turns = [2 * math.pi * i / KEYS for i in range(KEYS + 1)]
    return [(SECONDS * i / KEYS, HALF_X * math.cos(turn), 0, HALF_Z * math.sin(turn)) for i, turn in enumerate(turns)]


def main():
    here = pathlib.Path(__file__).parent / "fur.wind.json"
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else here
    target.write_text(put(target.read_text(), "ball", keys()))
    print(f"{target}: {KEYS + 1} keys, {SECONDS:.1f} s a round")


if __name__ == "__main__":
    main()
