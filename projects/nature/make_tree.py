"""Makes assets/fallen-tree.glb: a dead tree that lies on the ground, z along the trunk.

usage: make_tree.py [FILE.glb]
"""
import math
import pathlib
import sys

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent))
from glb_file import glb, joined, tube  # noqa: E402

LENGTH = 8.5  # m
BARK, MOSS, WOOD = numpy.array((0.115, 0.080, 0.055)), numpy.array((0.075, 0.095, 0.025)), numpy.array((0.30, 0.21, 0.12))


def furrows(seed, depth):
    random = numpy.random.RandomState(seed)
    phases = random.uniform(0, 2 * math.pi, 6)
    twist = random.uniform(0.03, 0.08)

    def bump(ring, angle):
        a = angle + twist * ring
        return 1 + depth * (0.6 * math.sin(9 * a + phases[0] + 0.3 * ring) + 0.5 * math.sin(14 * a + phases[1] - 0.2 * ring)
                            + 0.9 * math.sin(2 * a + phases[2] + 0.11 * ring) + 0.5 * math.sin(3 * a + phases[3] - 0.17 * ring))
    return bump


def trunk_at(along):
    """The middle of the trunk, which lies on the ground, at a z."""
    t = along / LENGTH + 0.5
    return 0.35 * math.sin(2.6 * t) - 0.12 * math.sin(6.0 * t), 0.5 * (1 - 0.38 * t), along


def limb(start, way, length, radius, bend, seed, sectors=22, tip=0.25, course=None):
    """Tapering, bending towards `bend` or along `course`; bark below, moss on top, bare wood at the broken end."""
    rings = max(8, int(length * 6))
    centres, radii = [], []
    at, way = numpy.array(start, float), numpy.array(way, float) / numpy.linalg.norm(way)
    random = numpy.random.RandomState(seed)
    for i in range(rings):
        t = i / (rings - 1)
        centres.append(at.copy() if course is None else numpy.array(course(start[2] + t * length), float))
        radii.append(radius * (1 - (1 - tip) * t ** 0.9))
        way = way + numpy.array(bend) / rings + random.normal(0, 0.025, 3)
        way /= numpy.linalg.norm(way)
        at += way * length / (rings - 1)
    positions, triangles = tube(centres, radii, sectors, furrows(seed, 0.045))
    colours = numpy.empty((len(positions), 3))
    for i in range(len(positions)):
        ring = min(i // sectors, rings - 1)
        out = positions[i] - centres[ring]
        up = out[1] / max(numpy.linalg.norm(out), 1e-6)
        spot = 0.5 + 0.5 * math.sin(2.1 * positions[i][2] + 3.7 * positions[i][0]) * math.sin(1.3 * positions[i][2] + seed)
        mossy = min(max(1.6 * up - 0.5 + 0.7 * spot, 0.0), 0.85) if radius > 0.1 else 0.15
        shade = random.uniform(0.75, 1.25)
        colours[i] = (BARK * (1 - mossy) + MOSS * mossy) * shade
    ends = range((rings - 1) * sectors, len(positions))
    for i in ends:
        if i != len(positions) - 2:  # the first end's middle
            colours[i] = WOOD * (0.8 if i < rings * sectors else 1.0)
    colours[-2] = WOOD
    return positions, triangles, colours


def roots():
    """Broken off around the foot."""
    parts = []
    for k in range(9):
        angle = 2 * math.pi * k / 9 + 0.35 * math.sin(5 * k)
        way = (math.cos(angle), math.sin(angle), -0.75)
        start = (0.30 * math.cos(angle), 0.50 + 0.30 * math.sin(angle), -LENGTH / 2 + 0.30)
        length = 0.75 + 0.35 * math.sin(3 * k + 1)
        parts.append(limb(start, way, length, 0.19, (0, -0.3, -0.3), 40 + k, 9, 0.22))
    return parts


def twigs(start, way, length, radius, seed):
    """Off a branch to all sides, the longest in its middle."""
    random = numpy.random.RandomState(seed)
    way = numpy.array(way) / numpy.linalg.norm(way)
    made = []
    for i in range(9):
        part = 0.28 + 0.62 * i / 8
        aside = numpy.cross(way, random.normal(0, 1, 3))
        aside /= numpy.linalg.norm(aside)
        aside[1] = abs(aside[1]) if aside[1] < -0.3 else aside[1]
        foot = numpy.array(start) + way * part * 0.9 * length + numpy.array((0, 0.11, 0.15)) * part * part * length
        size = length * random.uniform(0.35, 0.6) * (1.15 - part)
        made.append(limb(foot, 0.75 * aside + 0.7 * way, size + 0.35, 0.42 * radius, (0, 0.35, 0.2), seed + i, 6, 0.35))
    return made


def branches():
    parts = []
    for k, (along, angle, length, radius) in enumerate([
            (0.6, 70, 2.2, 0.16), (1.5, 128, 2.6, 0.17), (2.3, 25, 2.1, 0.15), (2.9, 95, 2.4, 0.14), (3.4, 160, 1.9, 0.13),
            (3.7, 55, 1.7, 0.11), (1.1, 40, 2.0, 0.13), (2.6, 145, 2.2, 0.14), (3.2, 75, 2.1, 0.13), (3.9, 115, 1.8, 0.12)]):
        a = math.radians(angle)
        x, y, _ = trunk_at(along)
        start = (x + 0.1 * math.cos(a), y + 0.1 * math.sin(a), along)
        way = (math.cos(a), math.sin(a), 0.8)
        parts.append(limb(start, way, length, radius, (0, 0.5, 0.7), 60 + k, 10, 0.3))
        parts += twigs(start, way, length, radius, 80 + 10 * k)
    return parts


def main():
    target = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "assets" / "fallen-tree.glb"
    trunk = limb(trunk_at(-LENGTH / 2), (0, 0, 1), LENGTH, 0.52, (0, 0, 0), 3, 36, 0.5, trunk_at)
    positions, triangles, colours = joined([trunk] + roots() + branches())
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(glb("fallen tree", "make_tree.py", positions, triangles, colours))
    print(f"{target}: {len(triangles)} triangles, {positions.min(axis=0).round(2)} to {positions.max(axis=0).round(2)}")


if __name__ == "__main__":
    main()
