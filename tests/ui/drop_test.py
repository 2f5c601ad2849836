"""Files dropped on the real window: a project opens, after a question where there is unsaved work; a picture and a glTF mesh
become the ground; anything else is refused with a line that says what may be dropped.

usage: drop_test.py WINDLOOM_EDITOR PROJECTS
"""
import json
import pathlib
import shutil
import sys
import tempfile

from drop import DropSource
from editor_driver import Failure, check, display, editor, run


def write_mesh(file):
    """A pyramid 40 m wide and 10 m high, as a glTF file that holds its own data."""
    import base64
    import struct
    corners = [(-20, 0, -20), (20, 0, -20), (20, 0, 20), (-20, 0, 20), (0, 10, 0)]
    sides = [0, 4, 1, 1, 4, 2, 2, 4, 3, 3, 4, 0]
    data = b"".join(struct.pack("<3f", *corner) for corner in corners) + struct.pack("<12H", *sides)
    file.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
        "bufferViews": [{"buffer": 0, "byteLength": 60}, {"buffer": 0, "byteOffset": 60, "byteLength": 24}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3", "min": [-20, 0, -20], "max": [20, 10, 20]},
                      {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]}))


def drop_all(app, folder, elsewhere, environment):
    source = DropSource(environment["DISPLAY"])
    middle = app.centre("viewport")

    def drop(file):
        source.drop(int(app.window), (app.origin[0] + middle[0], app.origin[1] + middle[1]), [file])

    app.wait_fact("scene", "yes")
    drop(elsewhere / "heights.png")
    app.wait("that the project has to be saved", lambda: "Save the project first" in app.fact("message"))
    drop(folder / "first.wind.json")
    app.wait("the project", lambda: app.fact("title").startswith("first.wind.json"))
    drop(elsewhere / "heights.png")
    app.wait_fact("terrain", "assets/heights.png")
    app.wait_fact("steps", "1")
    drop(elsewhere / "pyramid.gltf")
    app.wait_fact("terrain", "assets/pyramid.gltf")
    app.key("ctrl+z")
    app.wait_fact("terrain", "assets/heights.png")
    drop(elsewhere / "notes.txt")
    app.wait("a refusal", lambda: "notes.txt" in app.fact("message"))
    drop(folder / "second.wind.json")
    app.wait_fact("dialog", "save changes")
    app.press("dialog/Save")
    app.wait("the other project", lambda: app.fact("title").startswith("second.wind.json"))
    saved = json.loads((folder / "first.wind.json").read_text())
    check(saved["terrain"]["file"] == "assets/heights.png", f"saved as {saved['terrain']}")
    check((folder / "assets" / "heights.png").exists(), "the picture must lie beside the project")


def main():
    windloom_editor, projects = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="windloom-drop-") as name, display() as environment:
        folder, elsewhere, home = (pathlib.Path(name) / part for part in ("work", "elsewhere", "home"))
        for made in (folder, elsewhere, home):
            made.mkdir()
        shutil.copy(next(pathlib.Path(projects).glob("hills/**/*.png")), elsewhere / "heights.png")
        write_mesh(elsewhere / "pyramid.gltf")
        (elsewhere / "notes.txt").write_text("nothing to open")
        for project in ("first", "second"):
            (folder / f"{project}.wind.json").write_text(json.dumps({
                "format": "windloom-project", "version": 1, "name": project, "field": {"resolution": [64, 64]},
                "grass": {"density": 1}}))
        with editor(windloom_editor, environment, home) as app:
            drop_all(app, folder, elsewhere, environment)
    print("projects, a height map and a mesh dropped; the rest refused")


if __name__ == "__main__":
    run(main)
