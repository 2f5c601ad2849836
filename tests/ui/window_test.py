"""The real editor in a real window: draws a two-branch tree, changes a strength by typing, undoes, redoes, saves; then
reads the saved file and asks `windloom sample` whether the air blows along the arrows. Also what happens with a broken
project and with a folder that can't be written.

usage: window_test.py WINDLOOM_EDITOR WINDLOOM
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from editor_driver import Failure, check, display, editor, run

# No tree yet; three probes whose places on the screen tell how pixels map to metres in the view from above.
PROBES = {40: (-30.0, -20.0), 41: (30.0, 20.0), 42: (30.0, -20.0)}
PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Window test",
    "field": {"centre": [0, 0], "size": [100, 100], "resolution": [128, 128]},
    "grass": {"density": 4},
    "probes": [{"id": id, "position": list(at)} for id, at in PROBES.items()],
}


def near(a, b, tolerance):
    return math.dist(a, b) <= tolerance


class TopView:
    """Pixels to metres in the orthographic view from above, from two probes; the third must agree."""

    def __init__(self, app):
        a, b, c = (app.centre(f"probe:{id}") for id in PROBES)
        (ax, az), (bx, bz), third = PROBES.values()
        self.scale = ((bx - ax) / (b[0] - a[0]), (bz - az) / (b[1] - a[1]))
        self.offset = (ax - a[0] * self.scale[0], az - a[1] * self.scale[1])
        check(near(self.metres(c), third, 2 * self.scale[0]), "the view is not straight from above")

    def metres(self, pixel):
        return tuple(self.offset[i] + pixel[i] * self.scale[i] for i in range(2))

    def pixel(self, metres):
        return tuple((metres[i] - self.offset[i]) / self.scale[i] for i in range(2))


def draw_and_save(app, project):
    """Gives the places where root and both tips were drawn, in metres."""
    app.key("KP_Home")  # the numpad's 7 without Num Lock: from above
    app.wait_fact("view", "top")
    view = TopView(app)
    root, first, second = (-25.0, 5.0), (-5.0, 5.0), (10.0, -12.0)

    app.key("d")
    app.wait_fact("tool", "draw")
    app.drag(view.pixel(root), view.pixel(first))
    app.wait_fact("steps", "1")
    app.drag(view.pixel(first), view.pixel(second))
    app.wait_fact("steps", "2")
    app.key("Escape")

    app.key("q")
    app.wait_fact("tool", "select")
    app.click(view.pixel(((first[0] + second[0]) / 2, (first[1] + second[1]) / 2)))
    app.wait("an arrow to be selected", lambda: app.fact("selection").startswith("Arrow"))
    app.press("inspector/arrow/strength")
    app.wait_fact("typing", "yes")
    app.type("12.5")
    app.key("Return")
    app.wait_fact("steps", "3")

    app.key("ctrl+z")
    app.wait_fact("steps", "2")
    app.key("ctrl+shift+z")
    app.wait_fact("steps", "3")
    check(app.fact("dirty") == "yes" and "*" in app.fact("title"), "edits must show in the title")
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    check("*" not in app.fact("title"), f"a saved project has a clean title, not {app.fact('title')}")
    app.key("ctrl+q")
    check(app.wait_end() == 0, "closing a saved project must end the editor with 0")
    return [view.metres(tuple(map(round, view.pixel(place)))) for place in (root, first, second)], abs(view.scale[0])


def check_graph(project, places, pixel_m):
    graph = json.loads(project.read_text())["graph"]
    points, arrows = graph["points"], graph["arrows"]
    check(len(points) == 3 and len(arrows) == 2, f"expected 3 points and 2 arrows, found {len(points)} and {len(arrows)}")
    by_id = {point["id"]: tuple(point["position"]) for point in points}
    ends = [(by_id[arrow["from"]], by_id[arrow["to"]], arrow) for arrow in arrows]
    root, first, second = places
    wanted = [(root, first), (first, second)]
    for (start, end, _), (wanted_start, wanted_end) in zip(ends, wanted):
        check(near(start, wanted_start, 2 * pixel_m) and near(end, wanted_end, 2 * pixel_m),
              f"an arrow goes from {start} to {end}, drawn from {wanted_start} to {wanted_end}")
    check(arrows[0]["to"] == arrows[1]["from"], "the second arrow must branch from the end of the first")
    check(arrows[1]["strength"] == 12.5, f"typed strength 12.5, saved {arrows[1]['strength']}")
    check(arrows[0].get("strength", 8) == 8, "only the selected arrow's strength may change")
    return ends


def check_wind(windloom, project, ends):
    """The air at both tips blows along their arrows."""
    tips = []
    for start, end, arrow in ends:
        tips += ["--at", f"{end[0]},{end[1]}"]
    result = subprocess.run([windloom, "sample", str(project), *tips, "--time", "4", "--backend", "cpu", "--json"],
                            capture_output=True, text=True)
    check(result.returncode == 0, f"windloom sample: {result.stderr}")
    samples = json.loads(result.stdout)["samples"]
    for (start, end, arrow), sample in zip(ends, samples):
        velocity = sample["velocity"]
        along = [end[i] - start[i] for i in range(2)]
        speed = sum(velocity[i] * along[i] for i in range(2)) / math.hypot(*along)
        check(0.5 < speed < 2 * arrow.get("strength", 8),
              f"at {end} the air blows {velocity} m/s, {speed} along its arrow of {arrow.get('strength', 8)} m/s")


def check_trouble(app, windloom, folder, project):
    """A broken project and a folder that can't be written leave what is open as it is."""
    broken = folder / "broken.wind.json"
    broken.write_text(json.dumps(dict(PROJECT, graph={"points": [{"id": 1, "position": [0, 0]}], "arrows": [
        {"id": 2, "from": 1, "to": 99}]})))
    title = app.fact("title")
    app.key("ctrl+o")
    app.wait_fact("dialog", "open")
    app.choose_path(broken)
    app.wait_fact("dialog", "error")
    shown = app.fact("dialog.text")
    told = subprocess.run([windloom, "validate", str(broken)], capture_output=True, text=True)
    check(told.returncode == 1, f"validate must refuse {broken}")
    check("/graph/arrows/0/to" in shown, f"the message must name the place: {shown}")
    for line in shown.split("\\n"):
        check(line.strip() in told.stderr + told.stdout, f"the editor says '{line}', the command line '{told.stderr}'")
    app.key("Return")
    app.wait_fact("dialog", "")
    check(app.fact("title") == title, "the open project must stay open")

    app.press("outliner/40")
    app.wait_fact("selection", "Probe 40")
    app.key("Delete")
    app.wait_fact("dirty", "yes")
    app.key("ctrl+shift+s")
    app.wait_fact("dialog", "save as")
    app.choose_path("/proc/windloom-test/nowhere.wind.json")
    app.wait_fact("dialog", "error")
    check("nowhere.wind.json" in app.fact("dialog.text"), f"the message must name the file: {app.fact('dialog.text')}")
    app.key("Return")
    app.wait_fact("dialog", "")
    check(app.fact("dirty") == "yes", "a failed save must leave the project dirty")
    check(len(json.loads(project.read_text())["probes"]) == 3, "a failed save must not touch the old file")

    theirs = project.read_text() + "\n"
    project.write_text(theirs)
    app.key("ctrl+s")
    app.wait_fact("dialog", "changed on disk")
    app.press("dialog/Save under another name")
    app.wait_fact("dialog", "save as")
    app.key("Escape")
    app.wait_fact("dialog", "")
    check(project.read_text() == theirs, "another program's changes must stay until the user says so")

    app.key("ctrl+q")
    app.wait_fact("dialog", "save changes")
    app.press("dialog/Cancel")
    app.wait_fact("dialog", "")
    app.key("ctrl+q")
    app.wait_fact("dialog", "save changes")
    app.press("dialog/Don't save")
    check(app.wait_end() == 0, "not saving must end the editor with 0")


