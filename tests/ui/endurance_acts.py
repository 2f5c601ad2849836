"""What the scripted user of endurance.py does: small acts by real keys and mouse. Each is given a dice of its own, made from
the seed and the act's number, so that the same seed does the same again on the same screen."""
import re
import time

SIZES = [(1280, 800), (1000, 700), (800, 600), (1180, 760), (640, 480), (1279, 533)]
# Not for a hand that presses at random: what asks for a file, what would ask for more memory than is there, the windows'
# own edges, and what has an act of its own.
NOT_AT_RANDOM = re.compile(
    r"^(viewport$|inspector/grass/kind|menu/|dialog|status/|export/(folder|open|copy|start|again|live|seconds|width|height|fps|live_name)"
    r"|inspector/tab/Export|.*(browse|Browse|file|File|save|remove)"
    r"|inspector/field/|inspector/.*(density|resolution|blades|patch_blades|size|texture|shells|reach|distance)"
    r"|surface:|split/|toolbar/surfaces|toolbar/species)")
COMMANDS = ["Light theme", "Interface at 125%", "Interface at 100%", "Reload shaders", "Full quality", "Grass view", "Leave out blades",
            "Wind vectors", "Vorticity map", "Add rotor", "Orthographic", "Frame all", "Show all", "Live wind on the project", "Reset panel sizes"]


class Hands:
    """The driver's hands, without patience for what is gone from the screen by now."""

    def __init__(self, app, dice):
        self.app, self.dice = app, dice

    def map(self):
        return self.app.read_map()

    def box(self, name):
        return self.map()[1].get(name)

    def inside(self, box):
        x, y, width, height = box
        return x + width * self.dice.uniform(0.1, 0.9), y + height * self.dice.uniform(0.1, 0.9)

    def in_view(self):
        box = self.box("viewport")
        return self.inside(box) if box else (400, 300)

    def click(self, place, button=1):
        self.app.move(place)
        self.frames(1)
        self.app.xdotool("click", button)

    def press(self, name):
        """Whether it was there."""
        box = self.box(name)
        if box is None:
            return False
        x, y, width, height = box
        self.click((x + width / 2, y + height / 2))
        return True

    def drag(self, start, end, button=1, steps=4):
        self.app.move(start)
        self.frames(1)
        self.app.xdotool("mousedown", button)
        for i in range(1, steps + 1):
            self.app.move((start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps))
        self.frames(1)
        self.app.xdotool("mouseup", button)

    def frames(self, count):
        """Waits so many frames more."""
        first = int(self.app.fact("frame") or 0)
        self.app.wait("the next frame", lambda: int(self.app.fact("frame") or 0) >= first + count, FRAME_PATIENCE_S)


FRAME_PATIENCE_S = 120


def draw(hands):
    hands.app.key("d")
    place = hands.in_view()
    for _ in range(hands.dice.randint(1, 3)):
        after = hands.in_view()
        hands.drag(place, after)
        place = after
    hands.app.key("Escape", "q")


def put(hands):
    hands.app.key(hands.dice.choice("ovp"))
    for _ in range(hands.dice.randint(1, 2)):
        hands.drag(hands.in_view(), hands.in_view())
    if hands.dice.random() < 0.4:  # a polygon, or half of one
        for _ in range(4):
            hands.click(hands.in_view())
        hands.app.key(hands.dice.choice(["Return", "Escape", "BackSpace"]))
    hands.app.key("Escape", "q")


def brush(hands):
    hands.app.key("b")
    for _ in range(3):
        hands.drag(hands.in_view(), hands.in_view(), steps=8)
    hands.app.key("q")


def transform(hands):
    hands.app.key(hands.dice.choice(["a", "ctrl+i", "ctrl+l"]), hands.dice.choice("wer"))
    hands.app.move(hands.in_view())
    hands.drag(hands.in_view(), hands.in_view())
    if hands.dice.random() < 0.5:
        start = hands.in_view()
        hands.app.move(start)
        hands.frames(1)
        hands.app.xdotool("mousedown", 1)
        hands.app.move(hands.in_view())
        hands.app.key(hands.dice.choice(["x", "z", "Escape"]))
        hands.app.move(hands.in_view())
        hands.frames(1)
        hands.app.xdotool("mouseup", 1)
    hands.app.key("Escape", "q")


def select(hands):
    hands.app.key("q")
    for _ in range(hands.dice.randint(1, 3)):
        hands.click(hands.in_view())
    if hands.dice.random() < 0.5:
        hands.drag(hands.in_view(), hands.in_view())
    hands.app.key(hands.dice.choice(["a", "alt+a", "ctrl+i", "ctrl+l", "h", "alt+h", "m", "bracketright", "bracketleft",
                                     "shift+bracketright", "shift+bracketleft", "f"]))


