"""Does with the real editor and the sample game what docs/tutorial.md tells, and takes its pictures: from the sample that
`./run` opens over an empty field to wind in a game. The editor's home is a folder for this alone.

usage: tutorial.py WINDLOOM_EDITOR WINDLOOM WINDLOOM_LEAVES [PICTURE_FOLDER]
Without a folder the pictures go nowhere: the test that the tutorial can be followed.
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


class Hands:
    def __init__(self, app, pictures):
        self.app = app
        self.pictures = pictures

    def picture(self, name, rest=0):
        """After two frames more, so that what was just done is on the screen, and after `rest` s."""
        time.sleep(rest)
        frame = int(self.app.fact("frame"))
        self.app.wait("the next frames", lambda: int(self.app.fact("frame")) > frame + 2)
        file = self.pictures / f"tutorial-{name}.png"
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


def draw_tree(hands):
    app = hands.app
    app.key("d")
    app.wait_fact("tool", "draw")
    places = [((-36, 12), (-8, 2)), ((-8, 2), (24, -13)), ((-8, 2), (22, 16))]
    for number, (start, end) in enumerate(places, 1):
        app.drag(hands.at(*start), hands.at(*end))
        app.wait_fact("steps", str(number))
    app.key("q")
    app.wait_fact("tool", "select")
    hands.picture("tree")
    app.click(hands.at(-22, 7))
    app.wait("the trunk to be selected", lambda: app.fact("selection").startswith("Arrow"))
    app.key("bracketright")
    app.wait_fact("steps", "4")
    app.key("ctrl+z")
    app.wait_fact("steps", "3")
    return places


def give_a_pulse(hands):
    app = hands.app
    app.click(hands.at(-36, 12))
    app.wait("the root to be selected", lambda: app.fact("selection").startswith("Point"))
    hands.choose("inspector/signal/kind", "pulse")
    app.key("ctrl+l")  # the whole tree
    app.wait("the tree to be selected", lambda: "3 arrows" in app.fact("selection"))
    hands.type_into("inspector/arrow/strength", "12")
    hands.picture("signal")
    app.click(hands.at(-10, -30))
    app.wait_fact("selection", "")


def watch(hands):
    app = hands.app
    app.key("KP_End")  # the front view, then nearer and a little from above
    app.wait("the front view", lambda: app.fact("view") != "top")
    app.key("KP_Begin")
    x, y = app.centre("viewport")
    app.point_at((x, y))
    app.xdotool("mousedown", 2)
    for step in range(1, 9):
        app.move((x + 9 * step, y + 6 * step))
    app.xdotool("mouseup", 2)
    for _ in range(5):
        app.xdotool("click", 4)
    hands.play_until(8)
    app.key("space")
    app.wait_fact("playing", "no")
    hands.app.command("full quality")
    hands.picture("meadow")
    app.key("6")
    hands.picture("streamlines")
    app.key("6", "9")
    hands.picture("lic")
    app.key("9")
    hands.app.command("full quality")
    app.key("space")
    app.wait_fact("playing", "yes")


def export(hands, folder):
    hands.app.key("ctrl+shift+e")
    app = hands.app
    app.point_at(app.centre("export/preset"))
    app.xdotool("click", "--repeat", 3, "--delay", 50, 5)  # the window is small: down to where the length is
    hands.type_into("export/seconds", "6")
    hands.app.press("export/start")
    hands.app.wait("the export's end", lambda: (folder / "first-wind" / "manifest.json").exists(), 480)
    hands.picture("export", rest=1)


def check_result(windloom, folder, places):
    project = folder / "first.wind.json"
    graph = json.loads(project.read_text())["graph"]
    check(len(graph["arrows"]) == len(places), f"{len(graph['arrows'])} arrows were saved")
    check(all(arrow["strength"] == 12 for arrow in graph["arrows"]), "every arrow's strength was set to 12")
    check(graph["signals"][0]["kind"] == "pulse", "the root plays a pulse")
    told = subprocess.run([windloom, "sample", str(project), "--at", "20,-11", "--time", "7", "--backend", "cpu", "--json"],
                          capture_output=True, text=True, check=True)
    velocity = json.loads(told.stdout)["samples"][0]["velocity"]
    check(math.hypot(*velocity) > 1, f"the pulse must have reached the tips: {velocity}")
    check((folder / "first-wind" / "wind.windpack").exists(), "the export holds a pack")
    frames = json.loads((folder / "first-wind" / "manifest.json").read_text())["time"]["frames"]
    check(frames == 90, f"6 s at 15 frames a second are 90 frames, not {frames}")


def play(windloom_leaves, environment, folder, pictures):
    """The sample game with the wind that was exported; its picture."""
    file = pictures / "tutorial-game.png"
    subprocess.run([windloom_leaves, str(folder / "first-wind" / "wind.windpack"), "--frames", "90", "--screenshot", str(file),
                    "--size", "960x480"], env=environment, check=True)
    check(file.stat().st_size > 20000, "the game shows nothing")


def start_anew(hands):
    """From the sample to an empty field, seen from above."""
    app = hands.app
    app.wait_fact("scene", "yes")
    app.key("ctrl+n")
    app.wait("an empty project", lambda: "meadow" not in app.fact("title").lower())
    app.key("KP_Home")
    app.wait_fact("view", "top")
    hands.picture("empty")


def save(hands, folder):
    app = hands.app
    app.key("ctrl+s")
    app.wait_fact("dialog", "save as")
    app.centre("files/folder")  # until the dialog rests
    left, top, _, height = app.read_map()[1]["files/folder"]
    app.click((left - height, top + height / 2))  # the house button, at its left
    app.press("files/name")
    app.choose_path("first.wind.json")
    app.wait_fact("dirty", "no")
    check((folder / "first.wind.json").exists(), "the house button leads to the home folder")


def follow(programs, sample, pictures):
    with tempfile.TemporaryDirectory(prefix="windloom-tutorial-") as name, display(SIZE) as environment:
        folder = pathlib.Path(name)
        with editor(programs[0], environment, folder, str(sample), size=SIZE) as app:
            hands = Hands(app, pictures)
            start_anew(hands)
            places = draw_tree(hands)
            give_a_pulse(hands)
            watch(hands)
            save(hands, folder)
            export(hands, folder)
            app.key("ctrl+q")
            check(app.wait_end() == 0, "a saved project closes without a question")
        check_result(programs[1], folder, places)
        play(programs[2], environment, folder, pictures)


def main():
    programs = sys.argv[1:4]
    # Where the editor finds its samples, as ./run opens it.
    sample = pathlib.Path(programs[0]).resolve().parents[1] / "share/windloom/projects/meadow/meadow.wind.json"
    with tempfile.TemporaryDirectory(prefix="windloom-tutorial-") as nowhere:
        follow(programs, sample, pathlib.Path(sys.argv[4] if len(sys.argv) > 4 else nowhere))
    print("the tutorial can be followed")


if __name__ == "__main__":
    run(main)
