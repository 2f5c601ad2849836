"""Does with the real editor what docs/guide.md tells, and takes its pictures: from the empty project to an exported wind.

usage: guide.py WINDLOOM_EDITOR WINDLOOM [PICTURE_FOLDER]
Without a folder the pictures go nowhere: the test that the guide can be followed.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import time

from editor_driver import check, display, editor, run

SIZE = "1280x720"


class Guide:
    def __init__(self, app, pictures):
        self.app = app
        self.pictures = pictures

    def picture(self, name, rest=0):
        """After two frames more, so that what was just done is on the screen, and after `rest` s."""
        time.sleep(rest)
        frame = int(self.app.fact("frame"))
        self.app.wait("the next frames", lambda: int(self.app.fact("frame")) > frame + 2)
        file = self.pictures / f"guide-{name}.png"
        self.app.picture(file)
        check(file.stat().st_size > 20000, f"{file.name} shows nothing")

    def at(self, x, z):
        """Pixel of a place on the ground in the view from above on the field's middle."""
        length, _, _, pixels, _ = self.app.fact("scale").split()
        middle = self.app.centre("viewport")
        scale = float(pixels) / float(length)
        return middle[0] + x * scale, middle[1] + z * scale

    def type_into(self, control, text):
        self.app.press(control)
        self.app.wait_fact("typing", "yes")
        self.app.key("ctrl+a")
        self.app.type(text)
        self.app.key("Return")
        self.app.wait_fact("typing", "no")

    def choose(self, control, choice):
        self.app.press(control)
        self.app.press(f"{control}/{choice}")

    def play_until(self, seconds):
        self.app.wait(f"{seconds} s of wind", lambda: float(self.app.fact("time") or 0) >= seconds, 90)


def draw_tree(guide):
    app = guide.app
    app.key("KP_Home")
    app.wait_fact("view", "top")
    app.key("d")
    app.wait_fact("tool", "draw")
    places = [((-36, 12), (-18, 6)), ((-18, 6), (0, 0)), ((0, 0), (16, -12)), ((16, -12), (34, -14)), ((0, 0), (14, 12)),
              ((14, 12), (32, 14))]
    for number, (start, end) in enumerate(places, 1):
        app.drag(guide.at(*start), guide.at(*end))
        app.wait_fact("steps", str(number))
    app.key("Escape")
    guide.picture("tree")
    return places


def give_a_pulse(guide):
    app = guide.app
    app.key("q")
    app.click(guide.at(-36, 12))
    app.wait("the root to be selected", lambda: app.fact("selection").startswith("Point"))
    guide.choose("inspector/signal/kind", "pulse")
    app.key("ctrl+l")  # the whole tree
    app.wait("the tree to be selected", lambda: "6 arrows" in app.fact("selection"))
    guide.type_into("inspector/arrow/strength", "12")
    guide.picture("signal")


def put_things(guide):
    app = guide.app
    app.key("o")
    app.wait_fact("tool", "obstacle")
    app.drag(guide.at(10, 0), guide.at(13.5, 0))
    app.key("p")
    app.wait_fact("tool", "probe")
    app.click(guide.at(26, -13))
    app.click(guide.at(26, 13))
    app.key("q", "alt+a")


def watch(guide):
    app = guide.app
    app.key("KP_End")  # the front view, then from a little above
    app.wait("the front view", lambda: app.fact("view") != "top")
    app.key("KP_Begin")
    x, y = app.centre("viewport")
    app.point_at((x, y))
    app.xdotool("mousedown", 2)
    for step in range(1, 9):
        app.move((x + 9 * step, y + 11 * step))
    app.xdotool("mouseup", 2)
    guide.play_until(8)
    guide.picture("meadow")
    app.key("space")  # held, the picture has time to become fine
    app.wait_fact("playing", "no")
    app.key("6")
    guide.picture("streamlines", rest=1)
    app.key("6", "9")
    guide.picture("lic", rest=2)
    app.key("9", "space")


def export(guide, folder):
    app = guide.app
    app.key("ctrl+shift+e")
    app.press("export/section/Formats")  # closed, the rows below it come into sight
    guide.type_into("export/seconds", "1")
    app.press("export/section/Formats")
    app.press("export/start")
    app.wait("the export's end", lambda: (folder / "first-wind" / "manifest.json").exists(), 240)
    guide.picture("export", rest=1)


def check_result(windloom, folder, places):
    project = folder / "first.wind.json"
    graph = json.loads(project.read_text())["graph"]
    check(len(graph["arrows"]) == len(places), f"{len(graph['arrows'])} arrows were saved")
    check(all(arrow["strength"] == 12 for arrow in graph["arrows"]), "every arrow's strength was set to 12")
    check(graph["signals"][0]["kind"] == "pulse", "the root plays a pulse")
    told = subprocess.run([windloom, "sample", str(project), "--at", "26,-13", "--time", "7", "--backend", "cpu", "--json"],
                          capture_output=True, text=True, check=True)
    velocity = json.loads(told.stdout)["samples"][0]["velocity"]
    check(math.hypot(*velocity) > 1, f"the pulse must have reached the tips: {velocity}")
    check((folder / "first-wind" / "wind.windpack").exists(), "the export holds a pack")


def follow(windloom_editor, windloom, pictures):
    with tempfile.TemporaryDirectory(prefix="windloom-guide-") as name, display(SIZE) as environment:
        folder = pathlib.Path(name)
        with editor(windloom_editor, environment, folder, size=SIZE) as app:
            guide = Guide(app, pictures)
            app.wait_fact("scene", "yes")
            guide.picture("empty")
            places = draw_tree(guide)
            give_a_pulse(guide)
            put_things(guide)
            app.key("ctrl+s")
            app.wait_fact("dialog", "save as")
            app.choose_path(folder / "first.wind.json")
            app.wait_fact("dirty", "no")
            watch(guide)
            export(guide, folder)
            app.key("ctrl+q")
            check(app.wait_end() == 0, "a saved project closes without a question")
        check_result(windloom, folder, places)


def main():
    windloom_editor, windloom = sys.argv[1:3]
    if len(sys.argv) > 3:
        follow(windloom_editor, windloom, pathlib.Path(sys.argv[3]))
    else:
        with tempfile.TemporaryDirectory(prefix="windloom-guide-") as pictures:
            follow(windloom_editor, windloom, pathlib.Path(pictures))
    print("the guide can be followed")


if __name__ == "__main__":
    run(main)
