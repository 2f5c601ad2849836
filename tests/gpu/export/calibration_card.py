"""Bakes the calibration card for every preset, runs the shader snippets that lie beside it on the baked images, and looks
whether the checker turns green; then spoils the images on purpose and looks whether it says what is wrong. HLSL goes the
way HLSL -> SPIR-V -> GLSL."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "cli" / "bake"))
import harness  # noqa: E402
from read_dds import read_dds  # noqa: E402

WINDLOOM, RUN_FRAGMENT = sys.argv[1:3]
SIDE = 64
FPS, FRAMES, SECONDS = 10, 40, 1.37
COLOURS = {(0, 255, 0): "green", (255, 0, 0): "red", (255, 128, 0): "orange", (255, 127, 0): "orange",
           (0, 0, 255): "blue", (255, 255, 0): "yellow", (0, 255, 255): "cyan", (255, 0, 255): "magenta",
           (255, 255, 255): "white", (0, 0, 0): "black"}
PRESETS = ("generic", "godot", "unreal", "unity", "unity-negz")

GLSL_PAIR = """
layout(location = 0) in vec2 part;
layout(location = 0) out vec4 colour;
layout(binding = 0) uniform sampler2D early;
layout(binding = 1) uniform sampler2D late;
void main() {
  vec2 ground = WIND_MIN + part * WIND_SIZE;
  vec2 uv = windUv(ground);
  vec2 wind = mix(windFrom8(texture(early, uv)), windFrom8(texture(late, uv)), windFrames(%s).z);
  colour = vec4(windCheck(wind, ground, %s), 1.0);
}
"""
GLSL_ARRAY = """
layout(location = 0) in vec2 part;
layout(location = 0) out vec4 colour;
layout(binding = 0) uniform sampler2DArray frames;
void main() {
  vec2 ground = WIND_MIN + part * WIND_SIZE;
  colour = vec4(windCheck(windAt(frames, ground, %s), ground, %s), 1.0);
}
"""
HLSL_PAIR = """
Texture2D early : register(t0);
Texture2D late : register(t1);
SamplerState linearSampler : register(s0);
float4 main(float2 part : TEXCOORD0) : SV_Target {
  float2 ground = WIND_MIN + part * WIND_SIZE;
  return float4(windCheck(windBetween(early, late, linearSampler, ground, %s), ground, %s), 1.0);
}
"""
HLSL_ARRAY = """
Texture2DArray frames : register(t0);
SamplerState linearSampler : register(s0);
float4 main(float2 part : TEXCOORD0) : SV_Target {
  float2 ground = WIND_MIN + part * WIND_SIZE;
  return float4(windCheck(windAt(frames, linearSampler, ground, %s), ground, %s), 1.0);
}
"""


class CalibrationCard(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls._folder = tempfile.TemporaryDirectory(prefix="windloom-card-")
        cls.folder = pathlib.Path(cls._folder.name)
        project = cls.folder / "card.wind.json"
        subprocess.run([WINDLOOM, "new", project, "--template", "calibration"], check=True, capture_output=True)
        for preset in PRESETS:
            subprocess.run([WINDLOOM, "bake", project, "--backend", "cpu", "--out", cls.folder / preset, "--format",
                            "png,dds", "--preset", preset, "--seconds", str(FRAMES / FPS), "--fps", str(FPS), "--loop"],
                           check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        cls._folder.cleanup()

    def shader(self, preset, glsl, hlsl, seconds):
        """GLSL of the preset's snippet with one of the main functions above."""
        folder = self.folder / preset
        snippet = next(folder.glob("wind.[ghl]*s*"))
        text = snippet.read_text()
        if snippet.suffix != ".hlsl":
            return "#version 450\n" + text + glsl % (seconds, seconds)
        source, binary = folder / "check.hlsl", folder / "check.spv"
        source.write_text(text + hlsl % (seconds, seconds))
        done = subprocess.run(["glslangValidator", "-D", "-V", "-S", "frag", "-e", "main", "-o", binary, source],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        done = subprocess.run(["spirv-cross", binary, "--version", "450", "--no-es",
                               "--combined-samplers-inherit-bindings"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def colours(self, shader, *textures):
        """How often each colour of the checker shows, in parts of the field."""
        (self.folder / "check.frag").write_text(shader)
        done = subprocess.run([RUN_FRAGMENT, self.folder / "check.frag", self.folder / "out.raw", str(SIDE), *textures],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        raw = numpy.frombuffer((self.folder / "out.raw").read_bytes(), numpy.uint8).reshape(-1, 4)[:, :3]
        found = {}
        for pixel in map(tuple, raw):
            name = COLOURS[pixel]
            found[name] = found.get(name, 0) + 1 / len(raw)
        return found

    def images(self, preset):
        """The two 8-bit images around SECONDS, rows as the engine samples them: v = 0 first."""
        at = SECONDS * FPS
        pair = [harness.read_png(self.folder / preset / f"flow.{n:04}.png")
                for n in (int(at), (int(at) + 1) % FRAMES)]
        return [image[::-1] for image in pair] if preset.startswith("unity") else pair

    def check_images(self, preset, pair, seconds=SECONDS):
        textures = []
        for name, image in zip(("early", "late"), pair):
            (self.folder / name).write_bytes(numpy.ascontiguousarray(image, numpy.uint8).tobytes())
            textures.append(f"rgba8:{self.folder / name}:{image.shape[1]}:{image.shape[0]}")
        return self.colours(self.shader(preset, GLSL_PAIR, HLSL_PAIR, seconds), *textures)

    def test_flow_maps_turn_green_for_every_preset(self):
        for preset in PRESETS:
            with self.subTest(preset=preset):
                self.assertEqual(self.check_images(preset, self.images(preset)), {"green": 1.0})

    def test_arrays_of_halves_turn_green_for_every_preset(self):
        for preset in PRESETS:
            with self.subTest(preset=preset):
                layers = read_dds(self.folder / preset / "wind.dds")[1]
                if preset.startswith("unity"):
                    layers = layers[:, ::-1]
                (self.folder / "layers").write_bytes(numpy.ascontiguousarray(layers).tobytes())
                depth, height, width, _ = layers.shape
                found = self.colours(self.shader(preset, GLSL_ARRAY, HLSL_ARRAY, SECONDS),
                                     f"rg16f:{self.folder / 'layers'}:{width}:{height}:{depth}")
                self.assertEqual(found, {"green": 1.0})

    def most(self, found):
        self.assertLess(found.get("green", 0), 0.2, found)
        return max(found, key=found.get)

    def test_the_checker_says_what_is_wrong(self):
        for preset in PRESETS:
            pair = self.images(preset)
            swap, first, second = [1, 0, 2, 3], numpy.array(pair), numpy.array(pair)
            first[..., 0] = 256 - first[..., 0]
            second[..., 1] = 256 - second[..., 1]
            half = [(image - 128) // 2 + 128 for image in pair]
            with self.subTest(preset=preset):
                self.assertEqual(self.most(self.check_images(preset, first)), "red")
                self.assertEqual(self.most(self.check_images(preset, second)), "orange")
                self.assertEqual(self.most(self.check_images(preset, [image[..., swap] for image in pair])), "blue")
                self.assertEqual(self.most(self.check_images(preset, [image[:, ::-1] for image in pair])), "yellow")
                self.assertEqual(self.most(self.check_images(preset, [image[::-1] for image in pair])), "cyan")
                self.assertEqual(self.most(self.check_images(preset, half)), "magenta")
                self.assertEqual(self.most(self.check_images(preset, pair, SECONDS + 1.0)), "white")

    def test_images_read_as_colours_are_not_green(self):
        pair = [255 * (image / 255) ** 2.2 for image in self.images("generic")]
        self.most(self.check_images("generic", pair))

    def test_the_manifest_knows_the_card_and_the_wind_is_the_formula(self):
        manifest = json.loads((self.folder / "generic" / "manifest.json").read_text())
        self.assertTrue(manifest["card"])
        layers = read_dds(self.folder / "generic" / "wind.dds")[1].astype(float)
        (left, low), (right, high) = manifest["bounds"]["min"], manifest["bounds"]["max"]
        self.assertEqual((left, low, right, high), (-24, -28, 40, 20))
        for n, i, k in ((0, 0, 0), (7, 100, 20), (39, 5, 90)):
            u, w, turn = (i + 0.5) / 128, (k + 0.5) / 96, 2 * math.pi * n / FRAMES
            expected = (5 * math.cos(turn) + 2 * math.sin(2 * math.pi * (w + 0.125)),
                        5 * math.sin(turn) + 2 * math.sin(2 * math.pi * (2 * u + 0.125)))
            numpy.testing.assert_allclose(layers[n, k, i], expected, atol=0.005)


unittest.main(argv=sys.argv[:1])
