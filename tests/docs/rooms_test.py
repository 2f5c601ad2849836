"""Every room has a README that says in one line what lives there and which file to open first, and no more than a screen of it;
docs/architecture.md names the same rooms.

usage: rooms_test.py REPOSITORY

Rooms are the folders of engine, editor, tests, docs/examples and projects, and some of the root's own. Samples open with their project
file; what it shows stands in the table of projects/README.md, which must have them all.
"""
import pathlib
import re
import sys

import markdown

PARENTS = ["engine", "editor", "tests", "docs/examples", "projects"]
ALONE = ["cmake", "docs/examples", "packaging", "projects", "scripts", "shaders", "tests"]
SCREEN = 45  # lines
PROGRAMS = ["docs/examples"]  # a program of its own may explain itself at length
LINE = 260  # characters of the first paragraph, its links without their targets


def rooms(root, files):
    found = {room for room in ALONE if any(file.startswith(room + "/") for file in files)}
    for parent in PARENTS:
        depth = parent.count("/") + 1
        found |= {"/".join(file.split("/")[:depth + 1]) for file in files
                  if file.startswith(parent + "/") and file.count("/") > depth}
    return sorted(found)


def readme_problems(root, room):
    path = root / room / "README.md"
    if not path.exists():
        return [f"{room} has no README.md"]
    lines = path.read_text().rstrip("\n").split("\n")
    found = []
    if not re.match(r"# \S", lines[0]):
        return [f"{room}/README.md begins with no title"]
    first = next((line for line in lines[1:] if line.strip()), "")
    after = lines[lines.index(first) + 1:]
    if after and after[0].strip():
        found.append(f"{room}/README.md: the first paragraph is longer than a line")
    if len(re.sub(r"\]\([^)]*\)", "]", first)) > LINE:
        found.append(f"{room}/README.md: the first line is longer than {LINE} characters")
    opened = re.search(r"Open first: (.*)$", first)
    targets = re.findall(r"\]\(([^)]+)\)", opened.group(1)) if opened else []
    if not targets:
        found.append(f"{room}/README.md: the first line doesn't end with 'Open first: [file](file)'")
    found += [f"{room}/README.md: there is no {target}" for target in targets if not (root / room / target).exists()]
    if room.startswith("projects/") and targets and not targets[0].endswith(".wind.json"):
        found.append(f"{room}/README.md: a sample opens with its project file")
    if len(lines) > SCREEN and not any(room.startswith(program + "/") for program in PROGRAMS):
        found.append(f"{room}/README.md: {len(lines)} lines are more than a screen ({SCREEN})")
    return found


def table_problems(root, names):
    """The tables that list rooms have them all, and none that isn't there."""
    found = []
    architecture = (root / "docs/architecture.md").read_text()
    named = set(re.findall(r"^\| ((?:engine|editor)/\w+) \|", architecture, re.M))
    there = {room for room in names if room.startswith(("engine/", "editor/"))}
    found += [f"docs/architecture.md has no row for {room}" for room in sorted(there - named)]
    found += [f"docs/architecture.md has a row for {room}, which isn't there" for room in sorted(named - there)]
    for parent in ("projects", "tests"):
        listed = set(re.findall(r"^\| \[[^\]]+\]\((\w[\w-]*)\)", (root / parent / "README.md").read_text(), re.M))
        children = {room.split("/")[1] for room in names if room.startswith(parent + "/")}
        found += [f"{parent}/README.md doesn't list {child}" for child in sorted(children - listed)]
        found += [f"{parent}/README.md lists {child}, which isn't there" for child in sorted(listed - children)]
    return found


def main():
    root = pathlib.Path(sys.argv[1])
    names = rooms(root, markdown.tracked(root))
    found = [problem for room in names for problem in readme_problems(root, room)] + table_problems(root, names)
    for line in found:
        print(line)
    print(f"{len(names)} rooms, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
