#!/usr/bin/env python3
"""Drives the built `windloom`: new, validate, info, docs, and the messages and exit status of bad input."""
import argparse
import base64
import json
import os
import pathlib
import stat
import struct
import subprocess
import sys
import tempfile
import unittest

PATIENCE = int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))
DONE, BAD_INPUT, USAGE = 0, 1, 2

# file -> (place, part of the message)
REFUSALS = {
    "array": ("", "expected a Windloom project"),
    "bezier-without-gravity": ("/bezier/gravity/direction", "has no length, expected a direction"),
    "beyond-float": ("/graph/points/0/position", "expected two numbers"),
    "binary": ("line 1, column 1", "is not valid JSON"),
    "collider-key-backwards": ("/colliders/0/keys/2", "is not later than the key before it"),
    "collider-key-short": ("/colliders/0/keys/1", "expected four numbers [time, x, height, z]"),
    "collider-mesh-without-file": ("/colliders/0/file", "is missing, expected the glTF file of the object"),
    "control-character-name": ("/name", "without control characters"),
    "dangling-arrow": ("/graph/arrows/0/to", "there is no point 7"),
    "dangling-signal": ("/graph/signals/0/root", "there is no point 7"),
    "duplicate-ids": ("/graph/points/2/id", "id 2 is used already, at /graph/points/1"),
    "duplicate-key": ("/graph/arrows/0/radius", "is there twice"),
    "empty": ("", "is empty"),
    "id-of-point-and-arrow": ("/graph/arrows/0/id", "id 2 is used already, at /graph/points/1"),
    "id-of-species-and-collider": ("/colliders/0/id", "id 5 is used already, at /species/0"),
    "id-of-surface-and-rotor": ("/rotors/0/id", "id 5 is used already, at /surfaces/0"),
    "keys-not-ascending": ("/graph/signals/0/keys/1", "not later"),
    "map-outside": ("/grass/maps/density", "which leaves the project's folder"),
    "missing-format": ("/format", "is missing"),
    "missing-id": ("/graph/points/0/id", "is missing, expected an id"),
    "missing-version": ("/version", "is missing"),
    "nan": ("line 7, column 30", "is not valid JSON"),
    "nan-text": ("/graph/points/0/position", "expected two numbers"),
    "negative-radius": ("/graph/arrows/0/radius", "found -4, expected a number from 0.05 to 1000 (m)"),
    "newer-version": ("/version", "the project is of version 99, this program reads up to version 1"),
    "not-json": ("line 1, column 1", "is not valid JSON"),
    "not-utf8": ("line 4, column 12", "is not valid JSON"),
    "null-position": ("/graph/points/0/position", "found [null,0], expected two numbers"),
    "number-too-large": ("line 7, column 34", "is not valid JSON"),
    "periodic-alone": ("/field/borders/xMax", "expected both or neither"),
    "resolution-fraction": ("/field/resolution", "expected two whole numbers from 8 to 4096"),
    "resolution-huge": ("/field/resolution", "expected two whole numbers from 8 to 4096"),
    "resolution-zero": ("/field/resolution", "expected two whole numbers from 8 to 4096"),
    "self-arrow": ("/graph/arrows/0/to", "expected another one"),
    "shell-over-bend": ("/shell/bend/overBend", "found 3, expected a number from 1 to 2"),
    "shell-picture-outside": ("/shell/texture/file", "which leaves the project's folder"),
    "species-mesh-outside": ("/species/0/file", "an absolute path"),
    "species-unknown-shape": ("/species/0/shape", 'found "tulip", expected one of blade, daisy, poppy, spike, mesh'),
    "surface-mesh-without-file": ("/surfaces/0/file", "is missing, expected the glTF file of the surface"),
    "surface-unknown-shape": ("/surfaces/0/shape", 'found "cube", expected one of moebius, torus, sphere, hare, mesh'),
    "too-deep": (None, "nested deeper than 64 levels"),
    "too-many-blades": ("/grass/density", "million blades"),
    "too-many-species": ("/species", "holds 17 objects, expected at most 16"),
    "too-many-rotors": ("/rotors", "holds 17 objects, expected at most 16"),
    "truncated": (None, "unexpected end of input"),
    "twin-arrows": ("/graph/arrows/1", "as arrow 11 already does"),
    "unknown-choice": ("/graph/arrows/0/drive", 'found "magic", expected one of speed, force'),
    "wrong-format": ("/format", 'expected "windloom-project"'),
    "wrong-types": ("/graph/arrows/0/radius", "expected a number"),
    "zero-length-arrow": ("/graph/arrows/0", "has no length"),
}


