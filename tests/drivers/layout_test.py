"""Structs that C++ and GLSL share (shaders/shared): size and every member's offset as the C++ compiler has them against those
of std430, and of std140 for structs that a uniform block has, as glslangValidator lays them out and spirv-cross tells. Also:
no array of three-component vectors in a buffer, and the same distance from one element of an array to the next.

usage: layout_test.py REPOSITORY CXX
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

STRUCT = re.compile(r"^struct (\w+) \{\n(.*?)^\};", re.M | re.S)
MEMBERS = re.compile(r"^\s*\w+\s+([^;()]+);", re.M)


def fail(message):
    print(f"FAILED: {message}", file=sys.stderr)
    sys.exit(1)


def run(*command):
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True)
    if done.returncode != 0:
        fail(f"{command}: {done.stdout}{done.stderr}")
    return done.stdout


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def structs(repository):
    found = {}
    for header in sorted((repository / "shaders/shared").glob("*.h")):
        for name, body in STRUCT.findall(without_comments(header.read_text())):
            found[name] = (header.name, [re.sub(r"\[.*", "", part).strip() for line in MEMBERS.findall(body) for part in line.split(",")])
    return found


def blocks(repository):
    """What the shaders declare as buffers and uniform blocks: kind -> names of struct types inside."""
    used = {"buffer": set(), "uniform": set()}
    bodies = []
    for file in sorted((repository / "shaders").rglob("*")):
        if not file.is_file():
            continue
        text = without_comments(file.read_text())
        for kind, body in re.findall(r"\)\s*(?:(?:readonly|writeonly|restrict|coherent)\s+)*(buffer|uniform)\s+\w+\s*\{(.*?)\}", text, re.S):
            bodies.append((file, kind, body))
            used[kind].update(re.findall(r"(\w+)\s+\w+(?:\[[^\]]*\])?\s*;", body))
    for file, kind, body in bodies:
        if re.search(r"\b[iu]?vec3\s+\w+\s*\[", body):
            fail(f"{file}: an array of three-component vectors in a {kind} block")
    return used


def cpp_layout(repository, compiler, found, folder):
    lines = ["#include <cstddef>", "#include <cstdio>"]
    lines += [f'#include "shaders/shared/{header}"' for header in sorted({header for header, _ in found.values()})]
    lines += ["using namespace windloom::shared;", "int main() {"]
    for name, (_, members) in found.items():
        lines.append(f'std::printf("{name} . %zu\\n", sizeof({name}));')
        lines += [f'std::printf("{name} {member} %zu\\n", offsetof({name}, {member}));' for member in members]
    source = folder / "layout.cpp"
    source.write_text("\n".join([*lines, "}"]))
    run(compiler, "-std=c++20", "-w", f"-I{repository}", source, "-o", folder / "layout")
    told = {}
    for line in run(folder / "layout").splitlines():
        name, member, value = line.split()
        told.setdefault(name, {})[member] = int(value)
    return told


def expand(repository, file, seen):
    """The includes of a file, each once, as the program's own loader does."""
    if file in seen:
        return ""
    seen.add(file)
    text = ""
    for line in (repository / file).read_text().splitlines():
        included = re.match(r'\s*#include "([^"]+)"', line)
        if included:
            path = included[1] if included[1].startswith("shaders/") else str(pathlib.PurePosixPath(file).parent / included[1])
            text += expand(repository, path, seen)
        elif not re.match(r"\s*#include", line):
            text += line + "\n"
    return text


def gpu_layout(repository, name, header, rules, folder):
    """Offsets of the members and the distance from one element of an array to the next."""
    source = folder / f"{name}-{rules}.comp"
    kind = "buffer" if rules == "std430" else "uniform"
    count = "" if rules == "std430" else "2"
    source.write_text("#version 450 core\n" + expand(repository, f"shaders/shared/{header}", set()) +
                      f"layout(local_size_x = 1) in;\nlayout({rules}, binding = 0) {kind} Block {{ {name} items[{count}]; }};\n"
                      f"layout(std430, binding = 1) buffer Out {{ uint kept; }};\n"
                      f"void main() {{ {name} item = items[1]; kept = uint(item == items[0]); }}\n")
    binary = source.with_suffix(".spv")
    run("glslangValidator", "-G", "-o", binary, source)
    told = json.loads(run("spirv-cross", binary, "--reflect"))
    block = next(type for type in told["types"].values() if type["name"] == "Block")
    items = block["members"][0]
    layout = {member["name"]: member["offset"] for member in told["types"][items["type"]]["members"]}
    layout["."] = items["array_stride"]
    return layout


def main():
    repository, compiler = pathlib.Path(sys.argv[1]), sys.argv[2]
    found, used = structs(repository), blocks(repository)
    in_buffers = {name for name in found if name in used["buffer"] | used["uniform"]}
    for name in list(in_buffers):  # and what they are made of
        body = STRUCT.findall(without_comments((repository / "shaders/shared" / found[name][0]).read_text()))
        in_buffers.update(word for struct, text in body if struct == name for word in re.findall(r"\w+", text) if word in found)
    checked = 0
    with tempfile.TemporaryDirectory(prefix="windloom-layout-") as name:
        folder = pathlib.Path(name)
        cpp = cpp_layout(repository, compiler, {name: found[name] for name in in_buffers}, folder)
        for struct in sorted(in_buffers):
            header, members = found[struct]
            for rules in ["std430"] + (["std140"] if struct in used["uniform"] else []):
                gpu = gpu_layout(repository, struct, header, rules, folder)
                if set(gpu) != set(cpp[struct]):
                    fail(f"{struct}: members {sorted(set(gpu) ^ set(cpp[struct]))} are not known to both")
                wrong = {member: (cpp[struct][member], at) for member, at in gpu.items() if cpp[struct][member] != at}
                if wrong and not (rules == "std430" and struct not in used["buffer"]):
                    fail(f"{header}: {struct} in {rules}: C++ and GLSL disagree (member: C++, GLSL): {wrong}")
                checked += len(gpu)
    if not in_buffers:
        fail("no shared struct was found in any block")
    print(f"{len(in_buffers)} structs of {len(found)} are in blocks, {checked} offsets and sizes agree: {' '.join(sorted(in_buffers))}")


if __name__ == "__main__":
    main()
