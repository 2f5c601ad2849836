"""Images and textures of `windloom bake`, read by readers that share no code with it, in every preset and space."""
import json
import resource
import shutil
import signal
import subprocess
import unittest

import numpy

import harness
from harness import CELLS, HIGH, LOW
from read_bc5 import block_ranges
from read_dds import read_dds
from read_exr import read_exr
from read_ktx2 import read_ktx2
from read_png16 import read_png16

FORMATS = "npy,exr,png16,atlas,dds,dds-rgba,dds-bc5,dds-volume,ktx2,ktx2-rgba,ktx2-bc5,ktx2-zstd"
PRESETS = ("generic", "godot", "unreal", "unity", "unity-negz")
SIZE = (HIGH[0] - LOW[0], HIGH[1] - LOW[1])


def image_of(wind, preset, space):
    """Frames of our own frame ([..., z ascending, x ascending, 2], m/s) as the preset's image, from formats.md."""
    signs = {"unity": (-1, 1), "unity-negz": (1, -1)}.get(preset, (1, 1))
    image = wind.astype(float) * signs
    if preset == "unity":
        image = image[..., ::-1, :]  # columns follow -x
    if preset == "unity":
        image = image[..., ::-1, :, :]  # the top row is at the greatest z; for negz at the greatest -z, our first row
    if space == "uv":
        return image / SIZE  # u runs with the columns, v with the second axis in all of them
    return image * (100 if preset == "unreal" else 1)


def lengths_of(image):
    return numpy.hypot(image[..., 0], image[..., 1])


