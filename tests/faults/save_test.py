"""Saving, autosaving, preferences and pictures: killed at every system call, and with every call failing in turn.

What must hold: the file is whole, the old or the new one, a refusal is told with its path, the work is kept in memory and
still dirty, the next try succeeds and leaves nothing but the files that it should.
"""
import json
import shutil

from fault_runs import (ERRORS, LONG, SAVE_LOOP, calls_of, check, facts, folder, killed, main, probes_of, project_in, run,
                        temporaries)


class Save:
    """Ctrl+S."""
    name = "save"

    def __init__(self, place):
        self.place, self.file = place, project_in(place)

    def command(self):
        return [SAVE_LOOP, "save", self.file]

    def target(self):
        return self.file

    def version(self):
        """0: the old file, 1: the new one; fails for anything else."""
        return {1: 0, 2: 1}[probes_of(self.file)]

    def names(self):
        """What may lie in the folder in the end."""
        return {"mine.wind.json", "mine.wind.json.bak"}

    def check_rest(self):
        backup = self.place / "mine.wind.json.bak"
        if backup.exists():
            check(probes_of(backup) in (1, 2), "a torn backup")


class SaveOverBackup(Save):
    """Where the backup of an earlier save exists."""
    name = "save over a backup"

    def __init__(self, place):
        super().__init__(place)
        shutil.copy(self.file, self.place / "mine.wind.json.bak")

    def check_rest(self):
        check(probes_of(self.place / "mine.wind.json.bak") == 1, "the older backup or the old file")


class SaveAs(Save):
    """Into another folder, with a picture that the project uses."""
    name = "save as"

    def __init__(self, place):
        super().__init__(place)
        (place / "there").mkdir()
        project = json.loads(self.file.read_text())
        run([SAVE_LOOP, "picture", place / "map.png"], place)
        project["grass"]["maps"] = {"density": "map.png"}
        self.file.write_text(json.dumps(project))

    def command(self):
        return [SAVE_LOOP, "saveas", self.file, self.target()]

    def target(self):
        return self.place / "there" / "mine.wind.json"

    def version(self):
        check(probes_of(self.file) == 1, "the first file must stay as it is")
        return {2: 1}[probes_of(self.target())] if self.target().exists() else 0

    def names(self):
        return {"mine.wind.json", "map.png", "there"}

    def check_rest(self):
        if self.version() == 1:
            check((self.place / "there" / "map.png").read_bytes() == (self.place / "map.png").read_bytes(),
                  "a project without its picture")


class Autosave(Save):
    name = "autosave"

    def __init__(self, place):
        super().__init__(place)
        self.side = place / "side"

    def command(self):
        return [SAVE_LOOP, "autosave", self.file, self.side]

    def target(self):
        # Where the first name's lock fails, the second is taken.
        return next(self.side.glob("*.rescue.json"), self.side / "driver.rescue.json")

    def version(self):
        check(probes_of(self.file) == 1, "autosave must leave the project alone")
        if not self.target().exists():
            return 0
        # Without faults the first write is the 21st probe, after a failure the 41st.
        return {21: 1, 41: 1}[len(json.loads(json.loads(self.target().read_text())["project"])["probes"])]

    def names(self):
        return {"mine.wind.json", "side"}

    def check_rest(self):
        """What is there is offered by the next start."""
        version = self.version()
        with folder() as aside:
            shutil.copytree(self.side, aside / "side") if self.side.exists() else None
            told = facts(run([SAVE_LOOP, "rescue", aside / "side", aside / "rescued.wind.json"], aside))
            check(("rescue" in told) == (version == 1) and "failed" not in told.get("rescue", ""), f"next start: {told}")


class Preferences(Save):
    name = "preferences"

    def __init__(self, place):
        self.place, self.file = place, place / "config" / "preferences.json"

    def command(self):
        return [SAVE_LOOP, "preferences", self.file]

    def version(self):
        return 1 if self.file.exists() and json.loads(self.file.read_text())["numbers"] else 0

    def names(self):
        return {"config"}

    def check_rest(self):
        pass


class Picture(Save):
    name = "picture"

    def __init__(self, place):
        self.place, self.file = place, place / "picture.png"
        self.file.write_bytes(b"old")

    def command(self):
        return [SAVE_LOOP, "picture", self.file]

    def version(self):
        found = self.file.read_bytes()
        check(found == b"old" or (found.startswith(b"\x89PNG") and found.endswith(b"IEND\xaeB\x60\x82")), "a torn picture")
        return int(found != b"old")

    def names(self):
        return {"picture.png"}

    def check_rest(self):
        pass


DEEDS = (Save, SaveOverBackup, SaveAs, Autosave, Preferences, Picture)


def count_calls(kind):
    with folder() as place:
        deed = kind(place)
        calls, done = calls_of(deed.command(), place)
        check(done.returncode == 0 and deed.version() == 1, f"{kind.name}: {done}")
        check(len(calls) > 5, f"{kind.name}: the library saw {len(calls)} calls")
        return calls[-1].number


