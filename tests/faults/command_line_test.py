"""The command line where its output or its files meet trouble: exit status 3 and a message that names what failed."""
import os
import pathlib
import subprocess

from fault_runs import ERRORS, LONG, SAVE_LOOP, WINDLOOM, calls_of, check, facts, folder, main, project_in, run, temporaries

RESULTS = (("info",), ("info", "--json"), ("validate", "--json"), ("sample", "--at", "0,0", "--time", "0.1"),
           ("sample", "--at", "0,0", "--time", "0.1", "--json"))


def call(words, **streams):
    return subprocess.run([str(word) for word in words], text=True, timeout=60, **streams)


def results_that_never_arrive():
    runs = 0
    with folder() as place, open("/dev/full", "w") as full:
        file = project_in(place)
        commands = [[WINDLOOM, verb, file, *options] for verb, *options in RESULTS]
        commands += [[WINDLOOM, "--help"], [WINDLOOM, "bake", "--help"], [WINDLOOM, "--version"],
                     [WINDLOOM, "bake", "--list-formats"], [WINDLOOM, "info", "--json", place / "none.wind.json"]]
        for words in commands:
            done = call(words, stdout=full, stderr=subprocess.PIPE)
            check(done.returncode == 3, f"{words}: {done}")
            reason = "" if words[-1] in ("--help", "--version") else ": No space left"
            check("to standard output" + reason in done.stderr, f"{words}: {done.stderr}")
            # A pipe that nobody has open, as `>&-` gives.
            done = call(["sh", "-c", '"$@" >&-', "sh", *words], stderr=subprocess.PIPE)
            check(done.returncode == 3 and "standard output" in done.stderr, f"closed, {words}: {done}")
            runs += 2
    return f"{runs} results to a full disk and to nowhere: exit status 3"


def messages_that_never_arrive():
    """Standard error is full or closed: the work is done all the same."""
    with folder() as place, open("/dev/full", "w") as full:
        file = project_in(place)
        for number, shell in enumerate(('"$@" 2>/dev/full', '"$@" 2>&-', '"$@" 2>&- <&- >&-')):
            out = place / f"out{number}"
            done = call(["sh", "-c", shell, "sh", WINDLOOM, "bake", file, "--backend", "cpu", "--format", "npy", "--steps", 6,
                         "--out", out], stdout=subprocess.DEVNULL)
            check((out / "manifest.json").exists(), f"{shell}: {done}")
            check(done.returncode == (3 if ">&-" in shell.split("<")[-1] and "<&-" in shell else 0), f"{shell}: {done}")
            # Nothing that was meant for a stream may end in a file that got its number.
            for path in out.iterdir():
                check(b"windloom:" not in path.read_bytes() and b"\r" not in path.read_bytes()[:1], f"{shell}: {path}")
        done = call([WINDLOOM, "info", place / "none.wind.json"], stderr=full, stdout=subprocess.DEVNULL)
        check(done.returncode == 1, f"a missing project: {done}")
    return "3 bakes without standard error were whole"


def new_projects():
    runs = 0
    with folder() as place:
        file = place / "fresh.wind.json"
        words = [WINDLOOM, "new", file]
        calls, _ = calls_of(words, place)
        file.unlink()
        for at in range(1, calls[-1].number + 1):
            for error, text in ERRORS.items():
                done = run(words, place, at=at, do=error)
                if done.returncode == 0:
                    check(run([WINDLOOM, "validate", file], place).returncode == 0, f"{error} at {at}: not a whole project")
                    file.unlink()
                else:
                    check(done.returncode == 3 and text in done.stderr and str(file) in done.stderr, f"{at}: {done}")
                    check(not file.exists() and not temporaries(place), f"{error} at {at}: left {list(place.iterdir())}")
                runs += 1
    return f"{runs} faults"


def pictures():
    """`render` needs OpenGL; where there is none this says so."""
    with folder() as place:
        out, file = place / "out", project_in(place)
        out.mkdir()
        picture = out / "picture.png"
        words = [WINDLOOM, "render", file, "--out", picture, "--size", "64x48", "--grass", "none"]
        calls, done = calls_of(words, out)
        if done.returncode == 3 and "OpenGL" in done.stderr:
            return "not tried: no OpenGL here"
        check(done.returncode == 0, str(done))
        old = picture.read_bytes()
        runs = 0
        for number, at in enumerate(range(1, calls[-1].number + 1, 1 if LONG else 4)):
            error, text = list(ERRORS.items())[number % len(ERRORS)]
            done = run(words, out, at=at, do=error)
            if done.returncode != 0:
                check(done.returncode == 3 and text in done.stderr and "picture.png" in done.stderr, f"{error} at {at}: {done}")
                check(picture.read_bytes() == old and len(list(out.iterdir())) == 1, f"{error} at {at}: {list(out.iterdir())}")
            runs += 1
    return f"{runs} faults"


def live_link():
    """Shared memory that is full: a message, and no object stays."""
    name = f"windloom-faults-{os.getpid()}"
    shared = f"/dev/shm/{name}"
    runs = refused = 0
    calls, done = calls_of([SAVE_LOOP, "live", name], shared)
    check(done.returncode == 0 and facts(done)["first"] == "ok", str(done))
    check({call.name for call in calls} >= {"create", "flock"}, "the library sees the object")
    for at in range(1, calls[-1].number + 2):
        for error, text in (*ERRORS.items(), ("ENOMEM", "Cannot allocate memory")):
            done = run([SAVE_LOOP, "live", name], shared, at=at, do=error)
            check(done.returncode == 0, f"{error} at {at}: {done}")
            told = facts(done)
            if told["first"] != "ok":
                check(text in told["first"] and name in told["first"] and told["again"] == "ok", f"{error} at {at}: {told}")
                refused += 1
            check(not os.path.exists(shared), f"{error} at {at}: {shared} stays")
            runs += 1
    check(refused > 0, "no fault reached it")
    return f"{runs} faults, {refused} told"


def the_log():
    """The log's file is a help, never a hindrance; a crash leaves its last word there."""
    runs = 0
    with folder() as place:
        calls, done = calls_of([SAVE_LOOP, "log", place / "state"], place)
        check("line 199" in (place / "state" / "log.txt").read_text(), "every line is there")
        for at in (1, 2, 3, 50, calls[-1].number):
            for error in ("ENOSPC", "EIO", "EACCES", "short"):
                done = run([SAVE_LOOP, "log", place / "state"], place, at=at, do=error, again=True)
                check(done.returncode == 0 and facts(done)["first"] == "ok", f"{error} at {at}: {done}")
                check(done.stderr.count("warning: line") == 200, f"{error} at {at}: standard error lost lines")
                runs += 1
        for _ in range(60):
            run([SAVE_LOOP, "log", place / "state"], place)
        sizes = {path.name: path.stat().st_size for path in (place / "state").iterdir()}
        check(set(sizes) == {"log.txt", "log.old.txt"} and max(sizes.values()) < 600 << 10, f"it grows: {sizes}")
        done = run([SAVE_LOOP, "crash", place / "crashed"], place)
        check(done.returncode == -6, str(done))
        text = (place / "crashed" / "log.txt").read_text()
        program = pathlib.Path(SAVE_LOOP).read_bytes()
        sanitized = b"__asan_init" in program or b"__tsan_init" in program  # they tell of crashes themselves
        check("about to crash" in text and (sanitized or "crashed by signal 06" in text), text)
    return f"{runs} faults made no difference"


main(results_that_never_arrive, messages_that_never_arrive, new_projects, pictures, live_link, the_log)
