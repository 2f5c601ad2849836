"""Runs one fuzz target for a while: first every input that once broke something, then the corpus and what becomes of it.

usage: run_fuzz.py PROGRAM SECONDS CRASHES [KEEP]
PROGRAM is .../NAME_fuzz; CRASHES is the folder where an input that breaks something is left; KEEP one that gets the inputs
that were found to reach more than others, to be put into corpus/NAME. Needs the program, Python and
this repository, nothing else. Fails where an input crashes, hangs, leaks or takes too much memory, or where hardly anything
was tried. Tells in one line what was done.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import seeds

HERE = pathlib.Path(__file__).resolve().parent
LONGEST = {"project": 32768, "clipboard": 32768, "rescue": 32768, "gltf": 8192, "preferences": 65536, "live": 512, "typed": 256,
           "command_line": 1024}


def options(name, crashes):
    return [f"-max_len={LONGEST.get(name, 4096)}", "-timeout=60", "-rss_limit_mb=2048", "-malloc_limit_mb=1024",
            "-len_control=0", f"-artifact_prefix={crashes}/{name}-", "-close_fd_mask=1"]


def dictionary(name):
    file = HERE / "dictionaries" / f"{name}.dict"
    return [f"-dict={file}"] if file.exists() else []


def fuzz(program, arguments, scratch):
    # A contract that breaks, and bad input, are told on standard error; a run of minutes says much.
    with tempfile.TemporaryFile(dir=scratch) as told:
        done = subprocess.run([program, *arguments], stdout=subprocess.DEVNULL, stderr=told,
                              env={**os.environ, "TMPDIR": str(scratch), "WINDLOOM_THREADS": "1"})
        told.seek(max(0, told.seek(0, os.SEEK_END) - (1 << 20)))
        return done.returncode, told.read().decode(errors="replace")


def last(pattern, text):
    found = re.findall(pattern, text)
    return int(found[-1]) if found else 0


def main():
    program, seconds, crashes = sys.argv[1], int(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    name = pathlib.Path(program).name.removesuffix("_fuzz")
    crashes.mkdir(parents=True, exist_ok=True)
    memory = "/dev/shm"  # inputs become files, and some code waits for a disk
    with tempfile.TemporaryDirectory(prefix="windloom-fuzz-", dir=memory if os.access(memory, os.W_OK) else None) as folder:
        corpus, fixed = pathlib.Path(folder, "corpus"), pathlib.Path(folder, "fixed")
        corpus.mkdir()
        fixed.mkdir()
        getattr(seeds, name)(corpus)
        for source, target in ((HERE / "corpus" / name, corpus), (HERE / "regressions" / name, fixed)):
            if source.is_dir():
                shutil.copytree(source, target, dirs_exist_ok=True)
        kept, begun = len(list(fixed.iterdir())), len(list(corpus.iterdir()))
        if hasattr(seeds, name + "_damage"):
            getattr(seeds, name + "_damage")(fixed)
        status, told = fuzz(program, [*options(name, crashes), "-runs=0", fixed], folder)
        if status == 0:
            status, told = fuzz(program, [*options(name, crashes), *dictionary(name), f"-max_total_time={seconds}",
                                          "-print_final_stats=1", corpus], folder)
        size, ran = len(list(corpus.iterdir())), told
        if status == 0 and len(sys.argv) > 4:
            keep = pathlib.Path(sys.argv[4], name)
            keep.mkdir(parents=True, exist_ok=True)
            status, told = fuzz(program, [*options(name, crashes), "-merge=1", keep, corpus], folder)
    if status != 0:
        print("\n".join(told.splitlines()[-70:]), f"\nThe input is in {crashes}.")
        return 1
    runs, edges = last(r"number_of_executed_units: *(\d+)", ran), last(r"cov: (\d+)", ran)
    memory, slowest = last(r"peak_rss_mb: *(\d+)", ran), last(r"slowest_unit_time_sec: *(\d+)", ran)
    print(f"{name}: {runs} inputs in {seconds} s, {edges} edges, corpus {size}, {memory} MB, slowest {slowest} s, "
          f"{kept} regression inputs; nothing broke")
    # A run that came hardly beyond the inputs it began with shows nothing, however slow the machine is.
    return 0 if runs > begun + 2 * seconds else 1


sys.exit(main())
