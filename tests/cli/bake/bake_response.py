"""How plants lean: the baked tracks against oscillators integrated in many small steps."""
import json

import numpy

import harness

FPS, SECONDS = 30, 2.0


def steady(wind, bend):
    """The angle saturates as the meadow's blades do: x / sqrt(1 + (x / 1.2)^2)."""
    size = bend * numpy.linalg.norm(wind, axis=-1, keepdims=True)
    return wind * bend / numpy.sqrt(1 + (size / 1.2) ** 2)


def integrated(wind, frequency, damping, bend, substeps=64):
    """Plants that rest in the first frame; their target goes evenly from frame to frame."""
    w = 2 * numpy.pi * frequency
    target = steady(wind, bend)
    x, v = target[0].copy(), numpy.zeros_like(target[0])
    h = 1 / FPS / substeps
    frames = [x.copy()]
    for before, after in zip(target, target[1:]):
        for n in range(substeps):
            # The middle of the step, then the step: second order.
            begin, middle = before + (after - before) * (n / substeps), before + (after - before) * ((n + 0.5) / substeps)
            xm = x + v * (h / 2)
            vm = v + (-2 * damping * w * v - w * w * (x - begin)) * (h / 2)
            x, v = x + vm * h, v + (-2 * damping * w * vm - w * w * (xm - middle)) * h
        frames.append(x.copy())
    return numpy.array(frames)


class Response(harness.Case):
    def test_the_tracks_are_the_answers_of_damped_oscillators(self):
        out = self.bake("--seconds", SECONDS, "--fps", FPS, "--response", "--resolution", "16x10")
        wind = numpy.load(out / "wind.npy").astype(float)
        self.assertGreater(numpy.abs(numpy.diff(wind, axis=0)).max(), 0.5, "the test needs gusts")
        classes = json.loads((out / "manifest.json").read_text())["response"]["classes"]
        self.assertEqual([c["track"] for c in classes], ["bend-soft", "bend-limber", "bend-firm", "bend-stiff"])
        for plants in classes:
            bends = numpy.load(out / f"{plants['track']}-wind.npy")
            self.assertEqual(bends.shape, wind.shape)
            expected = integrated(wind, plants["frequency"], plants["damping"], plants["bend"])
            numpy.testing.assert_allclose(bends, expected, atol=2e-4, err_msg=plants["track"])
            self.assertLess(numpy.linalg.norm(bends, axis=-1).max(), 1.5)

    def test_softer_plants_lean_further_and_none_lies_down(self):
        out = self.bake("--seconds", 0.2, "--fps", 10, "--from", 0.5, "--response", "--resolution", "16x10")
        leans = [numpy.abs(numpy.load(out / f"bend-{name}-wind.npy")).max() for name in ("soft", "limber", "firm", "stiff")]
        self.assertEqual(leans, sorted(leans, reverse=True))
        self.assertLess(leans[0], 1.2)


harness.main()
