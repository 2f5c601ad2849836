"""Makes assets/helicopter.glb: a light helicopter, its nose towards +z, its skids at y = 0.

usage: make_helicopter.py [FILE.glb]
"""
import math
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from glb_file import glb, joined, tube  # noqa: E402

RED, WHITE, GLASS, METAL, DARK = (0.32, 0.018, 0.012), (0.55, 0.54, 0.50), (0.012, 0.018, 0.024), (0.11, 0.115, 0.12), (0.02, 0.02, 0.022)
ROTOR = 5.0  # m, radius
MAST = 3.05  # m, height of the rotor

# Along z: height of the middle, half width, half height.
HULL = [(2.35, 1.08, 0.04, 0.04), (2.28, 1.10, 0.24, 0.22), (2.05, 1.16, 0.48, 0.46), (1.65, 1.28, 0.68, 0.70), (1.1, 1.42, 0.80, 0.90),
        (0.5, 1.50, 0.84, 0.98), (-0.2, 1.52, 0.82, 0.97), (-0.8, 1.55, 0.72, 0.86), (-1.3, 1.62, 0.55, 0.66), (-1.75, 1.72, 0.36, 0.44),
        (-2.2, 1.80, 0.24, 0.29), (-3.2, 1.88, 0.19, 0.22), (-4.4, 1.95, 0.15, 0.17), (-5.6, 2.02, 0.11, 0.12), (-6.0, 2.04, 0.05, 0.05)]
SECTORS = 48


def hull():
    z, y, wide, high = numpy.array(HULL[::-1]).T
    fine = numpy.linspace(0, 1, 70)
    way = numpy.linspace(0, 1, len(z))
    smooth = [numpy.interp(fine, way, v) for v in (z, y, wide, high)]
    kernel = numpy.array([0.25, 0.5, 0.25])
    for _ in range(3):
        smooth = [numpy.concatenate([[v[0]], numpy.convolve(v, kernel, "valid"), [v[-1]]]) for v in smooth]
    z, y, wide, high = smooth
    positions, triangles = tube(numpy.stack([0 * z, y, z], axis=1), list(zip(wide, high)), SECTORS)
    colours = numpy.empty((len(positions), 3))
    for i, (x, up, along) in enumerate(positions):
        part = numpy.interp(along, z, y)
        above = up - part
        glass = along > 0.45 - 0.25 * above and above > -0.30 - 0.22 * (along - 0.5) and along < 2.3
        frame = abs(along - 1.05) < 0.05 or abs(x) < 0.035
        door = -0.55 < along < 0.35 and abs(x) > 0.45 and 0.02 < above < 0.55
        colours[i] = (DARK if frame else GLASS) if glass else GLASS if door else WHITE if abs(above + 0.22 + 0.03 * along) < 0.09 else RED
    return positions, triangles, colours


def box(middle, size, colour, turn=0.0, pitch=0.0):
    """Its corners shared by no two sides, so that its edges stay sharp; turned about y, then pitched about its own x."""
    corners, triangles = [], []
    half = numpy.array(size) / 2
    for axis in range(3):
        for side in (-1, 1):
            a, b = (axis + 1) % 3, (axis + 2) % 3
            first = len(corners)
            for p, q in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                corner = numpy.zeros(3)
                corner[axis], corner[a], corner[b] = side * half[axis], p * half[a], q * half[b]
                corners.append(corner)
            order = (0, 1, 2, 0, 2, 3) if side > 0 else (0, 2, 1, 0, 3, 2)
            triangles += [[first + order[i] for i in range(0, 3)], [first + order[i] for i in range(3, 6)]]
    corners = numpy.array(corners)
    s, c = math.sin(pitch), math.cos(pitch)
    corners = corners @ numpy.array([[1, 0, 0], [0, c, s], [0, -s, c]])
    s, c = math.sin(turn), math.cos(turn)
    corners = corners @ numpy.array([[c, 0, -s], [0, 1, 0], [s, 0, c]])
    return corners + numpy.array(middle), numpy.array(triangles), colour


def rod(points, radius, colour, sectors=14):
    positions, triangles = tube(points, [radius] * len(points), sectors)
    return positions, triangles, colour


def blades():
    """Three, coned upwards a little."""
    parts = [rod([(0, 2.3, 0), (0, 2.7, 0), (0, MAST + 0.12, 0)], 0.09, METAL), rod([(0, MAST - 0.10, 0), (0, MAST, 0), (0, MAST + 0.10, 0)], 0.24, DARK)]
    for k in range(3):
        turn = 0.45 + 2 * math.pi * k / 3
        for i in range(8):
            t = (i + 0.5) / 8
            reach = 0.2 + (ROTOR - 0.2) * t
            middle = (reach * math.sin(turn), MAST + 0.35 * t * t, reach * math.cos(turn))
            colour = (0.5, 0.38, 0.02) if i == 7 else DARK
            parts.append(box(middle, (0.30, 0.035, (ROTOR - 0.2) / 8 * 1.02), colour, turn, -0.075 * t))
    return parts


def tail():
    parts = [box((0, 2.55, -5.55), (0.07, 1.25, 0.55), RED, 0.0, 0.30), box((0, 1.55, -5.75), (0.06, 0.75, 0.42), WHITE, 0.0, -0.35),
             box((0, 1.98, -4.55), (1.9, 0.05, 0.42), WHITE)]
    parts.append(rod([(0.05, 2.1, -5.75), (0.15, 2.1, -5.75), (0.26, 2.1, -5.75)], 0.07, METAL))
    for k in range(2):
        angle = 0.7 + math.pi * k
        parts.append(box((0.26, 2.1 + 0.45 * math.cos(angle), -5.75 + 0.45 * math.sin(angle)), (0.03, 0.90, 0.13), DARK, 0.0, angle))
    return parts


def skids():
    parts = []
    for side in (-1, 1):
        x = 0.95 * side
        parts.append(rod([(x, 0.22, 1.75), (x, 0.07, 1.45), (x, 0.05, 1.0), (x, 0.05, -0.9), (x, 0.05, -1.3)], 0.05, METAL))
        for z in (0.85, -0.75):
            parts.append(rod([(0.30 * side, 0.80, z), (0.66 * side, 0.52, z), (0.90 * side, 0.22, z), (x, 0.05, z)], 0.045, METAL))
    return parts


def main():
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "assets" / "helicopter.glb"
    engine = tube([(0, 2.42, 0.75), (0, 2.46, 0.3), (0, 2.48, -0.5), (0, 2.36, -1.2), (0, 2.2, -1.6)],
                  [(0.10, 0.08), (0.36, 0.24), (0.40, 0.30), (0.32, 0.26), (0.16, 0.14)], 28)
    parts = [hull(), (*engine, RED), rod([(0.28, 2.42, -1.0), (0.34, 2.42, -1.45), (0.42, 2.44, -1.75)], 0.09, DARK)]
    positions, triangles, colours = joined(parts + blades() + tail() + skids())
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(glb("helicopter", "make_helicopter.py", positions, triangles, colours))
    print(f"{target}: {len(triangles)} triangles, {positions.min(axis=0).round(2)} to {positions.max(axis=0).round(2)}")


if __name__ == "__main__":
    main()