def check_solver(app, project):
    """The last step's numbers in the status bar and in their panel; the paper's scheme by a click, undone by one key."""
    app.wait("the residual", lambda: app.fact("status.residual").endswith("%"))
    check(float(app.fact("status.residual")[:-1].split()[1]) < 0.2, f"a step leaves {app.fact('status.residual')}")
    app.press("notes/tab/Solver")
    app.wait("the solver's numbers", lambda: app.fact("solver.residual") != "")
    for name in ("divergence before", "divergence after", "worst cell after", "cycles", "kinetic energy", "fastest air",
                 "CFL", "step", "  forces", "  advection", "  projection"):
        check(app.fact(f"solver.{name}") != "", f"the panel doesn't show '{name}'")
    check(app.fact("solver.cells reset") == "0", "no cell may have been reset")
    app.press("inspector/tab/Solver")
    app.press("inspector/solver/preset/cwd-sim")
    app.wait_fact("steps", "1")
    app.wait_fact("solver.cycles", "20")
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    solver = json.loads(project.read_text())["solver"]
    check((solver["pressure"], solver["advection"]) == ("jacobi", "semi-lagrangian"), f"cwd-sim saved as {solver}")
    app.key("ctrl+z")
    app.wait_fact("steps", "0")
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    check(json.loads(project.read_text())["solver"]["pressure"] == "multigrid", "undo must bring the scheme back")
    app.key("ctrl+q")
    check(app.wait_end() == 0, "closing a saved project must end the editor with 0")


