"""`windloom bench --quick`: every scene runs, and its report is complete."""
import json

import harness


def luma(picture):
    return picture @ [0.299, 0.587, 0.114]


class BenchReport(harness.Case):
    def check(self, report, scenes):
        self.assertEqual((report["ok"], report["format"], report["version"]), (True, "windloom-bench", 1))
        self.assertRegex(report["date"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        for key in ("cpu", "cores", "memoryMiB", "system", "compiler", "build", "commit"):
            self.assertTrue(report["machine"][key], key)
        self.assertEqual(list(report["scenes"]), scenes)

    def test_measures_every_scene_on_the_cpu_without_opengl(self):
        report = json.loads(self.call("bench", "--quick", "--backend", "cpu", "--json").stdout)
        self.check(report, ["floor", "solver", "meadow", "grassland", "bezier", "shell", "live", "picture", "load", "startup", "export", "runtime"])
        self.assertEqual(report["settings"], {"quick": True, "cpu": True, "gpu": False})
        for scene in ("meadow", "grassland", "bezier", "shell", "live", "picture"):
            self.assertEqual(report["scenes"][scene], [], f"{scene} can't be measured without OpenGL")
        solver = {(row["scheme"], row.get("arrows")): row for row in report["scenes"]["solver"]}
        self.assertEqual(list(solver), [("one plain Jacobi sweep", None), ("windloom", 10), ("windloom", 100)])
        step = solver["windloom", 10]
        self.assertGreater(step["ms"], 0)
        self.assertAlmostEqual(step["sweeps"], step["ms"] / solver["one plain Jacobi sweep", None]["ms"], delta=1e-6)
        self.assertLess(step["residual"], 2e-3)
        self.assertEqual(step["not finite"], 0)
        self.assertEqual(set(step["stages"]), {"forces", "advection", "projection"})
        for key in ("divergenceBefore", "divergenceAfter", "maxDivergenceBefore", "maxDivergenceAfter", "kineticEnergy", "maxSpeed", "cfl", "cycles"):
            self.assertGreater(step["last step"][key], 0, key)
        for rows in report["scenes"].values():
            for row in rows:
                self.assertGreaterEqual(row["runs"], 1)

    def test_measures_the_gpu_where_it_is_asked_for_by_name(self):
        done = self.call("bench", "floor", "solver", "--quick", "--backend", "gpu", "--json", "-")
        report = json.loads(done.stdout)
        self.check(report, ["floor", "solver"])
        self.assertTrue(report["machine"]["opengl"]["renderer"])
        self.assertEqual({row["where"] for row in report["scenes"]["solver"]}, {"gpu"})
        schemes = {row["scheme"]: row for row in report["scenes"]["solver"]}
        self.assertLess(schemes["windloom"]["residual"], 2e-3)
        self.assertLess(schemes["windloom"]["residual"], 0.1 * schemes["plain, 20 Jacobi sweeps"]["residual"])

    def test_measures_frames_of_meadows(self):
        done = self.call("bench", "meadow", "grassland", "live", "--quick", "--backend", "gpu", "--json", "-")
        report = json.loads(done.stdout)
        self.check(report, ["meadow", "grassland", "live"])
        meadow = report["scenes"]["meadow"]
        self.assertEqual([(row["camera"], row["with"]) for row in meadow],
                         [("eye", "all"), ("over", "all"), ("top", "all"), ("eye", "no thinning"), ("eye", "no culling"), ("eye", "neither")])
        for row in meadow:
            self.assertNotIn("note", row)
            for key in ("wind sim ms", "grass sim ms", "rendering ms", "frame ms", "fps", "drawn", "grass MiB", "runs"):
                self.assertGreater(row[key], 0, key)
            self.assertEqual(row["shadow ms"], 0)
            self.assertGreater(row["all MiB"], row["grass MiB"])
            self.assertAlmostEqual(sum(row["stages"].values()), row["grass sim ms"] + row["rendering ms"], delta=1e-6)
        drawn = {row["with"]: row["drawn"] for row in meadow if row["camera"] == "eye"}
        for mode in ("no thinning", "no culling"):
            self.assertGreaterEqual(drawn[mode], drawn["all"], mode)
            self.assertGreaterEqual(drawn["neither"], drawn[mode], mode)
        self.assertEqual(list(dict.fromkeys(row["column"] for row in report["scenes"]["grassland"])),
                         ["A no animation", "B wind", "C wind and a ball", "wind and 20 balls"])
        for row in report["scenes"]["grassland"]:
            self.assertEqual(row["wind sim ms"] > 0, row["column"] != "A no animation")
            self.assertGreater(row["fps"], 0)
        played = (("meadow", "instanced"), ("meadow", "bezier"), ("prairie", "shell"))
        self.assertEqual([(row["sample"], row["grass"], row["stretch"]) for row in report["scenes"]["live"]],
                         [(sample, grass, stretch) for sample, grass in played for stretch in ("settling", "settled")])
        for row in report["scenes"]["live"]:
            self.assertGreater(row["frame ms"], 0)
            self.assertGreaterEqual(row["changes of detail"], 0)

    def test_prints_the_papers_tables_of_bezier_grass(self):
        rows = json.loads(self.call("bench", "bezier", "--quick", "--backend", "gpu", "--json").stdout)["scenes"]["bezier"]
        for scene, spheres in (("nature", 2), ("helicopter", 0)):
            table = {row["what"]: row for row in rows if row["scene"] == scene}
            every, quiet, whole = (lambda what, mode=mode: table[what][mode] for mode in ("all features", "no collision", "no culling"))
            for column in (every, quiet, whole):
                self.assertGreater(column("frame ms"), 0)
                self.assertEqual(column("blades"), 4000)
                self.assertLessEqual(column("blades drawn"), column("blades of visible patches"))
                self.assertLessEqual(column("bytes a blade, shape"), 64)
                self.assertLess(column("bytes a blade, state"), 17)
            self.assertEqual([column("collision spheres") for column in (every, quiet, whole)], [spheres, 0, spheres])
            for test in ("orientation", "frustum", "distance", "occlusion"):
                self.assertEqual(whole(f"culled by {test}"), 0, test)
            self.assertGreater(whole("blades drawn"), every("blades drawn"))
            views = [what for what in table if what.endswith("SSIM to no culling")]
            self.assertEqual(views, ["hero: SSIM to no culling"])
            for what in views:
                self.assertTrue(0.3 < table[what]["all features"] <= 1, table[what])

    def test_prints_the_papers_table_of_shell_grass(self):
        rows = json.loads(self.call("bench", "shell", "--quick", "--backend", "gpu", "--json").stdout)["scenes"]["shell"]
        table = [row for row in rows if row["what"] == "table"]
        shells = ["1 (ground)", "9 plain", "17 plain", "33 plain", "65 plain", "9 filled"]
        self.assertEqual([(row["samples"], row["shells"]) for row in table], [(samples, n) for samples in (1, "own") for n in shells])
        for row in table:
            self.assertGreater(row["frame ms"], 0)
            self.assertAlmostEqual(row["fps"], 1000 / row["frame ms"], delta=1e-3 * row["fps"])
            self.assertLessEqual(row["textures MB"], 32)
            ground = row["shells"] == "1 (ground)"
            for key in ("triangles", "layers"):
                self.assertEqual(row[key] == 0, ground, (row["shells"], key))
        for samples in (1, "own"):
            plain = [row for row in table if row["samples"] == samples and row["shells"].endswith("plain")]
            for few, more in zip(plain, plain[1:]):
                for key in ("triangles", "layers"):
                    self.assertGreater(more[key], few[key], (more["shells"], key))
                if more["fragments a pixel"] > 0:  # some drivers don't count
                    self.assertGreater(more["fragments a pixel"], few["fragments a pixel"], more["shells"])
        compared = [row for row in rows if row["what"] == "compared"]
        self.assertEqual([row["camera"] for row in compared],
                         [camera for camera in ("prairie hero", "prairie worst", "knoll hero") for _ in ("as 65", "own")])
        for row in compared:
            self.assertTrue(0.3 < row["SSIM"] <= 1, row)
            self.assertTrue(85 < row["brightness %"] < 115, row)
            self.assertGreater(row["layers"], 0)
            self.assertAlmostEqual(row["cost, frame"], row["frame ms"] / row["65 plain: frame ms"], delta=1e-6)

    def test_compares_pictures_and_keeps_them(self):
        folder = self.folder / "pictures"
        done = self.call("bench", "picture", "--quick", "--size", "128x72", "--pictures", folder, "--backend", "gpu", "--json")
        rows = json.loads(done.stdout)["scenes"]["picture"]
        self.assertEqual([row["view"] for row in rows], ["eye", "over", "top"])
        for row in rows:
            self.assertNotIn("note", row)
            self.assertTrue(0.3 < row["ssim"] <= 1, row)
            self.assertTrue(80 < row["brightness %"] < 125, row)
            lod, every, difference = (harness.read_png(folder / f"2-k-{row['view']}-{kind}.png") for kind in ("lod", "every", "difference"))
            self.assertEqual({lod.shape, every.shape, difference.shape}, {(36, 64, 3)})
            self.assertAlmostEqual(100 * luma(lod).mean() / luma(every).mean(), row["sRGB %"], delta=0.5)
            self.assertLess(abs(difference - (128 + 4 * (lod - every)).clip(0, 255)).max(), 9)
        self.assertIn("WxH", self.call("bench", "picture", "--size", "large", status=2).stderr)

    def test_times_every_writer_beside_plain_writes_and_a_bake_beside_its_simulation(self):
        rows = json.loads(self.call("bench", "export", "--quick", "--backend", "cpu", "--json").stdout)["scenes"]["export"]
        helped = self.call("bake", "--help").stdout
        writers = [row for row in rows if not row["format"].startswith("bake: ")]
        for name in ("npy", "png", "exr", "png16", "atlas", "dds", "dds-rgba", "dds-bc5", "dds-volume", "ktx2", "ktx2-rgba",
                     "ktx2-bc5", "ktx2-zstd", "windpack"):
            self.assertIn(name, [row["format"] for row in writers])
        for row in writers:
            self.assertIn(row["format"], helped)
            for key in ("MB", "MB in files", "ms", "MB/s", "plain write ms"):
                self.assertGreater(row[key], 0, (row["format"], key))
            self.assertAlmostEqual(row["MB/s"], 1000 * row["MB"] / row["ms"], delta=1e-6 * row["MB/s"])
        self.assertEqual([row["format"] for row in writers if "32 x 32" in row["frames"]], ["exr", "dds"])
        exact = {row["format"]: row for row in reversed(writers)}
        for name in ("dds", "ktx2-bc5", "dds-volume"):
            self.assertEqual(exact[name]["MB"], exact[name]["MB in files"], name)
        bakes = [row for row in rows if row["format"].startswith("bake: ")]
        self.assertEqual(len(bakes), 3)
        for row in bakes:
            self.assertGreater(row["only simulated ms"], 0)
            self.assertAlmostEqual(row["more %"], 100 * (row["ms"] / row["only simulated ms"] - 1), delta=1e-6)

    def test_takes_the_sides_of_the_solvers_fields(self):
        report = json.loads(self.call("bench", "solver", "--quick", "--cells", "32,48", "--backend", "cpu", "--json").stdout)
        self.assertEqual([row["cells"] for row in report["scenes"]["solver"] if row["scheme"] == "windloom"],
                         ["32 x 32", "48 x 48"])
        self.call("bench", "solver", "--cells", "4", status=2)

    def test_writes_tables_and_a_file(self):
        file = self.folder / "bench.json"
        done = self.call("bench", "load", "runtime", "--quick", "--backend", "cpu", "--json", file)
        self.check(json.loads(file.read_text()), ["load", "runtime"])
        self.assertIn("ns a sample", done.stdout)
        self.assertIn("validate", done.stdout)

    def test_refuses_wrong_usage(self):
        self.assertIn("floor, solver", self.call("bench", "teapot", status=2).stderr)
        self.assertIn("file name", self.call("bench", "--json", "solver", status=2).stderr)
        self.call("bench", "load", "--quick", "--backend", "cpu", "--json", self.project / "x.json", status=3)


harness.main()
