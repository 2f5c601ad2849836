"""Real disks: a small one that fills up, one that is read-only, folders that go away and files that turn into folders.

The first two need a mount of their own (unshare, as root or with user namespaces); where that isn't allowed this says so.
"""
import os
import pathlib
import shutil
import subprocess
import sys

from fault_runs import SAVE_LOOP, WINDLOOM, check, facts, folder, main, probes_of, project_in, temporaries, tree

INSIDE = "--inside"


def call(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=120)


def save(file):
    done = call(SAVE_LOOP, "save", file, "once")
    return facts(done)["first"], done.stdout.splitlines()[0]


def bake(file, out, *more):
    return call(WINDLOOM, "bake", file, "--backend", "cpu", "--out", out, "--format", "npy,png", "--steps", 6, "--fps", 60, *more)


def fill(disk):
    with open(disk / "filler", "wb", buffering=0) as file:
        try:
            while True:
                file.write(b"x" * 4096)
        except OSError:
            pass


def full_disk(disk):
    """On a tmpfs of 1 MiB."""
    file = project_in(disk)
    check(save(file)[0] == "ok" and probes_of(file) == 2, "there is room at first")
    check(bake(file, disk / "out").returncode == 0, "there is room for a bake")
    before = tree(disk)
    fill(disk)
    with_filler = set(tree(disk))
    told, dirty = save(file)
    check("No space left" in told and str(file) in told and dirty.endswith("dirty"), told)
    done = bake(file, disk / "out", "--preset", "unreal")
    check(done.returncode == 3 and ("No space left" in done.stderr or "the disk has" in done.stderr), str(done))
    done = call(WINDLOOM, "new", disk / "new.wind.json")
    check(done.returncode == 3 and "No space left" in done.stderr, str(done))
    done = call(SAVE_LOOP, "autosave", file, disk / "side", "once")
    check("failed" in facts(done)["first"], str(done))
    shutil.rmtree(disk / "side")  # its lock, of an editor that didn't end in order
    check(set(tree(disk)) == with_filler, f"left on the full disk: {set(tree(disk)) ^ with_filler}")
    (disk / "filler").unlink()
    after = tree(disk)
    check(after == before, f"changed on the full disk: {after} {before}")
    check(save(file)[0] == "ok" and probes_of(file) == 3, "with room again it must succeed")
    check(bake(file, disk / "out").returncode == 0 and not temporaries(disk), "and so must a bake")


def read_only_disk(disk):
    """The same disk, mounted read-only."""
    file = disk / "mine.wind.json"
    before = tree(disk)
    told, dirty = save(file)
    check("may not be written to" in told and str(file) in told and dirty.endswith("dirty"), told)
    for out in (disk / "out", disk / "other"):
        done = bake(file, out)
        check(done.returncode == 3 and "Read-only file system" in done.stderr and str(out) in done.stderr, str(done))
    check(tree(disk) == before, "a read-only disk has changed")
    check(call(WINDLOOM, "info", file).returncode == 0, "reading needs no writing")


def inside(disk):
    """In a mount namespace of its own."""
    if call("mount", "-t", "tmpfs", "-o", "size=1m", "none", disk).returncode != 0:
        return print("not tried: no tmpfs may be mounted here")
    full_disk(disk)
    check(call("mount", "-o", "remount,ro", disk).returncode == 0, "remount")
    read_only_disk(disk)
    print("a full disk and a read-only one: told, nothing changed, done when there was room again")


def small_disks():
    with folder() as place:
        for how in (["unshare", "-m"], ["unshare", "-rm"]):
            if call(*how, "true").returncode == 0:
                done = call(*how, sys.executable, *sys.argv, INSIDE, place)
                check(done.returncode == 0, done.stdout + done.stderr)
                return done.stdout.strip()
    return "not tried: no mount namespace may be made here"


def folders_that_go_away():
    with folder() as place:
        away = place / "away"
        away.mkdir()
        file = project_in(away)
        # The project is open while its folder goes: save_loop opens it by another name.
        done = call("sh", "-c", f'exec "{SAVE_LOOP}" saveas "{file}" "{place}/gone/mine.wind.json" once')
        told = facts(done)["first"]
        check("No such file or directory" in told and "gone/mine.wind.json" in told, told)
        check(done.stdout.splitlines()[0] == "probes 2 dirty", done.stdout)
    return "a missing folder is told, the work kept"


def files_that_turn_into_something_else():
    with folder() as place:
        file = project_in(place)
        for name, make in (("folder", lambda path: path.mkdir()), ("pipe", os.mkfifo),
                           ("link", lambda path: path.symlink_to("nowhere/at all"))):
            other = place / f"{name}.wind.json"
            make(other)
            done = call(SAVE_LOOP, "saveas", file, other, "once")
            check(facts(done)["first"].startswith("failed") and "dirty" in done.stdout.splitlines()[0], f"{name}: {done}")
            check(str(other) in facts(done)["first"], f"{name}: {done.stdout}")
            check(os.path.lexists(other) and not other.is_file(), f"{name}: was replaced")
        (place / "nowhere").mkdir()
        check(facts(call(SAVE_LOOP, "saveas", file, place / "link.wind.json", "once"))["first"] == "ok" and
              probes_of(place / "nowhere" / "at all") == 2, "the file that a link names is made where its folder is there")
        backup = place / "mine.wind.json.bak"
        backup.mkdir()
        told, _ = save(file)
        check(told == "ok" and probes_of(file) == 2, "a backup that can't be kept must not keep from saving")
        check(backup.is_dir() and not temporaries(place), "a folder in the backup's place stays")
        backup.rmdir()
        done = call(WINDLOOM, "new", "/dev/null")
        check(done.returncode != 0 and pathlib.Path("/dev/null").is_char_device(), "a device must stay one")
        for link in ("hard", "soft"):
            linked = place / f"{link}.wind.json"
            os.link(file, linked) if link == "hard" else linked.symlink_to(file)
            shutil.copy(file, place / "copy")
            check(save(linked)[0] == "ok" and probes_of(linked) == probes_of(place / "copy") + 1, f"through a {link} link")
    return "folders, pipes, dead links and devices are refused, links followed"


if sys.argv[-2] == INSIDE:
    inside(pathlib.Path(sys.argv[-1]))
else:
    main(small_disks, folders_that_go_away, files_that_turn_into_something_else)