def kill_at_every_call():
    points = 0
    for kind in DEEDS:
        last, versions = count_calls(kind), set()
        for at in range(1, last + 1):
            with folder() as place:
                deed = kind(place)
                done = run(deed.command(), place, at=at, do="kill")
                check(killed(done), f"{kind.name}: not killed at call {at}: {done}")
                versions.add(deed.version())
                deed.check_rest()
                check(len(temporaries(place)) <= 2, f"{kind.name}: leftovers {temporaries(place)}")
                # The next one goes as if nothing had been, and clears up.
                again = kind.__new__(kind)
                again.__dict__ = deed.__dict__
                done = run(again.command(), place)
                check(done.returncode == 0 and facts(done).get("first") == "ok", f"{kind.name} after call {at}: {done}")
                check(not temporaries(place), f"{kind.name} after call {at}: {temporaries(place)}")
                points += 1
        check(versions == {0, 1}, f"{kind.name}: {versions}: old before the last step, new after it")
    return f"{points} kills, one at every system call of {len(DEEDS)} deeds"


def fail(kind, at, error, again):
    """One run; true where the deed failed at first."""
    where = f"{kind.name}, call {at}: {error}{' from there on' if again else ''}"
    with folder() as place:
        deed = kind(place)
        done = run(deed.command(), place, at=at, do=error, again=again)
        if done.returncode == 9:  # it could not even be opened
            check("can't open" in done.stdout and str(place) in done.stdout and deed.version() == 0, f"{where}: {done}")
            return True
        check(done.returncode == 0, f"{where}: {done}")
        told = facts(done)
        refused = told["first"] != "ok"
        lines = done.stdout.splitlines()
        if refused:
            told_first = told["first"]
            # Where a file is read or a folder made, an interruption may be told.
            check(error in ERRORS or "can't open: Interr" in told_first or "folder: Interr" in told_first,
                  f"{where}: must be no failure: {told_first}")
            if error not in ERRORS:
                return True
            check(ERRORS[error] in told_first or "can't autosave" in told_first, f"{where}: told {told_first}")
            check(str(place) in told_first, f"{where}: names no path: {told_first}")
            check(told["again"] == "ok", f"{where}: {told['again']}")
            if issubclass(kind, Save) and "probes" in told:
                check(lines[0] == "probes 2 dirty", f"{where}: work must be kept and dirty: {lines}")
        if "told" in told:
            check(told["told"] == "again 0", f"{where}: told with each frame")
        check(deed.version() == 1, f"{where}: in the end it is the new file")
        deed.check_rest()
        found = {path.name for path in place.iterdir()}
        check(found <= deed.names(), f"{where}: left {found - deed.names()}")
        check(not temporaries(place), f"{where}: {temporaries(place)}")
        return refused


def fail_every_call():
    runs = refusals = 0
    errors = (*ERRORS, "EINTR", "short") if LONG else ("ENOSPC", "EIO", "EINTR", "short")
    for kind in DEEDS:
        for at in range(1, count_calls(kind) + 1):
            for error in errors:
                for again in ((False, True) if error in ("ENOSPC", "EACCES") and LONG else (False,)):
                    refusals += fail(kind, at, error, again)
                    runs += 1
    check(refusals > runs / 10, f"only {refusals} of {runs} runs failed: do faults reach the program?")
    return f"{runs} faults, {refusals} refused with a message and done on the second try, the others made no difference"


def without_locks():
    """File systems that know no locks: saving works, and nobody's temporary files are taken for left ones."""
    for kind in DEEDS:
        if kind is Autosave:  # its lock tells whether an editor runs
            continue
        with folder() as place:
            deed = kind(place)
            left = place / ".mine.wind.json.abc123.windloom"
            left.write_text("of somebody at work, perhaps")
            done = run(deed.command(), place, calls="flock", at=1, do="ENOLCK", again=True)
            check(facts(done)["first"] == "ok" and deed.version() == 1 and left.exists(), f"{kind.name}: {done}")
    return f"{len(DEEDS) - 1} deeds"


def old_file_stays_while_it_fails():
    """The state between a failure and the next try: the old file byte for byte, nothing beside it."""
    runs = 0
    for kind in (Save, SaveOverBackup, Picture, Preferences):
        for at in range(1, count_calls(kind) + 1):
            with folder() as place:
                deed = kind(place)
                # Every call from there on fails, and the second try is not reached: its calls are among them.
                done = run([*deed.command(), "once"], place, at=at, do="ENOSPC", again=True)
                if done.returncode == 9 or facts(done)["first"] != "ok":
                    check(deed.version() == 0, f"{kind.name}, call {at}: not the old file")
                    check("again" not in facts(done), "only once")
                deed.check_rest()
                runs += 1
    return f"{runs} runs"


main(kill_at_every_call, fail_every_call, old_file_stays_while_it_fails, without_locks)
