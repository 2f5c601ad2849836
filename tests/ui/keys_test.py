"""Keys and gestures that need the real window, one row each: what is pressed and what the editor says, or saves, after it.
Those that need no window are rows of tests/unit/editor/key_table_test.cpp.

usage: keys_test.py WINDLOOM_EDITOR
"""
import json
import pathlib
import sys
import tempfile

from editor_driver import Failure, check, display, editor, run
from window_test import PROJECT, TopView

PROJECT = dict(PROJECT, graph={
    "points": [{"id": 1, "name": "gate", "position": [-20, 0]}, {"id": 2, "position": [0, 0]},
               {"id": 3, "position": [15, -8]}, {"id": 4, "position": [15, 8]}],
    "arrows": [{"id": 10, "from": 1, "to": 2}, {"id": 11, "from": 2, "to": 3}, {"id": 12, "from": 2, "to": 4}]},
    cameras=[{"id": 50, "name": "hero", "position": [0, 40, 60], "target": [0, 0, 0], "fieldOfView": 45}])


class Rows:
    def __init__(self, app, project):
        self.app, self.project, self.count = app, project, 0

    def row(self, what, act, expect):
        """`act` presses or is a key; `expect` is asked until it is true."""
        if callable(act):
            act()
        else:
            self.app.key(act)
        try:
            self.app.wait(what, expect, seconds=20)
        except Failure as failure:
            raise Failure(f"{what}: {failure}") from None
        self.count += 1

    def says(self, name, value):
        return lambda: self.app.fact(name) == value

    def saved(self):
        self.app.key("ctrl+s")
        self.app.wait_fact("dirty", "no")
        return json.loads(self.project.read_text())


def play(rows):
    app, says = rows.app, rows.says
    app.wait_fact("playing", "yes")
    rows.row("Space holds", "space", says("playing", "no"))
    before = float(app.fact("time"))
    rows.row("Period steps once", "period", lambda: 0 < float(app.fact("time")) - before < 0.1)
    rows.row("Shift+Space restarts", "shift+space", lambda: float(app.fact("time")) == 0)
    rows.row("Space plays", "space", says("playing", "yes"))
    rows.row("time goes on", lambda: None, lambda: float(app.fact("time")) > 0)


def seeing(rows):
    """What the picture shows: digits for the grass and the overlays."""
    app, says = rows.app, rows.says
    # Ground maps take turns, marks and lines add up.
    for key, shown in (("6", "arrows streamlines"), ("7", "arrows streamlines speed"),
                       ("8", "arrows streamlines divergence"), ("9", "arrows streamlines lic"), ("9", "arrows streamlines"),
                       ("6", "arrows"), ("5", ""), ("5", "arrows")):
        rows.row(f"{key} leaves {shown or 'nothing'} shown", key, lambda: sorted(app.fact("overlays").split()) == sorted(shown.split()))
    rows.row("4 leaves the ground bare", "4", says("status.blades", "0 / 0 blades"))
    rows.row("2 is Bezier grass", "2", lambda: app.fact("grass") == "bezier" and not app.fact("status.blades").endswith("/ 0 blades"))
    rows.row("3 is shell grass", "3", lambda: app.fact("grass") == "shell" and not app.fact("status.blades").endswith("/ 0 blades"))
    rows.row("1 is instanced grass", "1", lambda: not app.fact("status.blades").endswith("/ 0 blades"))
    check(rows.saved()["grass"]["kind"] == "instanced", "the kind of grass is the project's")
    app.key("ctrl+z", "ctrl+z", "ctrl+z", "ctrl+z")
    app.wait_fact("steps", "0")
    rows.saved()


def windows(rows):
    app, says = rows.app, rows.says
    rows.row("F1 shows the keys", "F1", says("help", "yes"))
    rows.row("F1 again hides them", "F1", says("help", "no"))
    for keys in ("F3", "ctrl+shift+p"):
        rows.row(f"{keys} opens the palette", keys, says("palette", "yes"))
        rows.row("Esc closes it", "Escape", says("palette", "no"))
    rows.row("the palette runs a command", "F3", says("typing", "yes"))
    app.type("top view")
    rows.row("Enter runs what was found", "Return", says("view", "top"))
    for keys, dialog in (("ctrl+o", "open"), ("ctrl+shift+s", "save as")):
        rows.row(f"{keys} asks for a file", keys, says("dialog", dialog))
        rows.row("Esc closes the dialog", "Escape", says("dialog", ""))
    rows.row("Ctrl+Shift+E shows the export", "ctrl+shift+e", lambda: "export/preset" in app.read_map()[1])
    app.press("inspector/tab/Selection")


def views(rows):
    app, says = rows.app, rows.says
    rows.row("a project opens with its camera", lambda: None, says("view", "perspective"))
    for what, keys in (("front", "KP_End"), ("side", "KP_Next")):
        rows.row(f"numpad: {what}", keys, says("view", "orthographic"))
        rows.row("numpad 5 switches to perspective", "KP_Begin", says("view", "perspective"))
    rows.row("numpad 7: top", "KP_Home", says("view", "top"))
    app.key("shift+f")
    return TopView(app)


