"""A loss of power at any moment of a save, an autosave and a bake, in a model of a disk.

The preloaded library writes down every call on the files. The model of the disk: bytes of a file are only safe once it was
synced, names (made, moved, removed) once their folder was; what isn't safe may be on the disk or not, each for itself.
After every call all disks that a loss of power could leave are looked at (where many names wait: each prefix of the order in
which they were given, each one missing, each one alone).
"""
import itertools
import json
import pathlib

from fault_runs import LONG, SAVE_LOOP, WINDLOOM, calls_of, check, folder, main, project_in, run


class File:
    """One file's bytes, whatever its name."""
    def __init__(self, old):
        self.old, self.dirty = old, False


class Disk:
    def __init__(self, place):
        self.safe = {str(path): File(True) for path in place.rglob("*") if path.is_file()}  # name to file
        self.now = dict(self.safe)
        self.waiting = []  # (folder, change of names) in their order

    def change(self, name, deed):
        deed(self.now)
        self.waiting.append((str(pathlib.Path(name).parent), deed))

    def take(self, call):
        if call.result < 0:
            return
        name, to = call.first, call.second
        if call.name == "create" and name not in self.now:
            file = File(False)
            self.change(name, lambda names: names.__setitem__(name, file))
        elif call.name in ("write", "ftruncate") and name in self.now:
            self.now[name].dirty = True
        elif call.name in ("rename", "link"):
            file, moves = self.now.get(name), call.name == "rename"
            if file:  # of a folder: the files in it keep their folder in these programs
                self.change(to, lambda names: give(names, name, to, file, moves))
        elif call.name == "unlink":
            self.change(name, lambda names: names.pop(name, None))
        elif call.name == "syncfs":
            self.sync(None)
            for file in self.now.values():
                file.dirty = False
        elif call.name == "fsync":
            if name in self.now:
                self.now[name].dirty = False
            else:
                self.sync(name)

    def sync(self, where):
        for place, deed in self.waiting:
            if where in (None, place):
                deed(self.safe)
        self.waiting = [entry for entry in self.waiting if where not in (None, entry[0])]

    def crashes(self):
        """What may be on the disk after a loss of power now."""
        deeds = [deed for _, deed in self.waiting]
        n = len(deeds)
        if n <= 6:
            kept = itertools.chain.from_iterable(itertools.combinations(range(n), k) for k in range(n + 1))
        else:
            all_of = range(n)
            kept = itertools.chain(([*range(k)] for k in range(n + 1)), ([i for i in all_of if i != k] for k in all_of),
                                   ([k] for k in all_of))
        for choice in kept:
            names = dict(self.safe)
            for index in choice:
                deeds[index](names)
            yield names


def give(names, name, to, file, moves):
    if moves and names.get(name) is file:
        del names[name]
    names[to] = file


def follow(place, command, look):
    """Number of disks that were looked at; `look(names, ended)` says what is wrong with one."""
    disk, seen = Disk(place), 0
    calls, done = calls_of(command, place)
    check(done.returncode == 0, str(done))
    for number, call in enumerate(calls):
        disk.take(call)
        # Only these change what may be lost; a write is looked at with what follows it.
        if call.name not in ("rename", "link", "unlink", "fsync", "syncfs", "create") and number + 1 < len(calls):
            continue
        for names in disk.crashes():
            wrong = look(names, number + 1 == len(calls))
            check(not wrong, f"power lost after call {number + 1} ({call.name} {call.first} {call.second}): {wrong}")
            seen += 1
    return seen


def of_a_file(target, backup=None):
    def look(names, ended):
        file = names.get(str(target))
        if file and file.dirty:
            return f"{target} is torn"
        if ended and (not file or file.old):
            return f"{target} was promised as saved"
        kept = names.get(str(backup))
        return f"{backup} is torn" if kept and kept.dirty else ""
    return look


def saves():
    seen = 0
    with folder() as place:
        file = project_in(place)
        look_more = of_a_file(file, place / "mine.wind.json.bak")

        def look(names, ended):
            return look_more(names, ended) or ("" if str(file) in names else "the project is gone")
        for _ in range(2):  # without and with a backup from before
            seen += follow(place, [SAVE_LOOP, "save", file], look)
    with folder() as place:
        file, side = project_in(place), place / "side"
        seen += follow(place, [SAVE_LOOP, "autosave", file, side], of_a_file(side / "driver.rescue.json"))
    return f"{seen} disks, none with a torn file"


def listed(manifest):
    return [entry["path"] for entry in json.loads(manifest.read_text())["files"]] if manifest.exists() else []


def bake_words(place, formats, preset):
    return [WINDLOOM, "bake", place / "mine.wind.json", "--backend", "cpu", "--out", place / "out", "--format", formats,
            "--steps", 6, "--fps", 20, "--preset", preset]


def bake(formats):
    with folder() as place:
        project_in(place)
        out = place / "out"
        manifest = out / "manifest.json"
        run(bake_words(place, formats, "unity"), place)
        before = listed(manifest)
        with folder() as aside:
            project_in(aside)
            run(bake_words(aside, formats, "unreal"), aside)
            after = listed(aside / "out" / "manifest.json")
        check(len(before) > 1 and len(after) > 1, "both bakes have files")

        def look(names, ended):
            made = names.get(str(manifest))
            if not made:
                return "the bake was promised" if ended else ""
            for name in before if made.old else after:
                file = names.get(str(out / name))
                if not file or file.dirty or file.old != made.old:
                    return f"a manifest over {name}, which is " + ("torn" if file and file.dirty else "another or gone")
            return "the new bake was promised" if ended and made.old else ""
        return follow(place, bake_words(place, formats, "unreal"), look)


def bakes():
    formats = ["npy,png"] + (["exr,dds", "atlas,windpack", "vf,fga,ktx2"] if LONG else [])
    return f"{sum(map(bake, formats))} disks, none with a manifest over files that aren't its own and whole"


def the_model_finds_what_is_wrong():
    """A program that renames before it syncs, and one that never syncs the folder."""
    with folder() as place:
        file = project_in(place)
        wrong = ("import os, sys; p = sys.argv[1]; f = os.open(p + '.new', os.O_CREAT | os.O_WRONLY); os.write(f, b'x');"
                 "{}; os.rename(p + '.new', p); os.close(f)")
        for sync, expected in (("None", "torn"), ("os.fsync(f)", "promised")):
            try:
                follow(place, ["/usr/bin/python3", "-c", wrong.format(sync), file], of_a_file(file))
            except AssertionError as error:
                check(expected in str(error), f"{error}, expected {expected}")
            else:
                check(False, f"the model accepts {sync}")
    return "two wrong programs were found out"


main(the_model_finds_what_is_wrong, saves, bakes)
