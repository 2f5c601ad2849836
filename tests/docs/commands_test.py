"""Runs every command that a document shows, in a copy of the tree.

usage: commands_test.py REPOSITORY FOLDER_OF_PROGRAMS [--long] [--page PAGE] [--list]

Commands are the lines of blocks fenced as `sh` and `console` (after "$ "), blocks of Python, blocks of C (which are compiled), and `code`
within a line that begins with one of PROGRAMS and has arguments. Each must end with 0 and write the files it names; what a `console` block shows is compared by its shape:
numbers may differ. Where a word in capitals or brackets stands for something, verb and options are looked up in the help.
Scripts of tests are run by tests of their own and only compiled here.
By default sizes and times are cut down (`small`), and the samples' winds are computed on few cells; --long runs all as it stands, and a
picture of docs/images that it makes must look as the one that is there.
"""
import concurrent.futures
import dataclasses
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

import markdown
from command_exceptions import LONG, NEVER, REFUSED

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "ui"))
from editor_driver import display  # noqa: E402

PROGRAMS = re.compile(r"(windloom(-editor|-leaves)?|\./run|\./test|cmake|ctest|python3|cc|montage|build/\w+/bin/[\w-]+)(?= |$)")
STANDS_FOR = re.compile(r"\b[A-Z]{2,}\b(?!/)|\[|\.\.\.|\b[A-Z],[A-Z]\b| [A-Z]$")
# Speaks of an option, names no project.
WITHOUT_FILE = re.compile(r"windloom (bake|render|sample|info|validate) (?!.*(\.wind\.json|--help|--list))")
# Blocks in these languages are commands; a command in another block is an oversight.
SHELL = ("sh", "console")
# What a reader has done before on that page, or elsewhere, without a command.
BEFORE = {
    # The home folder is the tree's copy.
    "docs/tutorial.md": ["windloom new first.wind.json --template breeze",
                         "windloom bake first.wind.json --out first-wind --format windpack --seconds 0.2"],
    "docs/windpack.md": ["windloom bake projects/meadow/meadow.wind.json --out wind --format windpack --seconds 0.2",
                         "cp wind/wind.windpack ."],
}
# What a piece of C stands in: names that the text around it explains.
C_AROUND = """#include <stdio.h>
#include <windloom_runtime.h>
%s
int main(void) {
  windloom_status status = WINDLOOM_OK;
  float x = 0, z = 0, wind[2] = {0, 0};
  double seconds = 0;
  { %s }
  return wind[0] > x + z + seconds + status;
}
"""
SKIPPED = ("docs/images/", "tests/golden/pictures/", "tests/data/broken/", "engine/", "editor/")
CELLS = 32
# Of 255, in the mean. Another way of bending blades makes 2.4, another camera 10; windows are taken at no fixed moment.
RENDER_LIMIT, WINDOW_LIMIT = 2, 8


@dataclasses.dataclass
class Command:
    page: str
    line: int
    text: str
    output: list  # lines that the page shows

    def matches(self, entry):
        return entry[0] == self.page and entry[1] in self.text


def in_order(text):
    """The lines of a piece of C: what it includes, and the rest."""
    lines = text.split("\n")
    return tuple("\n".join(line for line in lines if line.startswith("#") == first) for first in (True, False))


def commands_of_block(page, block):
    if block.language == "python":
        return [Command(page, block.line, f"python3 - <<'END'\n{block.text}END", [])]
    if block.language == "c":
        return [Command(page, block.line, f"cc -x c -Wall -fsyntax-only -I \"$RUNTIME\" - <<'END'\n{C_AROUND % in_order(block.text)}END", [])]
    found, pending = [], ""
    whole = re.search(r"^(for|while|if) ", block.text, re.M)
    if whole:
        return [Command(page, block.line, block.text.rstrip(), [])]
    for offset, line in enumerate(block.text.rstrip().split("\n")):
        if block.language == "console" and not pending and not line.startswith("$ "):
            if found:
                found[-1].output.append(line)
            continue
        pending += line.removeprefix("$ ") if block.language == "console" else line
        if pending.endswith("\\"):
            pending = pending[:-1]
        else:
            text = re.sub(r"\s+#\s.*$", "", pending).strip()
            if text:
                found.append(Command(page, block.line + offset, text, []))
            pending = ""
    return found