def edits(rows, view):
    app, says = rows.app, rows.says
    for keys, tool in (("d", "draw"), ("o", "obstacle"), ("v", "vortex"), ("p", "probe"), ("b", "brush"),
                       ("w", "move"), ("e", "rotate"), ("r", "scale"), ("q", "select")):
        rows.row(f"{keys} chooses {tool}", keys, says("tool", tool))
    for tool in ("vortex", "brush", "select"):
        rows.row(f"the toolbar has {tool}", lambda tool=tool: app.press(f"toolbar/tool.{tool}"), says("tool", tool))
    rows.row("a click selects", lambda: app.click(view.pixel((-20, 0))), says("selection", "Point 1 (gate)"))
    rows.row("F2 opens the name", "F2", says("typing", "yes"))
    app.key("ctrl+a")
    app.type("wind mill")
    rows.row("Enter takes it", "Return", says("steps", "1"))
    check(rows.saved()["graph"]["points"][0]["name"] == "wind mill", "the name must be saved")
    rows.row("Ctrl+C, Ctrl+V copy", lambda: (app.key("ctrl+c"), app.point_at(view.pixel((-20, 12))),
                                             app.key("ctrl+v")), says("steps", "2"))
    rows.row("Ctrl+Z undoes", "ctrl+z", says("steps", "1"))
    rows.row("Ctrl+Y redoes", "ctrl+y", says("steps", "2"))
    rows.row("a click selects the copy", lambda: app.click(view.pixel((-20, 12))),
             lambda: app.fact("selection").startswith("Point"))
    rows.row("Del deletes", "Delete", says("steps", "3"))
    rows.row("a drag moves", lambda: app.drag(view.pixel((15, 8)), view.pixel((20, 14))), says("steps", "4"))
    rows.row("focus is kept by a text field", lambda: None, says("typing", "no"))


def polygon(rows, view):
    """Drawn by clicks; then a corner moved, one put in, one taken out."""
    app, says = rows.app, rows.says
    corners = [(-28, 8), (-22, 8), (-22, 14), (-28, 14)]
    app.key("o")
    app.wait_fact("tool", "obstacle")
    rows.row("clicks make corners", lambda: [app.click(view.pixel(c)) for c in corners], says("dragging", "yes"))
    rows.row("Enter closes the polygon", "Return", says("steps", "5"))
    app.key("q")
    app.wait_fact("tool", "select")
    check("grip:corner:0" in app.read_map()[1] or app.centre("grip:corner:0"), "corners must have handles")
    rows.row("a corner is dragged", lambda: app.drag(view.pixel((-22, 14)), view.pixel((-19, 17))), says("steps", "6"))

    def ctrl_click():
        app.point_at(view.pixel((-25, 8)))
        app.xdotool("keydown", "ctrl", "click", 1)
        app.wait_fact("steps", "7")
        app.xdotool("keyup", "ctrl")

    rows.row("Ctrl+click puts a corner in", ctrl_click, says("steps", "7"))
    check(len(rows.saved()["obstacles"][0]["points"]) == 5, "five corners are saved")
    app.point_at(view.pixel((-28, 14)))
    rows.row("Del takes the corner under the pointer out", "Delete", says("steps", "8"))
    check(len(rows.saved()["obstacles"][0]["points"]) == 4, "four corners are saved")


def brush(rows, view):
    app = rows.app
    app.key("b")
    app.wait_fact("tool", "brush")
    app.point_at(view.pixel((-10, -15)))
    app.xdotool("mousedown", 1)
    app.point_at(view.pixel((0, -15)))
    app.point_at(view.pixel((10, -15)))
    rows.row("the brush leaves strokes", lambda: app.xdotool("mouseup", 1), lambda: int(app.fact("strokes")) > 0)
    rows.row("they fade", lambda: None, rows.says("strokes", "0"))
    check(app.fact("dirty") == "no", "the brush makes no edit")
    app.key("q")


def outliner(rows):
    app, says = rows.app, rows.says
    steps = int(app.fact("steps"))
    first, last = app.centre("outliner/40"), app.centre("outliner/42")
    rows.row("a row is dragged", lambda: app.drag(last, (first[0], first[1] - 8)), says("steps", str(steps + 1)))
    order = [probe["id"] for probe in rows.saved()["probes"]]
    check(order == [42, 40, 41], f"probes in the order {order}")
    first, second = app.centre("outliner/11"), app.centre("outliner/12")
    rows.row("arrows change places", lambda: app.drag(second, (first[0], first[1] - 8)), says("steps", str(steps + 2)))
    order = [arrow["id"] for arrow in rows.saved()["graph"]["arrows"]]
    check(order.index(12) < order.index(11), f"arrows in the order {order}")
    place = app.centre("outliner/40")
    app.point_at(place)
    app.xdotool("mousedown", 1)
    app.point_at((place[0], place[1] + 40))
    app.key("Escape")
    app.point_at((place[0], place[1] + 41))
    app.xdotool("mouseup", 1)
    app.point_at((place[0] + 2, place[1] + 42))
    rows.row("Esc cancels a dragged row", lambda: None, says("steps", str(steps + 2)))
    rows.row("Ctrl+Z takes the order back", "ctrl+z", says("steps", str(steps + 1)))


def main():
    windloom_editor = sys.argv[1]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        project = pathlib.Path(name) / "keys.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(windloom_editor, environment, name, str(project)) as app:
            app.wait_fact("scene", "yes")
            rows = Rows(app, project)
            view = views(rows)
            play(rows)
            seeing(rows)
            windows(rows)
            edits(rows, view)
            polygon(rows, view)
            brush(rows, view)
            outliner(rows)
            rows.row("Ctrl+S saves", "ctrl+s", rows.says("dirty", "no"))
            rows.row("Ctrl+N starts anew", "ctrl+n", lambda: app.fact("title").startswith("Untitled"))
            app.key("ctrl+q")
            check(app.wait_end() == 0, "closing must end the editor with 0")
    print(f"{rows.count} keys and gestures did what they should")


if __name__ == "__main__":
    run(main)
