"""kill -9 at random moments: an editor without a window that edits, saves and autosaves without a pause, and bakes.

tests/ui/kill_test.py does the same, more slowly, to the editor with its window.
"""
import json
import random
import subprocess
import time

from fault_runs import (LONG, SAVE_LOOP, WINDLOOM, check, facts, folder, probes_of, project_in, run, sha256, temporaries)

EDITORS, BAKES = (450, 150) if LONG else (40, 12)
MOST_LOST = 25  # edits


def life(dice, file, side):
    """Runs an editor for a random while; what it told last of each thing."""
    with open(file.parent / "told", "w+") as told:
        child = subprocess.Popen([SAVE_LOOP, "loop", file, side, str(dice.randrange(1 << 30))], stdout=told)
        time.sleep(0.02 + dice.random() * 0.15)
        child.kill()
        ended = child.wait()
        told.seek(0)
        lines = told.read().splitlines()
        check(ended == -9, f"it must run until it is killed: {ended} {lines[-2:]}")
    return {line.split()[0]: int(line.split()[-1]) for line in lines if len(line.split()) == 2}


def editors():
    rescued = 0
    with folder() as place:
        file, side = project_in(place), place / "side"
        for number in range(EDITORS):
            dice = random.Random(number)
            before = time.time_ns() - 20_000_000  # files have the time of the last tick of the clock
            told = life(dice, file, side)
            found = probes_of(file)
            check(found >= told.get("saved", 0), f"{number}: {told} but the file has {found}")
            backup = file.with_name(file.name + ".bak")
            check(not backup.exists() or probes_of(backup) > 0, f"{number}: a torn backup")
            sides = list(side.glob("*.rescue.json"))
            own = [path for path in sides if path.stat().st_mtime_ns >= before]
            kept = max([len(json.loads(json.loads(path.read_text())["project"])["probes"]) for path in own] + [found])
            check(told.get("edited", 0) - kept <= MOST_LOST, f"{number}: {told}, kept {kept}: {sorted(side.iterdir())}")
            if sides and dice.random() < 0.5:
                done = run([SAVE_LOOP, "rescue", side, file], place)
                check("rescue" in facts(done) and "failed" not in done.stdout, f"{number}: {done}")
                check(not list(side.glob("*.rescue.json")), f"{number}: the rescued file stays")
                rescued += 1
            if probes_of(file) > 500:  # a project holds a limited number
                project_in(place)
                for path in [backup, *side.iterdir()]:
                    path.unlink()
            names = {path.name for path in place.iterdir()} - {"told", "side", file.name, file.name + ".bak"}
            # One of each life since the last that came to save.
            check(len(names) <= 12 and len(list(side.iterdir())) <= 60, f"{number}: leftovers grow: {names}")
        run([SAVE_LOOP, "save", file], place)
        run([SAVE_LOOP, "autosave", file, side], place)
        check(not temporaries(place), f"left after all: {temporaries(place)}")
    return f"{EDITORS} kills, every file whole and every promise kept; {rescued} rescues"


def bakes():
    """Several formats, and every time over what the one before left."""
    states = {True: 0, False: 0}
    with folder() as place:
        file, out = project_in(place), place / "out"
        for number in range(BAKES):
            dice = random.Random(number)
            words = [WINDLOOM, "bake", file, "--backend", "cpu", "--out", out, "--preset", dice.choice(("unity", "unreal")),
                     "--format", dice.choice(("npy,png", "exr,dds,atlas", "windpack,vf", "png16,ktx2,fga")),
                     "--seconds", 1, "--fps", 20]
            words = [str(word) for word in words]
            started = time.monotonic()
            if number == 0:
                subprocess.run(words, check=True, capture_output=True)
                length = time.monotonic() - started
            child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            time.sleep(length * (0.1 + 1.1 * dice.random() ** 0.5))
            child.kill()
            child.wait()
            there = (out / "manifest.json").exists()
            states[there] += 1
            for entry in json.loads((out / "manifest.json").read_text())["files"] if there else ():
                check(sha256(out / entry["path"]) == entry["sha256"], f"{number}: {entry['path']}")
            hidden = list(out.glob(".bake*"))
            check(len(hidden) <= 1, f"{number}: leftovers grow: {hidden}")
        done = subprocess.run(words, capture_output=True, text=True)
        check(done.returncode == 0, f"the last bake: {done}")
        listed = {entry["path"] for entry in json.loads((out / "manifest.json").read_text())["files"]}
        found = {path.name for path in out.iterdir()} - {"manifest.json"}
        check(found == listed, f"left after all: {found ^ listed}")
    return f"{BAKES} kills: {states[True]} left a whole bake, {states[False]} none; the last bake stands alone"


if __name__ == "__main__":
    for test in (editors, bakes):
        print(f"{test.__name__}: {test()}", flush=True)
