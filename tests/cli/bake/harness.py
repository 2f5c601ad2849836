"""What the scripts here share: a small project, running the program, and readers that know nothing of our code."""
import hashlib
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import numpy

from read_windpack import read_windpack  # noqa: F401, for the scripts

WINDLOOM, SAMPLE_PACK = sys.argv[1:3]
PATIENCE = int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))  # more where sanitizers slow everything down

PROJECT = {
    "format": "windloom-project",
    "version": 1,
    "name": "Test",
    "field": {"centre": [4, -2], "size": [32, 20], "resolution": [48, 30],
              "borders": {"xMin": "open", "xMax": "open", "zMin": "open", "zMax": "open"}, "timeStep": 0.016666667},
    "ambient": {"speed": 1.5, "direction": 30},
    "graph": {
        "points": [{"id": 1, "position": [-4, -4]}, {"id": 2, "position": [6, -1]}, {"id": 3, "position": [12, 4]}],
        "arrows": [{"id": 10, "from": 1, "to": 2, "strength": 9, "radius": 3, "travelSpeed": 60},
                   {"id": 11, "from": 2, "to": 3, "strength": 7, "radius": 3, "travelSpeed": 60}],
        "signals": [{"root": 1, "kind": "pulse", "period": 1, "on": 0.4, "attack": 0.1, "release": 0.2}]},
    "probes": [{"id": 40, "name": "tip", "position": [12, 4]}],
}
LOW, HIGH, CELLS = (-12.0, -12.0), (20.0, 8.0), (48, 30)


def centre_of(i, k):
    return tuple(LOW[a] + (n + 0.5) * (HIGH[a] - LOW[a]) / CELLS[a] for a, n in ((0, i), (1, k)))


class Case(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory(prefix="windloom-cli-")
        self.addCleanup(self._folder.cleanup)
        self.folder = pathlib.Path(self._folder.name)
        self.project = self.folder / "test.wind.json"
        self.project.write_text(json.dumps(PROJECT))

    def call(self, *args, status=0, env=None, **kwargs):
        """Runs `windloom ARGS`; the finished process. `status` is what it must exit with."""
        done = subprocess.run([WINDLOOM, *map(str, args)], capture_output=True, text=True, timeout=200 * PATIENCE,
                              env={**os.environ, **(env or {})}, **kwargs)
        self.assertEqual(done.returncode, status, f"{args}: {done.stdout}{done.stderr}")
        return done

    def bake(self, *args, out="out", formats="npy", **kwargs):
        """Bakes the project on the CPU; the output folder."""
        folder = self.folder / out
        self.call("bake", self.project, "--backend", "cpu", "--out", folder, "--format", formats, *args, **kwargs)
        return folder


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def read_png(path):
    """8-bit samples of a PNG that isn't interlaced, [height, width, channels]; after ISO 15948."""
    raw = path.read_bytes()
    assert raw[:8] == b"\x89PNG\r\n\x1a\n"
    at, data, header = 8, b"", None
    while at < len(raw):
        length, kind = struct.unpack_from(">I4s", raw, at)
        body = raw[at + 8:at + 8 + length]
        assert struct.unpack_from(">I", raw, at + 8 + length)[0] == zlib.crc32(kind + body)
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            data += body
        at += 12 + length
    width, height, depth, colour, _, _, interlace = header
    assert depth == 8 and interlace == 0
    channels = {0: 1, 2: 3, 6: 4}[colour]
    lines = numpy.frombuffer(zlib.decompress(data), numpy.uint8).reshape(height, 1 + width * channels)
    image = numpy.zeros((height, width * channels), int)
    above = numpy.zeros(width * channels, int)
    for row in range(height):
        line = lines[row, 1:].astype(int)
        above = image[row] = unfilter(lines[row, 0], line, above, channels)
    return image.reshape(height, width, channels)


def unfilter(kind, line, above, channels):
    if kind == 0:
        return line
    if kind == 2:
        return (line + above) % 256
    out = numpy.zeros_like(line)
    for i in range(len(line)):
        left = out[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        up = above[i]
        if kind == 1:
            guess = left
        elif kind == 3:
            guess = (left + up) // 2
        else:
            estimate = left + up - corner
            guess = min((left, up, corner), key=lambda v: (abs(estimate - v)))
        out[i] = (line[i] + guess) % 256
    return out


def main():
    unittest.main(argv=sys.argv[:1])