def graph(hands):
    select(hands)
    for _ in range(2):
        hands.app.move(hands.in_view())
        hands.app.key(hands.dice.choice(["shift+e", "ctrl+j", "y", "ctrl+Delete", "ctrl+r", "ctrl+p", "Delete", "shift+d"]))
    hands.click(hands.in_view())
    hands.app.key("Escape")


def copies(hands):
    select(hands)
    hands.app.key(hands.dice.choice(["ctrl+c", "ctrl+x"]))
    for _ in range(hands.dice.randint(1, 2)):
        hands.app.move(hands.in_view())
        hands.app.key("ctrl+v")
    hands.app.key("ctrl+d")


def undo_redo(hands):
    hands.app.key(*["ctrl+z"] * hands.dice.randint(1, 12))
    hands.app.key(*[hands.dice.choice(["ctrl+shift+z", "ctrl+y"])] * hands.dice.randint(1, 12))


KINDS_OF_GRASS = "1234"


def grass(hands):
    for _ in range(hands.dice.randint(1, 3)):
        hands.app.key(hands.dice.choice(KINDS_OF_GRASS))
        hands.frames(2)


def overlays(hands):
    hands.app.key(hands.dice.choice("56789"))
    hands.frames(1)
    if hands.dice.random() < 0.3:
        hands.press("toolbar/overlay." + hands.dice.choice(["vectors", "vorticity", "streamlines", "lic"]))


def play(hands):
    for _ in range(hands.dice.randint(1, 4)):
        hands.app.key(hands.dice.choice(["space", "period", "shift+space", "alt+Left", "alt+Right", "shift+l", "shift+i", "shift+o"]))
        hands.frames(1)
    ruler = hands.box("timeline/ruler")
    if ruler:
        x, y, width, height = ruler
        start = (x + width * hands.dice.uniform(0, 0.5), y + height / 2)
        end = (x + width * hands.dice.uniform(0, 0.5), y + height / 2)
        hands.drag(start, end)
        hands.frames(2)
        if hands.dice.random() < 0.3:
            hands.app.key("Escape")
    if hands.app.fact("playing") != "yes":
        hands.app.key("space")


def camera(hands):
    for _ in range(hands.dice.randint(1, 3)):
        kind = hands.dice.randrange(5)
        place = hands.in_view()
        if kind == 0:
            hands.drag(place, hands.in_view(), button=2)
        elif kind == 1:
            hands.app.xdotool("keydown", "shift")
            hands.drag(place, hands.in_view(), button=2)
            hands.app.xdotool("keyup", "shift")
        elif kind == 2:
            hands.app.move(place)
            hands.app.xdotool("click", "--repeat", hands.dice.randint(1, 5), hands.dice.choice([4, 5]))
        elif kind == 3:
            hands.app.move(place)
            hands.app.key(hands.dice.choice(["KP_Home", "KP_End", "KP_Next", "KP_Begin", "Home", "f"]))
        else:
            hands.app.move(place)
            hands.app.xdotool("mousedown", 3)
            hands.app.xdotool("keydown", "w")
            hands.frames(3)
            hands.app.xdotool("keyup", "w")
            hands.app.xdotool("mouseup", 3)
            hands.app.key("Escape")


def resize(hands):
    width, height = hands.dice.choice(SIZES)
    hands.app.xdotool("windowsize", hands.app.window, width, height)
    hands.frames(2)


def panels(hands):
    kind = hands.dice.randrange(4)
    if kind == 0:
        hands.app.key("F1")
        hands.frames(2)
        hands.app.key("F1")
    elif kind == 1:
        names = [name for name in hands.map()[1] if re.match(r"(notes|inspector)/tab/", name)]
        for _ in range(3):
            hands.press(hands.dice.choice(sorted(names)) if names else "")
            hands.frames(1)
    elif kind == 2:
        name = "split/" + hands.dice.choice(["left", "right", "bottom", "timeline"])
        box = hands.box(name)
        if box:
            start = (box[0] + box[2] / 2, box[1] + box[3] / 2)
            hands.drag(start, (start[0] + hands.dice.randint(-60, 60), start[1] + hands.dice.randint(-60, 60)))
    else:
        command(hands)


def command(hands, name=None):
    """By the palette."""
    hands.app.key("F3")
    hands.frames(2)
    if hands.app.fact("dialog") == "palette":
        hands.app.type(name or hands.dice.choice(COMMANDS))
        hands.frames(2)
        hands.app.key("Return")
    hands.frames(1)


