"""The real editor, used for long by a scripted hand: it draws, drags, copies, undoes, scrubs, switches kinds of grass, solvers,
projects and panels, resizes the window, exports and shares (endurance_acts.py). All the while it is checked that OpenGL has no
error, that wind and camera are finite, that what is saved is valid, that undoing everything gives the first bytes and redoing
everything the last, that the window answers, and that memory, looked at in one same state again and again, doesn't grow.

usage: endurance.py WINDLOOM_EDITOR WINDLOOM SECONDS [SEED] [--samples FILE.csv] [--keep FOLDER]
First every project is opened once with every kind of grass, so that what is made once and kept is there (a short run opens
two). Then the first ten minutes, of a shorter run its first half, are for caches to fill; after them resident memory, heap and OpenGL's
memory may grow by 5%. A run of under five minutes is too short for that, as the driver still compiles what is used for the first
time: of it only OpenGL's memory is judged, as the program counts it.
"""
import argparse
import csv
import json
import math
import pathlib
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

import endurance_acts as acts
from editor_driver import Failure, check, display, editor, run

PROJECTS = pathlib.Path(__file__).resolve().parents[2] / "projects"
WINDOW = (1280, 800)
GROWTH, SHORT_GROWTH, SHORT_S = 0.05, 0.30, 300
MOST_SPEED = 1000  # m/s: whatever was drawn, the air is slower
# What the log may call an error because the hands asked for it.
TOLERATED = ("cancelled",)
REFERENCE = {
    "format": "windloom-project", "version": 1, "name": "Reference",
    "field": {"centre": [0, 0], "size": [60, 60], "resolution": [128, 128]},
    "grass": {"density": 10}, "ambient": {"speed": 3, "direction": 20},
    "graph": {"points": [{"id": 1, "position": [-20, 0]}, {"id": 2, "position": [10, 4]}],
              "arrows": [{"id": 11, "from": 1, "to": 2}]},
    "probes": [{"id": 40, "position": [0, 0]}],
}
LIGHT = ["rolling-ball", "colliding-winds"]  # for the short form
COLUMNS = ["seconds", "acts", "resident", "heap", "gpu", "frames", "longest_frame_ms", "last_project"]


