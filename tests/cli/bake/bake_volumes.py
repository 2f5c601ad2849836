"""Volumes that `windloom bake` writes, read with readers that share no code with it; the array in our own frame is what
they must agree with."""
import json
import subprocess
import unittest

import numpy

import harness
from harness import HIGH, LOW
from read_volumes import read_fga, read_slab, read_vdb, read_vf, vdb_header

try:
    import pyopenvdb as openvdb
except ImportError:
    openvdb = None

PRESETS = ("generic", "godot", "unreal", "unity", "unity-negz")
CODED_FULLY = 0.5 / 255 * 2 * 1.001  # of the strength


def layer_factors(layers=8, top=8.0, reference=2.0, roughness=0.03):
    """Of each layer, from the ground up: the logarithmic law in the layer's middle."""
    if layers == 1:
        return numpy.ones(1)
    heights = (numpy.arange(layers) + 0.5) * top / layers
    return numpy.log1p(heights / roughness) / numpy.log1p(reference / roughness)


def block_of(field, frame, factors):
    """Our field [k, i, 2] as [z, y, x, 3] of a frame, and its (low, high) corner."""
    flat = factors[:, None, None, None] * field[None]  # [layer, k, i, 2]
    zero = numpy.zeros(flat.shape[:3])
    vx, vz = flat[..., 0], flat[..., 1]
    if frame == "unreal":  # left-handed, +Z up, cm: (x, z, y)
        return 100 * numpy.stack([vx, vz, zero], -1)
    block = numpy.stack([vx, zero, vz], -1).transpose(1, 0, 2, 3)  # [k, layer, i]
    if frame == "unity":
        block = block[:, :, ::-1] * [-1, 1, 1]
    elif frame == "unity-negz":
        block = block[::-1] * [1, 1, -1]
    return block


def corners_of(frame, low_height, high_height, low=LOW, high=HIGH):
    if frame == "unreal":
        return 100 * numpy.array([*low, low_height]), 100 * numpy.array([*high, high_height])
    (x0, z0), (x1, z1) = low, high
    if frame == "unity":
        x0, x1 = -x1, -x0
    elif frame == "unity-negz":
        z0, z1 = -z1, -z0
    return numpy.array([x0, low_height, z0]), numpy.array([x1, high_height, z1])


def averaging(cells, fewer):
    """The matrix that averages over an area: how much of each old cell lies under each new one."""
    edges = numpy.arange(fewer + 1) * cells / fewer
    matrix = numpy.zeros((fewer, cells))
    for n in range(fewer):
        for i in range(cells):
            matrix[n, i] = max(0.0, min(edges[n + 1], i + 1) - max(edges[n], i)) / (edges[n + 1] - edges[n])
    return matrix


def averaged(field, width, height):
    rows, columns = averaging(field.shape[0], height), averaging(field.shape[1], width)
    return numpy.einsum("nk,mi,kic->nmc", rows, columns, field)


class VolumeCase(harness.Case):
    def baked(self, formats, *args, preset="generic", out=None, frames=2):
        """(folder, our array [frame, k, i, 2], manifest entries by path)."""
        folder = self.bake("--from", 0.3, "--seconds", frames / 10, "--fps", 10, "--preset", preset, *args,
                           "--no-sidecars", out=out or preset, formats="npy," + formats)
        entries = {entry["path"]: entry for entry in json.loads((folder / "manifest.json").read_text())["files"]}
        self.assertEqual({p.name for p in folder.iterdir()}, {*entries, "manifest.json"})
        return folder, numpy.load(folder / "wind.npy").astype(float), entries

    def check_entry(self, entry, frame, target, corners, shape, units):
        """What the manifest says beside a file; shape is [z, y, x]."""
        self.assertEqual((entry["role"], entry["frame"], entry["units"]), ("volume", frame, units))
        self.assertEqual(entry["grid"], list(shape[::-1]))
        self.assertEqual(entry["coordinates"]["up"], "+Z" if target == "unreal" else "+Y")
        self.assertEqual(entry["coordinates"]["handedness"], "right" if target in ("generic", "godot") else "left")
        self.assertEqual(entry["lengthUnit"], "cm" if target == "unreal" else "m")
        numpy.testing.assert_allclose(entry["bounds"]["min"], corners[0], atol=1e-3)
        numpy.testing.assert_allclose(entry["bounds"]["max"], corners[1], atol=1e-3)


