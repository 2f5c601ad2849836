"""The sample game docs/examples/leaves in a real window: its picture, whether its leaves go where the drawn tree blows,
and what it does when its file is replaced, missing or damaged.

usage: game_test.py WINDLOOM_LEAVES WINDLOOM MEADOW_PROJECT
"""
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

from editor_driver import check, display, run
from game_driver import SMALL, Running, fact, play, read_leaves

GAME, WINDLOOM, MEADOW = sys.argv[1:4]
FPS = 10


def bake(folder, out, *arguments):
    """The meadow as a pack and as arrays, which another reader than the runtime's can read; a fraction of its cells."""
    project = json.loads(pathlib.Path(MEADOW).read_text())
    project["field"]["resolution"] = [160, 160]
    file = folder / "meadow.wind.json"
    file.write_text(json.dumps(project))
    done = subprocess.run([WINDLOOM, "bake", str(file), "--out", str(folder / out), "--format", "windpack,npy", "--backend",
                           "cpu", "--fps", str(FPS), "--resolution", "128x128", *arguments], capture_output=True, text=True)
    check(done.returncode == 0, f"windloom bake: {done.stderr}")
    packs = [file for file in (folder / out).glob("*.windpack") if not file.name.startswith("bend")]
    check(len(packs) == 1, f"expected one pack, found {packs}")
    return packs[0]