def solver(hands):
    hands.press("inspector/tab/Solver")
    hands.frames(2)
    kind = hands.dice.randrange(3)
    if kind == 0:
        hands.press("inspector/solver/preset/" + hands.dice.choice(["default", "cwd-sim"]))
    elif kind == 1:
        hands.press("inspector/tab/Ambient")
        hands.frames(2)
        turn(hands, "inspector/ambient/")
    else:
        turn(hands, "inspector/solver/")


def turn(hands, prefix):
    """A drag on a number, a click on a box or a list."""
    names = [name for name in sorted(hands.map()[1]) if name.startswith(prefix) and not NOT_AT_RANDOM.match(name)]
    if not names:
        return
    box = hands.box(hands.dice.choice(names))
    if box:
        place = hands.inside(box)
        hands.drag(place, (place[0] + hands.dice.randint(-40, 40), place[1]))
        hands.frames(1)


def inspect(hands):
    names = [name for name in sorted(hands.map()[1]) if re.match(r"outliner/\d+$", name)]
    if names:
        hands.press(hands.dice.choice(names))
        hands.frames(2)
    for _ in range(3):
        turn(hands, "inspector/")


def anything(hands):
    """A click, a drag or a turn of the wheel on anything that has a name."""
    for _ in range(3):
        names = [name for name in sorted(hands.map()[1]) if not NOT_AT_RANDOM.match(name)]
        box = hands.box(hands.dice.choice(names)) if names else None
        if box is None:
            continue
        place = hands.inside(box)
        kind = hands.dice.randrange(5)
        if kind < 2:
            end = (place[0] + hands.dice.randint(-80, 80), place[1] + hands.dice.randint(-50, 50))
            hands.drag(place, tuple(max(coordinate, 0) for coordinate in end))  # the pointer can't leave the screen
        elif kind == 2:
            hands.app.move(place)
            hands.app.xdotool("click", hands.dice.choice([4, 5]))
        elif kind == 3:
            hands.click(place, 3)
            hands.app.key("Escape")
        else:
            hands.click(place)
        hands.frames(1)


def export(hands):
    """Begun and, if it isn't done by then, cancelled."""
    hands.app.key("Escape", "ctrl+shift+e")
    hands.frames(3)
    if not hands.press("export/start"):
        return
    hands.frames(hands.dice.randint(2, 12))
    cancel_export(hands)


def cancel_export(hands):
    def over():
        if hands.app.fact("export.running") != "yes":
            return True
        hands.press("export/cancel")
        hands.frames(2)
        return False

    hands.app.wait("the export to end", over, FRAME_PATIENCE_S)


def end_export(hands):
    """None runs, and none begins again by itself after an edit."""
    hands.app.key("Escape", "ctrl+shift+e")
    hands.app.wait("the export's panel", lambda: hands.app.fact("export/again") != "", FRAME_PATIENCE_S)
    if hands.app.fact("export/again") == "yes":
        hands.app.press("export/again")
        hands.app.wait_fact("export/again", "no")
    cancel_export(hands)


def live_link(hands):
    hands.app.key("Escape", "ctrl+shift+e")
    hands.frames(3)
    box = hands.box("export/live")
    view = hands.box("status/message")
    if not box or not view or box[1] + box[3] > view[1]:  # below what can be seen: the list of formats is open
        hands.press("export/section/Formats")
        hands.frames(4)
    hands.press("export/live")
    hands.frames(5)


def drop_dialogs(hands, patience_s=60):
    """Closes what is open: typing, menus, dialogs. Whether that went."""
    end = time.monotonic() + patience_s
    hands.app.xdotool("mouseup", 1, "mouseup", 2, "mouseup", 3)
    hands.app.key("Escape", "Escape")  # lists and menus, of which no fact tells
    hands.frames(3)
    while time.monotonic() < end:
        facts = hands.map()[0]
        if facts.get("dialog", "") == "" and facts.get("typing") == "no" and facts.get("help") == "no":
            return True
        hands.app.key("F1" if facts.get("help") == "yes" and not facts.get("dialog") else "Escape")
        hands.frames(2)
    return False


ACTS = [(draw, 4), (put, 3), (brush, 2), (transform, 4), (select, 3), (graph, 3), (copies, 3), (undo_redo, 4), (grass, 2),
        (overlays, 3), (play, 4), (camera, 4), (resize, 1), (panels, 3), (solver, 2), (inspect, 3), (anything, 5), (export, 1),
        (live_link, 1)]