def runs_on(page, text):
    """Records of long runs are looked up; the choice of tests is run, which lists them only."""
    return not page.startswith("docs/reliability") or re.match(r"(ctest|\./test)\b", text) is not None


def commands_of(page):
    """(commands to run, forms whose words stand for something)."""
    name, found, forms = str(page.path), [], []
    for block in page.blocks:
        if block.language in SHELL + ("python", "c"):
            found += commands_of_block(name, block)
    found, forms = ([c for c in found if runs_on(name, c.text)], [c for c in found if not runs_on(name, c.text)])
    for line, code in markdown.inline_code(page):
        code = code.replace("\\|", "|")
        if not PROGRAMS.match(code):
            continue
        if STANDS_FOR.search(code) or not re.search(r" (-|\S*[./])|^windloom docs ", code) or WITHOUT_FILE.match(code) or not runs_on(name, code):
            forms.append(Command(name, line, code, []))
        else:
            found.append(Command(name, line, code, []))
    return found, forms


def stray_blocks(page):
    """Commands in blocks that aren't fenced as such."""
    return [f"{page.path}:{block.line}: fence this block as sh" for block in page.blocks
            if block.language not in SHELL and any(PROGRAMS.match(line) for line in block.text.split("\n"))]


def bounded(text):
    """The same command so that it ends by itself and soon, in both forms: windows close, measurements are quick, and programs of
    tests, which have tests of their own, only list what they would do."""
    if re.match(r"\./run\b(?!.*--)", text):
        return f"timeout 5 {text} || [ $? = 124 ]"  # it opens the editor, which stays open
    if re.search(r"windloom-leaves\b(?!.*--frames)", text):
        text += " --frames 30"
    if re.search(r"windloom-editor\b(?!.*--(screenshot|keys))", text):
        text += " --frames 2 --screenshot window.png"
    if re.search(r"bin/\w+_test\b", text):
        text += " --gtest_list_tests | grep '^  ' >/dev/null"  # the filter must find something
    if re.search(r"bin/\w+_bench\b", text):
        text += " --benchmark_list_tests | grep . >/dev/null"
    return re.sub(r"(windloom bench .*)$", r"\1 --quick", text)


def small(text):
    """The same command at a size that takes a moment."""
    text = re.sub(r"(?<=\bwindloom )render\b", f"render --size 96x54 --resolution {CELLS}x{CELLS} --density 4", text)
    if "windloom render" in text:
        head, tail = text.split("--density 4", 1)
        tail = re.sub(r" --(size|resolution) \d+x\d+| --full-quality", "", tail)
        text = head + "--density 4" + re.sub(r"--time \d+(\.\d+)?", "--time 0.1", tail)
    text = bounded(re.sub(r"(--resolution) \d+x\d+(?! --density)", rf"\1 {CELLS}x{CELLS}", text))
    if "windloom-editor" in text and "--screenshot" in text:
        text = re.sub(r"--frames \d+", "--frames 3", re.sub(r"--size \d+x\d+", "--size 480x320", text))
    if "windloom-leaves" in text:
        text = re.sub(r"--frames \d+", "--frames 2", text) + " --size 240x160"
    return text


def test_script(text, root):
    """The script that a command runs, where a test of its own runs it, too."""
    script = re.match(r"python3 (tests/\S+/(\w+\.py))", text)
    if not script:
        return ""
    lists = [file.read_text() for file in (root / script.group(1)).parent.glob("CMakeLists.txt")]
    return script.group(1) if any(f"SCRIPT {script.group(2)}" in text for text in lists) else ""


STUBS = {
    # The build is done; only presets and folders are looked at. Installing and other trees are real.
    "cmake": 'case "$1 $2" in "--preset "*) grep -q "\\"name\\": \\"$2\\"" CMakePresets.json ;; '
             '"--build build/"*) [ -d "$2" ] ;; *) exec {cmake} "$@" ;; esac',
    # A build with sanitizers, which wants patience, leaves some tests out.
    "ctest": '{ctest} -N "$@" | tee /dev/stderr | grep -q "Total Tests: [1-9]" || '
             '{{ [ "${{WINDLOOM_TEST_PATIENCE:-1}}" != 1 ] && grep -Eq "cli_valgrind|package_test|fuzz" <<< "$*"; }}',
    "dpkg-query": "printf installed",
    "python3": 'exec {python} "$@"',
}


