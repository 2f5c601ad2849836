"""Makes terrain/hills.png: smooth hills.

usage: make_ground.py [FILE.png]
"""
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "hills"))
from make_hills import smooth_noise, write_ground  # noqa: E402

SIDE = 129     # pixels, one for each metre of 128 m
EXTENT = 128.0  # m
HEIGHT = 16.0  # m from black to white


def heights():
    line = numpy.linspace(-EXTENT / 2, EXTENT / 2, SIDE)
    x, z = numpy.meshgrid(line, line)
    hills = 3.2 + 4.6 * smooth_noise(x + 9, z, 34.0, 21) + 1.5 * smooth_noise(x, z, 17.0, 23) + 0.25 * smooth_noise(x, z, 7.0, 25)
    # A hollow in the middle, higher land around.
    away = numpy.hypot(x / 30.0, (z - 4.0) / 26.0)
    return hills - 2.2 * numpy.exp(-away ** 2) + 5.0 * numpy.clip((away - 1.1) / 1.4, 0, 1) ** 2


if __name__ == "__main__":
    write_ground(heights(), HEIGHT, pathlib.Path(__file__).parent)
