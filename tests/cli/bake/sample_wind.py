"""`windloom sample` against the array that `windloom bake` writes."""
import json

import numpy

import harness
from harness import centre_of

NO_OPENGL = {"__EGL_VENDOR_LIBRARY_DIRS": "/nonexistent", "LIBGL_DRIVERS_PATH": "/nonexistent", "EGL_PLATFORM": "none"}


class SampledWind(harness.Case):
    def sample(self, *args, **kwargs):
        return json.loads(self.call("sample", self.project, "--json", "--backend", "cpu", *args, **kwargs).stdout)

    def test_is_the_baked_wind_at_the_same_place_and_time(self):
        wind = numpy.load(self.bake("--from", 0.5, "--seconds", 0.1, "--fps", 10) / "wind.npy")[0]
        cells = [(0, 0), (24, 15), (12, 20), (47, 29)]
        at = [word for cell in cells for word in ("--at", "{:.9g},{:.9g}".format(*centre_of(*cell)))]
        answer = self.sample(*at, "--time", 0.5)
        self.assertEqual((answer["steps"], answer["backend"]), (30, "cpu"))
        for (i, k), place in zip(cells, answer["samples"]):
            numpy.testing.assert_allclose(place["velocity"], wind[k, i], atol=1e-4)
            self.assertAlmostEqual(place["speed"], numpy.hypot(*wind[k, i]), delta=1e-4)
            turned = numpy.degrees(numpy.arctan2(wind[k, i, 1], wind[k, i, 0]))
            self.assertAlmostEqual((place["direction"] - turned + 180) % 360, 180, delta=0.1)
        between = self.sample("--at", "{:.9g},{:.9g}".format(*centre_of(20.5, 10)), "--time", 0.5)["samples"][0]
        numpy.testing.assert_allclose(between["velocity"], (wind[10, 20] + wind[10, 21]) / 2, atol=1e-4)

    def test_blows_along_the_arrows_where_they_drive(self):
        answer = self.sample("--at", "1,-2.5", "--time", 0.5)["samples"][0]
        along = numpy.array([10, 3]) / numpy.hypot(10, 3)
        self.assertGreater(numpy.dot(answer["velocity"], along), 3)
        self.assertGreater(numpy.dot(answer["velocity"], along) / answer["speed"], 0.9)

    def test_takes_the_probes_where_no_place_is_given(self):
        answer = self.sample("--time", 0.1)
        self.assertEqual([place["name"] for place in answer["samples"]], ["tip"])
        self.assertEqual(answer["samples"][0]["at"], [12, 4])

    def test_tells_the_state_of_the_solver(self):
        diagnostics = self.sample("--time", 0.2)["diagnostics"]
        self.assertEqual(diagnostics["nonFiniteCells"], 0)
        self.assertGreater(diagnostics["maxSpeed"], 1)
        self.assertGreater(diagnostics["cfl"], 0)
        self.assertGreater(diagnostics["kineticEnergy"], 0)
        self.assertLess(diagnostics["divergenceAfter"], 2e-3 * diagnostics["divergenceBefore"] + 1e-6)
        self.assertAlmostEqual(diagnostics["residual"] * diagnostics["divergenceBefore"],
                               diagnostics["divergenceAfter"], delta=1e-9)
        self.assertGreaterEqual(diagnostics["maxDivergenceBefore"], diagnostics["divergenceBefore"])
        self.assertGreaterEqual(diagnostics["maxDivergenceAfter"], diagnostics["divergenceAfter"])
        self.assertGreater(diagnostics["cycles"], 0)
        self.assertGreater(diagnostics["stageMs"]["projection"], 0)
        self.assertLessEqual(sum(diagnostics["stageMs"].values()), 1.01 * diagnostics["stepMs"] + 0.1)

    def test_runs_the_papers_scheme_by_name(self):
        diagnostics = self.sample("--time", 0.2, "--solver", "cwd-sim")["diagnostics"]
        self.assertEqual(diagnostics["cycles"], 20)
        self.assertGreater(diagnostics["residual"], 0.01)
        self.assertIn("default, cwd-sim",
                      self.call("sample", self.project, "--time", 1, "--solver", "magic", status=2).stderr)
        made = self.folder / "new.wind.json"
        self.call("new", made, "--solver", "cwd-sim")
        solver = json.loads(made.read_text())["solver"]
        self.assertEqual((solver["pressure"], solver["advection"], solver["sweeps"]), ("jacobi", "semi-lagrangian", 20))

    def test_prints_a_table_for_people(self):
        done = self.call("sample", self.project, "--backend", "cpu", "--at", "-4,-4", "--time", 0.1)
        lines = done.stdout.splitlines()
        self.assertIn("speed m/s", lines[1])
        name, *numbers = lines[2].split()
        self.assertEqual(name, "-4,-4")
        speed, _, vx, vz = map(float, numbers)
        self.assertAlmostEqual(speed, numpy.hypot(vx, vz), delta=0.002)

    def test_starts_from_a_given_wind(self):
        still = self.folder / "still.npy"
        numpy.save(still, numpy.full((30, 48, 2), [0.0, 3.0], "<f4"))
        place = self.sample("--at", "15,-8", "--time", 0, "--initial", still)["samples"][0]
        numpy.testing.assert_allclose(place["velocity"], [0, 3], atol=0.05)

    def test_needs_no_opengl(self):
        words = ("sample", self.project, "--json", "--time", 0.1)
        asked = self.call(*words, env=NO_OPENGL)
        self.assertEqual(json.loads(asked.stdout)["backend"], "cpu")
        refused = self.call(*words, "--backend", "gpu", env=NO_OPENGL, status=3)
        self.assertFalse(json.loads(refused.stdout)["ok"])
        self.assertIn("OpenGL", refused.stderr)

    def test_refuses_places_outside_and_says_the_bounds(self):
        done = self.call("sample", self.project, "--at", "20.5,0", "--time", 1, status=1)
        self.assertIn("x -12 to 20 and z -12 to 8", done.stderr)

    def test_refuses_wrong_usage(self):
        self.assertIn("expected X,Z", self.call("sample", self.project, "--at", "north", "--time", 1, status=2).stderr)
        self.call("sample", self.project, "--at", "1,nan", "--time", 1, status=2)
        for number in ("nan", "-nan", "inf", "1e999", "0x10"):
            self.call("sample", self.project, "--at", "1,2", "--time", number, status=2)
            self.call("bake", self.project, "--out", "never", "--format", "npy", "--fps", number, status=2)
        self.call("sample", self.project, "--at", "1,1", "--time", -1, status=2)
        self.call("sample", self.project, "--at", "1,1", status=2)

    def test_refuses_initial_winds_that_do_not_fit(self):
        start = self.folder / "start.npy"

        def refusal_of(path):
            words = ("sample", self.project, "--time", 0.1, "--backend", "cpu")
            return self.call(*words, "--initial", path, status=1).stderr

        def refusal(array):
            numpy.save(start, array)
            return refusal_of(start)

        self.assertIn("48 x 30", refusal(numpy.zeros((48, 30, 2), "<f4")))
        self.assertIn("<f8", refusal(numpy.zeros((30, 48, 2))))
        self.assertIn("Fortran", refusal(numpy.asfortranarray(numpy.ones((30, 48, 2), "<f4"))))
        broken = numpy.zeros((30, 48, 2), "<f4")
        broken[3, 5, 1] = numpy.nan
        self.assertIn("start.npy", refusal(broken))
        start.write_bytes(start.read_bytes()[:500])
        self.assertIn("cut short", refusal_of(start))
        self.assertIn("none.npy", refusal_of("none.npy"))


harness.main()
