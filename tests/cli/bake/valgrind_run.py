"""The command line under valgrind: no read of memory that isn't ours or was never written, and nothing lost at the end."""
import os
import pathlib
import re
import shutil
import subprocess
import unittest

import harness
from harness import WINDLOOM

PROJECTS = pathlib.Path(__file__).parents[3] / "projects"
BROKEN = pathlib.Path(__file__).parents[2] / "data" / "broken"
FOUND, LOST = 99, ("definitely lost", "indirectly lost")


class Valgrind(harness.Case):
    def watched(self, *arguments, status=0):
        """Runs `windloom ARGUMENTS` under valgrind, which makes its exit status 99 when it finds something."""
        log = self.folder / "valgrind.txt"
        done = subprocess.run(
            ["valgrind", f"--error-exitcode={FOUND}", "--leak-check=full", "--show-leak-kinds=definite",
             "--errors-for-leak-kinds=definite", "--num-callers=30", f"--log-file={log}", WINDLOOM, *map(str, arguments)],
            capture_output=True, text=True, env={**os.environ, "WINDLOOM_DATA": str(PROJECTS.parent)})
        told = log.read_text()
        self.assertEqual(done.returncode, status, f"{arguments}: {done.stderr}{told}")
        self.assertIn("ERROR SUMMARY: 0 errors", told)
        for kind in LOST:
            bytes_lost = re.search(kind + r": ([\d,]+) bytes", told)
            self.assertTrue(bytes_lost is None or bytes_lost[1] == "0", f"{arguments}: {told}")

    def test_projects_are_written_and_read(self):
        for template in ("empty", "canyon-funnel"):
            self.watched("new", self.folder / f"{template}.wind.json", "--template", template)
        self.watched("validate", *sorted(PROJECTS.glob("*/*.wind.json")))
        self.watched("info", PROJECTS / "flowers" / "flowers.wind.json", "--json")

    def test_broken_projects_are_refused(self):
        self.watched("validate", *sorted(BROKEN.glob("*.wind.json")), status=1)

    def test_wind_is_sampled(self):
        self.watched("sample", self.project, "--backend", "cpu", "--at", "4,-2", "--time", 0.2, "--json")

    def test_every_format_is_baked(self):
        formats = [line.split()[0] for line in self.call("bake", "--list-formats").stdout.splitlines()]
        self.assertGreater(len(formats), 10)
        self.watched("bake", self.project, "--backend", "cpu", "--out", self.folder / "all", "--seconds", 0.3, "--fps", 10,
                     "--resolution", "16x10", "--loop", "--response", "--format", ",".join(formats))

    def test_wrong_usage_is_told(self):
        for wrong in (["bake"], ["sample", self.project, "--at", "x"], ["nothing"], ["new", "--template", "nothing"]):
            self.watched(*wrong, status=2)


if shutil.which("valgrind") is None:
    raise SystemExit("valgrind is not installed")
harness.main()
