"""The tree of the paper's Figure 8 by hand in the real window: a root, two levels of branches, two flows that merge; beside
it a ring, an obstacle, a polygon; the wind as a pulse that travels, set in the inspector. Saved, read again, and asked of
`windloom sample`: calm at the tips before the pulse arrives, along the arrows after it.

usage: figure8_test.py WINDLOOM_EDITOR WINDLOOM
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from editor_driver import check, display, editor, run
from window_test import PROJECT, TopView, near

ROOT, FORK = (-30.0, 0.0), (-14.0, 0.0)
LEFT, RIGHT = (0.0, -9.0), (0.0, 9.0)
TIPS = [(16.0, -17.0), (18.0, 0.0), (16.0, 17.0)]
RING = [(-28.0, 12.0), (-20.0, 12.0), (-20.0, 18.0), (-28.0, 18.0)]
POLYGON = [(-12.0, 14.0), (-6.0, 13.0), (-7.0, 17.0), (-12.0, 18.0)]
# In the order they are drawn; the last flow joins the tip that the other branch made.
ARROWS = [(ROOT, FORK), (FORK, LEFT), (FORK, RIGHT), (LEFT, TIPS[0]), (LEFT, TIPS[1]), (RIGHT, TIPS[2]),
          (RIGHT, TIPS[1])]


def draw(app, view):
    steps = 0

    def done(count=1):
        nonlocal steps
        steps += count
        app.wait_fact("steps", str(steps))

    app.key("d")
    app.wait_fact("tool", "draw")
    for start, end in ARROWS:
        app.drag(view.pixel(start), view.pixel(end))
        done()
    # The ring: corner by corner, closed on its first point.
    for corner in [*RING, RING[0]]:
        app.click(view.pixel(corner))
    done(4)
    check(app.fact("dragging") == "no", "joining a point ends the chain")
    app.key("o")
    app.wait_fact("tool", "obstacle")
    app.drag(view.pixel((27.0, -10.0)), view.pixel((29.0, -10.0)))
    done()
    for corner in POLYGON:
        app.click(view.pixel(corner))
    app.key("Return")
    done()
    # A pulse for the tree, in the inspector of its root.
    app.key("q")
    app.wait_fact("tool", "select")
    app.click(view.pixel(ROOT))
    app.wait("the root to be selected", lambda: app.fact("selection").startswith("Point"))
    app.press("inspector/signal/kind")
    app.press("inspector/signal/kind/pulse")
    done()
    for name, value in (("period", "30"), ("on", "12")):
        app.press(f"inspector/signal/{name}")
        app.wait_fact("typing", "yes")
        app.type(value)
        app.key("Return")
        done()
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    app.key("ctrl+q")
    check(app.wait_end() == 0, "closing a saved project must end the editor with 0")


def check_saved(project, pixel_m):
    saved = json.loads(project.read_text())
    places = {point["id"]: tuple(point["position"]) for point in saved["graph"]["points"]}
    tree, ring = saved["graph"]["arrows"][:7], saved["graph"]["arrows"][7:]
    check(len(ring) == 4 and len(places) == 11, f"7 + 4 arrows and 7 + 4 points, saved {len(ring)} and {len(places)}")
    for arrow, (start, end) in zip(tree, ARROWS):
        check(near(places[arrow["from"]], start, 2 * pixel_m) and near(places[arrow["to"]], end, 2 * pixel_m),
              f"an arrow goes from {places[arrow['from']]} to {places[arrow['to']]}, drawn from {start} to {end}")
    check(tree[4]["to"] == tree[6]["to"], "two flows must merge in the middle tip")
    check([a["to"] for a in ring] == [ring[1]["from"], ring[2]["from"], ring[3]["from"], ring[0]["from"]],
          f"the ring must be closed: {ring}")
    signals = [s for s in saved["graph"]["signals"] if s["root"] == tree[0]["from"]]
    check(len(signals) == 1 and (signals[0]["kind"], signals[0]["period"], signals[0]["on"]) == ("pulse", 30, 12),
          f"the root's signal was saved as {signals}")
    shapes = [(o["shape"], len(o.get("points", []))) for o in saved["obstacles"]]
    check(shapes == [("circle", 0), ("polygon", 4)], f"obstacles saved as {shapes}")
    return [(places[a["from"]], places[a["to"]], a) for a in (tree[3], tree[5])]


def sample(windloom, project, tips, seconds):
    at = [part for _, end, _ in tips for part in ("--at", f"{end[0]},{end[1]}")]
    result = subprocess.run([windloom, "sample", str(project), *at, "--time", str(seconds), "--backend", "cpu", "--json"],
                            capture_output=True, text=True)
    check(result.returncode == 0, f"windloom sample: {result.stderr}")
    return [one["velocity"] for one in json.loads(result.stdout)["samples"]]


def check_wind(windloom, project, tips):
    """The outer tips: the merged one gets wind from both sides."""
    before, after = sample(windloom, project, tips, 0.5), sample(windloom, project, tips, 7)
    for (start, end, arrow), early, late in zip(tips, before, after):
        along = [end[i] - start[i] for i in range(2)]
        speed = sum(late[i] * along[i] for i in range(2)) / math.hypot(*along)
        check(speed > 1.5, f"at {end} the air blows {late} m/s after the pulse came, {speed:.2f} along the arrow")
        check(speed > 0.7 * math.hypot(*late), f"at {end} the air blows {late} m/s, not along the arrow")
        check(math.hypot(*early) < 0.2 * speed, f"at {end} the air blows {early} m/s before the pulse came")


def main():
    windloom_editor, windloom = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        project = pathlib.Path(name) / "figure8.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(windloom_editor, environment, name, str(project)) as app:
            app.key("KP_Home")
            app.wait_fact("view", "top")
            view = TopView(app)
            draw(app, view)
        check_wind(windloom, project, check_saved(project, abs(view.scale[0])))
    print("the tree of Figure 8, a ring, obstacles and a pulse drawn, saved and sampled")


if __name__ == "__main__":
    run(main)
