"""Shell grass in a real window: switched to by key while view, wind and time stay; its tab, what it says is drawn, a bad
picture that is refused and a good one that is taken and cleared; saved, and the file asked.

usage: shell_test.py WINDLOOM_EDITOR WINDLOOM
"""
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

from editor_driver import check, display, editor, run

PROJECT = {"format": "windloom-project", "version": 1, "name": "Shells",
           "field": {"centre": [0, 0], "size": [40, 40], "resolution": [48, 48]}, "grass": {"density": 20},
           "shell": {"shells": 6, "texture": {"texels": 128, "tile": 2}},
           "ambient": {"speed": 5, "gusts": {"strength": 0.5}},
           "cameras": [{"id": 50, "name": "hero", "position": [0, 12, 22], "target": [0, 0, 0]}]}
# Groups above its own with a row of each: they are closed, so that its own stand in the window.
OF_ALL_GRASS = (("Blades", "clumping"), ("Dynamics", "windFactor"), ("Colours", "dryness"), ("Shade", "shadow/min"),
                ("Ground", "slope/limit"), ("Maps", "maps/colour"))


def write_png(path, alpha):
    """Green, 8 x 8; `alpha` of a pixel's column and row."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + b"".join(bytes((40, 120, 20, alpha(x, y))) for x in range(8)) for y in range(8))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 8, 8, 8, 6, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def steps(app, count):
    app.wait_fact("steps", str(count))


def switch(app):
    """Time is held, so that what must stay can be compared."""
    app.wait("some wind", lambda: float(app.fact("time") or 0) > 0.5)
    app.key("space")
    app.wait_fact("playing", "no")

    def state():
        return [app.fact(name) for name in ("time", "camera", "wind")]

    before = state()
    for key, kind, count in (("3", "shell", 1), ("1", "instanced", 2), ("3", "shell", 3)):
        app.key(key)
        app.wait_fact("grass", kind)
        steps(app, count)
        app.wait(f"blades of {kind}", lambda: not app.fact("status.blades").startswith("0 /"))
        check(state() == before, f"{kind}: time, view and wind must stay: {before} became {state()}")
    app.key("space")


def tab(app):
    app.press("inspector/tab/Grass")
    for group, row in OF_ALL_GRASS:
        app.press(f"inspector/grass/group/{group}")
        app.wait(f"{group} closed", lambda: not any(name.startswith(f"inspector/grass/{row}") for name in app.read_map()[1]))
    app.wait("layers drawn", lambda: int(app.fact("shell count.layers") or 0) > 0)
    # A slow machine draws fewer of them.
    check(1 <= int(app.fact("shell count.shells")) <= 6, f"shells near the camera: {app.fact('shell count.shells')}")


def choose_picture(app, folder):
    app.press("inspector/shell/texture/file/browse")
    app.wait_fact("dialog", "asset")
    app.choose_path(folder / "solid.png")
    app.wait("the reason why not", lambda: "has no transparency" in (app.fact("dialog.text") or ""))
    app.key("Escape")
    steps(app, 3)
    app.press("inspector/shell/texture/file/browse")
    app.wait_fact("dialog", "asset")
    app.choose_path(folder / "blades.png")
    steps(app, 4)
    app.press("inspector/shell/texture/file/clear")
    steps(app, 5)
    app.key("ctrl+z")
    steps(app, 4)


def main():
    program, windloom = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        folder = pathlib.Path(name)
        write_png(folder / "solid.png", lambda x, y: 255)
        write_png(folder / "blades.png", lambda x, y: 200 if x % 4 == 1 and y % 4 == 1 else 0)
        project = folder / "shells.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(program, environment, folder, str(project)) as app:
            app.wait_fact("scene", "yes")
            switch(app)
            tab(app)
            choose_picture(app, folder)
            app.key("ctrl+s")
            app.wait_fact("dirty", "no")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing a saved project must end the editor with 0")
        saved = json.loads(project.read_text())
        check(saved["grass"]["kind"] == "shell", f"saved kind: {saved['grass']['kind']}")
        check(saved["shell"]["texture"]["file"] == "blades.png", f"saved picture: {saved['shell']['texture']}")
        told = subprocess.run([windloom, "validate", str(project)], capture_output=True, text=True)
        check(told.returncode == 0, told.stdout + told.stderr)
    print("switched, its tab shown, a picture refused and one taken, saved")


if __name__ == "__main__":
    run(main)
