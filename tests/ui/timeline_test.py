"""Time and signals in the real window: a root's signal becomes a pulse, then a curve; keys are added, moved and deleted with
the mouse; drags are cancelled and undone; time is scrubbed back and forth; then the saved file is read.

usage: timeline_test.py WINDLOOM_EDITOR
"""
import json
import pathlib
import sys
import tempfile

from editor_driver import check, display, editor, run

PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Timeline test",
    "field": {"centre": [0, 0], "size": [60, 60], "resolution": [48, 48]},
    "graph": {"points": [{"id": 1, "name": "gate", "position": [-20, 0]}, {"id": 2, "position": [0, 0]},
                         {"id": 3, "position": [20, 5]}],
              "arrows": [{"id": 11, "from": 1, "to": 2}, {"id": 12, "from": 2, "to": 3}]},
    "grass": {"density": 2},
    "probes": [{"id": 40, "position": [-5, 0]}],
}


def number(app, name):
    return float(app.fact(name))


class Ruler:
    """Pixels of times, from what the editor says about its ruler."""

    def __init__(self, app):
        app.centre("timeline/ruler")  # waits until it rests
        facts, rectangles = app.read_map()
        self.left, self.top, self.width, self.height = rectangles["timeline/ruler"]
        self.start, self.seconds = float(facts["timeline.from"]), float(facts["timeline.seconds"])

    def at(self, time):
        return self.left + (time - self.start) / self.seconds * self.width, self.top + self.height / 2


def wait_time(app, seconds):
    """Within what a pixel of the ruler is worth."""
    app.wait(f"time {seconds}", lambda: app.fact("seek") == "no" and abs(number(app, "time") - seconds) < 0.1)


def edit_curve(app):
    app.press("timeline/lane/1")
    app.wait_fact("curve.root", "1")
    app.press("curve/kind")
    app.press("curve/kind/1")
    app.wait_fact("steps", "1")
    app.press("curve/convert")
    app.wait_fact("curve.keys", "4")
    app.wait_fact("steps", "2")
    app.point_at(app.centre("curve/area"))
    app.key("Home")  # the whole round on the screen
    app.wait("the curve to fill the lane", lambda: number(app, "timeline.seconds") < 8)

    third = app.centre("curve/key/2")
    app.drag(third, (third[0] + 20, third[1] + 15))  # later and weaker
    app.wait_fact("steps", "3")
    app.wait_fact("curve.selected", "1")
    moved = app.centre("curve/key/2")
    check(moved[0] > third[0] + 10 and moved[1] > third[1] + 8, f"the key went from {third} to {moved}")
    app.key("ctrl+z")
    app.wait_fact("steps", "2")
    app.key("ctrl+shift+z")
    app.wait_fact("steps", "3")

    app.point_at(moved)  # a drag that is taken back
    app.xdotool("mousedown", 1)
    app.point_at((moved[0] - 30, moved[1]))
    app.key("Escape")
    app.xdotool("mouseup", 1)
    app.wait("the key to be back", lambda: app.centre("curve/key/2") == moved)
    check(app.fact("steps") == "3", "a cancelled drag must leave no step")

    second, third = app.centre("curve/key/1"), app.centre("curve/key/2")
    app.click(((second[0] + third[0]) / 2, (second[1] + third[1]) / 2))  # on the line between them
    app.wait_fact("curve.keys", "5")
    app.wait_fact("steps", "4")
    app.click(app.centre("curve/key/2"), button=3)
    app.press("curve/menu/hold")
    app.wait_fact("steps", "5")

    first, last = app.centre("curve/key/3"), app.centre("curve/key/4")
    top = app.read_map()[1]["curve/area"][1]
    app.drag((first[0] - 8, top + 4), (last[0] + 8, last[1] + 1), steps=3)  # a box around the last two
    app.wait_fact("curve.selected", "2")
    app.click(app.centre("curve/key/3"))
    app.key("Delete")
    app.wait_fact("curve.keys", "4")
    app.wait_fact("steps", "6")
    app.key("Delete")  # none is selected: the tree must not go instead
    app.key("ctrl+z")
    app.wait_fact("curve.keys", "5")
    check(app.fact("curve.root") == "1" and app.fact("steps") == "5", "Del over the curve must leave its tree")

    first = app.centre("curve/key/1")
    app.point_at(first)  # a key that is held
    app.xdotool("mousedown", 1)
    app.point_at((first[0], first[1] + 20))
    app.key("Delete")
    app.key("Escape")
    app.xdotool("mouseup", 1)
    app.wait("the held key to be back", lambda: app.centre("curve/key/1") == first)
    check(app.fact("curve.keys") == "5" and app.fact("steps") == "5", "Del in a drag must delete nothing")


def scrub(app):
    app.key("shift+space")
    app.wait_fact("playing", "no")
    app.wait_fact("time", "0.00")
    ruler = Ruler(app)
    app.click(ruler.at(3))
    wait_time(app, 3)
    app.drag(ruler.at(3), ruler.at(1))
    wait_time(app, 1)
    check(app.fact("playing") == "no", "scrubbing a held wind must not let it run")
    app.key("alt+Right")
    wait_time(app, 2)
    app.wait("the probe's wind", lambda: "m/s" in app.fact("probe.40"))
    there = app.fact("probe.40")
    app.key("alt+Right")
    wait_time(app, 3)
    app.key("alt+Left")
    wait_time(app, 2)
    app.wait("the same wind at the same time", lambda: app.fact("probe.40") == there)
    app.key("shift+i")
    app.key("alt+Right")
    wait_time(app, 3)
    app.key("shift+o")
    app.wait("the loop's range", lambda: app.fact("loop") != "off" and float(app.fact("loop").split()[1]) < 4)
    start, end = map(float, app.fact("loop").split())
    check(abs(start - 2) < 0.15 and abs(end - 3) < 0.15, f"loop from {start} to {end}")
    app.key("space")
    app.wait_fact("playing", "yes")
    times = []

    def went_back():
        times.append(number(app, "time"))
        return any(b < a for a, b in zip(times, times[1:]))

    app.wait("the loop to begin again", went_back)
    check(max(times) < end + 0.2 and min(times) > start - 0.1, f"the loop ran from {min(times)} to {max(times)}")
    app.key("space")
    app.wait_fact("playing", "no")


def check_saved(app, project):
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    signals = json.loads(project.read_text())["graph"]["signals"]
    check(len(signals) == 1 and signals[0]["root"] == 1 and signals[0]["kind"] == "curve", f"saved {signals}")
    keys = signals[0]["keys"]
    check(len(keys) == 5, f"saved {keys}")
    times = [key[0] for key in keys]
    check(times == sorted(times) and times[0] == 0, f"times {times}")
    check(keys[0][1:] == [0, "smooth"] and keys[2][2:] == ["hold"] and len(keys[4]) == 2, f"easings of {keys}")
    check(keys[3][0] > 2.6 and keys[3][1] < 0.95, f"the moved key is {keys[3]}, was [2.5, 1]")
    app.key("ctrl+q")
    check(app.wait_end() == 0, "closing a saved project must end the editor with 0")


def main():
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        folder = pathlib.Path(name)
        project = folder / "timeline.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(sys.argv[1], environment, folder, str(project)) as app:
            app.wait_fact("playing", "yes")
            app.key("space")
            app.wait_fact("playing", "no")
            edit_curve(app)
            scrub(app)
            check_saved(app, project)
    print("pulse to curve, keys added, moved, eased, deleted, undone; scrubbed, looped, saved")


if __name__ == "__main__":
    run(main)