class BakedImages(harness.Case):
    def assert_halves(self, found, expected, what):
        self.assertEqual(found.dtype, numpy.dtype("<f2"), what)
        # Half a step of the 11 bits, and of the smallest halves; a little for the single floats before.
        bound = numpy.abs(expected) * (2.0**-11 + 2.0**-21) + 2.0**-25
        self.assertTrue((numpy.abs(found.astype(float) - expected) <= bound).all(), what)

    def assert_codes(self, codes, image, full_scale, what):
        """BC5: codes 0 to 255 around 128; a block's range lies in seven steps, its ends are exact."""
        exact = numpy.rint(image / full_scale * 127) + 128
        for layer in range(len(codes)):
            bound = block_ranges(exact[layer]) / 14 + 1.01
            self.assertTrue((numpy.abs(codes[layer] - exact[layer]) <= bound).all(), what)
        self.assertLess(numpy.abs(codes - exact).mean(), 1.0, what)

    def check_textures(self, out, image, full_scale, track=""):
        frames, height, width = image.shape[:3]
        rgba = numpy.concatenate([image, lengths_of(image)[..., None], numpy.ones(image.shape[:3] + (1,))], axis=3)
        expected = {"": (image, 34, 83), "-rgba": (rgba, 10, 97), "-volume": (image, 34, None),
                    "-zstd": (image, None, 83), "-bc5": (None, 83, 141)}
        for suffix, (texels, dxgi, vulkan) in expected.items():
            name = track + ("flow" if suffix == "-bc5" else "wind") + suffix
            if dxgi:
                facts, found = read_dds(out / f"{name}.dds")
                self.assertEqual(facts, {"dxgi": dxgi, "volume": suffix == "-volume", "slices": frames,
                                         "size": (width, height)})
                self.check_texels(found, texels, image, full_scale, suffix)
            if vulkan:
                facts, texts, found = read_ktx2(out / f"{name}.ktx2")
                self.assertEqual(facts, {"format": vulkan, "layers": frames if frames > 1 else 0,
                                         "size": (width, height), "scheme": 2 if suffix == "-zstd" else 0})
                self.assertEqual(texts["KTXorientation"], "rd")
                self.assertRegex(texts["KTXwriter"], r"^Windloom \d")
                self.check_texels(found, texels, image, full_scale, suffix)
                if suffix == "-bc5":
                    self.assertAlmostEqual(float(texts["windloom.vmax"]), full_scale, delta=1e-6 * full_scale)

    def check_texels(self, found, texels, image, full_scale, what):
        if texels is None:
            self.assert_codes(found, image, full_scale, what)
        else:
            self.assert_halves(found, texels, what)

    def check_pictures(self, out, image, full_scale, manifest):
        parts = image / full_scale
        lengths = lengths_of(parts)
        for frame in range(len(image)):
            codes = read_png16(out / f"flow16.{frame:04}.png")
            numpy.testing.assert_allclose((codes[..., :2] - 32768) / 32767, parts[frame], atol=0.51 / 32767)
            numpy.testing.assert_allclose(codes[..., 2] / 65535, lengths[frame], atol=0.51 / 65535)
            self.assertTrue((codes[..., 3] == 65535).all())
        entry = self.entry(manifest, "flow-atlas.png")
        across, down = entry["tiles"]
        height, width = image.shape[1:3]
        atlas = harness.read_png(out / "flow-atlas.png")
        self.assertEqual(atlas.shape, (down * height, across * width, 4))
        for tile in range(across * down):
            y, x = tile // across * height, tile % across * width
            codes = atlas[y:y + height, x:x + width]
            if tile >= len(image):
                self.assertTrue((codes == [128, 128, 0, 255]).all(), "a tile without a frame holds still air")
                continue
            numpy.testing.assert_allclose((codes[..., :2] - 128) / 127, parts[tile], atol=0.51 / 127)
            numpy.testing.assert_allclose(codes[..., 2] / 255, lengths[tile], atol=0.51 / 255)
            self.assertTrue((codes[..., 3] == 255).all())

    def check_exr(self, out, image, preset, space, frame):
        attributes, picture = read_exr(out / f"wind.{frame:04}.exr")
        self.assertEqual(list(picture), ["B", "G", "R"])
        self.assertEqual(attributes["compression"], 3)
        self.assertEqual(attributes["dataWindow"], (0, 0, CELLS[0] - 1, CELLS[1] - 1))
        self.assert_halves(picture["R"], image[frame, ..., 0], "R")
        self.assert_halves(picture["G"], image[frame, ..., 1], "G")
        self.assert_halves(picture["B"], lengths_of(image[frame]), "B")
        low, high = list(LOW), list(HIGH)
        for axis in ([0] if preset == "unity" else [1] if preset == "unity-negz" else []):
            low[axis], high[axis] = -HIGH[axis], -LOW[axis]
        scale = 100 if preset == "unreal" else 1
        self.assertEqual([float(word) for word in attributes["bounds"].split()], [scale * v for v in low + high])
        self.assertEqual(attributes["lengthUnit"], "cm" if preset == "unreal" else "m")
        unit = "uv/s" if space == "uv" else "cm/s" if preset == "unreal" else "m/s"
        axes = "u v" if space == "uv" else "x y" if preset == "unreal" else "x z"
        told = {name: attributes[name] for name in ("preset", "space", "unit", "axes", "frame", "frames", "fps", "loop",
                                                    "wrap", "track", "start")}
        self.assertEqual(told, {"preset": preset, "space": space, "unit": unit, "axes": axes, "frame": str(frame),
                                "frames": "3", "fps": "10", "loop": "no", "wrap": "none", "track": "wind",
                                "start": "0.3"})
        self.assertAlmostEqual(float(attributes["time"]), 0.3 + frame / 10, delta=1e-9)
        longest = lengths_of(image[frame]).max()
        self.assertAlmostEqual(float(attributes["vmax"]), longest, delta=1e-5 * longest)

    @staticmethod
    def entry(manifest, path):
        return next(entry for entry in manifest["files"] if entry["path"] == path)

    def test_every_format_holds_the_array_in_each_presets_frame_and_space(self):
        for preset in PRESETS:
            for space in ("world", "uv"):
                with self.subTest(preset=preset, space=space):
                    out = self.bake("--from", 0.3, "--seconds", 0.3, "--fps", 10, "--preset", preset, "--space", space,
                                    out=f"{preset}-{space}", formats=FORMATS)
                    manifest = json.loads((out / "manifest.json").read_text())
                    image = image_of(numpy.load(out / "wind.npy"), preset, space)
                    self.assertGreater(numpy.abs(image[2] - image[0]).max(), 0.05 * numpy.abs(image).max())
                    full_scale = self.entry(manifest, "flow-bc5.dds")["full_scale"]
                    self.assertGreaterEqual(full_scale, lengths_of(image).max() * (1 - 1e-6))
                    for frame in range(3):
                        self.check_exr(out, image, preset, space, frame)
                    self.check_pictures(out, image, full_scale, manifest)
                    self.check_textures(out, image, full_scale)

    def test_the_manifest_says_what_each_file_holds(self):
        out = self.bake("--seconds", 0.4, "--fps", 10, "--preset", "unreal", formats=FORMATS)
        manifest = json.loads((out / "manifest.json").read_text())
        for path, encoding, details in (
                ("wind.0003.exr", "half", {"frame": 3, "channels": "RGB", "units": "cm/s"}),
                ("flow16.0001.png", "unorm16", {"frame": 1, "units": "cm/s"}),
                ("flow-atlas.png", "unorm8", {"layout": "atlas", "frames": 4, "tiles": [2, 2]}),
                ("wind.dds", "half", {"layout": "array", "frames": 4, "channels": "RG", "units": "cm/s"}),
                ("wind-rgba.dds", "half", {"layout": "array", "channels": "RGBA"}),
                ("flow-bc5.dds", "bc5", {"layout": "array", "channels": "RG"}),
                ("wind-volume.dds", "half", {"layout": "volume", "frames": 4}),
                ("wind.ktx2", "half", {"layout": "array", "frames": 4}),
                ("wind-zstd.ktx2", "half", {"layout": "array"})):
            entry = self.entry(manifest, path)
            self.assertEqual((entry["role"], entry["encoding"], entry["sha256"]),
                             ("flow", encoding, harness.sha256(out / path)))
            self.assertEqual({key: entry[key] for key in details}, details, path)

    def test_plants_answers_are_written_as_images_of_their_own(self):
        out = self.bake("--seconds", 0.3, "--fps", 10, "--response", "--preset", "unity",
                        formats="npy,exr,png16,atlas,dds,dds-rgba,dds-bc5,dds-volume,ktx2,ktx2-rgba,ktx2-bc5,ktx2-zstd")
        manifest = json.loads((out / "manifest.json").read_text())
        tracks = [entry["track"] for entry in manifest["response"]["classes"]]
        self.assertEqual(len(tracks), 4)
        for track in tracks:
            with self.subTest(track=track):
                bend = numpy.load(out / f"{track}-wind.npy")
                self.assertGreater(numpy.abs(bend).max(), 0.001)
                image = image_of(bend, "unity", "world")
                self.check_textures(out, image, 1.5, f"{track}-")
                attributes, picture = read_exr(out / f"{track}-wind.0002.exr")
                self.assert_halves(picture["R"], image[2, ..., 0], track)
                self.assert_halves(picture["G"], image[2, ..., 1], track)
                self.assertEqual((attributes["unit"], attributes["track"]), ("rad", track))
                codes = read_png16(out / f"{track}-flow16.0002.png")
                numpy.testing.assert_allclose((codes[..., :2] - 32768) / 32767 * 1.5, image[2], atol=0.51 / 32767 * 1.5)

    def test_one_frame_of_any_size_is_a_plain_texture(self):
        for columns, rows in ((1, 1), (3, 2), (5, 30), (17, 9)):
            with self.subTest(columns=columns, rows=rows):
                out = self.bake("--seconds", 0.1, "--fps", 10, "--resolution", f"{columns}x{rows}",
                                out=f"{columns}x{rows}", formats=FORMATS)
                manifest = json.loads((out / "manifest.json").read_text())
                image = numpy.load(out / "wind.npy").astype(float)
                self.assertEqual(image.shape, (1, rows, columns, 2))
                full_scale = self.entry(manifest, "flow-bc5.dds")["full_scale"]
                self.check_textures(out, image, full_scale)
                self.check_pictures(out, image, full_scale, manifest)
                picture = read_exr(out / "wind.0000.exr")[1]
                self.assert_halves(picture["R"], image[0, ..., 0], "R")

    def test_a_chosen_scale_shortens_longer_vectors_without_turning_them(self):
        out = self.bake("--from", 0.5, "--seconds", 0.1, "--fps", 10, "--vmax", 3, formats="npy,png16,dds-bc5,dds")
        wind = numpy.load(out / "wind.npy").astype(float)
        lengths = lengths_of(wind)
        self.assertGreater(lengths.max(), 4)
        cut = wind * numpy.minimum(1, 3 / lengths)[..., None]
        codes = read_png16(out / "flow16.0000.png")
        numpy.testing.assert_allclose((codes[..., :2] - 32768) / 32767 * 3, cut[0], atol=0.51 / 32767 * 3)
        self.assert_codes(read_dds(out / "flow-bc5.dds")[1], cut, 3, "bc5")
        self.assert_halves(read_dds(out / "wind.dds")[1], wind, "halves have no scale")

    def test_parts_of_a_recording_have_the_bytes_of_the_whole(self):
        whole = self.bake("--seconds", 0.5, "--fps", 10, "--vmax", 12, out="whole", formats="exr,png16")
        for part in ("3-4", "0-2"):
            parts = self.bake("--seconds", 0.5, "--fps", 10, "--vmax", 12, "--frames", part, out="parts",
                              formats="exr,png16")
        for path in whole.iterdir():
            self.assertEqual(harness.sha256(path), harness.sha256(parts / path.name), path.name)
        message = self.call("bake", self.project, "--backend", "cpu", "--out", self.folder / "no", "--format", "dds",
                            "--frames", "0-1", status=2).stderr
        self.assertIn("numbered files", message)

    def test_the_same_bake_gives_the_same_bytes_for_any_number_of_threads(self):
        bakes = [self.bake("--seconds", 0.3, out=f"threads{n}", formats=FORMATS, env={"WINDLOOM_THREADS": str(n)})
                 for n in (1, 3)]
        for path in bakes[0].iterdir():
            self.assertEqual(harness.sha256(path), harness.sha256(bakes[1] / path.name), path.name)

    def test_says_at_once_what_a_format_cant_hold(self):
        for format_, frames, cells, limit in (("dds", 2049, "1x1", "2048 layers"), ("dds-bc5", 2049, "1x1", "2048 layers"),
                                              ("dds-rgba", 5000, "1x1", "2048 layers"),
                                              ("dds-volume", 2049, "1x1", "2048 slices"),
                                              ("dds-volume", 2, "2049x8", "2048 pixels"),
                                              ("atlas", 65, "2048x2048", "holds 64 frames")):
            with self.subTest(format=format_, cells=cells):
                done = self.call("bake", self.project, "--backend", "cpu", "--out", self.folder / "refused", "--format",
                                 format_, "--seconds", frames / 1000, "--fps", 1000, "--resolution", cells, status=1)
                self.assertIn(limit, done.stderr)
                self.assertIn(f"{format_}: ", done.stderr)
                self.assertNotIn("recording", done.stderr)
                self.assertFalse((self.folder / "refused").exists())
        done = self.call("bake", self.project, "--backend", "cpu", "--out", self.folder / "long", "--format", "ktx2",
                         "--seconds", 2.049, "--fps", 1000, "--resolution", "1x1")
        self.assertIn("2048 layers", done.stderr)
        self.assertEqual(read_ktx2(self.folder / "long" / "wind.ktx2")[0]["layers"], 2049)

    def test_a_full_disk_is_said_for_every_format_and_leaves_nothing(self):
        def disk_of_1_kb():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1024, 1024))
        for format_ in FORMATS.split(","):
            with self.subTest(format=format_):
                out = self.folder / format_
                done = self.call("bake", self.project, "--backend", "cpu", "--out", out, "--format", format_, "--seconds",
                                 0.1, "--fps", 20, status=3, preexec_fn=disk_of_1_kb)
                self.assertIn("can't write", done.stderr)
                self.assertFalse(out.exists(), "not even the folder that the bake made")

    def test_the_largest_array_and_volume_are_written(self):
        out = self.bake("--seconds", 2.048, "--fps", 1000, "--resolution", "3x2", formats="npy,dds,dds-volume,dds-bc5")
        wind = numpy.load(out / "wind.npy").astype(float)
        for name in ("wind.dds", "wind-volume.dds"):
            facts, found = read_dds(out / name)
            self.assertEqual(facts["slices"], 2048)
            self.assert_halves(found, wind, name)

    @unittest.skipUnless(shutil.which("exrmaketiled"), "needs the tools of OpenEXR")
    def test_the_tools_of_openexr_read_the_pictures(self):
        out = self.bake("--seconds", 0.2, "--fps", 10, formats="exr")
        told = subprocess.run(["exrheader", out / "wind.0001.exr"], capture_output=True, text=True, check=True).stdout
        self.assertIn("B, 16-bit floating-point, sampling 1 1\n    G, 16-bit floating-point", told)
        self.assertIn("zip, multi-scanline blocks", told)
        self.assertIn('unit (type string): "m/s"', told)
        # A copy that isn't packed, as one tile: its pixels are the file's last bytes.
        copy = self.folder / "tiled.exr"
        subprocess.run(["exrmaketiled", "-o", "-z", "none", "-t", "64", "64", out / "wind.0001.exr", copy], check=True,
                       capture_output=True)
        columns, rows = CELLS
        pixels = numpy.frombuffer(copy.read_bytes()[-6 * columns * rows:], "<f2").reshape(rows, 3, columns)
        picture = read_exr(out / "wind.0001.exr")[1]
        for i, name in enumerate("BGR"):
            numpy.testing.assert_array_equal(pixels[:, i], picture[name])


harness.main()
