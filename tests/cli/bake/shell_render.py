"""`windloom render` of shell grass: every sample can be shown with it, its wind moves it, and what it refuses."""
import json
import pathlib

import harness
import numpy

PROJECTS = pathlib.Path(__file__).parents[3] / "projects"
SAMPLES = sorted(folder.name for folder in PROJECTS.iterdir() if (folder / f"{folder.name}.wind.json").exists())


class ShellRender(harness.Case):
    def render(self, sample, *more, camera="hero", size="96x72", time="0"):
        """What it reports, and the picture."""
        out = self.folder / "picture.png"
        done = self.call("render", PROJECTS / sample / f"{sample}.wind.json", "--out", out, "--size", size, "--resolution", "32x32",
                         "--backend", "cpu", "--camera", camera, "--time", time, "--overlay", "none", "--json", *more)
        return json.loads(done.stdout), harness.read_png(out).astype(float)

    def first_camera(self, sample):
        return json.loads((PROJECTS / sample / f"{sample}.wind.json").read_text())["cameras"][0]["name"]

    def test_shows_every_sample(self):
        self.assertIn("prairie", SAMPLES)
        self.assertIn("knoll", SAMPLES)
        for sample in SAMPLES:
            with self.subTest(sample):
                camera = self.first_camera(sample)
                told, grass = self.render(sample, "--grass", "shell", camera=camera)
                self.assertTrue(told["ok"])
                _, bare = self.render(sample, "--grass", "none", camera=camera)
                # Something grows in view of the first camera, and no pixel is left black.
                self.assertGreater(numpy.abs(grass - bare).mean(), 1.0)
                self.assertLess((grass.max(axis=2) == 0).mean(), 0.001)

    def test_is_the_same_each_time(self):
        one, other = (self.render("prairie", time="0.5")[1] for _ in range(2))
        self.assertTrue((one == other).all())

    def test_the_gust_is_seen_from_the_air(self):
        """Where the gust is the grass looks other than in calm air; the place moves to the right."""
        calm = self.render("prairie", camera="air", size="160x90", time="0")[1].mean(axis=2)
        middles = []
        for time in ("5", "8", "11"):
            windy = self.render("prairie", camera="air", size="160x90", time=time)[1].mean(axis=2)
            change = numpy.abs(windy - calm)[30:].mean(axis=0)
            change = numpy.convolve(change, numpy.ones(9) / 9, "same")[8:-8]
            weight = (change - change.min()) ** 2
            middles.append((weight * numpy.arange(len(weight))).sum() / weight.sum())
        self.assertGreater(middles[1], middles[0] + 5, middles)
        self.assertGreater(middles[2], middles[1] + 5, middles)

    def test_other_kinds_of_grass_show_the_same_place(self):
        seen = {kind: self.render("knoll", "--grass", kind, size="160x120")[1] for kind in ("instanced", "bezier", "shell")}
        for kind, picture in seen.items():
            others = [other for name, other in seen.items() if name != kind]
            for other in others:
                self.assertGreater(numpy.abs(picture - other).mean(), 0.5, kind)
                # The knoll, the sky and their colours stay where they are.
                coarse = [p.reshape(12, 10, 16, 10, 3).mean(axis=(1, 3)) for p in (picture, other)]
                self.assertLess(numpy.abs(coarse[0] - coarse[1]).mean(), 30, kind)

    def test_refuses_what_it_does_not_know(self):
        done = self.call("render", PROJECTS / "prairie" / "prairie.wind.json", "--out", self.folder / "a.png", "--grass", "shells", status=2)
        self.assertIn("expected", done.stderr)
        self.assertIn("shell", done.stderr)


harness.main()
