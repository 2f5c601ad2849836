#!/usr/bin/env python3
"""Drives the built `windloom` on projects with terrain: validate, info, sample and what they say of a lost file."""
import argparse
import json
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PATIENCE = int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))
DONE, BAD_INPUT = 0, 1


def png(width, height, depth=16):
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + b"".join(struct.pack(">H", 257 * (x + y)) for x in range(width)) for y in range(height))
    header = struct.pack(">IIBBBBB", width, height, depth, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")


class Terrain(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        (self.folder / "terrain").mkdir()
        (self.folder / "terrain" / "a.png").write_bytes(png(20, 10))
        self.project = self.folder / "a.wind.json"
        self.write({"kind": "heightmap", "file": "terrain/a.png", "size": [40, 20], "height": 8, "base": 1})

    def write(self, terrain):
        self.project.write_text(json.dumps({"format": "windloom-project", "version": 1, "terrain": terrain,
                                            "field": {"size": [30, 30], "resolution": [32, 32]},
                                            "ambient": {"speed": 3}}))

    def run_windloom(self, status, *arguments):
        done = subprocess.run([windloom, *map(str, arguments)], capture_output=True, text=True, timeout=60 * PATIENCE)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_info_tells_what_the_ground_is(self):
        told = json.loads(self.run_windloom(DONE, "info", self.project, "--json").stdout)["terrain"]
        self.assertEqual(told["kind"], "heightmap")
        self.assertEqual(told["pixels"], [20, 10])
        self.assertEqual(told["samples"], [20, 10])
        self.assertEqual(told["size"], [40, 20])
        self.assertEqual(told["bytes"], 20 * 10 * 4)
        self.assertEqual(told["lowest"], 1)
        self.assertAlmostEqual(told["highest"], 1 + 8 * 28 / 255, 4)
        self.assertIn("20 x 10 pixels", self.run_windloom(DONE, "info", self.project).stdout)

    def test_flat_ground_is_told_as_such(self):
        self.write({"kind": "flat"})
        self.assertEqual(json.loads(self.run_windloom(DONE, "info", self.project, "--json").stdout)["terrain"], {"kind": "flat"})

    def test_a_lost_file_is_bad_input_everywhere(self):
        (self.folder / "terrain" / "a.png").unlink()
        for verb in (["validate"], ["info"], ["sample", "--at", "0,0", "--time", "0.1"]):
            done = self.run_windloom(BAD_INPUT, verb[0], self.project, *verb[1:])
            self.assertIn("/terrain/file", done.stderr, verb)
            self.assertIn("a.png", done.stderr, verb)
        told = json.loads(self.run_windloom(BAD_INPUT, "validate", self.project, "--json").stdout)
        self.assertEqual([error["pointer"] for error in told["errors"]], ["/terrain/file"])

    def test_a_damaged_file_and_one_outside_are_refused(self):
        whole = (self.folder / "terrain" / "a.png").read_bytes()
        (self.folder / "terrain" / "a.png").write_bytes(whole[:60])
        self.assertIn("damaged", self.run_windloom(BAD_INPUT, "validate", self.project).stderr)
        for file in ("../a.png", "/tmp/a.png", ""):
            self.write({"kind": "heightmap", "file": file})
            self.assertIn("/terrain/file", self.run_windloom(BAD_INPUT, "validate", self.project).stderr)

    def test_the_wind_does_not_depend_on_the_ground(self):
        sample = ["sample", self.project, "--at", "3,4", "--time", "0.5", "--backend", "cpu", "--json"]
        on_hills = json.loads(self.run_windloom(DONE, *sample).stdout)["samples"]
        self.write({"kind": "flat"})
        self.assertEqual(json.loads(self.run_windloom(DONE, *sample).stdout)["samples"], on_hills)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--windloom", required=True)
    options, rest = parser.parse_known_args()
    windloom = options.windloom
    unittest.main(argv=[sys.argv[0], *rest])
