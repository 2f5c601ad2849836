"""Every shader program that the program can build, read by another compiler: glslangValidator, by desktop GLSL's rules. The
sources are what the driver was given, written by the shader library itself ($WINDLOOM_SHADER_DUMP) while the tests that load
every table of programs run, and while pictures and recordings need the variants that are known only at run time. Every file
of shaders/ must have been among them.

usage: shaders_test.py SHADERS WINDLOOM PROJECTS TEST_PROGRAM...
"""
import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# Said of good code: what a version later than ours would want, and that GLSL's own words are long.
HARMLESS = re.compile(r"^$|\.(vert|frag|comp|geom)$")


def fail(message):
    print(f"FAILED: {message}", file=sys.stderr)
    sys.exit(1)


def dump(folder, windloom, projects, programs):
    environment = dict(os.environ, WINDLOOM_SHADER_DUMP=str(folder))
    runs = [[program, "--gtest_filter=*Programs*:*LoadAll*:*AllCompile*:*ShadersCompile*:PlainGpuScheme.Compiles*"]
            for program in programs]
    small = ["--size", "96x64", "--time", "0.05", "--backend", "gpu", "--out", str(folder.parent / "p.png")]
    for name in ("knoll", "prairie", "nature", "flowers", "fur"):
        runs.append([windloom, "render", str(projects / name / f"{name}.wind.json"), *small])
    meadow = str(projects / "canyon" / "canyon.wind.json")
    for solver in ("default", "cwd-sim"):
        runs.append([windloom, "render", meadow, "--solver", solver, "--overlay", "arrows", *small])
    runs.append([windloom, "bench", "floor", "--quick", "--backend", "gpu"])
    for run in runs:
        done = subprocess.run(run, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            fail(f"{run}: {done.stdout[-2000:]}{done.stderr[-2000:]}")


def facts(text, what):
    return re.findall(rf"^// {what}: (.*)$", text, re.M)


def compile_all(folder):
    """Each text alone, then the stages of a program together."""
    by_program, entries, files = collections.defaultdict(dict), set(), set()
    texts = sorted(folder.iterdir())
    for path in texts:
        text = path.read_text()
        program, stage = facts(text, "program")[0], facts(text, "stage")[0]
        entries.add("shaders/" + stage)
        files.update(facts(text, "file"))
        defines = tuple(re.findall(r"^#define (\w+ .*|\w+)$", text.split("// file")[0], re.M)[:0])
        by_program[program, defines].setdefault(path.suffix, []).append(path)
        check([path])
    linked = 0
    for (program, _), stages in by_program.items():
        if {".vert", ".frag"} <= set(stages):
            for vertex in stages[".vert"]:
                check(["-l", vertex, stages[".frag"][0]])
                linked += 1
    return len(texts), linked, entries, files


def check(arguments):
    told = subprocess.run(["glslangValidator", *map(str, arguments)], capture_output=True, text=True)
    lines = [line for line in told.stdout.splitlines() if not HARMLESS.search(line)]
    if told.returncode != 0 or lines:
        text = pathlib.Path(arguments[-1]).read_text()
        fail(f"{facts(text, 'program')} {facts(text, 'stage')} {arguments}: " + "\n".join(lines[:20]) + told.stderr)


def main():
    shaders, windloom, projects = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    with tempfile.TemporaryDirectory(prefix="windloom-shaders-") as name:
        folder = pathlib.Path(name) / "dump"
        folder.mkdir()
        dump(folder, windloom, projects, sys.argv[4:])
        texts, linked, entries, files = compile_all(folder)
    there = {"shaders/" + path.relative_to(shaders).as_posix() for path in shaders.rglob("*") if path.is_file()}
    code = {name for name in there if not name.endswith(".md")}
    left = code - files
    if left:
        fail(f"no program was built from {sorted(left)}")
    needed = {name for name in code if re.search(r"\.(vert|frag|comp|geom)$", name) and "/include/" not in name}
    if needed - entries:
        fail(f"no stage was compiled from {sorted(needed - entries)}")
    print(f"{texts} texts of {len(entries)} stages compiled, {linked} programs linked, all {len(code)} files used")


if __name__ == "__main__":
    main()