class Scratch:
    """A copy of the tree with the built programs on PATH and under build/."""

    def __init__(self, root, programs, folder, long):
        self.root = root
        self.tree = folder / "tree"
        self.bin = folder / "bin"
        self.long = long
        self.programs = programs
        for name in markdown.tracked(root):
            if not name.startswith(SKIPPED):
                (self.tree / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy2(root / name, self.tree / name)
        self.bin.mkdir()
        for name in ("windloom", "windloom-editor", "windloom-leaves"):
            (self.bin / name).symlink_to(programs / name)
        for name, script in STUBS.items():
            (self.bin / name).write_text("#!/bin/bash\n" +
                                          script.format(cmake=shutil.which("cmake"), ctest=shutil.which("ctest"), python=sys.executable))
            (self.bin / name).chmod(0o755)
        self.shrink(self.tree)

    def shrink(self, folder):
        """Few cells for the wind of every project in a folder."""
        for file in () if self.long else folder.rglob("*.wind.json"):
            text = file.read_bytes()
            shrunk = re.sub(rb'("resolution": )\[\d+, \d+\]', rb"\1[%d, %d]" % (CELLS, CELLS), text)
            if shrunk != text:
                file.write_bytes(shrunk)

    def page_tree(self, page):
        folder = self.tree.parent / page.replace("/", "_")
        shutil.copytree(self.tree, folder)
        (folder / "docs/images").mkdir(parents=True, exist_ok=True)
        (folder / "build").mkdir()
        for name in re.findall(r'"configurePreset": "(\w+)"', (folder / "CMakePresets.json").read_text()):
            (folder / "build" / name).symlink_to(self.programs.parent)
        return folder


def written(text):
    """Files and folders that a command says it writes."""
    return [path.strip("'\"") for path in re.findall(r"--(?:out|screenshot|pictures|keys|prefix) (\S+)", text)]


def grains(file):
    """A picture as 96 x 54 colours."""
    return subprocess.run(["convert", str(file), "-resize", "96x54!", "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout


def stale(path, limit, folder, root):
    """Whether a picture of the documents looks other than what its command makes now."""
    stored = root / path
    if not path.startswith("docs/images/") or not stored.exists() or not (folder / path).exists():
        return ""
    now, then = grains(folder / path), grains(stored)
    difference = sum(abs(a - b) for a, b in zip(now, then)) / len(then)
    return f"{path} is out of date: off by {difference:.1f} of 255 in the mean" if difference > limit else ""


def shape(line):
    return re.sub(r"\s+", " ", re.sub(r"-?\d+(\.\d+)?", "#", line)).strip()


def run_command(command, scratch, folder, environment):
    """Problems of one command."""
    script = test_script(command.text, scratch.root)
    text = (f"python3 -m py_compile {script}" if script else
            bounded(command.text) if scratch.long else small(command.text))
    environment = dict(environment, PATH=f"{scratch.bin}:{environment['PATH']}", HOME=str(folder), TMPDIR=str(folder),
                       RUNTIME=str(scratch.root / "engine/runtime"))
    began = time.time()
    try:
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", text], cwd=folder, env=environment, capture_output=True, text=True,
                              timeout=3600 if scratch.long else 240)
    except subprocess.TimeoutExpired:
        return [f"{command.page}:{command.line}: doesn't end: {text}"]
    where = f"{command.page}:{command.line}: {text}"
    if done.returncode != 0:
        return [f"{where}\n  ended with {done.returncode}: {(done.stdout + done.stderr)[-600:]}"]
    found = []
    for path in written(text):
        numbered = path.replace(".png", ".0000.png")
        there = [folder / p for p in (path, numbered) if (folder / p).exists()]
        if not there or max(p.stat().st_mtime for p in there) < began - 2:
            found.append(f"{where}\n  didn't write {path}")
        elif scratch.long:
            problem = stale(path, RENDER_LIMIT if "windloom render" in text else WINDOW_LIMIT, folder, scratch.root)
            found += [f"{where}\n  {problem}"] if problem else []
    shown = [shape(line) for line in command.output if line.strip()]
    told = [shape(line) for line in done.stdout.split("\n") if line.strip()]
    if shown and shown != told:
        found.append(f"{where}\n  the page shows\n    " + "\n    ".join(shown) + "\n  it printed\n    " + "\n    ".join(told))
    if re.match(r"windloom new|.* windloom new", text):
        scratch.shrink(folder)
    return found


def run_page(page, commands, scratch, environment):
    folder = scratch.page_tree(page)
    found = []
    try:
        for command in [Command(page, 0, text, []) for text in BEFORE.get(page, [])] + commands:
            found += run_command(command, scratch, folder, environment)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return found


class Forms:
    """Looks verbs and options up in the programs' help."""

    def __init__(self, root, programs):
        self.root = root
        self.programs = programs
        self.helps = {}

    def help(self, *words):
        if words not in self.helps:
            done = subprocess.run([self.programs / words[0], *words[1:], "--help"], capture_output=True, text=True)
            self.helps[words] = done.stdout if done.returncode == 0 else None
        return self.helps[words]

    def problems(self, form):
        words = form.text.split()
        program = pathlib.PurePosixPath(words[0]).name
        if program == "python3" and words[1].startswith("tests/") and not (self.root / words[1]).exists():
            return [f"{form.page}:{form.line}: there is no {words[1]}"]
        if not program.startswith("windloom"):
            return []
        verb = [words[1]] if program == "windloom" and len(words) > 1 and re.fullmatch(r"[a-z]+", words[1]) else []
        told = self.help(program, *verb)
        if told is None:
            return [f"{form.page}:{form.line}: there is no {program} {' '.join(verb)}"]
        options = re.findall(r"--[a-z][\w-]*", form.text)
        return [f"{form.page}:{form.line}: {program} {' '.join(verb)} has no {option}" for option in options
                if not re.search(rf"{option}\b", told + self.help("windloom"))]


def self_check(scratch, environment):
    """The checks bite: each of these must be refused."""
    wrong = [("windloom info nothing.wind.json", []), ("windloom bake --no-such-option x", []), ("true --out nothing.png", []),
             ("windloom --version", ["another program 1.2"])]
    return [f"self check: not refused: {text}" for text, output in wrong
            if not run_command(Command("self check", 0, text, output), scratch, scratch.tree, environment)]


def list_problems(commands):
    """Entries of the exceptions that no command needs."""
    found = [f"{name}: no command matches {entry[:2]}" for name, entries in (("NEVER", NEVER), ("LONG", LONG))
             for entry in entries if not any(command.matches(entry) for command in commands)]
    return found + [f"BEFORE: {page} has no commands" for page in BEFORE if not any(c.page == page for c in commands)]


def main():
    root, programs = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
    long = "--long" in sys.argv
    only = sys.argv[sys.argv.index("--page") + 1] if "--page" in sys.argv else ""
    pages = [page for page in markdown.pages(root) if str(page.path) != "CHANGELOG.md"]
    found, everything, forms = [problem for page in pages for problem in stray_blocks(page)], [], []
    for page in pages:
        commands, stands_for = commands_of(page)
        everything += commands
        forms += stands_for
    look_up = Forms(root, programs)
    found += list_problems(everything) + [problem for form in forms for problem in look_up.problems(form)]
    left_out = NEVER if long else NEVER + LONG
    refused = {command.text for command in everything if any(re.search(pattern, command.text) for pattern, _ in REFUSED)}
    chosen, seen = {}, set()
    for command in everything:
        known = (command.text, command.page if command.output or "first" in command.text else "")
        if (known not in seen and command.text not in refused and only in ("", command.page)
                and not any(command.matches(entry) for entry in left_out)):
            chosen.setdefault(command.page, []).append(command)
        seen.add(known)
    count = sum(map(len, chosen.values()))
    if "--list" in sys.argv:
        for command in (c for page in chosen.values() for c in page):
            print(f"{command.page}:{command.line}: {command.text}")
    else:
        with tempfile.TemporaryDirectory(prefix="windloom-docs-") as name, display("1280x800") as environment:
            scratch = Scratch(root, programs, pathlib.Path(name), long)
            found += self_check(scratch, environment)
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                jobs = [pool.submit(run_page, page, commands, scratch, environment)
                        for page, commands in sorted(chosen.items(), key=lambda item: -len(item[1]))]
                found += [problem for job in jobs for problem in job.result()]
    for line in found:
        print(line)
    print(f"{len(everything)} commands on {len({c.page for c in everything})} pages, {count} of them run, {len(forms)} forms looked up, "
          f"{len(NEVER) + len(refused)} never run, {len(LONG)} long, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