class Volumes(VolumeCase):
    def test_fga_is_in_unreals_frame_whatever_the_preset(self):
        for preset in PRESETS:
            with self.subTest(preset=preset):
                out, wind, entries = self.baked("fga", preset=preset)
                for frame in range(2):
                    low, high, vectors = read_fga(out / f"wind.{frame:04}.fga")
                    corners = corners_of("unreal", 0, 8)
                    numpy.testing.assert_allclose([low, high], corners, atol=1e-3)
                    expected = block_of(wind[frame], "unreal", layer_factors())
                    self.assertEqual(vectors.shape, (8, 30, 48, 3))
                    numpy.testing.assert_allclose(vectors, expected, atol=5e-5 + 1e-6 * numpy.abs(expected).max())
                    self.check_entry(entries[f"wind.{frame:04}.fga"], frame, "unreal", corners, vectors.shape[:3],
                                     "cm/s")

    def test_fga_counts_x_first(self):
        out, wind, _ = self.baked("fga", frames=1)
        numbers = [float(token) for token in (out / "wind.0000.fga").read_text().split(",")]
        rng = numpy.random.default_rng(1)
        factors = layer_factors()
        for _ in range(50):
            i, k, layer = rng.integers(48), rng.integers(30), rng.integers(8)
            at = 9 + 3 * (i + 48 * (k + 30 * layer))
            vx, vz = 100 * factors[layer] * wind[0, k, i]
            numpy.testing.assert_allclose(numbers[at:at + 3], [vx, vz, 0], atol=2e-3)

    def test_fga_averages_a_grid_that_unreal_refuses_and_says_so(self):
        done = self.call("bake", self.project, "--backend", "cpu", "--out", self.folder / "big", "--format", "npy,fga",
                         "--resolution", "300x150", "--from", 0.3, "--seconds", 0.1, "--fps", 10, "--layers", 3,
                         "--top", 6, "--roughness", 0.1)
        self.assertIn("300 x 150 cells are averaged down to 128 x 64", done.stderr)
        wind = numpy.load(self.folder / "big" / "wind.npy")[0].astype(float)
        low, high, vectors = read_fga(self.folder / "big" / "wind.0000.fga")
        numpy.testing.assert_allclose([low, high], corners_of("unreal", 0, 6), atol=1e-3)
        expected = block_of(averaged(wind, 128, 64), "unreal", layer_factors(3, 6.0, 2.0, 0.1))
        numpy.testing.assert_allclose(vectors, expected, atol=5e-3)

    def test_fga_tiles_cover_the_field_without_gaps(self):
        out, wind, entries = self.baked("fga-tiles", "--resolution", "290x140", "--layers", 2, frames=1)
        corners = corners_of("unreal", 0, 8)
        side = (corners[1] - corners[0])[:2] / [290, 140]
        expected = block_of(wind[0], "unreal", layer_factors(2))
        widths, found = [96, 97, 97], numpy.full(expected.shape, numpy.nan)
        for y in range(2):
            at = 0
            for x in range(3):
                name = f"wind_t{x}_t{y}.0000.fga"
                low, high, vectors = read_fga(out / name)
                self.assertEqual(vectors.shape[:3], (2, 70, widths[x]))
                numpy.testing.assert_allclose(low[:2], corners[0][:2] + side * [at, 70 * y], atol=1e-2)
                numpy.testing.assert_allclose(high[:2], low[:2] + side * [widths[x], 70], atol=1e-2)
                numpy.testing.assert_allclose([low[2], high[2]], [0, 800])
                found[:, 70 * y:70 * y + 70, at:at + widths[x]] = vectors
                self.check_entry(entries[name], 0, "unreal", (low, high), vectors.shape[:3], "cm/s")
                self.assertEqual(entries[name]["tile"], [x, y])
                at += widths[x]
        numpy.testing.assert_allclose(found, expected, atol=2e-3)
        self.assertEqual(sum(name.endswith(".fga") for name in entries), 6)

    def test_one_layer_is_flat_around_the_reference_height(self):
        out, wind, _ = self.baked("fga,vf", "--layers", 1, "--reference-height", 1.5, frames=1)
        low, high, vectors = read_fga(out / "wind.0000.fga")
        numpy.testing.assert_allclose([low, high], corners_of("unreal", 0, 3), atol=1e-3)
        numpy.testing.assert_allclose(vectors, block_of(wind[0], "unreal", numpy.ones(1)), atol=2e-3)
        numpy.testing.assert_array_equal(read_vf(out / "wind.0000.vf")[1],
                                         block_of(wind[0], "unity", numpy.ones(1)).astype("f4"))

    def test_vf_is_in_unitys_frame(self):
        for preset in PRESETS:
            with self.subTest(preset=preset):
                frame_of = preset if preset == "unity-negz" else "unity"
                out, wind, entries = self.baked("vf,vf2", "--layers", 3, "--top", 5, preset=preset)
                low, high = corners_of(frame_of, 0, 5)
                for frame in range(2):
                    expected = block_of(wind[frame], frame_of, layer_factors(3, 5.0))
                    for name, first in ((f"wind.{frame:04}.vf", 10), (f"wind-v2.{frame:04}.vf", 77)):
                        place, vectors = read_vf(out / name)
                        self.assertEqual((out / name).stat().st_size, first + 12 * 48 * 3 * 30)
                        self.assertEqual(vectors.shape, (30, 3, 48, 3))
                        numpy.testing.assert_allclose(vectors, expected, rtol=1e-6, atol=1e-6)
                        self.check_entry(entries[name], frame, frame_of, (low, high), vectors.shape[:3], "m/s")
                        numpy.testing.assert_allclose(entries[name]["centre"], (low + high) / 2, atol=1e-5)
                        numpy.testing.assert_allclose(entries[name]["size"], high - low, atol=1e-5)
                    # The matrix brings the corners of a box of side 1 around 0 to the volume's.
                    numpy.testing.assert_allclose(place @ [-0.5, -0.5, -0.5, 1], [*low, 1], atol=1e-5)
                    numpy.testing.assert_allclose(place @ [0.5, 0.5, 0.5, 1], [*high, 1], atol=1e-5)

    def test_slab_decodes_as_godot_does(self):
        for preset in ("godot", "unity"):  # always in Godot's frame
            out, wind, entries = self.baked("godot-slab", "--layers", 4, preset=preset)
            factors = layer_factors(4)
            for frame in range(2):
                entry = entries[f"slab.{frame:04}.png"]
                self.assertEqual(entry["slices"][0] * entry["slices"][1], 30)
                self.assertEqual([entry["import"][f"slices/{side}"] for side in ("horizontal", "vertical")],
                                 entry["slices"])
                strength = entry["strength"]
                self.assertGreaterEqual(strength * 1.0001, numpy.hypot(*numpy.moveaxis(wind, 3, 0)).max() * factors[-1])
                vectors = read_slab(harness.read_png(out / f"slab.{frame:04}.png"), entry["slices"]) * strength
                expected = block_of(wind[frame], "godot", factors)
                self.assertEqual(vectors.shape, (30, 4, 48, 3))
                numpy.testing.assert_allclose(vectors, expected, atol=strength * CODED_FULLY)
                self.assertLess(abs(vectors[..., 1].mean()), strength * 1e-9, "no drift up or down")
                self.check_entry(entry, frame, "godot", corners_of("godot", 0, 8), vectors.shape[:3], "m/s")
                numpy.testing.assert_allclose(entry["size"], [32, 8, 20])
                numpy.testing.assert_allclose(entry["centre"], [4, 4, -2])

    def test_a_large_slab_is_averaged_to_what_godot_imports(self):
        out, wind, entries = self.baked("godot-slab", "--resolution", "300x130", "--layers", 2, "--vmax", 12, frames=1)
        entry = entries["slab.0000.png"]
        self.assertEqual(entry["grid"], [256, 2, 111])
        self.assertAlmostEqual(entry["strength"], 12 * layer_factors(2)[1], places=4)
        vectors = read_slab(harness.read_png(out / "slab.0000.png"), entry["slices"]) * entry["strength"]
        expected = block_of(averaged(wind[0], 256, 111), "godot", layer_factors(2))
        numpy.testing.assert_allclose(vectors, expected, atol=entry["strength"] * CODED_FULLY)

    def test_every_track_is_a_volume_of_its_own(self):
        out, _, entries = self.baked("fga,vf,godot-slab", "--response", "--layers", 2, preset="unreal", frames=1)
        for track in ("bend-soft", "bend-limber", "bend-firm", "bend-stiff"):
            bends = numpy.load(out / f"{track}-wind.npy").astype(float)
            same = numpy.ones(2)  # a plant leans as it leans, at every height
            _, _, vectors = read_fga(out / f"{track}-wind.0000.fga")
            numpy.testing.assert_allclose(vectors, block_of(bends[0], "unreal", same) / 100, atol=6e-7)
            numpy.testing.assert_allclose(read_vf(out / f"{track}-wind.0000.vf")[1], block_of(bends[0], "unity", same),
                                          atol=1e-6)
            entry = entries[f"{track}-wind.0000.fga"]
            self.assertEqual((entry["units"], entry["track"]), ("rad", track))

    def test_the_same_bake_gives_the_same_bytes_also_in_parts(self):
        formats = "fga,fga-tiles,vf,vf2,godot-slab" + (",vdb" if openvdb else "")
        args = ("--fps", 10, "--vmax", 9, "--layers", 2, "--from", 0.1)
        whole = self.bake(*args, "--seconds", 0.4, out="whole", formats=formats)
        again = self.bake(*args, "--seconds", 0.4, out="again", formats=formats)
        for part in ("2-3", "0-1"):
            self.bake(*args, "--seconds", 0.4, "--frames", part, out="parts", formats=formats)
        self.assertGreater(len(list(whole.iterdir())), 4 * 5)
        for path in whole.iterdir():
            for other in (again, self.folder / "parts"):
                self.assertEqual(harness.sha256(path), harness.sha256(other / path.name), path.name)


