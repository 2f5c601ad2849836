"""Every panel, menu and dialog of the real editor as a picture, to be looked at: 1280 x 720 at 100% and 2560 x 1440 at 200%, in
the dark and the light theme. Fails where a control lies outside the window or two controls of a panel overlap.

usage: panel_pictures.py WINDLOOM_EDITOR PROJECT [FOLDER]
"""
import contextlib
import json
import pathlib
import shutil
import sys
import tempfile

from editor_driver import Failure, display, editor, run

LOOKS = [("1280x720", "1", "dark"), ("1280x720", "1", "light"), ("2560x1440", "2", "dark"), ("2560x1440", "2", "light")]
TABS = ["Selection", "Field", "Solver", "Ambient", "Grass", "Terrain", "Export"]
NOTES = ["Probes", "Solver", "Log", "History"]
MENUS = ["File", "Edit", "Select", "Graph", "Tools", "View", "Play", "Help"]
# What lies over the picture may lie over each other, too.
LOOSE = ("viewport", "point:", "arrow:", "probe:", "obstacle:", "axis/", "split/", "timeline/")


def overlaps(a, b):
    return min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0]) > 1 and min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1]) > 1


def check_places(app, name, size):
    width, height = map(int, size.split("x"))
    _, rectangles = app.read_map()
    fixed = {key: box for key, box in rectangles.items() if not key.startswith(LOOSE)}
    for key, (x, y, w, h) in fixed.items():
        # Lists scroll: what lies below their end isn't drawn.
        if key.split("/")[0] in ("toolbar", "menu", "status", "dialog") and (x < 0 or y < 0 or x + w > width or y + h > height):
            raise Failure(f"{name}: '{key}' lies outside the window: {x} {y} {w} {h}")
    for kind in ("toolbar/", "inspector/tab/", "notes/tab/", "dialog/", "status/"):
        boxes = [(key, box) for key, box in fixed.items() if key.startswith(kind)]
        for i, (a, box) in enumerate(boxes):
            for b, other in boxes[i + 1:]:
                if overlaps(box, other):
                    raise Failure(f"{name}: '{a}' and '{b}' overlap")


class Album:
    def __init__(self, app, folder, look, size):
        self.app, self.folder, self.look, self.size = app, folder, look, size

    def take(self, name):
        frame = int(self.app.fact("frame"))
        self.app.wait("the next frames", lambda: int(self.app.fact("frame")) > frame + 3)
        check_places(self.app, f"{self.look} {name}", self.size)
        self.app.picture(self.folder / f"{self.look}-{name}.png")


def take_all(app, album):
    app.wait_fact("scene", "yes")
    app.key("a")
    for tab in TABS:
        app.press(f"inspector/tab/{tab}")
        album.take(f"tab-{tab.lower()}")
    for tab in NOTES:
        app.press(f"notes/tab/{tab}")
        album.take(f"notes-{tab.lower()}")
    for menu in MENUS:
        app.press(f"menu/{menu}")
        album.take(f"menu-{menu.lower()}")
        app.key("Escape")
    for key, name in (("F1", "help"), ("F3", "palette"), ("ctrl+o", "dialog-open"), ("ctrl+shift+s", "dialog-save-as")):
        app.key(key)
        album.take(name)
        app.key("Escape")
    app.key("Escape", "a", "bracketright")
    app.wait_fact("dirty", "yes")
    app.key("ctrl+q")
    app.wait_fact("dialog", "save changes")
    album.take("dialog-save-changes")
    app.press("dialog/Don't save")
    app.wait_end()


def main():
    program, project = sys.argv[1], pathlib.Path(sys.argv[2])
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(sys.argv[3]) if len(sys.argv) > 3 else pathlib.Path(
            stack.enter_context(tempfile.TemporaryDirectory(prefix="windloom-pictures-")))
        folder.mkdir(parents=True, exist_ok=True)
        for size, scale, theme in LOOKS:
            home = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="windloom-panels-")))
            shutil.copytree(project.parent, home / "project")
            (home / "config" / "windloom").mkdir(parents=True)
            (home / "config" / "windloom" / "preferences.json").write_text(json.dumps({"theme": theme}))
            with display(size) as environment, editor(program, environment, home, "--scale", scale,
                                                      str(home / "project" / project.name), size=size) as app:
                take_all(app, Album(app, folder, f"{size}-{theme}", size))
    print("every panel lies where it should")


if __name__ == "__main__":
    run(main)
