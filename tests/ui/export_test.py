"""The export in the real window: an engine proposes its formats, sizes and warnings follow the choices, a small project is
exported, a long export is cancelled and leaves nothing, an edit exports again, the folder is shown and its path copied, the
live wind is shared, and the choices are there in the next session.

usage: export_test.py WINDLOOM_EDITOR [PICTURE]
With PICTURE only the choices are made, and the panel is written there (docs/images/export.png).
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from editor_driver import check, display, editor, run
from live_reader import LiveReader

WINDOW = "1280x1180"
GRID = 96
PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Export test",
    "field": {"centre": [0, 0], "size": [50, 50], "resolution": [GRID, GRID]},
    "ambient": {"speed": 6, "direction": 20}, "grass": {"kind": "none"},
    "graph": {"points": [{"id": 1, "position": [-15, 0]}, {"id": 2, "position": [5, 0]}],
              "arrows": [{"id": 10, "from": 1, "to": 2, "strength": 9, "radius": 4}]},
}
PROPOSED = {"unreal": {"exr", "fga"}, "unity": {"exr", "vf"}, "godot": {"exr", "dds", "godot-slab"},
            "generic": {"exr", "windpack"}}


def type_into(app, name, text):
    app.press(name)
    app.wait_fact("typing", "yes")
    app.key("ctrl+a")
    app.type(text)
    app.key("Return")
    app.wait_fact("typing", "no")


def formats(app):
    """What is there to choose, and what is chosen."""
    facts = app.read_map()[0]
    prefix = "export.format."
    there = {name[len(prefix):]: value == "yes" for name, value in facts.items() if name.startswith(prefix)}
    missing = {name for name in there if facts["export.size." + name] == "missing"}
    return set(there) - missing, {name for name, on in there.items() if on}


def choose(app, *wanted):
    """Clicks until exactly these formats are chosen."""
    for name in formats(app)[1] ^ set(wanted):
        before = app.fact("export.format." + name)
        app.press("export/format/" + name)
        app.wait(f"{name} to change", lambda: app.fact("export.format." + name) != before)
    check(formats(app)[1] == set(wanted), f"chosen are {formats(app)[1]}, not {wanted}")


def show_formats(app, on):
    """Closing the list brings what is below it into sight."""
    app.press("export/section/Formats")
    app.wait("the list of formats", lambda: ("export/format/npy" in app.read_map()[1]) == on)


def pick(app, name, choice):
    app.press(name)
    app.press(f"{name}/{choice}")


def check_presets(app):
    for preset in ("unreal", "unity", "godot", "generic"):
        pick(app, "export/preset", preset)
        app.wait_fact("export.preset", preset)
        there, chosen = formats(app)
        check(chosen == PROPOSED[preset] & there, f"{preset} proposes {chosen}, of {there}")
        check(chosen >= PROPOSED[preset], f"{preset}: some of {PROPOSED[preset]} are missing in this build")


def check_sizes(app):
    """A format that is not compressed says its size to the byte (here: three digits)."""
    choose(app, "npy")
    type_into(app, "export/seconds", "2")
    type_into(app, "export/fps", "10")
    pick(app, "export/own_resolution", "on")
    type_into(app, "export/width", "100")
    type_into(app, "export/height", "50")
    app.wait("the size of 20 frames of 100 x 50", lambda: app.fact("export.size.npy") == "800 kB")
    check(app.fact("export.total").startswith("20 frames of 100 x 50\\n800 kB of "), app.fact("export.total"))
    app.press("export/response")
    app.wait_fact("export.size.npy", "4.0 MB")
    app.press("export/response")
    app.wait_fact("export.size.npy", "800 kB")


def check_warnings(app):
    choose(app, "npy")
    app.wait_fact("export.warnings", "")
    boxes = app.read_map()[1]
    check("export/layers" not in boxes, "height layers are for volumes only")
    check("export/clipping" not in boxes, "no integers, no clipping")
    choose(app, "fga")
    type_into(app, "export/width", "256")
    app.wait("a warning of the format's limit", lambda: "128" in app.fact("export.warnings"))
    check("export/warnings" in app.read_map()[1], "a sign beside what starts the export")
    app.wait("height layers", lambda: "export/layers" in app.read_map()[1])
    choose(app, "png")
    app.wait_fact("export.warnings", "")
    app.wait("the speeds", lambda: app.fact("export.clipping").startswith("Speeds now, fastest "))
    pick(app, "export/own_full_scale", "on")
    type_into(app, "export/full_scale", "3")
    app.wait("clipped cells", lambda: "% of cells clip" in app.fact("export.clipping"))
    part = float(app.fact("export.clipping").split("%")[0].split()[-1])
    check(part > 60, f"6 m/s of wind clip nearly everywhere at 3 m/s, not {part}%")
    type_into(app, "export/full_scale", "100")
    app.wait("nothing to clip", lambda: app.fact("export.clipping").startswith("Now no cells clip"))


def export_now(app, seconds=60):
    ended = app.fact("export.ended")
    app.press("export/start")
    app.wait("the export's end", lambda: app.fact("export.ended") != ended, seconds)
    outcome = app.fact("export.outcome")
    check(outcome.startswith("Exported "), outcome)


def contents(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


def check_export(app, folder, desk):
    choose(app, "npy", "windpack")
    type_into(app, "export/from", "0.2")
    type_into(app, "export/seconds", "0.5")
    type_into(app, "export/width", "32")
    type_into(app, "export/height", "32")
    export_now(app)
    manifest = json.loads((folder / "manifest.json").read_text())
    names = {entry["path"] for entry in manifest["files"]}
    check({"wind.npy", "wind.windpack"} <= names, f"exported {names}")
    check((folder / "wind.npy").stat().st_size == 128 + 5 * 32 * 32 * 8, "5 frames of 32 x 32")
    app.press("export/open")
    app.wait("the file manager", lambda: desk.exists())
    check(desk.read_text() == str(folder), f"shown was {desk.read_text()}, not {folder}")
    app.press("export/copy")
    app.wait("the copied path", lambda: app.fact("message") == f"Copied {folder}")


def check_refused(app, folder):
    """A folder that can't be written is told with its path; the usual one is back when the field is emptied."""
    before = contents(folder)
    type_into(app, "export/folder", "/proc/windloom-test")
    ended = app.fact("export.ended")
    app.press("export/start")
    app.wait("the refusal", lambda: app.fact("export.ended") != ended)
    check("/proc/windloom-test" in app.fact("export.outcome"), app.fact("export.outcome"))
    check("export/open" not in app.read_map()[1], "there is nothing to show")
    app.press("export/folder")
    app.wait_fact("typing", "yes")
    app.key("ctrl+a", "BackSpace", "Return")
    app.wait_fact("typing", "no")
    check(contents(folder) == before, "the export before stays")