OVERLAY_KEYS = {"5": "arrows", "6": "streamlines", "7": "speed", "8": "divergence", "9": "lic"}


def viewport_pixels(app, environment):
    """The middle of the viewport as it is on the screen."""
    left, top, width, height = app.read_map()[1]["viewport"]
    shot = subprocess.run(["import", "-window", app.window, "-crop", f"{width - 260}x{height - 80}+{left + 30}+{top + 40}",
                           "-depth", "8", "rgb:-"], env=environment, capture_output=True)
    check(shot.returncode == 0, f"the window could not be read: {shot.stderr}")
    return shot.stdout


def difference(a, b):
    check(len(a) == len(b), "the viewport must keep its size")
    return sum(abs(x - y) for x, y in zip(a[::7], b[::7])) / len(a[::7])


def check_overlays(app, environment):
    """Keys 5 to 9 switch overlays, one map replaces another, each changes the picture, and all are remembered."""
    app.key("KP_Home")
    app.wait_fact("view", "top")
    app.wait_fact("overlays", "arrows")
    app.key("space")  # hold the wind, so that only overlays change the picture
    app.key("5")
    app.wait_fact("overlays", "")

    def settled():
        last = viewport_pixels(app, environment)
        for _ in range(40):
            now = viewport_pixels(app, environment)
            if difference(last, now) < 0.02:
                return now
            last = now
        raise Failure("the held picture doesn't rest")

    plain = settled()
    for key, name in OVERLAY_KEYS.items():
        app.key(key)
        app.wait_fact("overlays", name)
        changed = difference(plain, settled())
        check(changed > 0.3, f"{name} (key {key}) must show; mean difference {changed}")
        app.key(key)
        app.wait_fact("overlays", "")
    app.key("7")
    app.wait_fact("overlays", "speed")
    app.key("9")
    app.wait_fact("overlays", "lic")
    app.key("6")
    app.wait_fact("overlays", "streamlines lic")
    app.press("toolbar/overlay.vorticity")
    app.wait_fact("overlays", "streamlines vorticity")
    app.press("toolbar/overlay.vectors")
    app.wait_fact("overlays", "vectors streamlines vorticity")
    boxes = app.read_map()[1]
    for name in ("legend/speed", "legend/vorticity"):
        check(name in boxes, f"{name} must show")
    app.press("legend/vorticity/range")
    app.wait_fact("typing", "yes")
    app.type("2.5")
    app.key("Return")
    app.wait_fact("typing", "no")
    app.key("ctrl+q")
    app.wait_end()


def main():
    windloom_editor, windloom = sys.argv[1:3]
    with tempfile.TemporaryDirectory(prefix="windloom-ui-") as name, display() as environment:
        folder = pathlib.Path(name)
        project = folder / "window.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(windloom_editor, environment, folder, str(project)) as app:
            places, pixel_m = draw_and_save(app, project)
        ends = check_graph(project, places, pixel_m)
        check_wind(windloom, project, ends)
        breeze = folder / "breeze.wind.json"
        breeze.write_text(json.dumps(dict(json.loads(project.read_text()), ambient={"speed": 4, "direction": 20})))
        with editor(windloom_editor, environment, folder, str(breeze)) as app:
            check_overlays(app, environment)
        with editor(windloom_editor, environment, folder, str(breeze)) as app:
            app.wait_fact("overlays", "vectors streamlines vorticity")  # as left
        kept = json.loads((folder / "config" / "windloom" / "preferences.json").read_text())["numbers"]
        check(kept["overlay.vorticityRange"] == 2.5, f"the typed range must be remembered: {kept}")
        (folder / "config" / "windloom" / "preferences.json").unlink()
        with editor(windloom_editor, environment, folder, str(project)) as app:
            check_solver(app, project)
        with editor(windloom_editor, environment, folder, str(project)) as app:
            check_trouble(app, windloom, folder, project)
        log = (folder / "state" / "windloom" / "log.txt").read_text()
        check(log.count(" starts") == 5 and "ends with status 0" in log, f"the log must tell of every run: {log}")
        check("nowhere.wind.json" in log, "and of what went wrong")
    print("drawn, typed, undone, redone, saved and sampled; overlays switched and remembered; broken and unwritable files refused")


if __name__ == "__main__":
    run(main)
