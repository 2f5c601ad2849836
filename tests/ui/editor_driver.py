"""A running windloom-editor under a private Xvfb, driven as a person would: real key and mouse events by xdotool, places
of controls from the editor's --ui-map file, and waiting on what the editor says instead of sleeping."""
import contextlib
import os
import pathlib
import subprocess
import sys
import time

PATIENCE_S = 30 * int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))  # for one condition; a loaded machine with two cores needs a few seconds at most


class Failure(Exception):
    pass


def check(condition, message):
    if not condition:
        raise Failure(message)


def run(main):
    """A test's main: what failed goes to standard error, the exit status is 1 then."""
    try:
        main()
    except Failure as failure:
        print(f"FAILED: {failure}", file=sys.stderr)
        sys.exit(1)


@contextlib.contextmanager
def display(size="1280x800"):
    """Xvfb on a display number of its own choosing; gives the environment to run in."""
    read_end, write_end = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{size}x24", "-nolisten", "tcp"],
        pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write_end)
    try:
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()
        if not number:
            raise Failure("Xvfb did not start")
        yield dict(os.environ, DISPLAY=f":{number}", WAYLAND_DISPLAY="", LIBGL_ALWAYS_SOFTWARE="1")
    finally:
        server.terminate()
        server.wait()


class Editor:
    def __init__(self, program, environment, folder, arguments, size):
        self.folder = pathlib.Path(folder)
        self.map_file = self.folder / "ui-map.txt"
        self.log_file = self.folder / "editor.log"
        self.environment = dict(environment, HOME=str(self.folder), XDG_CONFIG_HOME=str(self.folder / "config"),
                                XDG_STATE_HOME=str(self.folder / "state"))
        with open(self.log_file, "wb") as log:
            self.process = subprocess.Popen([program, "--size", size, "--ui-map", str(self.map_file), *arguments],
                                            env=self.environment, stdout=log, stderr=log)
        self.window = None
        self.origin = (0, 0)
        self.nudges = 0
        self.wait("the window", lambda: self.fact("title") != "")
        self.find_window()

    # What the editor says

    def read_map(self):
        facts, rectangles = {}, {}
        try:
            text = self.map_file.read_text()
        except FileNotFoundError:
            return facts, rectangles
        for line in text.splitlines():
            kind, name, value = line.split("\t", 2)
            if kind == "fact":
                facts[name] = value
            else:
                rectangles[name] = tuple(int(part) for part in value.split())
        return facts, rectangles

    def fact(self, name):
        return self.read_map()[0].get(name, "")

    def centre(self, name):
        """Middle of a named rectangle in window pixels; waits until it is there and stays where it is."""
        seen = {}  # by frame: a window that just opened may still find its place

        def rests():
            facts, rectangles = self.read_map()
            seen[facts.get("frame")] = rectangles.get(name)
            last = list(seen.values())[-3:]
            return len(last) == 3 and last[0] is not None and len(set(last)) == 1

        self.wait(f"'{name}' on the screen", rests)
        x, y, width, height = list(seen.values())[-1]
        return x + width / 2, y + height / 2

    def wait(self, what, condition, seconds=PATIENCE_S):
        end = time.monotonic() + seconds
        while True:
            if condition():
                return
            if self.process.poll() is not None:
                raise Failure(f"the editor ended with {self.process.returncode} while waiting for {what}:\n{self.log()}")
            if time.monotonic() > end:
                raise Failure(f"waited in vain for {what}; facts: {self.read_map()[0]}\n{self.log()}")
            time.sleep(0.02)

    def wait_fact(self, name, value):
        self.wait(f"{name} = '{value}'", lambda: self.fact(name) == value)

    def log(self):
        return self.log_file.read_text(errors="replace")[-4000:]

    # What the hands do

    def xdotool(self, *arguments):
        result = subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True, text=True)
        if result.returncode != 0:
            raise Failure(f"xdotool {arguments}: {result.stderr}")
        return result.stdout

    def find_window(self):
        self.window = self.xdotool("search", "--sync", "--onlyvisible", "--pid", self.process.pid).split()[0]
        self.xdotool("windowfocus", "--sync", self.window)
        geometry = dict(line.split("=") for line in self.xdotool("getwindowgeometry", "--shell", self.window).split())
        self.origin = (int(geometry["X"]), int(geometry["Y"]))

    def move(self, place):
        x, y = round(place[0]), round(place[1])
        self.xdotool("mousemove", self.origin[0] + x, self.origin[1] + y)
        return f"{x} {y}"

    def point_at(self, place):
        """Moves there and waits until the editor has seen it, so that the next press is there."""
        there = self.move(place)
        moved = time.monotonic()

        def seen():
            nonlocal moved
            if self.fact("pointer") == there:
                return True
            if time.monotonic() - moved > 3:  # a warp of the pointer may go by without an event: nudge it
                self.move((place[0] + 1, place[1]))
                self.move(place)
                self.nudges += 1
                moved = time.monotonic()
            return False

        self.wait(f"the pointer at {there}", seen)

    def click(self, place, button=1):
        self.point_at(place)
        self.xdotool("click", button)

    def press(self, name):
        self.click(self.centre(name))

    def drag(self, start, end, steps=6):
        self.point_at(start)
        self.xdotool("mousedown", 1)
        for i in range(1, steps):
            part = i / steps
            self.move((start[0] + (end[0] - start[0]) * part, start[1] + (end[1] - start[1]) * part))
        self.point_at(end)
        self.xdotool("mouseup", 1)

    def key(self, *keys):
        self.xdotool("key", *keys)

    def type(self, text):
        self.xdotool("type", "--", text)

    def picture(self, file):
        """The window as it is on the screen, as PNG."""
        subprocess.run(["import", "-window", self.window, str(file)], env=self.environment, check=True)

    def command(self, name):
        """By the palette, by a part of its name."""
        self.key("F3")
        self.wait_fact("palette", "yes")
        self.wait_fact("typing", "yes")
        self.type(name)
        self.key("Return")
        self.wait_fact("palette", "no")

    def choose_path(self, path):
        """Types a path into the open file dialog and accepts it."""
        self.wait_fact("typing", "yes")  # its name field takes the keyboard by itself
        self.key("ctrl+a")
        self.type(str(path))
        self.key("Return")

    def wait_end(self):
        try:
            return self.process.wait(PATIENCE_S)
        except subprocess.TimeoutExpired:
            raise Failure("the editor did not end") from None

    def kill(self):
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()


@contextlib.contextmanager
def editor(program, environment, folder, *arguments, size="1280x800"):
    running = Editor(program, environment, folder, arguments, size)
    try:
        yield running
    finally:
        running.kill()