def check_cancel(app, folder):
    before = contents(folder)
    type_into(app, "export/seconds", "3000")
    app.press("export/start")
    app.wait("the recording", lambda: "export/progress" in app.read_map()[1])
    frame = int(app.fact("frame"))
    app.wait("the window to go on", lambda: int(app.fact("frame")) > frame + 5)
    app.press("export/cancel")
    app.wait("the end", lambda: app.fact("export.running") == "no")
    check("cancelled" in app.fact("export.outcome"), app.fact("export.outcome"))
    check(contents(folder) == before, "a cancelled export must leave the one before as it was, and nothing else")
    type_into(app, "export/seconds", "0.5")


def check_again(app, folder):
    """The first export after the cancelled one; then edits make it again by themselves."""
    app.press("export/again")
    app.wait_fact("export/again", "yes")
    export_now(app)
    pack = folder / "wind.windpack"
    first = pack.read_bytes()
    app.point_at(app.centre("viewport"))
    app.key("a")
    app.key("shift+bracketright")
    app.key("shift+bracketright")
    edited = time.monotonic()
    app.wait_fact("dirty", "yes")
    app.wait("the export after an edit", lambda: app.fact("export.running") == "yes" or pack.read_bytes() != first)
    check(time.monotonic() - edited > 1, "it waits for more edits")
    app.wait("its end", lambda: app.fact("export.running") == "no" and pack.read_bytes() != first)
    app.press("export/again")
    app.wait_fact("export/again", "no")


