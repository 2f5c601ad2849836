"""Runs the fuzzer of wind packs for a while on good packs of every kind and what becomes of them.

usage: run_fuzz.py PROGRAM SECONDS CRASHES
CRASHES is the folder where the input that broke something is left.
"""
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

LOOP, WRAP_X, WRAP_Z, FLOATS, ZSTD = 1, 2, 4, 8, 16


def pack(version=2, flags=0, width=4, height=3, frames=2, quantity=0, roughness=0.03, seed=1):
    """A pack after docs/windpack.md."""
    numbers = random.Random(seed)
    cell = "2f" if flags & FLOATS else "2e"
    cells = b"".join(struct.pack("<" + cell, numbers.uniform(-9, 9), numbers.uniform(-9, 9))
                     for _ in range(width * height * frames))
    head = struct.pack("<8s6I4f2fd2Q", b"WINDPACK", version, 0x01020304, flags, width, height, frames, -2, -1, 6, 5, 10, 20, 1.5,
                       len(cells), 0)
    if version >= 2:
        head += struct.pack("<I2fI", quantity, 2, roughness, 0)
    if flags & ZSTD:
        cells = subprocess.run(["zstd", "-q", "-c", "--no-check"], input=cells, capture_output=True, check=True).stdout
    body = head + cells
    return body + struct.pack("<I", zlib.crc32(body))


def write_corpus(folder):
    packs = [pack(version=1), pack(version=1, flags=LOOP | WRAP_X, width=1, frames=3), pack(), pack(flags=FLOATS),
             pack(flags=LOOP | WRAP_X | WRAP_Z, width=17, height=9), pack(flags=FLOATS | LOOP, width=2, height=1, frames=5),
             pack(quantity=1, roughness=0), pack(width=1, height=1, frames=1)]
    if shutil.which("zstd"):
        packs += [pack(flags=ZSTD), pack(flags=ZSTD | FLOATS | LOOP, width=16, height=16)]
    packs += [packs[2][:95], packs[2][:8], packs[3] + b"x"]
    for n, data in enumerate(packs):
        (folder / f"{n:02}.windpack").write_bytes(data)


def write_damage(folder):
    """Packs cut at every byte, and with every bit of the header turned."""
    for kind, good in enumerate([pack(version=1), pack(), pack(flags=FLOATS | LOOP)]):
        header = 80 if kind == 0 else 96
        for length in range(len(good)):
            (folder / f"{kind}-cut-{length:04}").write_bytes(good[:length])
        for bit in range(8 * header):
            bad = bytearray(good)
            bad[bit // 8] ^= 1 << bit % 8
            (folder / f"{kind}-bit-{bit:04}").write_bytes(bad)


def fuzz(program, crashes, *options):
    return subprocess.run([program, "-max_len=4096", "-timeout=10", "-rss_limit_mb=1024", f"-artifact_prefix={crashes}/", *options],
                          capture_output=True, text=True, errors="replace")


def main():
    program, seconds, crashes = sys.argv[1], int(sys.argv[2]), pathlib.Path(sys.argv[3])
    crashes.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="windloom-fuzz-") as name:
        corpus, damage = pathlib.Path(name, "corpus"), pathlib.Path(name, "damage")
        corpus.mkdir()
        damage.mkdir()
        write_corpus(corpus)
        write_damage(damage)
        done = fuzz(program, crashes, "-runs=0", damage)
        if done.returncode == 0:
            done = fuzz(program, crashes, f"-max_total_time={seconds}", "-print_final_stats=1", corpus)
    if done.returncode != 0:
        print("\n".join(done.stderr.splitlines()[-60:]), f"\nThe input is in {crashes}.")
        return 1
    runs = [int(line.split()[-1]) for line in done.stderr.splitlines() if "number_of_executed_units" in line]
    print(f"{runs[0] if runs else 0} inputs in {seconds} s, nothing broke")
    # A fuzzer that tried hardly anything shows nothing.
    return 0 if runs and runs[0] > 50 * seconds else 1


sys.exit(main())
