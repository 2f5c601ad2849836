"""Draws the rooms and who includes whom from the table in include_rules.py, as an SVG that reads on light and dark ground.

usage: draw_rooms.py REPOSITORY           writes docs/images/rooms.svg again
       draw_rooms.py REPOSITORY --check   fails where the drawing or docs/architecture.md says something else

Only the arrows that others don't imply are drawn: where a includes b and b includes c, a -> c goes without saying.
"""
import html
import pathlib
import re
import sys

from include_rules import DIRECT

PICTURE = "docs/images/rooms.svg"
ARCHITECTURE = "docs/architecture.md"
# Room -> column and row of its box, and what is written in it. Arrows must point down.
PLACES = {
    "editor/app": (0.5, 0, "windloom-editor"),
    "editor/viewport": (1, 1, "the 3D view"),
    "editor/panels": (0, 1, "one panel a file"),
    "editor/widgets": (0.5, 2, "small pieces of UI"),
    "editor/core": (0.5, 4, "tools, history; no window"),
    "engine/cli": (2.25, 1, "windloom"),
    "engine/bake": (2.25, 2, "recording, exports"),
    "engine/runtime": (3, 3, "what a game links"),
    "engine/session": (1.75, 3, "a project come to life"),
    "engine/render": (2.25, 4, "the frame"),
    "engine/grass": (2.25, 5, "where and how it stands"),
    "engine/wind": (2.25, 6, "the solver"),
    "engine/io": (0.9, 6, "JSON, PNG, glTF"),
    "engine/model": (1.25, 7, "the project as a value"),
    "engine/gpu": (2.25, 7, "OpenGL objects"),
    "engine/core": (1.75, 8, "results, log, threads"),
}
WIDTH, HEIGHT, COLUMN, ROW, MARGIN = 174, 46, 196, 78, 12
# Fill and line for each half of the house. Their text is dark on both, so the ground behind doesn't matter.
COLOURS = {"editor": ("#f6dfb5", "#a87416"), "engine": ("#cfe5da", "#2f7a5c")}


def below(room):
    """All that a room may include."""
    return set().union(*({lower} | below(lower) for lower in DIRECT[room])) if DIRECT[room] else set()


def arrows():
    """The direct edges less those that other edges imply."""
    return [(room, lower) for room in DIRECT for lower in DIRECT[room]
            if not any(lower in below(other) for other in DIRECT[room])]


def corner(room):
    column, row, _ = PLACES[room]
    return MARGIN + column * COLUMN, MARGIN + row * ROW


def draw_arrow(room, lower):
    """From the lower edge of one box to the upper edge of another, leaving each a little towards the other."""
    (x, y), (to_x, to_y) = corner(room), corner(lower)
    lean = max(-50, min(50, (to_x - x) * 0.2))
    return (f'<path d="M{x + WIDTH / 2 + lean:g} {y + HEIGHT:g} L{to_x + WIDTH / 2 - lean:g} {to_y - 3:g}" '
            'stroke="#7d8590" stroke-width="1.5" fill="none" marker-end="url(#tip)"/>')


def draw_room(room):
    x, y = corner(room)
    fill, line = COLOURS[room.split("/")[0]]
    middle = x + WIDTH / 2
    return (f'<rect x="{x:g}" y="{y:g}" width="{WIDTH}" height="{HEIGHT}" rx="6" fill="{fill}" stroke="{line}" stroke-width="1.5"/>\n'
            f'<text x="{middle:g}" y="{y + 20:g}" font-weight="bold">{room}</text>\n'
            f'<text x="{middle:g}" y="{y + 36:g}" font-size="12">{html.escape(PLACES[room][2])}</text>')


def drawing():
    width = 2 * MARGIN + max(place[0] for place in PLACES.values()) * COLUMN + WIDTH
    height = 2 * MARGIN + max(place[1] for place in PLACES.values()) * ROW + HEIGHT
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" viewBox="0 0 {width:g} {height:g}" '
        'font-family="Helvetica, Arial, sans-serif" font-size="14" text-anchor="middle" fill="#1c2a24">',
        "<title>The rooms of Windloom; an arrow points at a room whose headers may be included</title>",
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="8" markerHeight="8" orient="auto">'
        '<path d="M0 0 L8 4 L0 8 z" fill="#7d8590"/></marker></defs>',
        *(draw_arrow(*arrow) for arrow in arrows()), *(draw_room(room) for room in DIRECT), "</svg>", ""])


def layout_problems():
    found = [f"{room} has no place in PLACES" for room in DIRECT if room not in PLACES]
    found += [f"PLACES has {room}, which is no room" for room in PLACES if room not in DIRECT]
    if found:
        return found
    found += [f"{room} -> {lower} doesn't point down" for room, lower in arrows() if PLACES[room][1] >= PLACES[lower][1]]
    return found + [f"{a} and {b} overlap" for a in PLACES for b in PLACES if a < b and PLACES[a][1] == PLACES[b][1]
                    and abs(PLACES[a][0] - PLACES[b][0]) * COLUMN < WIDTH]


def table_of(text):
    """Room -> what docs/architecture.md's table says that it may include."""
    found = {}
    for line in text.split("\n"):
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 3 and re.fullmatch(r"(engine|editor)/\w+", cells[0]):
            found[cells[0]] = cells[2]
    return found


def rooms_named(cell):
    """The rooms that a cell of the table stands for."""
    rooms = set()
    for name in (part.strip() for part in cell.split(",")):
        everything = re.fullmatch(r"all of (engine|editor)", name)
        if everything:
            rooms |= {room for room in DIRECT if room.startswith(everything.group(1) + "/")}
        elif name != "-":
            rooms.add(name if "/" in name else f"engine/{name}")
    return rooms


def table_problems(text):
    table = table_of(text)
    found = [f"{ARCHITECTURE} has no row for {room}" for room in DIRECT if room not in table]
    for room, cell in table.items():
        if room not in DIRECT:
            found.append(f"{ARCHITECTURE} has a row for {room}, which is no room of include_rules.py")
            continue
        named = rooms_named(cell) - {room}
        said = named.union(*(below(other) for other in named if other in DIRECT)) - {room}
        if said != below(room):
            found.append(f"{ARCHITECTURE}: {room} may include {sorted(below(room))}, the table says {sorted(said)}")
    return found


def self_check(text):
    """The check of the table bites: a room left out, one too many and a wrong edge are found."""
    spoilt = {"a room left out": re.sub(r"\n\| engine/gpu \|[^\n]*", "", text),
              "a room that isn't": text.replace("| engine/gpu |", "| engine/new |"),
              "a wrong edge": re.sub(r"(\n\| engine/gpu \|.*\|) core \|", r"\1 wind |", text)}
    return [f"self check: {what} is not found" for what, wrong in spoilt.items() if wrong == text or not table_problems(wrong)]


def main():
    root = pathlib.Path(sys.argv[1])
    found = layout_problems()
    if not found and "--check" not in sys.argv:
        (root / PICTURE).write_text(drawing())
    elif not found:
        text = (root / ARCHITECTURE).read_text()
        found += table_problems(text) + self_check(text)
        if not (root / PICTURE).exists() or (root / PICTURE).read_text() != drawing():
            found.append(f"{PICTURE} is not what the table gives; run: python3 tests/rules/draw_rooms.py .")
        if PICTURE.removeprefix("docs/") not in text:
            found.append(f"{ARCHITECTURE} doesn't show {PICTURE}")
    for line in found:
        print(line)
    print(f"{len(DIRECT)} rooms, {len(arrows())} arrows, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
