"""What the scripts here share: running a program under the preloaded library (faults.c), and what must hold of the
files that are left.

usage: NAME_test.py WINDLOOM SAVE_LOOP FAULTS_LIBRARY [long]
"""
import contextlib
import hashlib
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile

WINDLOOM, SAVE_LOOP, LIBRARY = sys.argv[1:4]
LONG = sys.argv[4:] == ["long"]
ERRORS = {"ENOSPC": "No space left on device", "EACCES": "Permission denied", "EIO": "Input/output error",
          "EDQUOT": "Disk quota exceeded"}
TEMPORARY = re.compile(r"\..*\.[a-zA-Z0-9]{6}\.windloom")

PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Faults",
    "field": {"centre": [0, 0], "size": [32, 20], "resolution": [24, 15]},
    "ambient": {"speed": 1.5, "direction": 30},
    "graph": {
        "points": [{"id": 1, "position": [-4, -4]}, {"id": 2, "position": [6, -1]}],
        "arrows": [{"id": 10, "from": 1, "to": 2, "strength": 9, "radius": 3, "travelSpeed": 60}]},
    "grass": {"density": 1},
    "probes": [{"id": 40, "name": "first", "position": [0, 0]}],
}


def check(holds, message):
    if not holds:
        raise AssertionError(message)


@contextlib.contextmanager
def folder():
    with tempfile.TemporaryDirectory(prefix="windloom-faults-") as name:
        yield pathlib.Path(name).resolve()


def project_in(place, name="mine.wind.json"):
    file = place / name
    file.write_text(json.dumps(PROJECT))
    return file


def environment(place, calls=None, at=0, do=None, again=False, log=None):
    """For a child whose calls on `place` are hit, see faults.c."""
    settings = {"LD_PRELOAD": LIBRARY, "FAULTS_FOLDER": place, "FAULTS_CALLS": calls, "FAULTS_AT": at, "FAULTS_DO": do,
                "FAULTS_AGAIN": int(again), "FAULTS_LOG": log}
    sanitizer = os.environ.get("ASAN_OPTIONS", "")
    return {**os.environ, **{key: str(value) for key, value in settings.items() if value is not None},
            "ASAN_OPTIONS": f"{sanitizer}:verify_asan_link_order=0:detect_leaks=0"}


def run(command, place, timeout=120, **faults):
    return subprocess.run([str(word) for word in command], env=environment(place, **faults), capture_output=True,
                          text=True, timeout=timeout)


class Call:
    """A line of the library's log."""
    def __init__(self, line):
        number, self.name, result, self.first, self.second = line.split("\t")
        self.number, self.result = int(number), int(result)


def calls_of(command, place):
    """All calls on the folder of a run without faults, and the run."""
    with folder() as aside:
        log = aside / "calls"
        done = run(command, place, log=log)
        text = log.read_text() if log.exists() else ""
    return [Call(line) for line in text.splitlines()], done


def killed(done):
    return done.returncode == -signal.SIGKILL


def facts(done):
    """Lines of save_loop by their first word; the last of each."""
    return dict((line.split(" ", 1) + [""])[:2] for line in done.stdout.splitlines())


def probes_of(file):
    """The number of probes of a whole project; fails for a torn one."""
    return len(json.loads(file.read_text())["probes"])


def temporaries(place):
    return [path for path in place.rglob("*") if TEMPORARY.fullmatch(path.name)]


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


def tree(place):
    return {str(path.relative_to(place)): sha256(path) for path in sorted(place.rglob("*")) if path.is_file()}


def main(*tests):
    for test in tests:
        print(f"{test.__name__}: {test()}", flush=True)
