#!/usr/bin/env python3
"""What `windloom` says to people who mistyped or took a word for another, and how it counts."""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PATIENCE = int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))
DONE, BAD_INPUT, USAGE = 0, 1, 2
VERBS = "new, validate, info, sample, bake, render, bench, edit"
PROJECT = {"format": "windloom-project", "version": 1, "name": "One of each",
           "field": {"size": [16, 16], "resolution": [16, 16], "timeStep": 0.05}, "ambient": {"speed": 2},
           "grass": {"density": 1},
           "graph": {"points": [{"id": 1, "position": [0, 0]}, {"id": 2, "position": [4, 0]}],
                     "arrows": [{"id": 11, "from": 1, "to": 2}], "signals": [{"root": 1, "kind": "pulse"}]},
           "probes": [{"id": 40, "position": [1, 1]}]}


class Messages(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        (self.folder / "my.wind.json").write_text(json.dumps(PROJECT), encoding="utf-8")

    def say(self, status, *arguments):
        """Runs `windloom ARGUMENTS` in the folder; the finished process."""
        done = subprocess.run([OPTIONS.windloom, *map(str, arguments)], capture_output=True, text=True, encoding="utf-8",
                              timeout=60 * PATIENCE, cwd=self.folder)
        self.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}\n{done.stderr}")
        return done

    def told(self, message, *arguments, status=USAGE):
        """`message` is the first line on standard error."""
        done = self.say(status, *arguments)
        self.assertEqual(done.stderr.splitlines()[0], "windloom: " + message, arguments)
        self.assertEqual(done.stdout, "")

    # Verbs and options

    def test_a_word_that_is_no_verb(self):
        self.told(f"'redner' is no verb; did you mean render? Verbs: {VERBS}", "redner", "my.wind.json")
        self.told(f"'bak' is no verb; did you mean bake? Verbs: {VERBS}", "bak")
        self.told(f"'frobnicate' is no verb. Verbs: {VERBS}", "frobnicate")
        self.told(f"'redner' is no verb; did you mean render? Verbs: {VERBS}", "redner", "info", "my.wind.json")
        self.told(f"expected a verb: {VERBS}")
        errors = json.loads(self.say(USAGE, "redner", "--json").stdout)["errors"]
        self.assertIn("did you mean render?", errors[0]["message"])

    def test_help_is_a_word_too(self):
        self.assertEqual(self.say(DONE, "help").stdout, self.say(DONE, "--help").stdout)
        self.assertEqual(self.say(DONE, "help", "render").stdout, self.say(DONE, "render", "--help").stdout)
        self.told(f"'redner' is no verb; did you mean render? Verbs: {VERBS}", "help", "redner")

    def test_a_project_in_the_place_of_the_verb(self):
        self.told(f"'my.wind.json' is no verb; to open it: windloom edit my.wind.json. Verbs: {VERBS}", "my.wind.json")
        self.told(f"'my one.wind.json' is no verb; to open it: windloom edit 'my one.wind.json'. Verbs: {VERBS}",
                  "my one.wind.json")
        self.told("'my.wind.json' stands before the verb: windloom info my.wind.json", "my.wind.json", "info")

    def test_an_unknown_option_is_named(self):
        self.told("no option --versoin; did you mean --version?", "--versoin")
        self.told("no option --output; did you mean --out?", "bake", "my.wind.json", "--output", "b", "--format", "npy")
        self.told("no option --output; did you mean --out?", "bake", "my.wind.json", "--output=b", "--format", "npy")
        self.told("no option --output; did you mean --out?", "render", "my.wind.json", "--output", "b.png")
        self.told("no option --quux", "info", "my.wind.json", "--quux", "7")
        self.told("--allow-outside stands behind the verb: windloom info ... --allow-outside", "--allow-outside", "info", "my.wind.json")

    def test_too_few_and_too_many_words(self):
        self.told("expected FILE: Project file (NAME.wind.json)", "info")
        self.told("expected --out IMG.png", "render", "my.wind.json")
        self.told("--out: expected DIR after it", "bake", "my.wind.json", "--out")
        self.told("--out can be given only once", "bake", "my.wind.json", "--out", "a", "--out", "b")
        self.told("found 'b.wind.json', expected only options there", "info", "my.wind.json", "b.wind.json", "c.wind.json")

    # Values

    def test_lists_that_were_torn(self):
        message = "--format takes one word: separate its values by commas without blanks, --format png,png16"
        bake = ("bake", "my.wind.json", "--out", "o", "--format")
        self.told(message, *bake, "png", "png16")
        self.told(message, *bake, "png,", "png16")
        self.told(message.replace("png,png16", "png,exr,npy"), *bake, "png", "exr", "npy", "--loop")
        self.told(message, "bake", "--format", "png", "png16", "my.wind.json", "--out", "o")
        self.told("--overlay takes one word: separate its values by commas without blanks, --overlay arrows,streamlines",
                  "render", "my.wind.json", "--out", "a.png", "--overlay", "arrows", "streamlines")
        text = self.say(DONE, "bake", "--help").stdout
        self.assertRegex(text, r"--format F\[,F\.\.\.\] +What")
        self.assertNotIn(" ...", self.say(DONE, "render", "--help").stdout)

    def test_a_list_does_not_take_the_file_behind_it(self):
        self.told("--camera: found 'nobody', expected one of above",
                  "render", "--overlay", "arrows", "my.wind.json", "--out", "a.png", "--camera", "nobody")

    def test_names_that_are_not_known(self):
        self.assertIn("--format: found 'tga', expected one of npy, png",
                      self.say(USAGE, "bake", "my.wind.json", "--out", "o", "--format", "tga").stderr)
        self.assertIn("found the scene 'medow', expected one of ", self.say(USAGE, "bench", "medow").stderr)
        self.told("--space: found 'moon', expected one of world, uv", "bake", "my.wind.json", "--space", "moon")

    def test_numbers_that_are_not_whole(self):
        render = ("render", "my.wind.json", "--out", "a.png", "--frames")
        for text in ("1.5", "0", "100001", "x", "0x10", "1e3", "99999999999999999999"):
            self.told(f"--frames: found '{text}', expected a whole number from 1 to 100000", *render, text)
        self.told("--cells: found '1', expected a whole number from 16 to 8192", "bench", "--cells", "64,1")

    def test_a_zero_before_a_number_means_nothing(self):
        self.say(DONE, "bake", "my.wind.json", "--out", "o", "--format", "npy", "--fps", "20", "--steps", "010", "--backend", "cpu")
        self.assertEqual(json.loads((self.folder / "o" / "manifest.json").read_text())["time"]["frames"], 11)

    def test_ranges_are_plain_decimals(self):
        self.told("--seconds: found '0', expected a number from 0.000001 to 1000000", "bake", "my.wind.json", "--seconds", "0")
        made = self.folder / "man"
        made.mkdir()
        self.say(DONE, "docs", "man", "--man")
        texts = {verb: self.say(DONE, verb, "--help").stdout for verb in VERBS.split(", ")}
        texts |= {page.name: page.read_text(encoding="utf-8") for page in made.iterdir()}
        for name, text in texts.items():
            self.assertIsNone(re.search(r"\de[+-]?\d", text), name)
        self.assertIn("S:FLOAT in [0.000001 - 1000000]", texts["bake"])
        self.assertIn("From 0.0001 to 10.", texts["windloom-bake.1"])

    def test_pictures_are_png(self):
        for name in ("a.jpg", "x.exr", "folder/", "a", ".png"):
            self.told(f"--out: found '{name}', expected a name that ends in .png", "render", "my.wind.json", "--out", name)
            self.told(f"--out: found '{name}', expected a name that ends in .png", "render", "my.wind.json", "--out", name,
                      "--frames", "3")
        self.assertIn("none.wind.json", self.say(BAD_INPUT, "render", "none.wind.json", "--out", "A.PNG").stderr)

    def test_density_reaches_what_files_may_have(self):
        self.say(BAD_INPUT, "render", "none.wind.json", "--out", "a.png", "--density", "20000")
        self.told("--density: found '20001', expected a number from 0 to 20000",
                  "render", "my.wind.json", "--out", "a.png", "--density", "20001")
        wide = dict(PROJECT, field={"size": [200, 200], "resolution": [16, 16]})
        (self.folder / "wide.wind.json").write_text(json.dumps(wide), encoding="utf-8")
        self.told("--density 20000: makes 800 million blades on this field, expected at most 200 million",
                  "render", "wide.wind.json", "--out", "a.png", "--density", "20000")

    # Files

    def test_new_adds_the_ending(self):
        for name, file in (("meadow", "meadow.wind.json"), ("gusts v1.2", "gusts v1.2.wind.json"), ("a.wind", "a.wind.json"),
                           ("b.json", "b.json")):
            self.assertEqual(self.say(DONE, "new", name).stdout, f"{file}: written from template meadow\n")
            self.assertTrue((self.folder / file).is_file(), file)
            self.assertIn("--force", self.say(BAD_INPUT, "new", name).stderr)
        self.assertFalse((self.folder / "meadow").exists())
        self.assertEqual(json.loads(self.say(DONE, "new", "c", "--json").stdout)["file"], "c.wind.json")
        for name in ("folder/", ".", ".."):
            self.told(f"found '{name}', expected the name of a file: NAME.wind.json", "new", name)
        self.assertIn("/dev/null: ", self.say(BAD_INPUT, "new", "/dev/null").stderr)

    def test_a_folder_that_does_not_exist(self):
        self.told("nodir/a.wind.json: the folder nodir doesn't exist", "new", "nodir/a.wind.json", status=BAD_INPUT)
        self.told("nodir/a.png: the folder nodir doesn't exist", "render", "my.wind.json", "--out", "nodir/a.png", status=BAD_INPUT)

    # Bakes in parts

    def test_one_number_for_a_range_of_frames(self):
        bake = ("bake", "my.wind.json", "--out", "o", "--backend", "cpu", "--format")
        hint = "; --frames takes a range A-B ({} alone is that one frame); the length is --seconds"
        for format_, frames in (("png", "10"), ("npy", "10"), ("exr", "100"), ("exr", "1.5")):
            line = self.say(USAGE, *bake, format_, "--frames", frames).stderr.splitlines()[-1]
            self.assertTrue(line.endswith(hint.format(frames)), line)
        self.assertNotIn("alone", self.say(USAGE, *bake, "png", "--frames", "10-12").stderr)

    def test_a_part_says_what_is_there_and_where(self):
        bake = ("bake", "my.wind.json", "--out", "o", "--backend", "cpu", "--format", "exr", "--seconds", "1", "--frames")
        first, second = self.say(DONE, *bake, "10").stdout.splitlines()
        self.assertRegex(first, r"^o: 1 file, .* MB: frame 10 of 30 of 16 x 16 cells at 30 a second")
        self.assertRegex(second, r"^part of a bake: frames 0-9, 11-29 are still missing \(2 ranges, counted from 0\); "
                                 r"until then the files wait in o/\.parts-\w+$")
        self.assertTrue((self.folder / second.rpartition(" ")[2] / "wind.0010.exr").is_file())
        first, second = self.say(DONE, *bake, "0-9").stdout.splitlines()
        self.assertRegex(first, r"^o: 10 files, .*: frames 0-9 of 30 of ")
        self.assertIn("frames 11-29 are still missing (1 range, counted", second)
        self.assertIn("frame 29 is still missing (1 range,", self.say(DONE, *bake, "11-28").stdout)
        whole, = self.say(DONE, *bake, "29").stdout.splitlines()
        self.assertRegex(whole, r"^o: \d+ files, .*: 30 frames of ")

    # Counts

    def test_one_is_no_plural(self):
        text = self.say(DONE, "info", "my.wind.json").stdout
        self.assertIn("2 points, 1 arrow, 1 root, 1 signal\n", text)
        self.assertIn("0 obstacles, 0 species, 0 colliders, 0 surfaces, 0 rotors, 1 probe, 0 cameras\n", text)
        self.assertIn(": 1 frame of 16 x 16 cells", self.say(DONE, "bake", "my.wind.json", "--out", "o", "--format", "npy",
                                                             "--steps", "1", "--backend", "cpu").stdout)
        self.assertIn("(1 step, cpu)", self.say(DONE, "sample", "my.wind.json", "--time", "0.05", "--backend", "cpu").stdout)

    def test_a_manual_page_names_itself_once(self):
        (self.folder / "man").mkdir()
        self.say(DONE, "docs", "man", "--man")
        text = (self.folder / "man" / "windloom.1").read_text(encoding="utf-8")
        self.assertIn(".SH NAME\nwindloom \\- wind drawn as trees of arrows, seen in grass, exported for games\n", text)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--windloom", required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