class Endurance:
    def __init__(self, app, windloom, folder, seconds, seed):
        self.app, self.windloom, self.folder, self.seconds, self.seed = app, windloom, folder, seconds, seed
        self.start = time.monotonic()
        self.samples, self.labels, self.counts, self.names = [], [], {}, []
        self.acts, self.round_trips, self.saves, self.opened, self.log_at = 0, 0, 0, 0, 0
        self.slowest = (0, "")
        self.reference = folder / "reference.wind.json"
        self.projects = sorted(path.name for path in PROJECTS.iterdir() if path.is_dir())

    def passed(self):
        return time.monotonic() - self.start

    def hands(self, salt=""):
        return acts.Hands(self.app, random.Random(f"{self.seed}/{self.acts}{salt}"))

    # What must hold after every act

    def look(self, what):
        facts = self.app.read_map()[0]
        check(facts.get("health.gl errors") == "0", f"after {what}: OpenGL: {facts.get('health.gl last')}")
        if facts.get("wind"):
            wind = float(facts["wind"])
            check(math.isfinite(wind) and 0 <= wind < MOST_SPEED, f"after {what}: wind of {wind} m/s")
            check(facts["health.cells reset"] == "0", f"after {what}: {facts['health.cells reset']} cells were not finite")
        check(all(math.isfinite(float(part)) for part in facts["camera"].split()), f"after {what}: camera {facts['camera']}")
        longest = float(facts["health.longest frame"])
        if longest > self.slowest[0]:
            self.slowest = (longest, what)
        self.read_log(what)

    def read_log(self, what):
        with open(self.app.log_file, errors="replace") as log:
            log.seek(self.log_at)
            text = log.read()
            whole = text[:text.rfind("\n") + 1]
            self.log_at += len(whole.encode())
        for line in whole.splitlines():
            wrong = line.startswith("error: ") or "Sanitizer" in line or "runtime error" in line
            check(not wrong or any(word in line for word in TOLERATED), f"after {what}: {line}")

    def tidy(self, what):
        check(acts.drop_dialogs(self.hands("tidy")), f"after {what}: a dialog stays: {self.app.read_map()[0]}")

    # Files

    def open(self, path):
        """Another project, without saving the one before."""
        self.tidy("opening")
        before = self.app.fact("health.opened")
        self.app.key("ctrl+o")

        self.app.wait("a dialog", lambda: self.app.fact("dialog") != "", acts.FRAME_PATIENCE_S)
        if self.app.fact("dialog") == "save changes":
            self.app.press("dialog/Don't save")
        self.app.wait("the open dialog", lambda: self.app.fact("dialog") == "open", acts.FRAME_PATIENCE_S)
        self.app.choose_path(path)
        self.app.wait(f"{path.name} to be open", lambda: self.app.fact("health.opened") != before and
                      self.app.fact("title").startswith(path.name), acts.FRAME_PATIENCE_S)
        self.opened += 1
        self.look(f"opening {path.name}")

    def open_sample(self, name):
        copy = self.folder / name
        if copy.exists():
            shutil.rmtree(copy)
        shutil.copytree(PROJECTS / name, copy)
        self.open(copy / f"{name}.wind.json")
        return copy / f"{name}.wind.json"

    def save(self, path):
        """Its bytes; they must be a valid project."""
        self.tidy("saving")
        before = path.stat()  # what is clean is written as well, so that "not dirty" tells nothing
        self.app.key("ctrl+s")
        self.app.wait("the project to be saved", lambda: path.stat().st_ino != before.st_ino or self.app.fact("dialog") != "",
                      acts.FRAME_PATIENCE_S)
        self.app.wait_fact("dirty", "no")
        check(self.app.fact("dirty") == "no", f"not saved: {self.app.read_map()[0]}")
        told = subprocess.run([self.windloom, "validate", str(path)], capture_output=True, text=True)
        check(told.returncode == 0, f"an invalid project was saved: {told.stdout}{told.stderr}")
        self.saves += 1
        return path.read_bytes()

    def walk_history(self, key, end):
        """To a step, by no more presses than lead there: there may be steps behind it that were undone before."""
        def there():
            at = self.app.fact("steps")
            if int(at) == end:
                return True
            self.app.key(*[key] * min(10, abs(end - int(at))))
            self.app.wait("the history to move", lambda: self.app.fact("steps") != at, acts.FRAME_PATIENCE_S)
            self.app.wait("the history to rest", self.rests("steps"), acts.FRAME_PATIENCE_S)
            return False

        self.app.wait(f"{key} to step {end}", there, acts.FRAME_PATIENCE_S)

    def rests(self, name):
        """Whether a fact is the same for some frames."""
        seen = []

        def same():
            facts = self.app.read_map()[0]
            if not seen or seen[-1][0] != facts[name]:
                seen.append((facts[name], int(facts["frame"])))
            return int(facts["frame"]) >= seen[-1][1] + 8

        return same

    def round_trip(self, path, first):
        """Undoing everything gives the first bytes, redoing everything the last."""
        self.tidy("an edit")
        last = self.save(path)
        steps = int(self.app.fact("steps"))
        if steps == 0:
            return
        self.walk_history("ctrl+z", 0)
        check(self.save(path) == first, f"undoing {steps} steps in {path.name} doesn't give the first bytes")
        self.walk_history("ctrl+shift+z", steps)
        check(self.save(path) == last, f"redoing {steps} steps in {path.name} doesn't give the last bytes")
        self.round_trips += 1
        self.look("undoing and doing again everything")

    # Memory

    def rest(self):
        """The state in which memory is compared: window, look, overlays, project, no export and no link."""
        self.tidy("the acts")
        self.open(self.reference)  # also as its frames are quick: a slow one may swallow what follows
        facts = self.app.read_map()[0]
        if facts.get("status.live"):
            acts.live_link(self.hands("rest"))
        self.app.xdotool("windowsize", self.app.window, *WINDOW)
        self.hands("rest").frames(3)
        acts.end_export(self.hands("rest"))
        keys = {"arrows": "5", "streamlines": "6", "speed": "7", "divergence": "8", "lic": "9"}
        for name in facts["overlays"].split():
            if name in keys:
                self.app.key(keys[name])
            else:
                self.hands("rest").press("toolbar/overlay." + name)
        for command in ("Reset panel sizes", "Interface at 100%"):
            acts.command(self.hands("rest"), command)
        self.app.key("q")
        if facts["loop"] != "off":
            self.app.key("shift+l")
        # Every kind of grass is drawn, then it is opened again: the driver holds on to buffers of the project before until
        # others take their places.
        for key in acts.KINDS_OF_GRASS:
            self.app.key(key)
            acts.Hands(self.app, random.Random(0)).frames(3)
        self.open(self.reference)
        self.app.key("shift+space")
        if self.app.fact("playing") != "yes":
            self.app.key("space")
        self.app.press("inspector/tab/Selection")
        self.app.press("notes/tab/Probes")
        self.app.wait("the reference to play", lambda: float(self.app.fact("time") or 0) > 2.5, acts.FRAME_PATIENCE_S)

    def sample(self):
        self.rest()
        facts = self.app.read_map()[0]
        status = pathlib.Path(f"/proc/{self.app.process.pid}/status").read_text()
        resident = next(int(line.split()[1]) * 1024 for line in status.splitlines() if line.startswith("VmRSS:"))
        self.samples.append(dict(zip(COLUMNS, [round(self.passed(), 1), self.acts, resident, int(facts["health.heap bytes"]),
                                               int(facts["health.gpu bytes"]), int(facts["frame"]),
                                               float(facts["health.longest frame"]), self.names[-1] if self.names else ""])))
        self.labels.append({name: int(value) for name, value in facts.items() if name.startswith("gpu.")})
        print(" ".join(f"{name}={value}" for name, value in self.samples[-1].items()), self.changed_labels() or "", flush=True)

    def growth(self, name):
        """Of what is used at the end over what was used once caches were full: medians of some samples each, as one may have
        met the machine at another moment."""
        settled = [sample[name] for sample in self.samples if sample["seconds"] >= min(self.seconds / 2, 600)]
        settled = settled if len(settled) > 1 else [sample[name] for sample in self.samples]
        few = max(1, len(settled) // 4)
        return statistics.median(settled[-few:]) / statistics.median(settled[:few]) - 1

    def changed_labels(self):
        """What of OpenGL's memory is not as it was at the first look."""
        first, last = self.labels[0], self.labels[-1]
        return {name: (first.get(name, 0), last.get(name, 0)) for name in sorted(first | last) if first.get(name) != last.get(name)}

    # The run

    def warm_up(self):
        """Everything that is made once and kept is made now: the programs of each kind of grass, tables, fonts."""
        for name in self.projects if self.seconds >= SHORT_S else LIGHT:
            self.open_sample(name)
            self.app.wait_fact("scene", "yes")
            for key in acts.KINDS_OF_GRASS:
                self.app.key(key)
                acts.Hands(self.app, random.Random(0)).frames(2)
            self.app.key(acts.KINDS_OF_GRASS[0])
            for key in "5678967895":
                self.app.key(key)
                acts.Hands(self.app, random.Random(0)).frames(1)

    def segment(self, name, seconds):
        """A visit to a project."""
        self.names.append(name)
        path = self.open_sample(name)
        first = self.save(path)
        end = time.monotonic() + seconds
        deeds, weights = zip(*acts.ACTS)
        while time.monotonic() < end:
            self.acts += 1
            hands = self.hands()
            deed = hands.dice.choices(deeds, weights)[0]
            self.counts[deed.__name__] = self.counts.get(deed.__name__, 0) + 1
            what = f"act {self.acts} ({deed.__name__} in {name})"
            try:
                deed(hands)
                self.tidy(what)
            except Failure as failure:
                raise Failure(f"{what}: {failure}") from None
            self.look(what)
        self.round_trip(path, first)

    def run(self):
        self.warm_up()
        self.start = time.monotonic()
        self.sample()
        dice = random.Random(self.seed)
        order = []
        visit_s = 30 if self.seconds >= SHORT_S else 8
        while self.passed() < self.seconds:
            if not order:
                order = dice.sample(self.projects, len(self.projects)) if self.seconds >= SHORT_S else LIGHT[:]
            self.segment(order.pop(), visit_s)
            self.sample()
        self.judge()

    def judge(self):
        short = self.seconds < SHORT_S
        for name in ("gpu",) if short else ("resident", "heap", "gpu"):
            grown, most = self.growth(name), SHORT_GROWTH if short else GROWTH
            check(grown <= most, f"{name} memory grew by {grown:.1%}, more than {most:.0%}: {[s[name] for s in self.samples]}; "
                                 f"labels: {self.changed_labels()}")

    def summary(self):
        used = " ".join(f"{name}={count}" for name, count in sorted(self.counts.items()))
        last = self.samples[-1] if self.samples else dict.fromkeys(COLUMNS, 0)
        grown = {name: f"{self.growth(name):+.1%}" for name in ("resident", "heap", "gpu")} if len(self.samples) > 2 else {}
        return (f"seed {self.seed}: {self.passed():.0f} s, {self.acts} acts ({used}), {self.opened} projects opened, {self.saves} saves, "
                f"{self.round_trips} histories walked back and forth, {last['frames']} frames, slowest {self.slowest[0]:.0f} ms "
                f"({self.slowest[1]}), growth {json.dumps(grown)}, resident at the end {last['resident'] / 1e6:.0f} MB")


def options():
    parser = argparse.ArgumentParser()
    parser.add_argument("editor")
    parser.add_argument("windloom")
    parser.add_argument("seconds", type=float)
    parser.add_argument("seed", nargs="?", type=int, default=1)
    parser.add_argument("--samples", type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path, help="where the log and the last files go when it fails")
    return parser.parse_args()


def write_samples(file, samples):
    with open(file, "w", newline="") as out:
        writer = csv.DictWriter(out, COLUMNS)
        writer.writeheader()
        writer.writerows(samples)


def main():
    chosen = options()
    with tempfile.TemporaryDirectory(prefix="windloom-endurance-") as name, display("1400x900") as environment:
        folder = pathlib.Path(name)
        (folder / "reference.wind.json").write_text(json.dumps(REFERENCE))
        environment["WINDLOOM_GL_DEBUG"] = "1"
        size = f"{WINDOW[0]}x{WINDOW[1]}"
        with editor(chosen.editor, environment, folder, str(folder / "reference.wind.json"), size=size) as app:
            app.wait_fact("scene", "yes")
            endurance = Endurance(app, chosen.windloom, folder, chosen.seconds, chosen.seed)
            try:
                endurance.run()
                app.key("ctrl+q")
                check(app.wait_end() == 0, "closing the reference must end the editor with 0")
                endurance.read_log("the end")
            except BaseException:
                if chosen.keep:
                    app.kill()
                    shutil.copytree(folder, chosen.keep, dirs_exist_ok=True)
                raise
            finally:
                if chosen.samples:
                    write_samples(chosen.samples, endurance.samples)
                print(endurance.summary(), flush=True)


if __name__ == "__main__":
    run(main)