def read_picture(file):
    """Rows of RGB, by ImageMagick rather than by our own reading of PNG."""
    size = subprocess.run(["identify", "-format", "%w %h", str(file)], capture_output=True, text=True, check=True).stdout
    width, height = map(int, size.split())
    raw = subprocess.run(["convert", str(file), "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout
    return numpy.frombuffer(raw, numpy.uint8).reshape(height, width, 3).astype(float)


def check_pictures(environment, folder, pack):
    windy, calm, again = (folder / name for name in ("windy.png", "calm.png", "again.png"))
    # Calm: the first moments of the project, before the gust has left the root.
    still = bake(folder, "calm", "--from", "0", "--seconds", "0.3")
    play(GAME, environment, pack, "--time", "2", "--frames", "60", "--screenshot", windy, *SMALL)
    first = play(GAME, environment, pack, "--time", "2", "--frames", "60", "--screenshot", again, "--print", *SMALL)
    play(GAME, environment, still, "--frames", "60", "--screenshot", calm, *SMALL)
    check(windy.read_bytes() == again.read_bytes(), "the same seed, time and frames must give the same picture")
    second = play(GAME, environment, pack, "--time", "2", "--frames", "60", "--print", "--seed", "2", *SMALL)
    check(first.stdout != second.stdout, "another seed must give other leaves")

    picture = read_picture(windy)
    check(picture.shape == (270, 480, 3), f"the picture has the size {picture.shape}")
    sky, meadow = picture[:40].mean(axis=(0, 1)), picture[150:].mean(axis=(0, 1))
    check(sky[2] > sky[0] and sky.min() > 60, f"the sky must be bright and blue, not {sky}")
    check(meadow[1] > meadow[2] + 30 and meadow[1] > 60, f"the meadow must be green, not {meadow}")
    red = (picture[100:, :, 0] > 1.35 * picture[100:, :, 1]) & (picture[100:, :, 0] > 90)
    check(red.sum() > 100, f"leaves and flags must be seen, found {red.sum()} reddish pixels")
    check((picture.max(axis=2) < 12).mean() < 0.001, "nothing may be black")
    check(len(numpy.unique(picture.reshape(-1, 3), axis=0)) > 3000, "the picture has few colours")
    change = numpy.abs(picture - read_picture(calm))[100:].mean()
    check(change > 2, f"wind must be seen: windy and calm differ by {change:.2f} of 255 only")


def tree_arrows():
    graph = json.loads(pathlib.Path(MEADOW).read_text())["graph"]
    places = {point["id"]: numpy.array(point["position"], float) for point in graph["points"]}
    return [(places[arrow["from"]], places[arrow["to"]]) for arrow in graph["arrows"]]


def away_from(start, end, places):
    part = numpy.clip(((places - start) @ (end - start)) / ((end - start) @ (end - start)), 0, 1)
    return numpy.linalg.norm(places - (start + part[:, None] * (end - start)), axis=1)


def between(a, b):
    """Degrees."""
    return math.degrees(math.acos(numpy.clip(a @ b / numpy.linalg.norm(a) / numpy.linalg.norm(b), -1, 1)))


def wind_along(arrays, places, first, seconds):
    """Mean of the baked wind at places, from the npy frames: vx, vz at cell centres, rows z ascending."""
    frames = [int(round(first + t * FPS)) % len(arrays) for t in numpy.arange(0, seconds, 1 / FPS)]
    cells = numpy.clip(((places + 50) / 100 * 128).astype(int), 0, 127)
    return arrays[frames][:, cells[:, 1], cells[:, 0]].mean(axis=0)


def check_drift(environment, pack):
    """Leaves near arrows with wind go where the recording blows, and mostly where the artist drew."""
    seconds, begin = 2.5, 1.5
    done = play(GAME, environment, pack, "--time", begin, "--frames", int(seconds * 30), "--print", *SMALL)
    starts, ends, drifts, jumps = read_leaves(done.stdout)
    stayed = jumps == 0
    check(numpy.abs(ends[stayed] - starts[stayed] - drifts[stayed]).max() < 0.01, "drift must be end - start")
    mean = [float(part) for part in fact(done.stdout, "mean drift").split()]
    check(numpy.allclose(drifts.mean(axis=0), mean, atol=0.01), f"mean drift {mean}, but the leaves' is {drifts.mean(axis=0)}")
    check(abs(float(fact(done.stdout, "seconds")) - seconds) < 0.04, f"played {fact(done.stdout, 'seconds')} s")
    arrays = numpy.stack([numpy.load(file) for file in sorted(pack.parent.rglob("*.npy"))]).reshape(-1, 128, 128, 2)
    judged = along = 0
    for start, end in tree_arrows():
        near = stayed & (away_from(start, end, starts) < 3.5)
        wind = wind_along(arrays, starts[near], begin * FPS, seconds).mean(axis=0)
        if near.sum() < 4 or numpy.linalg.norm(wind) < 3.5:
            continue
        moved = drifts[near].mean(axis=0)
        where = f"{near.sum()} leaves near the arrow {start} to {end} moved {moved} in wind {wind}"
        print(where)
        check(numpy.linalg.norm(moved) > 3, f"too little: {where}")
        check(between(moved, wind) < 30, f"{between(moved, wind):.0f} degrees off the wind: {where}")
        judged += 1
        along += between(moved, end - start) < 20
    # A side branch may be drowned by its stronger neighbour, the tree as a whole may not.
    check(judged >= 4 and along >= judged * 2 / 3, f"of {judged} arrows with wind {along} have leaves that follow them")


def check_refusals(environment, folder, pack):
    whole = pack.read_bytes()
    middle = len(whole) // 2
    cases = {"missing": None, "empty": b"", "other": b"{}" * 500, "cut": whole[:-100],
             "damaged": whole[:middle] + bytes([whole[middle] ^ 0x55]) + whole[middle + 1:]}
    for name, content in cases.items():
        file = folder / f"{name}.windpack"
        if content is not None:
            file.write_bytes(content)
        done = play(GAME, environment, file, "--frames", "5", status=1)
        check(file.name in done.stderr and len(done.stderr.split(":")[-1].strip()) > 15,
              f"{name}: the message must name file and reason: {done.stderr}")
        check(done.stderr.count("\n") == 1, f"{name}: one line will do: {done.stderr}")
    bake(folder, "lean", "--from", "0", "--seconds", "0.2", "--response")
    lean = next((folder / "lean").glob("bend*.windpack"))
    done = play(GAME, environment, lean, "--frames", "5", status=1)
    check("lean" in done.stderr, f"how plants lean is no wind: {done.stderr}")
    check(play(GAME, environment, "--live", "no-such-editor", "--frames", "5", status=1).stderr != "", "no editor, no file: a reason")
    done = play(GAME, environment, pack, "--live", "no-such-editor", "--frames", "5", "--print", *SMALL)
    check(fact(done.stdout, "source") == "file" and "no-such-editor" in done.stderr, f"no fall-back: {done.stderr}")
    for arguments in ([], [pack, "--frames", "x"], [pack, "--size", "12"], [pack, "--nonsense"], [pack, pack]):
        check("usage" in play(GAME, environment, *arguments, status=2).stderr, f"{arguments}: usage expected")
    check("usage" in play(GAME, environment, "--help").stdout, "help expected")


def replace(target, content):
    """As an export does: a new file takes the name of the old one at once."""
    fresh = target.with_suffix(".new")
    fresh.write_bytes(content)
    os.replace(fresh, target)


def check_following(environment, folder, pack):
    other = bake(folder, "other", "--from", "5", "--seconds", "0.5").read_bytes()
    file = folder / "followed.windpack"
    file.write_bytes(pack.read_bytes())
    game = Running(GAME, environment, folder / "followed.log", file, "--print", *SMALL)
    try:
        game.wait("a title with file and frames", lambda: re.search(r"followed\.windpack \| [1-9]\d* fps", game.title()))
        replace(file, other)
        game.wait_told("New wind from followed.windpack")
        game.wait("the note in the title", lambda: "New wind" in game.title())
        replace(file, other[:-50])
        game.wait_told("Kept the wind")
        replace(file, pack.read_bytes())
        game.wait("the second new wind", lambda: game.told().count("New wind from") == 2)
        game.key("space")
        game.wait("the pause", lambda: "paused" in game.title())
        game.key("l")
        game.wait_told("Live wind")
        game.key("r", "space")
        game.wait("the end of the pause", lambda: "paused" not in game.title())
        text = game.end()
    finally:
        game.process.kill()
    check(fact(text, "reloads") == "2", f"two good files were put there, {fact(text, 'reloads')} were taken over")
    check(fact(text, "source") == "file", "without an editor the wind comes from the file")
    read_leaves(text)


def main():
    with tempfile.TemporaryDirectory(prefix="windloom-game-") as name, display() as environment:
        folder = pathlib.Path(name)
        pack = bake(folder, "meadow", "--from", "2", "--seconds", "6", "--loop")
        check_refusals(environment, folder, pack)
        check_pictures(environment, folder, pack)
        check_drift(environment, pack)
        check_following(environment, folder, pack)
    print("the sample game: all as it should be")


run(main)