@unittest.skipIf(openvdb is None, "python3-openvdb isn't installed")
class OpenVdb(VolumeCase):
    def setUp(self):
        super().setUp()
        words = "4x4 --format vdb --seconds 0.1 --fps 10 --backend cpu --out".split()
        probe = subprocess.run([harness.WINDLOOM, "bake", self.project, "--resolution", *words, self.folder / "probe"],
                               capture_output=True, text=True)
        if probe.returncode == 3 and "no OpenVDB" in probe.stderr:
            self.skipTest("this build has no OpenVDB")
        self.assertEqual(probe.returncode, 0, probe.stderr)

    def test_vdb_has_square_cells_as_voxels_in_each_presets_frame(self):
        for preset in PRESETS:
            with self.subTest(preset=preset):
                out, wind, entries = self.baked("vdb", "--top", 2.5, preset=preset)
                scale = 100 if preset == "unreal" else 1
                side = 32 / 48
                layers = 4  # 2.67 m, the first whole voxel over 2.5
                low, high = corners_of(preset, 0, layers * side)
                factors = layer_factors(layers, layers * side)
                for frame in range(2):
                    path = out / f"wind_{frame:04}.vdb"
                    found_side, first, vectors = read_vdb(path, openvdb)
                    self.assertAlmostEqual(found_side, side * scale, delta=1e-4 * scale)
                    numpy.testing.assert_allclose(first, low + side * scale / 2, atol=1e-3)
                    expected = block_of(wind[frame], preset, factors)
                    self.assertEqual(vectors.shape, expected.shape)
                    numpy.testing.assert_allclose(vectors, expected, rtol=2 ** -11 * 1.01, atol=1e-5)
                    self.check_entry(entries[path.name], frame, preset, (low, high), vectors.shape[:3],
                                     "cm/s" if preset == "unreal" else "m/s")
                    self.assertAlmostEqual(entries[path.name]["voxel"], side * scale, delta=1e-4 * scale)
                    version, offsets, _ = vdb_header(path)
                    self.assertGreaterEqual(version, 222)
                    self.assertEqual(offsets, 1)

    def test_vdb_brings_other_cells_to_cubes(self):
        out, wind, _ = self.baked("vdb", "--resolution", "48x10", "--layers", 1, preset="unity", frames=1)
        side = 32 / 48
        found_side, first, vectors = read_vdb(out / "wind_0000.vdb", openvdb)
        self.assertAlmostEqual(found_side, side, delta=1e-5)
        numpy.testing.assert_allclose(first, [-20 + side / 2, 2, -12 + side / 2], atol=1e-4)
        at = numpy.clip((numpy.arange(30) + 0.5) / 3 - 0.5, 0, 9)
        below = numpy.minimum(at.astype(int), 8)
        part = (at - below)[:, None, None]
        rows = wind[0][below] * (1 - part) + wind[0][below + 1] * part
        numpy.testing.assert_allclose(vectors, block_of(rows, "unity", numpy.ones(1)), rtol=1e-3, atol=1e-4)

    def test_vdb_of_still_air_is_not_empty(self):
        project = dict(harness.PROJECT, graph={"points": [], "arrows": []}, ambient={"speed": 0})
        self.project.write_text(json.dumps(project))
        out, wind, _ = self.baked("vdb", "--layers", 1, frames=1)
        self.assertEqual(numpy.abs(wind).max(), 0)
        self.assertEqual(numpy.abs(read_vdb(out / "wind_0000.vdb", openvdb)[2]).max(), 0)

    def test_vdb_refuses_more_voxels_than_it_can_hold(self):
        done = self.call("bake", self.project, "--backend", "cpu", "--out", self.folder / "huge", "--format", "vdb",
                         "--resolution", "1600x1000", "--seconds", 0.1, "--fps", 10, status=1)
        self.assertIn("1600 x 400 x 1000", done.stderr)
        self.assertFalse((self.folder / "huge").exists())


harness.main()
