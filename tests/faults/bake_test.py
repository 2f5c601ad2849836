"""Bakes killed at system calls, and with calls failing in turn.

What must hold: every file that a manifest lists is there with its checksum; a bake that fails says why, exits with 3 and
leaves the older bake as it was byte for byte; the next bake into the folder succeeds and leaves nothing of the one before.
"""
import json

from fault_runs import ERRORS, LONG, WINDLOOM, calls_of, check, folder, killed, main, project_in, run, sha256, tree

# Few cells and frames: what counts here are the calls.
FORMATS = ["npy,png"] + (["png16,exr,dds", "atlas,ktx2,windpack", "vf,fga"] if LONG else [])
POINTS = 1000000 if LONG else 10  # at most, spread over a run
PRESETS = ("unity", "unreal")     # their frames differ, and so do the files beside them


def words(place, formats, preset, *more):
    return [WINDLOOM, "bake", place / "mine.wind.json", "--backend", "cpu", "--out", place / "out", "--format", formats,
            "--steps", 6, "--preset", preset, *(more or ("--fps", 20))]


def whole(out, where):
    """True for a bake, false for none; fails for what calls itself one and is not."""
    manifest = out / "manifest.json"
    if not manifest.exists():
        return False
    for entry in json.loads(manifest.read_text())["files"]:
        check((out / entry["path"]).exists() and sha256(out / entry["path"]) == entry["sha256"],
              f"{where}: {entry['path']} is not what the manifest says")
    return True


def spread(last, slant=0.5):
    """Numbers of calls; with a slant below 1 more of them near the end, where files are moved to their places."""
    points = min(last, POINTS)
    return sorted({max(1, round(last * ((i + 1) / points) ** slant)) for i in range(points)} if points < last
                  else range(1, last + 1))


class Scene:
    """A folder with a bake of the first preset; a bake of the second comes over it."""
    def __init__(self, place, formats):
        self.place, self.formats, self.out = place, formats, place / "out"
        project_in(place)
        done = run(words(place, formats, PRESETS[0]), place)
        check(done.returncode == 0 and whole(self.out, "the first bake"), str(done))
        self.first = tree(self.out)

    def again(self, **faults):
        return run(words(self.place, self.formats, PRESETS[1]), self.out, **faults)

    def reset(self, where):
        """Back to the first bake by baking it: it must come out as it did, with nothing else beside it."""
        done = run(words(self.place, self.formats, PRESETS[0]), self.place)
        check(done.returncode == 0, f"the bake after {where}: {done}")
        check(tree(self.out) == self.first, f"the bake after {where} left {set(tree(self.out)) ^ set(self.first)}")


def last_call(scene):
    calls, done = calls_of(words(scene.place, scene.formats, PRESETS[1]), scene.out)
    check(done.returncode == 0, str(done))
    scene.reset("counting")
    return calls[-1].number


def kill_bakes():
    states, points = {True: 0, False: 0}, 0
    for formats in FORMATS:
        with folder() as place:
            scene = Scene(place, formats)
            for at in spread(last_call(scene)):
                where = f"{formats}, killed at call {at}"
                done = scene.again(at=at, do="kill")
                # Threads take turns: another run may make a few calls less.
                check(killed(done) or done.returncode == 0, f"{where}: {done}")
                states[whole(scene.out, where)] += 1
                scene.reset(where)
                points += 1
    check(states[True] > 0 and states[False] > 0, f"{states}: some kills must fall between the two manifests")
    return f"{points} kills: {states[True]} left a whole bake, {states[False]} none, the next bake was whole and alone each time"


def fail_bakes():
    runs = refused = 0
    for formats in FORMATS:
        with folder() as place:
            scene = Scene(place, formats)
            for number, at in enumerate(spread(last_call(scene), 0.9)):
                for error in [list(ERRORS)[number % len(ERRORS)]]:
                    where = f"{formats}, {error} at call {at}"
                    done = scene.again(at=at, do=error)
                    runs += 1
                    if done.returncode == 0:
                        check(whole(scene.out, where), f"{where}: no bake")
                        scene.reset(where)
                        continue
                    refused += 1
                    check(done.returncode == 3, f"{where}: {done}")
                    check(ERRORS[error] in done.stderr and str(scene.out) in done.stderr, f"{where}: {done.stderr}")
                    left = {name for name in tree(scene.out) if not name.startswith(".bake.windloom.")}
                    check(left == set(scene.first), f"{where}: left {left ^ set(scene.first)}")
                    check(all(sha256(scene.out / name) == scene.first[name] for name in left), f"{where}: changed")
                for deed in ("EINTR", "short") if number % 4 == 0 else ():
                    done = scene.again(at=at, do=deed)
                    check(done.returncode in ((0, 3) if deed == "EINTR" else (0,)), f"{formats}, {deed} at {at}: {done}")
                    scene.reset(deed)
                    runs += 1
    check(refused >= 1, f"only {refused} of {runs} failed")
    return f"{runs} faults, {refused} refused with a message, the older bake byte for byte as it was"


def parts():
    """A bake in two ranges, the second killed: the first is not lost, and the whole comes about in the end."""
    with folder() as place:
        project_in(place)
        out = place / "out"
        # 6 steps at 60 a second are 0.1 s: frames 0 to 6
        halves = [words(place, "png", "unity", "--vmax", 30, "--fps", 60, "--frames", part) for part in ("0-2", "3-6")]
        calls, done = calls_of(halves[0], place)
        check(done.returncode == 0, str(done))
        with folder() as aside:
            project_in(aside)
            for part in ("0-2", "3-6"):
                run(words(aside, "png", "unity", "--vmax", 30, "--fps", 60, "--frames", part), aside)
            expected = tree(aside / "out")
            check("manifest.json" in expected, "the two ranges are the whole")
        calls, done = calls_of(halves[1], out)
        last, points = calls[-1].number, 0
        for at in spread(last):
            for path in sorted(out.rglob("*"), reverse=True):
                path.rmdir() if path.is_dir() else path.unlink()
            run(halves[0], place)
            done = run(halves[1], out, at=at, do="kill")
            check(killed(done) or done.returncode == 0, f"killed at {at}: {done}")
            whole(out, f"parts killed at {at}")
            done = run(halves[1], place)
            check(done.returncode == 0, f"after {at}: {done}")
            check(whole(out, f"after {at}"), f"killed at {at}: the ranges don't make a whole: {tree(out)}")
            check(tree(out) == expected, f"after {at}: left {set(tree(out)) ^ set(expected)}")
            points += 1
    return f"{points} kills of a range: the other range was kept and the whole came about"


def without_locks():
    """File systems that lock no folders, and some that lock nothing."""
    with folder() as place:
        scene = Scene(place, "npy,png")
        for error in ("EBADF", "ENOLCK"):
            done = scene.again(calls="flock", at=1, do=error, again=True)
            check(done.returncode == 0 and "can't be locked" in done.stderr, f"{error}: {done}")
            check(whole(scene.out, error), f"{error}: no bake")
            left = {name for name in tree(scene.out) if name.startswith(".")}
            check(left == {".bake.windloom.lock"}, f"{error}: left {left}")
        (scene.out / ".bake.windloom.lock").unlink()
        scene.reset("bakes without locks")
    return "2 bakes were whole, and warned"


main(kill_bakes, fail_bakes, parts, without_locks)
