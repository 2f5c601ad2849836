#!/usr/bin/env python3
"""Checks docs/project.schema.json with an independent validator: every sample and every template must
pass, and every broken file that a schema can tell apart must not."""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import jsonschema

# What a schema can't say: relations between records, text that is no JSON, keys given twice, limits on products.
BEYOND_A_SCHEMA = {
    "bezier-without-gravity", "binary", "collider-key-backwards", "collider-mesh-without-file", "dangling-arrow", "dangling-signal", "duplicate-ids", "duplicate-key", "empty", "id-of-point-and-arrow",
    "id-of-species-and-collider", "id-of-surface-and-rotor", "surface-mesh-without-file", "keys-not-ascending", "map-outside", "shell-picture-outside", "species-mesh-outside",
    "nan", "not-json", "not-utf8", "number-too-large", "periodic-alone", "self-arrow", "too-deep",
    "too-many-blades", "truncated", "twin-arrows", "zero-length-arrow",
}


class SchemaCheck(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        schema = json.loads(pathlib.Path(OPTIONS.schema).read_text(encoding="utf-8"))
        jsonschema.Draft202012Validator.check_schema(schema)
        cls.validator = jsonschema.Draft202012Validator(schema)

    def errors(self, path):
        document = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
        return [f"{path}: {e.json_path}: {e.message}" for e in self.validator.iter_errors(document)]

    def test_samples_pass(self):
        samples = sorted(pathlib.Path(OPTIONS.projects).glob("**/*.wind.json"))
        self.assertGreaterEqual(len(samples), 3)
        for sample in samples:
            self.assertEqual(self.errors(sample), [])

    def test_templates_pass(self):
        command = [OPTIONS.windloom, "new", "--list", "--json"]
        listing = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)
        with tempfile.TemporaryDirectory() as folder:
            for template in listing["templates"]:
                path = pathlib.Path(folder) / f"{template['name']}.wind.json"
                command = [OPTIONS.windloom, "new", path, "--template", template["name"]]
                subprocess.run(command, check=True, capture_output=True)
                self.assertEqual(self.errors(path), [])

    def test_broken_files_fail_where_a_schema_can_tell(self):
        refused = set()
        for path in sorted(pathlib.Path(OPTIONS.broken).glob("*.wind.json")):
            name = path.name.removesuffix(".wind.json")
            if name not in BEYOND_A_SCHEMA:
                self.assertNotEqual(self.errors(path), [], name)
                refused.add(name)
        self.assertGreaterEqual(len(refused), 12)

    def test_the_list_of_what_a_schema_can_not_tell_names_files(self):
        for name in BEYOND_A_SCHEMA:
            self.assertTrue((pathlib.Path(OPTIONS.broken) / f"{name}.wind.json").exists(), name)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    for option in ("schema", "projects", "broken", "windloom"):
        parser.add_argument(f"--{option}", required=True)
    OPTIONS, rest = parser.parse_known_args()
    unittest.main(argv=sys.argv[:1] + rest)
