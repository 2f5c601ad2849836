"""Reads what `windloom bake` writes with readers that share no code with it."""
import json
import pathlib
import subprocess

import jsonschema
import numpy

import harness
from harness import CELLS, HIGH, LOW, SAMPLE_PACK


class BakedFiles(harness.Case):
    def test_the_array_has_the_promised_shape_and_type(self):
        out = self.bake("--seconds", 0.5, "--fps", 10)
        wind = numpy.load(out / "wind.npy")
        self.assertEqual(wind.shape, (5, 30, 48, 2))
        self.assertEqual(wind.dtype, numpy.dtype("<f4"))
        self.assertTrue(numpy.isfinite(wind).all())
        self.assertGreater(numpy.abs(wind[4] - wind[0]).max(), 1.0)

    def test_the_manifest_describes_and_checks_every_file(self):
        out = self.bake("--seconds", 0.4, "--fps", 10, formats="npy,png,windpack")
        manifest = json.loads((out / "manifest.json").read_text())
        self.assertEqual(manifest["format"], "windpack")
        self.assertEqual(manifest["units"], "m/s")
        self.assertEqual(manifest["bounds"], {"min": list(LOW), "max": list(HIGH)})
        self.assertEqual(manifest["grid"], list(CELLS))
        numpy.testing.assert_allclose(manifest["cell"], [32 / 48, 20 / 30], rtol=1e-6)
        self.assertEqual({k: manifest["time"][k] for k in ("fps", "frames", "loop", "start")},
                         {"fps": 10, "frames": 4, "loop": False, "start": 0})
        self.assertEqual(manifest["frame"]["handedness"], "right")
        listed = {entry["path"]: entry["sha256"] for entry in manifest["files"]}
        self.assertEqual(sorted(listed), ["HOWTO.md", *(f"flow.000{n}.png" for n in range(4)), "wind.glsl", "wind.npy",
                                          "wind.windpack"])
        for path, digest in listed.items():
            self.assertEqual(harness.sha256(out / path), digest, path)
        self.assertEqual({p.name for p in out.iterdir()}, {*listed, "manifest.json"})

    def test_flow_maps_decode_to_the_array_in_each_presets_frame(self):
        for preset in ("generic", "godot", "unreal", "unity"):
            with self.subTest(preset=preset):
                out = self.bake("--from", 0.3, "--seconds", 0.2, "--fps", 10, "--preset", preset, out=preset,
                                formats="npy,png")
                manifest = json.loads((out / "manifest.json").read_text())
                wind = numpy.load(out / "wind.npy")
                scale = 100.0 if preset == "unreal" else 1.0
                expected = wind * scale
                low, high = numpy.array(LOW) * scale, numpy.array(HIGH) * scale
                if preset == "unity":
                    expected = (wind * [-1, 1])[:, ::-1, ::-1]
                    low[0], high[0] = -HIGH[0], -LOW[0]
                self.assertEqual(manifest["bounds"], {"min": list(low), "max": list(high)})
                self.assertEqual(manifest["rowOrder"], "descending" if preset == "unity" else "ascending")
                self.assertEqual(manifest["frame"]["handedness"], "right" if preset in ("generic", "godot") else "left")
                self.assertEqual(manifest["frame"]["up"], "+Z" if preset == "unreal" else "+Y")
                self.assertEqual(manifest["space"], "world")
                vmax = manifest["vmax"]
                speeds = numpy.hypot(*numpy.moveaxis(expected, 3, 0))
                self.assertGreaterEqual(vmax, speeds.max() * (1 - 1e-6))
                self.assertLess(vmax, speeds.max() + 0.0101 * scale)
                for frame in range(2):
                    codes = harness.read_png(out / f"flow.{frame:04}.png")
                    decoded = (codes[..., :2] - manifest["zero_code"]) / 127 * vmax
                    numpy.testing.assert_allclose(decoded, expected[frame], atol=vmax / 127 * 0.501)
                    numpy.testing.assert_allclose(codes[..., 2] / 255 * vmax, speeds[frame], atol=vmax / 255 * 0.501)
                    self.assertTrue((codes[..., 3] == 255).all())

    def test_a_chosen_scale_is_used_and_keeps_directions(self):
        out = self.bake("--from", 0.5, "--seconds", 0.1, "--fps", 10, "--vmax", 3, formats="npy,png")
        self.assertEqual(json.loads((out / "manifest.json").read_text())["vmax"], 3)
        wind = numpy.load(out / "wind.npy")[0]
        fastest = numpy.unravel_index(numpy.hypot(wind[..., 0], wind[..., 1]).argmax(), wind.shape[:2])
        self.assertGreater(numpy.hypot(*wind[fastest]), 4)
        code = harness.read_png(out / "flow.0000.png")[fastest][:2] - 128.0
        self.assertAlmostEqual(numpy.hypot(*code), 127, delta=1)
        self.assertAlmostEqual(numpy.arctan2(*code), numpy.arctan2(*wind[fastest]), delta=0.01)

    def test_the_pack_holds_the_array_as_halves_and_the_c_library_interpolates_it(self):
        out = self.bake("--seconds", 0.4, "--fps", 10, "--from", 0.1, formats="npy,windpack")
        wind = numpy.load(out / "wind.npy")
        header, halves = harness.read_windpack(out / "wind.windpack")
        numpy.testing.assert_array_equal(halves, wind.astype("<f2"))
        self.assertEqual(header["corners"], (*LOW, *HIGH))
        self.assertEqual((header["fps"], header["start"], header["flags"]), (10, 0.1, 0))
        stored = halves.astype(float)
        self.assertAlmostEqual(header["fastest"], numpy.hypot(stored[..., 0], stored[..., 1]).max(), delta=1e-5)
        places = [(-3.3, -3.1, 0.14), (7.77, 1.5, 0.299), (-100, 3, 0.05), (5, 50, 9), (12.1, 4.2, 0)]
        words = [str(number) for place in places for number in place]
        printed = subprocess.run([SAMPLE_PACK, out / "wind.windpack", *words], capture_output=True, text=True,
                                 check=True).stdout.splitlines()
        self.assertEqual(len(printed), len(places))
        for (x, z, time), line in zip(places, printed):
            found = [float(word) for word in line.split()]
            numpy.testing.assert_allclose(found, interpolate(halves, x, z, time * 10), atol=2e-5)

    def test_a_loop_has_no_jump_at_its_seam(self):
        plain = numpy.load(self.bake("--seconds", 1.0, "--fps", 20, out="plain") / "wind.npy")
        out = self.bake("--seconds", 0.8, "--fps", 20, "--loop", out="loop", formats="npy,windpack")
        loop = numpy.load(out / "wind.npy")
        self.assertEqual(loop.shape[0], 16)
        blended = json.loads((out / "manifest.json").read_text())["time"]
        self.assertEqual((blended["loop"], blended["crossfade"]), (True, 4))
        for n in range(16):
            weight = min(n / 4, 1.0)
            expected = plain[n] if n >= 4 else plain[16 + n] * (1 - weight) + plain[n] * weight
            numpy.testing.assert_allclose(loop[n], expected, atol=1e-5)
        self.assertEqual(harness.read_windpack(out / "wind.windpack")[0]["flags"], 1)
        steps = [numpy.hypot(*numpy.moveaxis(loop[n] - loop[n - 1], -1, 0)).max() for n in range(16)]
        seam = json.loads((out / "manifest.json").read_text())["time"]["seam"]
        self.assertAlmostEqual(seam["change"], steps[0], delta=1e-4)
        self.assertAlmostEqual(seam["largestStep"], max(steps[1:]), delta=1e-4)
        self.assertLess(steps[0], max(steps[1:]))

    def test_a_lower_resolution_keeps_the_mean(self):
        full = numpy.load(self.bake("--seconds", 0.3, "--fps", 10, out="full") / "wind.npy")
        out = self.bake("--seconds", 0.3, "--fps", 10, "--resolution", "17x9", out="small", formats="npy,png")
        small = numpy.load(out / "wind.npy")
        self.assertEqual(small.shape, (3, 9, 17, 2))
        numpy.testing.assert_allclose(small.mean(axis=(1, 2)), full.mean(axis=(1, 2)), atol=1e-5)
        self.assertEqual(harness.read_png(out / "flow.0002.png").shape, (9, 17, 4))

    def test_ranges_baked_at_the_same_time_are_the_whole_bake(self):
        args = ("--seconds", 0.8, "--fps", 10, "--from", 0.1, "--loop", "--vmax", 12, "--response", "--graph")
        whole = self.bake(*args, out="whole", formats="png")
        parted = self.folder / "parted"
        command = [harness.WINDLOOM, "bake", self.project, "--backend", "cpu", "--out", parted, "--format", "png",
                   *map(str, args)]
        ranges = ("4-5", "0", "6-7", "1-3")
        children = [subprocess.Popen([*command, "--frames", part], stdout=subprocess.PIPE, text=True)
                    for part in ranges]
        words = [child.communicate(timeout=120 * harness.PATIENCE)[0] for child in children]
        self.assertEqual([child.returncode for child in children], [0, 0, 0, 0])
        self.assertEqual(sum("still missing" in text for text in words), 3)
        self.assertEqual({path.name for path in parted.iterdir()}, {path.name for path in whole.iterdir()})
        for path in whole.iterdir():
            self.assertEqual(harness.sha256(path), harness.sha256(parted / path.name), path.name)

    def test_a_warm_up_is_the_wind_of_a_later_start(self):
        late = numpy.load(self.bake("--from", 2, "--warm-up", 0.5, "--seconds", 0.1, "--fps", 10, out="late") / "wind.npy")
        early = numpy.load(self.bake("--from", 2, "--seconds", 0.1, "--fps", 10, out="early") / "wind.npy")
        self.assertGreater(numpy.abs(late - early).max(), 0.05, "what blew before is left out")
        full = numpy.load(self.bake("--from", 2, "--warm-up", 2, "--seconds", 0.1, "--fps", 10, out="full") / "wind.npy")
        numpy.testing.assert_array_equal(full, early)
        done = self.call("bake", self.project, "--out", self.folder / "no", "--format", "npy", "--from", 1, "--warm-up", 2,
                         status=2)
        self.assertIn("--from 2", done.stderr)

    def test_uv_flow_counts_texture_coordinates(self):
        for preset, columns, rows, signs in (("generic", 1, 1, (1, 1)), ("unreal", 1, 1, (1, 1)),
                                             ("unity", -1, -1, (-1, 1)), ("unity-negz", 1, 1, (1, -1))):
            with self.subTest(preset=preset):
                out = self.bake("--from", 0.3, "--seconds", 0.1, "--fps", 10, "--preset", preset, "--space", "uv",
                                out=preset, formats="npy,png")
                manifest = json.loads((out / "manifest.json").read_text())
                self.assertEqual((manifest["space"], manifest["units"]), ("uv", "uv/s"))
                wind = numpy.load(out / "wind.npy")[0]
                expected = (wind * signs / (HIGH[0] - LOW[0], HIGH[1] - LOW[1]))[::rows, ::columns]
                codes = harness.read_png(out / "flow.0000.png")
                numpy.testing.assert_allclose((codes[..., :2] - 128) / 127 * manifest["vmax"], expected,
                                              atol=manifest["vmax"] / 127 * 0.501)

    def test_every_manifest_keeps_to_its_schema(self):
        schema = json.loads((pathlib.Path(__file__).parents[3] / "docs" / "manifest.schema.json").read_text())
        jsonschema.Draft202012Validator.check_schema(schema)
        formats = self.formats()
        for preset in ("generic", "unreal", "unity", "unity-negz", "godot"):
            with self.subTest(preset=preset):
                out = self.bake("--from", 0.2, "--seconds", 0.4, "--fps", 10, "--preset", preset, "--response", "--graph",
                                "--loop", out=preset, formats=",".join(formats))
                manifest = json.loads((out / "manifest.json").read_text())
                jsonschema.Draft202012Validator(schema).validate(manifest)
                for entry in manifest["files"]:
                    self.assertEqual(harness.sha256(out / entry["path"]), entry["sha256"], entry["path"])
                self.assertEqual({path.name for path in out.iterdir()},
                                 {"manifest.json", *(entry["path"] for entry in manifest["files"])})

    def formats(self):
        """All formats that this build can write."""
        words = self.call("bake", "--list-formats", "--json").stdout
        return [entry["name"] for entry in json.loads(words)["formats"] if not entry["missing"]]

    def test_the_same_bake_gives_the_same_bytes_for_any_number_of_threads(self):
        formats = ",".join(self.formats())
        one = self.bake("--seconds", 0.2, "--threads", 1, out="one", formats=formats)
        two = self.bake("--seconds", 0.2, "--threads", 2, out="two", formats=formats)
        for path in one.iterdir():
            self.assertEqual(harness.sha256(path), harness.sha256(two / path.name), path.name)


def interpolate(wind, x, z, frame):
    """Linear in each axis, clamped: the definition, one axis after the other."""
    wind = wind.astype(float)
    for axis, at in ((0, frame), (0, (z - LOW[1]) * 30 / 20 - 0.5), (0, (x - LOW[0]) * 48 / 32 - 0.5)):
        at = min(max(at, 0), wind.shape[axis] - 1)
        low = min(int(at), wind.shape[axis] - 1)
        high = min(low + 1, wind.shape[axis] - 1)
        wind = wind[low] * (1 - (at - low)) + wind[high] * (at - low)
    return wind


harness.main()