class Verbs(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)

    def run_windloom(self, *arguments):
        command = [OPTIONS.windloom, *map(str, arguments)]
        return subprocess.run(command, capture_output=True, text=True, encoding="utf-8", timeout=60 * PATIENCE)

    def expect(self, status, *arguments):
        result = self.run_windloom(*arguments)
        self.assertEqual(result.returncode, status, f"{arguments}\n{result.stdout}\n{result.stderr}")
        return result

    def broken(self, name):
        return os.path.join(OPTIONS.broken, name + ".wind.json")

    def test_every_broken_file_is_refused_with_its_place(self):
        names = {p.name.removesuffix(".wind.json") for p in pathlib.Path(OPTIONS.broken).glob("*.wind.json")}
        self.assertEqual(names, set(REFUSALS))
        for name, (pointer, message) in REFUSALS.items():
            for verb in ("validate", "info"):
                result = self.expect(BAD_INPUT, verb, self.broken(name), "--json")
                errors = json.loads(result.stdout)["errors"]
                self.assertFalse(json.loads(result.stdout)["ok"])
                found = [e for e in errors if pointer in (None, e["pointer"]) and message in e["message"]]
                self.assertTrue(found, f"{verb} {name}: {errors}")
                self.assertTrue(all(e["file"] == self.broken(name) for e in errors))
                self.assertIn(f"{self.broken(name)}: ", result.stderr)
                self.assertIn(message, result.stderr)

    def test_without_json_standard_output_stays_empty_on_failure(self):
        result = self.expect(BAD_INPUT, "info", self.broken("negative-radius"))
        self.assertEqual(result.stdout, "")
        self.assertIn("/graph/arrows/0/radius: found -4, expected a number from 0.05 to 1000 (m)", result.stderr)

    def test_a_missing_file_is_bad_input(self):
        result = self.expect(BAD_INPUT, "validate", self.folder / "none.wind.json")
        self.assertIn("none.wind.json", result.stderr)
        self.expect(BAD_INPUT, "info", self.folder)

    def test_validate_lists_all_problems_of_all_files(self):
        good = self.folder / "good.wind.json"
        self.expect(DONE, "new", good)
        files = [self.broken("wrong-types"), good, self.broken("negative-radius")]
        output = json.loads(self.expect(BAD_INPUT, "validate", "--json", *files).stdout)
        places = sorted(e["pointer"] for e in output["errors"])
        self.assertEqual(places, ["/field", "/graph/arrows/0/drive", "/graph/arrows/0/id", "/graph/arrows/0/muted",
                                  "/graph/arrows/0/radius", "/graph/arrows/0/radius"])

    def test_validate_warns_of_unknown_keys(self):
        path = self.folder / "later.wind.json"
        path.write_text('{"format": "windloom-project", "version": 1, "moon": 1, "colliders": []}', encoding="utf-8")
        output = json.loads(self.expect(DONE, "validate", "--json", path).stdout)
        self.assertEqual([w["pointer"] for w in output["warnings"]], ["/moon"])
        self.assertIn("warning: ", self.expect(DONE, "validate", path).stderr)

    def test_new_writes_every_template_and_refuses_to_overwrite(self):
        templates = json.loads(self.expect(DONE, "new", "--list", "--json").stdout)["templates"]
        names = [t["name"] for t in templates]
        self.assertEqual(len(set(names)), 10)
        for name in names:
            path = self.folder / f"{name}.wind.json"
            self.expect(DONE, "new", path, "--template", name)
            self.expect(DONE, "validate", path)
        path = self.folder / "meadow.wind.json"
        before = path.read_bytes()
        self.assertIn("--force", self.expect(BAD_INPUT, "new", path, "--template", "empty").stderr)
        self.assertEqual(path.read_bytes(), before)
        self.expect(DONE, "new", path, "--template", "empty", "--force")
        self.assertNotEqual(path.read_bytes(), before)
        self.assertEqual((self.folder / "meadow.wind.json.bak").read_bytes(), before)

    def test_new_into_a_missing_folder_is_refused(self):
        result = self.expect(BAD_INPUT, "new", self.folder / "none" / "a.wind.json", "--json")
        self.assertIn("doesn't exist", json.loads(result.stdout)["errors"][0]["message"])

    def test_new_files_get_the_usual_rights(self):
        path = self.folder / "a.wind.json"
        old = os.umask(0o022)
        self.expect(DONE, "new", path)
        os.umask(old)
        self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o644)

    def test_no_text_of_a_file_reaches_the_terminal_as_a_command(self):
        key = "\x1b]0;pwned\x07\x1b[31mred\x7f\x9b2J\nwindloom: fake line"
        place = self.folder / "a\x1b[2J\nb\udcff"
        place.mkdir()
        path = place / "p.wind.json"
        self.expect(DONE, "new", path)
        project = json.loads(path.read_text())
        project[key] = {key: 1}
        project["name"] = "meadow \x9b31m"
        path.write_text(json.dumps(project))
        broken = place / "broken.wind.json"
        broken.write_text(json.dumps({**project, "field": {"resolution": key}}))
        runs = [(DONE, "new", place / "n.wind.json"), (DONE, "validate", path), (DONE, "info", path),
                (BAD_INPUT, "validate", broken), (BAD_INPUT, "info", broken), (BAD_INPUT, "info", place / "none"),
                (BAD_INPUT, "new", path), (USAGE, "info", path, "--backend", key), (USAGE, key), (DONE, "docs", place),
                (DONE, "sample", path, "--at", "0,0", "--time", "0", "--backend", "cpu"),
                (BAD_INPUT, "sample", place / "none", "--at", "0,0", "--time", "0"),
                (DONE, "bake", path, "--out", place / "wind", "--format", "npy", "--seconds", "0.1", "--backend", "cpu")]
        for status, *arguments in runs:
            for more in ([], ["--json"]):
                if more and arguments[0] == "new" and status == DONE:
                    arguments.append("--force")
                command = [OPTIONS.windloom, *map(str, arguments), *more]
                result = subprocess.run(command, capture_output=True, timeout=60 * PATIENCE)
                told = result.stdout + result.stderr
                self.assertEqual(result.returncode, status, f"{command}\n{told}")
                text = told.decode("utf-8")  # fails on bytes that are none
                found = [c for c in text if (c < " " and c != "\n") or "\x7f" <= c <= "\x9f"]
                self.assertEqual(found, [], f"{command}\n{text!r}")
                self.assertNotIn("\nwindloom: fake line", text)
                if more:
                    json.loads(result.stdout)
        errors = json.loads(self.run_windloom("info", broken, "--json").stdout)["errors"]
        self.assertEqual(errors[0]["pointer"], "/field/resolution")

    def test_wrong_usage(self):
        for arguments in ([], ["blow"], ["validate"], ["new"], ["new", "x", "--template", "nope"],
                          ["info", "x", "--fps", "-1"],
                          ["info", "x", "--backend", "abacus"], ["validate", "x", "--no-such-option"]):
            result = self.expect(USAGE, *arguments)
            self.assertNotEqual(result.stderr, "", arguments)
            self.assertEqual(result.stdout, "", arguments)
        errors = json.loads(self.expect(USAGE, "info", "x", "--backend", "abacus", "--json").stdout)["errors"]
        self.assertIn("expected auto, gpu or cpu", errors[0]["message"])

    def test_help_and_version(self):
        text = self.expect(DONE, "--help").stdout
        for verb in ("new", "validate", "info"):
            self.assertIn(f"\n  {verb} ", text)
            self.assertIn("Usage: windloom " + verb, self.expect(DONE, verb, "--help").stdout)
        self.assertRegex(self.expect(DONE, "--version").stdout, r"^windloom \d+\.\d+\.\d+\n$")

    def test_info_tells_counts_arrivals_and_memory(self):
        path = self.folder / "line.wind.json"
        path.write_text(json.dumps({
            "format": "windloom-project", "version": 1, "field": {"size": [50, 20], "resolution": [100, 40]},
            "grass": {"density": 10},
            "graph": {"points": [{"id": 1, "name": "gate", "position": [0, 0]}, {"id": 2, "position": [10, 0]},
                                 {"id": 3, "position": [10, 5]}],
                      "arrows": [{"id": 11, "from": 1, "to": 2, "travelSpeed": 5},
                                 {"id": 12, "from": 2, "to": 3, "travelSpeed": 2}],
                      "signals": [{"root": 1, "kind": "pulse"}]}}), encoding="utf-8")
        info = json.loads(self.expect(DONE, "info", path, "--json", "--fps", "25").stdout)
        self.assertTrue(info["ok"])
        self.assertEqual(info["roots"], [{"id": 1, "signal": "pulse"}])
        self.assertEqual([(a["point"], a["time"]) for a in info["arrivals"]], [(1, 0), (2, 2), (3, 4.5)])
        self.assertEqual(info["counts"]["cells"], 4000)
        self.assertEqual(info["counts"]["blades"], 10000)
        self.assertEqual(info["extent"], {"min": [0, 0], "max": [10, 5]})
        self.assertEqual(info["field"]["cellSize"], [0.5, 0.5])
        self.assertEqual(info["bytes"]["field"], 4000 * 8)
        self.assertEqual(info["bytes"]["npyPerSecond"], 4000 * 8 * 25)
        text = self.expect(DONE, "info", path).stdout
        self.assertIn("1 (gate) plays pulse", text)
        self.assertIn("4.50 s  point 3", text)

    def test_info_tells_surfaces_rotors_and_the_kind_of_grass(self):
        path = self.folder / "band.wind.json"
        path.write_text(json.dumps({
            "format": "windloom-project", "version": 1, "field": {"size": [50, 20], "resolution": [100, 40]},
            "grass": {"kind": "bezier", "density": 1000}, "bezier": {"most": 20000},
            "surfaces": [{"id": 1, "name": "band", "shape": "moebius", "size": 6},
                         {"id": 2, "shape": "mesh", "file": "hill.gltf"}],
            "rotors": [{"id": 3, "lift": 12}]}), encoding="utf-8")
        self.assertIn("/surfaces/1/file", self.expect(BAD_INPUT, "info", path).stderr, "the lost file is told")
        places = base64.b64encode(struct.pack("<9f", 0, 0, 0, 0, 0, 1, 1, 0, 0)).decode()
        (self.folder / "hill.gltf").write_text(json.dumps({
            "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64," + places}]}))
        self.expect(DONE, "validate", path)
        info = json.loads(self.expect(DONE, "info", path, "--json").stdout)
        self.assertEqual((info["counts"]["surfaces"], info["counts"]["rotors"]), (2, 1))
        bare = self.folder / "bare.wind.json"
        bare.write_text(path.read_text(encoding="utf-8").replace('"name": "band"', '"name": "band", "hidden": true'), encoding="utf-8")
        blades = json.loads(self.expect(DONE, "info", bare, "--json").stdout)["counts"]["blades"]
        self.assertEqual(blades, 20000 + 750, "no more than the most on the ground, and 1500 per m^2 on half a m^2")
        self.assertGreater(info["counts"]["blades"], blades + 10000, "the band's")
        self.assertEqual(info["grass"], "bezier")
        self.assertEqual([s["shape"] for s in info["surfaces"]], ["moebius", "mesh"])
        self.assertEqual(info["surfaces"][1]["triangles"], 1)
        text = self.expect(DONE, "info", path).stdout
        self.assertIn("1 (band): moebius of 6 m, 1500 blades per m^2", text)
        self.assertIn("3: 12 m over the ground", text)
        self.assertIn("2: mesh hill.gltf, 1 triangle,", text)

    def test_info_tells_the_textures_of_shell_grass(self):
        path = self.folder / "shells.wind.json"
        project = {"format": "windloom-project", "version": 1, "field": {"size": [50, 20], "resolution": [100, 40]},
                   "grass": {"kind": "shell", "density": 20},
                   "shell": {"shells": 6, "texture": {"texels": 256, "tile": 2, "fullness": 4}}}
        path.write_text(json.dumps(project), encoding="utf-8")
        info = json.loads(self.expect(DONE, "info", path, "--json").stdout)
        self.assertEqual(info["grass"], "shell")
        levels = [256 >> i for i in range(5)]
        self.assertEqual(info["bytes"]["shellTextures"], 2 * 4 * sum(side * side for side in levels))
        self.assertAlmostEqual(info["counts"]["blades"], 50 * 20 * 20 * 4, delta=0.05 * 80000)
        self.assertIn("6 shells, 0.7 MB of textures that repeat every 2 m", self.expect(DONE, "info", path).stdout)
        project["shell"]["texture"]["file"] = "lost.png"
        path.write_text(json.dumps(project), encoding="utf-8")
        self.assertIn("/shell/texture/file", self.expect(BAD_INPUT, "validate", path).stderr, "the lost picture is told")

    def test_info_of_a_project_without_points(self):
        path = self.folder / "empty.wind.json"
        self.expect(DONE, "new", path, "--template", "empty")
        self.assertNotIn("extent", json.loads(self.expect(DONE, "info", path, "--json").stdout))
        self.expect(DONE, "info", path)

    def test_docs_writes_schema_and_parameters(self):
        self.expect(DONE, "docs", self.folder)
        self.assertIn("properties", json.loads((self.folder / "project.schema.json").read_text(encoding="utf-8")))
        self.assertIn("| strength |", (self.folder / "parameters.md").read_text(encoding="utf-8"))

    def test_paths_with_blanks_and_umlauts(self):
        path = self.folder / "große Wiese.wind.json"
        self.expect(DONE, "new", path)
        self.assertEqual(json.loads(self.expect(DONE, "info", path, "--json").stdout)["file"], str(path))


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("windloom", "broken"):
        parser.add_argument(f"--{option}", required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