def check_live(app, name):
    """Another program sees the wind that the editor shows, as it goes on; the editor's end is told."""
    app.wait_fact("playing", "yes")
    app.command("live wind on the project")  # however slow the machine
    show_formats(app, False)
    type_into(app, "export/live_name", name)
    app.press("export/live")
    app.wait("sharing", lambda: app.fact("live").endswith(" fields a second"))
    check(app.fact("status.live") == "live link", f"the status bar says {app.fact('status.live')}")
    check(app.fact("live").startswith(f"sharing {GRID} x {GRID}, "), app.fact("live"))
    reader = LiveReader(name)
    first = reader.field()
    check(first["size"] == (GRID, GRID), f"cells: {first['size']}")
    check(first["bounds"] == (-25, -25, 25, 25), f"bounds: {first['bounds']}")
    app.wait("later fields", lambda: reader.newest() > first["number"] + 5)
    later = reader.field()
    check(later["time"] > first["time"], "time goes on")
    speeds = [math.hypot(*cell) for cell in later["cells"]]
    check(abs(max(speeds) - later["fastest"]) < 0.02, f"{max(speeds)} m/s, told are {later['fastest']}")
    middle = later["cells"][GRID // 2 * GRID + GRID // 2]
    check(middle[0] > 4, f"the arrow draws the air in the middle along +x, found {middle}")
    app.key("space")
    app.wait_fact("playing", "no")
    app.wait("the held wind", lambda: app.fact("live").endswith("the wind is held"))
    held = reader.newest()
    app.key("period")
    app.wait("the field of one step", lambda: reader.newest() == held + 1)
    app.key("space")
    type_into(app, "export/live_name", "a/b")
    app.wait_fact("status.live", "no live link")
    check("a/b" in app.fact("live"), app.fact("live"))
    check(reader.ended() and not LiveReader.exists(name), "another name ends the one before")
    type_into(app, "export/live_name", name)
    app.wait_fact("status.live", "live link")
    show_formats(app, True)
    return LiveReader(name)


def check_gpu(app, folder):
    """Where the project asks for OpenGL, export and live link work with it, beside the window's."""
    app.wait("the wind on OpenGL", lambda: app.fact("status.grid").startswith("GPU"))
    app.key("ctrl+shift+e")
    app.wait("the choices", lambda: app.fact("export.total").startswith("5 frames"))
    export_now(app, 120)
    backend = json.loads((folder / "manifest.json").read_text())["solver"]["backend"]
    check(backend == "gpu", f"exported with {backend}")
    name = f"windloom-test-gpu-{os.getpid()}"
    show_formats(app, False)
    type_into(app, "export/live_name", name)
    app.press("export/live")
    app.wait("sharing", lambda: app.fact("live").startswith("sharing"))
    reader = LiveReader(name)
    app.wait("fields of the GPU", lambda: reader.newest() > 2)
    field = reader.field()
    width, height = field["size"]  # a slow machine's live grid is coarser
    middle = field["cells"][height // 2 * width + width // 2]
    check(middle[0] > 4, f"{field['size']}, in the middle {middle}")
    app.press("export/live")
    app.wait_fact("live", "")
    check(reader.ended() and not LiveReader.exists(name), "switched off, the link is gone")
    app.key("ctrl+q")
    check(app.wait_end() == 0, "closing must end the editor with 0")


def take_picture(windloom_editor, environment, home, project, picture):
    with editor(windloom_editor, environment, home, project, size="1280x920") as app:
        app.wait_fact("scene", "yes")
        app.key("ctrl+shift+e")
        app.wait("the export", lambda: app.fact("export.preset") != "")
        pick(app, "export/preset", "unreal")
        app.wait_fact("export.preset", "unreal")
        choose(app, "exr", "fga", "png")
        show_formats(app, False)
        pick(app, "export/own_full_scale", "on")
        type_into(app, "export/full_scale", "6")
        show_formats(app, True)
        app.wait("clipped cells", lambda: "% of cells clip" in app.fact("export.clipping"))
        app.point_at(app.centre("viewport"))
        app.picture(picture)
    subprocess.run(["convert", str(picture), "-crop", "320x830+960+58", "+repage", "-colors", "64", f"PNG8:{picture}"], check=True)


def main():
    windloom_editor = sys.argv[1]
    with tempfile.TemporaryDirectory(prefix="windloom-export-") as name, display("1280x1200") as environment:
        home = pathlib.Path(name)
        project = home / "small.wind.json"
        project.write_text(json.dumps(PROJECT))
        folder, desk = home / "small-wind", home / "shown"
        (home / "bin").mkdir()
        opener = home / "bin" / "xdg-open"
        opener.write_text(f'#!/bin/sh\nprintf %s "$1" > "{desk}.part" && mv "{desk}.part" "{desk}"\n')
        opener.chmod(0o755)
        environment["PATH"] = f"{home / 'bin'}:{os.environ['PATH']}"
        if len(sys.argv) > 2:
            return take_picture(windloom_editor, environment, home, str(project), pathlib.Path(sys.argv[2]))
        with editor(windloom_editor, environment, home, str(project), size=WINDOW) as app:
            app.wait_fact("scene", "yes")
            app.key("ctrl+shift+e")
            app.wait("the export", lambda: app.fact("export.preset") != "")
            check_presets(app)
            check_sizes(app)
            check_warnings(app)
            check_export(app, folder, desk)
            check_refused(app, folder)
            check_cancel(app, folder)
            check_again(app, folder)
            reader = check_live(app, f"windloom-test-{os.getpid()}")
            chosen = formats(app)[1]
            app.key("ctrl+s")
            app.wait_fact("dirty", "no")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing must end the editor with 0")
        check(reader.ended() and reader.field()["size"] == (GRID, GRID), "the end is told, the last field stays")
        with editor(windloom_editor, environment, home, str(project), size=WINDOW) as app:
            app.key("ctrl+shift+e")
            app.wait("the choices of the last session", lambda: formats(app)[1] == chosen)
            check(app.fact("export.total").startswith("5 frames of 32 x 32"), app.fact("export.total"))
            app.wait("the live link of the last session", lambda: app.fact("live").startswith("sharing"))
            show_formats(app, False)
            app.press("export/live")
            app.wait_fact("live", "")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing must end the editor with 0")
        (home / "gl.wind.json").write_text(json.dumps(dict(PROJECT, solver={"backend": "gpu"})))
        with editor(windloom_editor, environment, home, str(home / "gl.wind.json"), size=WINDOW) as app:
            check_gpu(app, home / "gl-wind")
    print("formats proposed, sized and warned of; exported, cancelled, exported again, shared; remembered")


if __name__ == "__main__":
    run(main)
