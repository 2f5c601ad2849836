"""Makes terrain/hills.png: a rounded knoll on uneven ground.

usage: make_ground.py [FILE.png]
"""
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "hills"))
from make_hills import smooth_noise, write_ground  # noqa: E402

SIDE = 257     # pixels, one for each 0.375 m of 96 m
EXTENT = 96.0  # m
HEIGHT = 9.0   # m from black to white


def heights():
    line = numpy.linspace(-EXTENT / 2, EXTENT / 2, SIDE)
    x, z = numpy.meshgrid(line, line)
    uneven = 0.9 * smooth_noise(x, z, 15.0, 41) + 0.35 * smooth_noise(x, z, 6.0, 43) + 0.08 * smooth_noise(x, z, 2.2, 45)
    # Steeper on its left than on its right, and a shoulder behind.
    wide = numpy.where(x < 0, 8.5, 11.5)
    knoll = 5.4 * numpy.exp(-((x / wide) ** 2 + (z / 9.5) ** 2) ** 1.25)
    shoulder = 1.9 * numpy.exp(-(((x - 13) / 8.0) ** 2 + ((z + 8) / 7.0) ** 2))
    far = numpy.clip((numpy.hypot(x, z) - 30.0) / 16.0, 0, 1)
    return 0.3 + uneven * (1 - 0.8 * far) + knoll + shoulder


if __name__ == "__main__":
    write_ground(heights(), HEIGHT, pathlib.Path(__file__).parent)
