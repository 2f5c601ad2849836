"""Colliders and plants in a real window: a collider and species added by palette, toolbar, menu and from a glTF file, the
collider dragged, a density map set and cleared; undone, redone, saved, and the file asked.

usage: plants_test.py WINDLOOM_EDITOR WINDLOOM
"""
import json
import math
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib

from editor_driver import check, display, editor, run

# Probes show where known places of the ground lie on the screen.
PROBES = {40: (-10.0, 0.0), 41: (10.0, 5.0)}
PROJECT = {"format": "windloom-project", "version": 1, "name": "Plants",
           "field": {"centre": [0, 0], "size": [60, 60], "resolution": [48, 48]}, "grass": {"density": 2},
           "probes": [{"id": id, "position": list(at)} for id, at in PROBES.items()]}


def write_glb(path):
    """A pyramid of 0.5 m."""
    positions = struct.pack("<15f", -.1, 0, -.1, .1, 0, -.1, .1, 0, .1, -.1, 0, .1, 0, .5, 0)
    indices = struct.pack("<18H", 0, 2, 1, 0, 3, 2, 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4)
    data = positions + indices
    text = json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3", "min": [-.1, 0, -.1],
                       "max": [.1, .5, .1]}, {"bufferView": 1, "componentType": 5123, "count": 18, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 60},
                        {"buffer": 0, "byteOffset": 60, "byteLength": 36}],
        "buffers": [{"byteLength": len(data)}]}).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(b"glTF" + struct.pack("<II", 2, 28 + len(text) + len(data)) + struct.pack("<I", len(text)) + b"JSON" +
                     text + struct.pack("<I", len(data)) + b"BIN\0" + data)


def write_png(path):
    """Grey, 2 x 2."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 2, 2, 8, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(b"\0\x40\xff\0\xff\x40")) + chunk(b"IEND", b""))


def steps(app, count):
    app.wait_fact("steps", str(count))


def add_things(app, folder):
    app.command("add collider")
    steps(app, 1)
    check(app.fact("selection").startswith("Collider"), f"what was added must be selected: {app.fact('selection')}")
    app.press("toolbar/species")
    app.press("menu/add.daisies")
    steps(app, 2)
    app.press("menu/Add")
    app.press("menu/add.poppies")
    steps(app, 3)
    app.press("menu/Add")
    app.press("menu/add.species_file")
    app.wait_fact("dialog", "asset")
    app.choose_path(folder / "tuft.glb")
    steps(app, 4)
    check(app.fact("selection") == "Species 45 (tuft)", f"the new plant must be selected: {app.fact('selection')}")


def drag_collider(app):
    """From where it is onto a probe's place, as one step that undo takes back."""
    app.press("outliner/42")
    app.wait_fact("selection", "Collider 42")
    before = app.centre("collider:42")
    app.drag(before, app.centre("probe:41"))
    steps(app, 5)
    app.key("ctrl+z")
    steps(app, 4)
    again = app.centre("collider:42")
    check(math.dist(before, again) < 2, f"undo must put it back: {before} and {again}")
    app.key("ctrl+shift+z")
    steps(app, 5)


def set_map(app, folder):
    app.press("inspector/tab/Grass")
    # Groups above the maps are closed, so that these stand in the window.
    for group, row in (("Dynamics", "windFactor"), ("Colours", "dryness"), ("Shade", "shadow/min")):
        app.press(f"inspector/grass/group/{group}")
        app.wait(f"{group} closed", lambda: f"inspector/grass/{row}" not in app.read_map()[1])
    app.press("inspector/grass/maps/density/browse")
    app.wait_fact("dialog", "asset")
    app.choose_path(folder / "mask.png")
    steps(app, 6)
    app.press("inspector/grass/maps/density/clear")
    steps(app, 7)
    app.key("ctrl+z")
    steps(app, 6)


def main():
    program, windloom = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        folder = pathlib.Path(name)
        (folder / "project").mkdir()
        project = folder / "project" / "plants.wind.json"
        project.write_text(json.dumps(PROJECT))
        write_glb(folder / "tuft.glb")
        write_png(folder / "mask.png")
        with editor(program, environment, folder, str(project)) as app:
            app.wait_fact("scene", "yes")
            add_things(app, folder)
            drag_collider(app)
            set_map(app, folder)
            app.key("ctrl+s")
            app.wait_fact("dirty", "no")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing a saved project must end the editor with 0")
        saved = json.loads(project.read_text())
        (collider,) = saved["colliders"]
        away = math.dist(collider["position"], PROBES[41])
        check(away < 0.6, f"the collider at {collider['position']} lies {away:.2f} m from the probe it was dragged to")
        shapes = [(plant["shape"], plant.get("file")) for plant in saved["species"]]
        check(shapes == [("daisy", None), ("poppy", None), ("mesh", "assets/tuft.glb")], f"saved species: {shapes}")
        check(saved["grass"]["maps"] == {"density": "assets/mask.png"}, f"saved maps: {saved['grass'].get('maps')}")
        for file in ("tuft.glb", "mask.png"):
            check((folder / "project" / "assets" / file).exists(), f"{file} must have come to assets/")
        told = subprocess.run([windloom, "validate", str(project)], capture_output=True, text=True)
        check(told.returncode == 0, told.stdout + told.stderr)
    print("a collider and plants added, dragged, undone, redone and saved; a map set, cleared and brought back")


if __name__ == "__main__":
    run(main)
