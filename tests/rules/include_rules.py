"""Reads every #include line and fails on an edge between rooms that docs/architecture.md doesn't have.

usage: include_rules.py REPOSITORY
"""
import pathlib
import re
import sys

# Room -> rooms whose headers it may include directly. "+" closes the set: all that those may include, too.
DIRECT = {
    "engine/core": [],
    "engine/model": ["engine/core"],
    "engine/io": ["engine/model"],
    "engine/gpu": ["engine/core"],
    "engine/wind": ["engine/model", "engine/gpu"],
    "engine/grass": ["engine/wind"],
    "engine/render": ["engine/grass"],
    "engine/session": ["engine/render", "engine/io"],
    "engine/runtime": [],
    "engine/bake": ["engine/session", "engine/runtime"],
    "engine/cli": ["engine/bake"],
    "editor/core": ["engine/model", "engine/io"],
    "editor/widgets": ["editor/core"],
    "editor/viewport": ["editor/core", "editor/widgets", "engine/session"],
    "editor/panels": ["editor/core", "editor/widgets", "engine/session", "engine/bake"],
    "editor/app": ["editor/viewport", "editor/panels", "engine/cli"],
}
# Third-party headers that only some rooms may name.
RESTRICTED = {
    r"imgui|GLFW/|forkawesome": ["editor/widgets", "editor/viewport", "editor/panels", "editor/app"],
    r"epoxy/": ["engine/gpu", "engine/wind", "engine/grass", "engine/render", "engine/session", "engine/cli",
                "editor/viewport", "editor/app"],
    r"nlohmann/": ["engine/io", "engine/bake", "engine/cli", "editor/core"],
    r"CLI/": ["engine/cli", "editor/app"],
    r"png\.h": ["engine/io"],
    r"openssl/.*": ["engine/io"],
    r"tiny_gltf": ["engine/io"],
    r"hwy/": ["engine/wind"],
    r"zstd\.h": ["engine/bake", "engine/runtime"],
    r"openvdb/": ["engine/bake"],
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]', re.M)


def allowed_rooms():
    closed = {}

    def close(room):
        if room not in closed:
            closed[room] = {room}
            for lower in DIRECT[room]:
                closed[room] |= close(lower)
        return closed[room]

    for room in DIRECT:
        close(room)
    return closed


def room_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 and parts[0] in ("engine", "editor") else None


def problems_in(path, text, closed):
    """Problems of one file, given its path from the repository's root."""
    room = room_of(path)
    found = []
    if room not in closed:
        return [f"{path}: '{room}' is no room of the table"]
    for match in INCLUDE.finditer(text):
        line = text.count("\n", 0, match.start(2)) + 1
        target = match.group(2)
        where = f"{path}:{line}: includes {target}"
        if target.startswith(("engine/", "editor/", "tests/")):
            if room_of(target) not in closed[room]:
                found.append(f"{where}, but {room} may not include {room_of(target) or target}")
        elif target.startswith("shaders/"):
            if not target.startswith("shaders/shared/"):
                found.append(f"{where}, but only shaders/shared is C++ as well")
        elif match.group(1) == '"' and "/" not in target and not target.startswith(("imgui", "windloom_runtime")):
            found.append(f"{where}; write the path from the repository's root")
        for pattern, rooms in RESTRICTED.items():
            if re.match(pattern, target) and room not in rooms:
                found.append(f"{where}, which only {', '.join(rooms)} may name")
    return found


def self_check(closed):
    """The rules bite: each of these made-up lines must be refused, and the legal ones not."""
    refused = [
        ("engine/core/a.cpp", '#include "engine/model/project.hpp"'),
        ("engine/wind/a.cpp", '#include "engine/render/frame.hpp"'),
        ("engine/gpu/a.cpp", '#include "engine/model/project.hpp"'),
        ("engine/runtime/a.cpp", '#include "engine/core/result.hpp"'),
        ("editor/core/a.cpp", "#include <imgui.h>"),
        ("engine/session/a.cpp", "#include <GLFW/glfw3.h>"),
        ("engine/model/a.hpp", '#include "project.hpp"'),
        ("engine/model/a.hpp", '  #  include "tests/x/y.hpp"'),
        ("engine/new/a.hpp", ""),
    ]
    legal = [
        ("engine/session/a.cpp", '#include "engine/core/log.hpp"'),
        ("engine/core/a.hpp", '#include "shaders/shared/hash.h"'),
        ("editor/app/a.cpp", '#include "engine/bake/recorder.hpp"'),
    ]
    return [f"self check: not refused: {p}: {t}" for p, t in refused if not problems_in(p, t, closed)] + [
        f"self check: refused: {p}: {t}" for p, t in legal if problems_in(p, t, closed)]


def main():
    root = pathlib.Path(sys.argv[1])
    closed = allowed_rooms()
    found = self_check(closed)
    files = [f for top in ("engine", "editor") for f in sorted((root / top).rglob("*")) if f.suffix in (".hpp", ".cpp", ".h", ".c")]
    if not files:
        found.append("no sources found")
    for file in files:
        found += problems_in(file.relative_to(root).as_posix(), file.read_text(), closed)
    for line in found:
        print(line)
    print(f"{len(files)} files, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
