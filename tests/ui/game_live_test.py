"""The sample game follows a running editor: it changes over when one begins to share its wind, its leaves go where the
editor's wind blows, and it goes back to its file when the editor ends.

usage: game_live_test.py WINDLOOM_LEAVES WINDLOOM WINDLOOM_EDITOR
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from editor_driver import check, display, editor, run
from game_driver import SMALL, Running, fact, play, read_leaves

GAME, WINDLOOM, EDITOR = sys.argv[1:4]
NAME = f"windloom-game-{os.getpid()}"
# Wind along +x everywhere, and more of it along the middle.
PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Game test",
    "field": {"centre": [10, 0], "size": [60, 60], "resolution": [64, 64]},
    "ambient": {"speed": 4, "direction": 0}, "grass": {"density": 2},
    "graph": {"points": [{"id": 1, "position": [-15, 0]}, {"id": 2, "position": [35, 0]}],
              "arrows": [{"id": 10, "from": 1, "to": 2, "strength": 9, "radius": 6, "where": "along"}]},
}


def bake_other(folder):
    """A pack of another, calm field: what the game plays while no editor is there."""
    file = folder / "calm.wind.json"
    file.write_text(json.dumps({"format": "windloom-project", "version": 1, "field": {"size": [40, 40], "resolution": [32, 32]}}))
    done = subprocess.run([WINDLOOM, "bake", str(file), "--out", str(folder / "calm"), "--format", "windpack", "--backend",
                           "cpu", "--seconds", "0.5", "--fps", "10"], capture_output=True, text=True)
    check(done.returncode == 0, f"windloom bake: {done.stderr}")
    return next((folder / "calm").glob("*.windpack"))


def share_from_the_start(folder):
    """As if the last session had shared its wind."""
    file = folder / "config" / "windloom" / "preferences.json"
    file.parent.mkdir(parents=True)
    file.write_text(json.dumps({"numbers": {"live.on": 1}, "texts": {"live.name": NAME}}))


def check_leaves(environment):
    """A game without a file, its leaves in the editor's wind."""
    done = play(GAME, environment, "--live", NAME, "--frames", "75", "--print", *SMALL)
    check(fact(done.stdout, "source") == "live", f"the wind must be the editor's: {done.stderr}")
    starts, _, drifts, jumps = read_leaves(done.stdout)
    check(starts[:, 0].min() >= -20 and starts[:, 0].max() <= 40, "leaves must lie on the editor's field")
    middle = (jumps == 0) & (abs(starts[:, 1]) < 5) & (starts[:, 0] < 20)
    moved = drifts[middle].mean(axis=0)
    check(moved[0] > 3 and abs(moved[1]) < 0.4 * moved[0], f"leaves on the arrow must go along +x, they went {moved}")


def main():
    with tempfile.TemporaryDirectory(prefix="windloom-live-") as name, display("1280x800") as environment:
        folder = pathlib.Path(name)
        project = folder / "live.wind.json"
        project.write_text(json.dumps(PROJECT))
        pack = bake_other(folder)
        game = Running(GAME, environment, folder / "game.log", pack, "--live", NAME, "--print", *SMALL)
        try:
            game.wait_told("Playing the file meanwhile")
            share_from_the_start(folder)
            with editor(EDITOR, environment, folder, str(project), size="1100x700") as app:
                app.wait("sharing", lambda: app.fact("live").endswith(" fields a second"))
                game.wait_told("Following the editor")
                game.wait("the name in the title", lambda: f"live: {NAME}" in game.title())
                check_leaves(environment)
                app.xdotool("windowfocus", "--sync", app.window)  # the other game had it
                app.key("ctrl+q")
                check(app.wait_end() == 0, "closing must end the editor with 0")
            game.wait_told("The editor has ended the live link")
            game.wait("the file in the title", lambda: pack.name in game.title())
            text = game.end()
        finally:
            game.process.kill()
        check(fact(text, "source") == "file", "after the editor the wind comes from the file")
        check(int(fact(text, "live fields")) > 10, f"only {fact(text, 'live fields')} fields were taken over")
    print("the sample game follows the editor")


run(main)
