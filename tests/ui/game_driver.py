"""The sample game docs/examples/leaves, played to its end or running in the background."""
import re
import subprocess
import time

import numpy

from editor_driver import PATIENCE_S as driver_patience, check

PATIENCE_S = 2 * driver_patience
SMALL = ["--size", "480x270"]


def play(game, environment, *arguments, status=0):
    done = subprocess.run([game, *map(str, arguments)], env=environment, capture_output=True, text=True, timeout=5 * PATIENCE_S)
    check(done.returncode == status, f"{arguments} ended with {done.returncode}: {done.stdout[-500:]}{done.stderr}")
    return done


def read_leaves(text):
    """Start, drift and number of jumps of each leaf."""
    number = r"(-?[\d.]+)"
    rows = re.findall(rf"^leaf \d+ start {number} {number} end {number} {number} drift {number} {number} jumps (\d+)$", text, re.M)
    check(len(rows) > 300, f"several hundred leaves expected, found {len(rows)}")
    table = numpy.array(rows, float)
    return table[:, 0:2], table[:, 2:4], table[:, 4:6], table[:, 6]


def fact(text, name):
    found = re.search(rf"^{name} (.*)$", text, re.M)
    check(found is not None, f"no '{name}' in what the game printed:\n{text[-300:]}")
    return found.group(1)


class Running:
    """The game in the background, driven by keys."""

    def __init__(self, game, environment, log, *arguments):
        self.environment = environment
        self.log = log
        with open(log, "w") as told:
            self.process = subprocess.Popen([game, *map(str, arguments)], env=environment, text=True,
                                            stdout=subprocess.PIPE, stderr=told)
        self.window = self.xdotool("search", "--sync", "--onlyvisible", "--pid", self.process.pid).split()[0]

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *map(str, arguments)], env=self.environment, capture_output=True, text=True,
                              check=True, timeout=PATIENCE_S).stdout

    def key(self, *keys):
        self.xdotool("windowfocus", "--sync", self.window)  # another window may have it
        self.xdotool("key", *keys)

    def told(self):
        return self.log.read_text()

    def title(self):
        return self.xdotool("getwindowname", self.window).strip()

    def wait(self, what, condition):
        end = time.monotonic() + PATIENCE_S
        while not condition():
            check(self.process.poll() is None, f"the game ended while waiting for {what}: {self.told()}")
            check(time.monotonic() < end, f"waited in vain for {what}; title '{self.title()}', said: {self.told()}")
            time.sleep(0.05)

    def wait_told(self, text):
        self.wait(f"'{text}'", lambda: text in self.told())

    def end(self):
        self.key("Escape")
        text, _ = self.process.communicate(timeout=PATIENCE_S)
        check(self.process.returncode == 0, f"Escape must end the game with 0: {self.told()}")
        return text
