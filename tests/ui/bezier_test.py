"""Bezier grass in a real window: switched to by key while view, wind and time stay; a surface and a rotor added by the
toolbar and dragged; debug views and culling tests with their counts; saved, and the file asked.

usage: bezier_test.py WINDLOOM_EDITOR WINDLOOM
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from editor_driver import check, display, editor, run

PROBE = (6.0, 4.0)
PROJECT = {"format": "windloom-project", "version": 1, "name": "Bezier",
           "field": {"centre": [0, 0], "size": [40, 40], "resolution": [48, 48]}, "grass": {"density": 20},
           "ambient": {"speed": 5, "gusts": {"strength": 0.5}},
           "probes": [{"id": 40, "position": list(PROBE)}],
           "cameras": [{"id": 50, "name": "hero", "position": [0, 12, 22], "target": [0, 0, 0]}]}
TESTS = ("orientation", "frustum", "distance", "occlusion")


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
    for key, kind, count in (("2", "bezier", 1), ("1", "instanced", 2), ("2", "bezier", 3)):
        app.key(key)
        app.wait_fact("grass", kind)
        steps(app, count)
        app.wait(f"blades of {kind}", lambda: not app.fact("status.blades").startswith("0 /"))
        check(state() == before, f"{kind}: time, view and wind must stay: {before} became {state()}")
    app.key("space")


def add_things(app):
    app.press("toolbar/surfaces")
    app.press("menu/add.torus")
    steps(app, 4)
    check(app.fact("selection") == "Surface 51", f"what was added must be selected: {app.fact('selection')}")
    app.drag(app.centre("surface:51"), app.centre("probe:40"))
    steps(app, 5)
    app.press("toolbar/add.rotor")
    steps(app, 6)
    app.wait_fact("selection", "Rotor 52")
    x, y = app.centre("grip:radius")
    app.drag((x, y), (x + 60, y))
    steps(app, 7)


def look(app):
    app.press("toolbar/grass_view")
    app.press("grass_view")
    app.press("grass_view.culled")
    app.wait_fact("grass view", "culled")

    def counts():
        shown = app.read_map()[0]
        if any(f"cull.{test}" not in shown for test in TESTS):
            return False
        left_out = sum(int(shown[f"cull.{test}"]) for test in TESTS)
        seen, drawn = int(shown["grass count.In the patches seen"]), int(shown["grass count.Drawn"])
        return drawn > 0 and seen == drawn + left_out

    app.wait("counts that add up", counts)
    app.wait("some that are seen from the side", lambda: int(app.fact("cull.orientation")) > 0)
    app.press("cull.orientation")
    app.wait_fact("culling", "frustum distance occlusion")
    app.wait("none left out for it", lambda: app.fact("cull.orientation") == "0" and counts())
    app.press("cull.orientation")
    app.wait_fact("culling", " ".join(TESTS))
    app.key("Escape")


def main():
    program, windloom = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        folder = pathlib.Path(name)
        project = folder / "bezier.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(program, environment, folder, str(project)) as app:
            app.wait_fact("scene", "yes")
            switch(app)
            add_things(app)
            look(app)
            app.key("ctrl+s")
            app.wait_fact("dirty", "no")
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing a saved project must end the editor with 0")
        saved = json.loads(project.read_text())
        check(saved["grass"]["kind"] == "bezier", f"saved kind: {saved['grass']['kind']}")
        (surface,), (rotor,) = saved["surfaces"], saved["rotors"]
        away = math.dist(surface["position"], PROBE)
        check(surface["shape"] == "torus" and away < 0.6, f"the surface {surface} lies {away:.2f} m from where it was dragged to")
        check(rotor["radius"] > 5.5, f"the rotor's radius must have grown: {rotor}")
        told = subprocess.run([windloom, "validate", str(project)], capture_output=True, text=True)
        check(told.returncode == 0, told.stdout + told.stderr)
    print("switched, a surface and a rotor added and dragged, culling counted, saved")


if __name__ == "__main__":
    run(main)
