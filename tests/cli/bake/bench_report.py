"""`windloom bench --quick`: every scene runs, and its report is complete."""
import json

import harness


class BenchReport(harness.Case):
    def check(self, report, scenes):
        self.assertEqual((report["ok"], report["format"], report["version"]), (True, "windloom-bench", 1))
        self.assertRegex(report["date"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        for key in ("cpu", "cores", "memoryMiB", "system", "compiler", "build", "commit"):
            self.assertTrue(report["machine"][key], key)
        self.assertEqual(list(report["scenes"]), scenes)

    def test_measures_every_scene_on_the_cpu_without_opengl(self):
        report = json.loads(self.call("bench", "--quick", "--backend", "cpu", "--json").stdout)
        self.check(report, ["floor", "solver", "grass", "load", "startup", "runtime"])
        self.assertEqual(report["settings"], {"quick": True, "cpu": True, "gpu": False})
        self.assertEqual(report["scenes"]["grass"], [], "grass can't be measured without OpenGL")
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
        done = self.call("bench", "floor", "solver", "grass", "--quick", "--backend", "gpu", "--json", "-")
        report = json.loads(done.stdout)
        self.check(report, ["floor", "solver", "grass"])
        self.assertTrue(report["machine"]["opengl"]["renderer"])
        self.assertEqual({row["where"] for row in report["scenes"]["solver"]}, {"gpu"})
        schemes = {row["scheme"]: row for row in report["scenes"]["solver"]}
        self.assertLess(schemes["windloom"]["residual"], 2e-3)
        self.assertLess(schemes["windloom"]["residual"], 0.1 * schemes["plain, 20 Jacobi sweeps"]["residual"])
        self.assertEqual([row["camera"] for row in report["scenes"]["grass"]], ["eye", "over", "top"])
        for row in report["scenes"]["grass"]:
            self.assertGreater(row["drawn"], 0)

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
