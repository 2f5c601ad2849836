"""`windloom render` of Bezier grass: its counts, its views, its switches, and what it refuses."""
import json
import pathlib

import harness
import numpy

PROJECTS = pathlib.Path(__file__).parents[3] / "projects"
TESTS = ("orientation", "frustum", "distance", "occlusion")


class BezierRender(harness.Case):
    def render(self, sample, *more, camera="hero", size="96x72", time="0"):
        """What it reports, and the picture."""
        out = self.folder / "picture.png"
        done = self.call("render", PROJECTS / sample / f"{sample}.wind.json", "--out", out, "--size", size, "--resolution", "16x16",
                         "--backend", "cpu", "--camera", camera, "--time", time, "--overlay", "none", "--json", *more)
        return json.loads(done.stdout).get("bezier"), harness.read_png(out).astype(float)

    def check(self, counts):
        self.assertLessEqual(counts["patchesSeen"], counts["patches"])
        self.assertLessEqual(counts["inPatchesSeen"], counts["blades"])
        self.assertLessEqual(sum(counts["culled"].values()) + counts["drawn"], counts["inPatchesSeen"])

    def test_nature_has_the_papers_blades(self):
        counts, _ = self.render("nature")
        self.assertEqual(counts["blades"], 397881)
        self.check(counts)
        for test in ("orientation", "frustum", "distance"):
            self.assertGreater(counts["culled"][test], 0, test)
        self.assertLess(counts["drawn"], 0.4 * counts["inPatchesSeen"])

    def test_each_test_can_be_left_out(self):
        all_tests, _ = self.render("fur", camera="near")
        self.check(all_tests)
        for test in TESTS:
            without, _ = self.render("fur", "--no-culling", test, camera="near")
            self.check(without)
            self.assertEqual(without["culled"][test], 0, test)
            self.assertGreaterEqual(without["drawn"], all_tests["drawn"], test)
        none, _ = self.render("fur", "--no-culling", "orientation,frustum,distance,occlusion", camera="near")
        self.assertEqual(none["drawn"], none["inPatchesSeen"])
        everything, _ = self.render("fur", "--no-culling", "all", camera="near")
        self.assertEqual(everything["drawn"], everything["blades"])

    def test_views_differ(self):
        seen = {view: self.render("fur", *(["--grass-view", view] if view else []))[1]
                for view in ("", "patches", "culled", "strength", "wireframe")}
        views = list(seen)
        for i, one in enumerate(views):
            for other in views[i + 1:]:
                self.assertGreater(numpy.abs(seen[one] - seen[other]).mean(), 1.0, f"{one} and {other}")

    def test_samples_smooth_edges(self):
        one, eight = (self.render("fur", "--samples", n)[1] for n in (1, 8))
        rough = [numpy.abs(numpy.diff(picture, axis=1)).mean() for picture in (one, eight)]
        self.assertGreater(rough[0], 1.05 * rough[1])

    def test_other_grass_has_no_such_counts(self):
        self.assertIsNone(self.render("fur", "--grass", "none")[0])

    def test_refuses_what_it_does_not_know(self):
        for more in (["--grass-view", "pretty"], ["--no-culling", "depth"], ["--samples", "3"]):
            done = self.call("render", PROJECTS / "fur" / "fur.wind.json", "--out", self.folder / "a.png", *more, status=2)
            self.assertIn(more[0], done.stderr)


harness.main()
