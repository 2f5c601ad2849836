"""Makes terrain/hills.png: long low swells.

usage: make_ground.py [FILE.png]
"""
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "hills"))
from make_hills import smooth_noise, write_ground  # noqa: E402

SIDE = 129     # pixels, one for each 2.5 m of 320 m
EXTENT = 320.0  # m
HEIGHT = 6.0   # m from black to white


def heights():
    line = numpy.linspace(-EXTENT / 2, EXTENT / 2, SIDE)
    x, z = numpy.meshgrid(line, line)
    swells = 3.4 * smooth_noise(x, z + 20, 74.0, 31) + 0.9 * smooth_noise(x + 5, z, 33.0, 33)
    # Level towards the edges, whose height goes on to the horizon.
    level = 1.0 - numpy.clip((numpy.maximum(abs(x), abs(z)) - 100.0) / 60.0, 0, 1)
    level = level * level * (3 - 2 * level)
    return 1.6 + (swells - 1.6) * level


if __name__ == "__main__":
    write_ground(heights(), HEIGHT, pathlib.Path(__file__).parent)
