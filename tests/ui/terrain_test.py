"""Hills in a real window: chooses a height map, draws an arrow on the slopes, undoes and redoes, saves; the saved places
are where the pixels lie on the ground, worked out here from the height map.

usage: terrain_test.py WINDLOOM_EDITOR
"""
import json
import math
import pathlib
import struct
import sys
import tempfile
import zlib

from editor_driver import check, display, editor, run

SIDE, SIZE, HEIGHT = 65, 100.0, 20.0
# Probes on a diagonal ramp show in the perspective view where known places of the ground lie.
PROBES = {40: (-20.0, -10.0), 41: (15.0, 10.0)}
PROJECT = {"format": "windloom-project", "version": 1, "name": "Hills",
           "field": {"centre": [0, 0], "size": [SIZE, SIZE], "resolution": [64, 64]}, "grass": {"density": 2},
           "probes": [{"id": id, "position": list(at)} for id, at in PROBES.items()]}


def write_png(path):
    """A wave along x that rises along z."""
    def value(i, k):
        return 0.5 + 0.25 * math.sin(8.0 * i / (SIDE - 1)) + 0.2 * (k / (SIDE - 1) - 0.5)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    rows = b"".join(b"\0" + b"".join(struct.pack(">H", round(65535 * value(i, k))) for i in range(SIDE)) for k in range(SIDE))
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIDE, SIDE, 16, 0, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        folder = pathlib.Path(name)
        (folder / "project").mkdir()
        project = folder / "project" / "hills.wind.json"
        project.write_text(json.dumps(PROJECT))
        write_png(folder / "wave.png")
        with editor(program, environment, folder, str(project)) as app:
            app.wait_fact("scene", "yes")
            flat = {id: app.centre(f"probe:{id}") for id in PROBES}
            app.press("inspector/tab/Terrain")
            app.press("inspector/terrain/browse")
            app.wait_fact("dialog", "terrain")
            app.choose_path(folder / "wave.png")
            app.wait_fact("terrain", "assets/wave.png")
            app.wait_fact("steps", "1")
            check((folder / "project" / "assets" / "wave.png").exists(), "a file from elsewhere must come to assets/")
            hilly = {id: app.centre(f"probe:{id}") for id in PROBES}
            for id in PROBES:
                check(flat[id][1] - hilly[id][1] > 5, f"probe {id} must rise with its hill: {flat[id]} to {hilly[id]}")

            # The probes' handles stand on known places of the hills: an arrow drawn between their pixels must end there.
            app.key("d")
            app.wait_fact("tool", "draw")
            app.drag(hilly[40], hilly[41])
            app.wait_fact("steps", "2")
            app.key("Escape")
            app.key("ctrl+z", "ctrl+z")
            app.wait_fact("terrain", "flat")
            app.key("ctrl+shift+z", "ctrl+shift+z")
            app.wait_fact("steps", "2")
            app.wait_fact("terrain", "assets/wave.png")
            app.key("ctrl+s")
            app.wait_fact("dirty", "no")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing a saved project must end the editor with 0")
        saved = json.loads(project.read_text())
        terrain = saved["terrain"]
        check((terrain["kind"], terrain["file"]) == ("heightmap", "assets/wave.png"), f"saved terrain: {terrain}")
        places = {point["id"]: point["position"] for point in saved["graph"]["points"]}
        (arrow,) = saved["graph"]["arrows"]
        # One pixel is at most about 0.15 m across here, several times that along the view.
        for end, id in ((arrow["from"], 40), (arrow["to"], 41)):
            away = math.dist(places[end], PROBES[id])
            check(away < 0.6, f"the arrow's end {places[end]} lies {away:.2f} m from the hill's {PROBES[id]}")
    print("a height map chosen, drawn on, undone, redone and saved")


if __name__ == "__main__":
    run(main)
