"""The three kinds of wind packs, read by a reader of their own and by the C library.

usage: wind_packs.py WINDLOOM SAMPLE_PACK
"""
import json
import subprocess

import harness
import numpy
from harness import CELLS, HIGH, LOW, SAMPLE_PACK
from read_windpack import FLOATS, LOOP, ZSTD, read_windpack

PACKS = {"windpack": ("wind.windpack", 0), "windpack-f32": ("wind-f32.windpack", FLOATS),
         "windpack-zstd": ("wind-zstd.windpack", ZSTD)}


class WindPacks(harness.Case):
    def test_each_kind_holds_the_array(self):
        out = self.bake("--seconds", 0.4, "--fps", 10, "--from", 0.1, formats="npy," + ",".join(PACKS))
        wind = numpy.load(out / "wind.npy")
        plain = 96 + wind.size * 2 + 4
        sizes = {}
        for kind, (name, flags) in PACKS.items():
            with self.subTest(kind=kind):
                header, cells = read_windpack(out / name)
                sizes[kind] = (out / name).stat().st_size
                self.assertEqual((header["version"], header["flags"], header["quantity"]), (2, flags, 0))
                self.assertEqual(header["corners"], (*LOW, *HIGH))
                stored = cells.astype(float)  # no cell of the pack is faster
                self.assertAlmostEqual(header["fastest"], numpy.hypot(stored[..., 0], stored[..., 1]).max(), delta=1e-5)
                self.assertEqual((header["fps"], header["start"]), (10, 0.1))
                self.assertEqual((header["reference"], numpy.float32(header["roughness"])), (2, numpy.float32(0.03)))
                expected = wind if flags & FLOATS else wind.astype("<f2")
                numpy.testing.assert_array_equal(cells, expected)
        self.assertEqual(sizes["windpack"], plain)
        self.assertEqual(sizes["windpack-f32"], plain + wind.size * 2)
        self.assertLess(sizes["windpack-zstd"], plain)

    def test_the_c_library_reads_each_kind_the_same_way(self):
        out = self.bake("--seconds", 0.4, "--fps", 10, "--loop", formats=",".join(PACKS))
        places = ["-3.3", "-3.1", "0.14", "7.77", "1.5", "0.399", "-100", "3", "-0.05", "12.1", "4.2", "77.7"]
        printed = {}
        for kind, (name, flags) in PACKS.items():
            self.assertEqual(read_windpack(out / name)[0]["flags"], flags | LOOP)
            done = subprocess.run([SAMPLE_PACK, out / name, *places], capture_output=True, text=True, check=True)
            printed[kind] = [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
        self.assertEqual(printed["windpack"], printed["windpack-zstd"])
        numpy.testing.assert_allclose(printed["windpack"], printed["windpack-f32"], atol=6e-3)
        self.assertNotEqual(printed["windpack"], printed["windpack-f32"])

    def test_the_manifest_names_encoding_and_compression(self):
        out = self.bake("--seconds", 0.1, "--fps", 10, formats=",".join(PACKS))
        entries = {entry["path"]: entry for entry in json.loads((out / "manifest.json").read_text())["files"]}
        for kind, (name, flags) in PACKS.items():
            self.assertEqual(entries[name]["encoding"], "float32" if flags & FLOATS else "half")
            self.assertEqual(entries[name].get("compression"), "zstd" if flags & ZSTD else None)
            self.assertEqual(entries[name]["version"], 2)

    def test_the_profile_is_the_one_that_was_asked_for(self):
        out = self.bake("--seconds", 0.1, "--fps", 10, "--reference-height", 3, "--roughness", 0.25, formats="windpack")
        header = read_windpack(out / "wind.windpack")[0]
        self.assertEqual((header["reference"], header["roughness"]), (3, 0.25))

    def test_the_same_wind_gives_the_same_bytes(self):
        first = self.bake("--seconds", 0.3, "--threads", 1, out="first", formats=",".join(PACKS), env={"WINDLOOM_THREADS": "1"})
        second = self.bake("--seconds", 0.3, "--threads", 2, out="second", formats=",".join(PACKS), env={"WINDLOOM_THREADS": "3"})
        for name, _ in PACKS.values():
            self.assertEqual(harness.sha256(first / name), harness.sha256(second / name), name)

    def test_a_response_has_packs_of_its_own(self):
        out = self.bake("--seconds", 0.2, "--fps", 10, "--response", formats="windpack")
        bends = sorted(out.glob("bend-*-wind.windpack"))
        self.assertEqual(len(bends), 4, [path.name for path in out.iterdir()])
        for path in bends:
            header, cells = read_windpack(path)
            self.assertEqual((header["quantity"], header["roughness"]), (1, 0))
            self.assertEqual(cells.shape, (2, CELLS[1], CELLS[0], 2))


harness.main()
