"""Makes terrain/hills.png: flowing hills, a valley that winds through them and climbs a slope at its end.

usage: make_hills.py [FILE.png]
"""
import pathlib
import struct
import sys
import zlib

import numpy

SIDE = 513      # pixels, one for each 0.3125 m of 160 m
EXTENT = 160.0  # m
HEIGHT = 26.0   # m from black to white


def smooth_noise(x, z, cell, seed):
    """Value noise with a smooth course between the nodes of a lattice, 0..1."""
    random = numpy.random.RandomState(seed).rand(64, 64)
    u, v = x / cell + 31.3, z / cell + 17.7
    i, k = numpy.floor(u).astype(int), numpy.floor(v).astype(int)
    f, g = u - i, v - k
    f, g = f ** 3 * (f * (6 * f - 15) + 10), g ** 3 * (g * (6 * g - 15) + 10)
    at = lambda a, b: random[b % 64, a % 64]
    return (at(i, k) * (1 - f) + at(i + 1, k) * f) * (1 - g) + (at(i, k + 1) * (1 - f) + at(i + 1, k + 1) * f) * g


def heights():
    line = numpy.linspace(-EXTENT / 2, EXTENT / 2, SIDE)
    x, z = numpy.meshgrid(line, line)
    hills = 15.0 * smooth_noise(x, z, 46.0, 3) + 5.0 * smooth_noise(x, z, 21.0, 5) + 1.2 * smooth_noise(x, z, 8.0, 7)
    hills += 0.25 * smooth_noise(x, z, 3.0, 9)
    # The valley's bed winds from the west; in the east it climbs a shoulder.
    bed = 9.0 * numpy.sin(x / 24.0) + 2.0
    away = numpy.abs(z - bed)
    floor = 2.2 + 0.35 * smooth_noise(x, z, 9.0, 11) + 8.0 / (1 + numpy.exp(-(x - 34.0) / 6.0))
    wall = 1 / (1 + numpy.exp(-(away - 13.0) / 3.6))
    rise = 3.0 + hills * 0.9 + 4.0 * smooth_noise(x, z, 60.0, 13)
    return floor * (1 - wall) + numpy.maximum(rise, floor) * wall


def write_png(path, samples):
    """16-bit grey."""
    rows = b"".join(b"\0" + row.astype(">u2").tobytes() for row in samples)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", samples.shape[1], samples.shape[0], 16, 0, 0, 0, 0)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def write_ground(made, height, folder):
    """To the file that the command line names, else to terrain/hills.png of the folder; white is `height` m."""
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(folder) / "terrain" / "hills.png"
    if made.min() < 0 or made.max() > height:
        raise SystemExit(f"heights from {made.min():.2f} to {made.max():.2f} m leave 0 to {height} m")
    write_png(target, numpy.round(made / height * 65535))
    print(f"{target}: {made.min():.2f} to {made.max():.2f} m")


if __name__ == "__main__":
    write_ground(heights(), HEIGHT, pathlib.Path(__file__).parent)
