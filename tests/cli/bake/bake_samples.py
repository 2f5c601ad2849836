"""Every sample project, baked for every engine and read back by readers that share no code with the writers."""
import json
import pathlib

import numpy

import harness
from read_dds import read_dds
from read_exr import read_exr
from read_gltf import strict
from read_ktx2 import read_ktx2
from read_png16 import read_png16
from read_volumes import read_fga, read_vf

PRESETS = ("generic", "unreal", "unity", "unity-negz", "godot")
FORMATS = "npy,exr,png,png16,dds,ktx2,fga,vf,godot-slab,windpack"
SAMPLES = sorted((pathlib.Path(__file__).parents[3] / "projects").glob("*/*.wind.json"))
GRID = (40, 32)


def image_of(wind, preset):
    """Frames of our own frame (rows z ascending, m/s) as the preset's image: formats.md, table of axes."""
    if preset == "unity":
        return wind[:, ::-1, ::-1] * [-1, 1]
    return wind * {"unreal": [100, 100], "unity-negz": [1, -1]}.get(preset, [1, 1])


class BakedSamples(harness.Case):
    def check(self, sample, preset):
        out = self.folder / f"{sample.parent.name}-{preset}"
        self.call("bake", sample, "--backend", "cpu", "--out", out, "--format", FORMATS, "--preset", preset, "--from", 0.05,
                  "--seconds", 0.2, "--fps", 10, "--resolution", "x".join(map(str, GRID)), "--graph", "--layers", 3)
        manifest = json.loads((out / "manifest.json").read_text())
        for entry in manifest["files"]:
            self.assertEqual(harness.sha256(out / entry["path"]), entry["sha256"], entry["path"])
        project = json.loads(sample.read_text())
        size = project["field"]["size"]
        wind = numpy.load(out / "wind.npy")
        self.assertEqual(wind.shape, (2, GRID[1], GRID[0], 2))
        self.assertTrue(numpy.isfinite(wind).all())
        image = image_of(wind.astype(float), preset)
        full = manifest["vmax"]
        unit = 100 if preset == "unreal" else 1
        numpy.testing.assert_allclose(numpy.subtract(manifest["bounds"]["max"], manifest["bounds"]["min"]),
                                      numpy.multiply(size, unit), rtol=1e-5)
        half = {"rtol": 2e-3, "atol": 1e-3}
        numpy.testing.assert_allclose(read_dds(out / "wind.dds")[1].astype(float), image, **half)
        numpy.testing.assert_allclose(read_ktx2(out / "wind.ktx2")[2].astype(float), image, **half)
        _, halves = harness.read_windpack(out / "wind.windpack")
        numpy.testing.assert_allclose(halves.astype(float), wind, **half)
        for n in range(2):
            channels = read_exr(out / f"wind.{n:04}.exr")[1]
            picture = numpy.stack([channels["R"], channels["G"]], axis=-1)
            numpy.testing.assert_allclose(picture.astype(float), image[n], **half)
            codes = harness.read_png(out / f"flow.{n:04}.png")
            numpy.testing.assert_allclose((codes[..., :2] - 128) / 127 * full, image[n], atol=full / 253)
            codes = read_png16(out / f"flow16.{n:04}.png")
            numpy.testing.assert_allclose((codes[..., :2].astype(float) - 32768) / 32767 * full, image[n],
                                          atol=full / 65534 * 1.01)  # half a code and the rounding of floats
            self.check_volumes(out, n, wind[n])
        strict((out / "graph.gltf").read_text())

    def check_volumes(self, out, n, wind):
        """The share of the plane's wind is the same in all cells of a layer, and grows with height."""
        _, _, block = read_fga(out / f"wind.{n:04}.fga")
        self.assertEqual(block.shape, (3, GRID[1], GRID[0], 3))
        numpy.testing.assert_array_equal(block[..., 2], 0)  # nothing blows upwards (Unreal's z)
        _, unity = read_vf(out / f"wind.{n:04}.vf")
        self.assertEqual(unity.shape, (GRID[1], 3, GRID[0], 3))
        shares = [numpy.abs(layer).max() / 100 / max(numpy.abs(wind).max(), 1e-9) for layer in block]
        if numpy.abs(wind).max() > 0.1:
            self.assertEqual(shares, sorted(shares))
            for share, layer in zip(shares, block):
                numpy.testing.assert_allclose(layer[..., :2] / 100, wind * share, atol=2e-3 * numpy.abs(wind).max())

    def test_samples_arrive_in_every_engine(self):
        self.assertGreaterEqual(len(SAMPLES), 13)
        for sample in SAMPLES:
            for preset in PRESETS:
                with self.subTest(sample=sample.parent.name, preset=preset):
                    self.check(sample, preset)


harness.main()
