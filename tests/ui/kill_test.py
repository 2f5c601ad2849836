"""The real editor, killed at random moments of drags, saves and autosaves: the file on disk is always a whole project,
the old or the new one, and the next start offers the rest.

usage: kill_test.py WINDLOOM_EDITOR WINDLOOM [KILLS]
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import time

from editor_driver import check, display, editor, run

MOST_LOST = 25  # edits
PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Kill test",
    "field": {"centre": [0, 0], "size": [100, 100], "resolution": [32, 32]},
    "grass": {"density": 1},
    "probes": [{"id": 1, "position": [0, 0]}],
}


def probes_of(windloom, project):
    """The number of probes of a whole, valid project: each edit adds one."""
    told = subprocess.run([windloom, "validate", str(project)], capture_output=True, text=True)
    check(told.returncode == 0, f"a torn or invalid file: {told.stdout}{told.stderr}")
    return len(json.loads(project.read_text())["probes"])


def edits(app, count):
    """Copies of the one probe: each Ctrl+D is an edit and leaves its copy selected."""
    app.key(*["ctrl+d"] * count)


def begin_drag(app, dice):
    """Leaves the editor in the middle of dragging everything."""
    x, y = app.centre("viewport")
    app.key("a", "w")
    app.point_at((x, y))
    app.xdotool("mousedown", 1)
    for step in range(dice.randrange(1, 12)):
        app.move((x + 9 * step, y + 4 * step))


def deeds(app, kind, dice):
    """Something to be killed in. Nothing waits for its end."""
    if kind == "save":
        edits(app, dice.randrange(1, 5))
        app.key("ctrl+s")
    elif kind == "autosave":
        # After the save the 20th edit begins to write the side file.
        edits(app, 24)
        last = 3 + dice.randrange(18, 24)
        app.wait(f"{last} steps", lambda: int(app.fact("steps") or 0) >= last)
    else:
        begin_drag(app, dice)


def live(app, kind, dice):
    """An editor's life until it is killed: the edits that it said to have made, and those that a save surely wrote."""
    app.press("outliner/1")
    app.wait_fact("selection", "Probe 1")
    edits(app, 3)
    app.wait_fact("steps", "3")
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    saved = app.fact("steps")
    deeds(app, kind, dice)
    time.sleep(dice.random() * 0.4)
    steps = app.fact("steps")
    app.kill()
    return int(steps), int(saved)


def rescued_probes(folder):
    files = list((folder / "state" / "windloom" / "autosave").glob("*.rescue.json"))
    check(len(files) <= 1, f"more side files than editors: {files}")
    return [len(json.loads(json.loads(file.read_text())["project"])["probes"]) for file in files]


def kill_once(programs, environment, dice, kind):
    windloom_editor, windloom = programs
    with tempfile.TemporaryDirectory(prefix="windloom-kill-") as name:
        folder = pathlib.Path(name)
        project = folder / "kill.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(windloom_editor, environment, folder, str(project)) as app:
            steps, saved = live(app, kind, dice)
        found = probes_of(windloom, project)
        check(found >= 1 + saved, f"{kind}: {saved} edits were saved, the file has {found - 1}")
        for backup in folder.glob("*.bak"):
            probes_of(windloom, backup.rename(folder / "backup.wind.json"))
        rescued = rescued_probes(folder)
        lost = 1 + steps - max([found, *rescued])
        check(lost <= MOST_LOST, f"{kind}: {lost} of {steps} edits are lost")
        return rescued


def offer(programs, environment):
    """Restore, Discard and Show what changed after a kill in the real window."""
    windloom_editor, windloom = programs
    with tempfile.TemporaryDirectory(prefix="windloom-kill-") as name:
        folder = pathlib.Path(name)
        project = folder / "kill.wind.json"
        project.write_text(json.dumps(PROJECT))

        def crash():
            with editor(windloom_editor, environment, folder, str(project)) as app:
                app.press("outliner/1")
                edits(app, 22)
                app.wait_fact("steps", "22")
                app.wait("the side file", lambda: rescued_probes(folder) == [1 + 20])
                app.kill()

        crash()
        with editor(windloom_editor, environment, folder, str(project)) as app:
            app.wait_fact("dialog", "rescue")
            app.press("dialog/Show what changed")
            app.wait("the changes", lambda: "20 probes added" in app.fact("dialog.text"))
            app.press("dialog/Restore")
            app.wait_fact("dialog", "")
            app.wait_fact("dirty", "yes")
            app.key("ctrl+s")
            app.wait_fact("dirty", "no")
            check(probes_of(windloom, project) == 21, "the restored work must be saved to the project's file")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "the editor must end in order")
        project.write_text(json.dumps(PROJECT))
        crash()
        with editor(windloom_editor, environment, folder, str(project)) as app:
            app.wait_fact("dialog", "rescue")
            app.press("dialog/Discard")
            app.press("dialog/Discard for good")
            app.wait_fact("dialog", "")
            check(rescued_probes(folder) == [], "discarded work must be gone")
            check(app.fact("dirty") == "no", "discarding must leave the project alone")


def main():
    programs, kills = sys.argv[1:3], int(sys.argv[3]) if len(sys.argv) > 3 else 3
    kinds = ("drag", "save", "autosave")
    with display() as environment:
        offer(programs, environment)
        rescues = 0
        for number in range(kills):
            dice = random.Random(number)
            rescues += len(kill_once(programs, environment, dice, kinds[number % len(kinds)]))
    print(f"{kills} kills: every file whole, {rescues} left work to restore")


if __name__ == "__main__":
    run(main)
