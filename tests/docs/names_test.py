"""What documents name is there: options, keys, files and folders, names of the code.

usage: names_test.py REPOSITORY WINDLOOM WINDLOOM_EDITOR WINDLOOM_LEAVES

Options are looked up in the help of our programs, in scripts of the repository, or in ELSEWHERE. Keys in **bold** are looked up in
docs/keys.md or KEYS_ELSEWHERE. Backticks that look like a path are resolved from the root, from the page's folder, or from one of the
folders that the page speaks of. An entry of these lists that nothing needs any more fails, so the lists stay short.
"""
import pathlib
import posixpath
import re
import subprocess
import sys

import markdown

# Options of other programs, with who knows them.
ELSEWHERE = {
    "--build": "cmake", "--install": "cmake", "--preset": "cmake", "--target": "cmake", "--component": "cmake", "--prefix": "cmake",
    "--test-dir": "ctest", "--cflags": "pkg-config", "--libs": "pkg-config",
    "--gtest_filter": "GoogleTest", "--gtest_output": "GoogleTest", "--benchmark_filter": "Google Benchmark",
    "--benchmark_repetitions": "Google Benchmark", "--benchmark_report_aggregates_only": "Google Benchmark",
    "--benchmark_min_time": "Google Benchmark",
}
# Bold words that look like keys but are pressed in one panel or game only, with where they are told.
KEYS_ELSEWHERE = {"Enter": "dialogs", "Space": "also in the sample game"}
# Paths that a bake, a build or the user makes, as patterns, with what makes them.
MADE = {
    r"first(-wind|\.png|\.wind\.json)(/.*)?": "the tutorial",
    r"(wind|flow|flow16|slab|wind-v2|bend-soft)[\w.-]*": "a bake",
    r"(HOWTO\.md|manifest\.json|graph\.gltf|wind\.(hlsl|glsl|gd|gdshaderinc)|WindloomImport\.cs|import_windloom\.py|log(\.old)?\.txt)": "a bake, the editor",
}


def help_of(program, *arguments):
    return subprocess.run([program, *arguments, "--help"], capture_output=True, text=True, check=True).stdout


def known_options(root, windloom, editor, leaves):
    """Every option that one of our programs or scripts takes."""
    main = help_of(windloom)
    verbs = re.findall(r"^  (\w+)  +", main.split("Subcommands:")[1], re.M)
    text = main + help_of(editor) + help_of(leaves) + "".join(help_of(windloom, verb) for verb in [*verbs, "docs"])
    scripts = [name for name in markdown.tracked(root) if name.endswith((".py", ".sh")) or name in ("run", "test")]
    text += "".join((root / name).read_text() for name in scripts if name != "tests/docs/names_test.py")
    return set(re.findall(r"--[a-zA-Z][\w-]*", text))


def option_problems(pages, known):
    found, seen = [], set()
    for page in pages:
        if str(page.path) == "CHANGELOG.md":
            continue
        texts = [(block.line, block.text) for block in page.blocks] + list(markdown.inline_code(page))
        for line, text in texts:
            for option in re.findall(r"(?<![\w-])--[a-zA-Z][\w-]*", text):
                seen.add(option)
                if option not in known and option not in ELSEWHERE:
                    found.append(f"{page.path}:{line}: no program has {option}")
    return found + [f"ELSEWHERE: no page names {option}" for option in ELSEWHERE if option not in seen], len(seen)


KEY = re.compile(r"(?:(?:Ctrl|Shift|Alt)\+)*(?:[A-Z]|\d|F\d{1,2}|[\[\].]|Space|Enter|Esc|Del|Home|Tab|Left|Right|Numpad \S+)", re.I)


def key_problems(root, pages):
    """Bold keys must stand in the table of keys."""
    table = (root / "docs/keys.md").read_text()
    keys = {key.strip().lower() for row in re.findall(r"^\| [^|]* \| ([^|]*) \|", table, re.M)
            for key in re.split(r", | or ", row.replace("then", ",").replace(" + ", "+"))}
    found, seen = [], set()
    for page in pages:
        for line, text in page.text:
            for bold in re.findall(r"\*\*([^*]+)\*\*", re.sub(r"`[^`]*`", "", text)):
                if not KEY.fullmatch(bold) or str(page.path).startswith("docs/examples/"):
                    continue
                seen.add(bold)
                if bold.lower() not in keys and bold not in KEYS_ELSEWHERE:
                    found.append(f"{page.path}:{line}: docs/keys.md has no key {bold}")
    return found + [f"KEYS_ELSEWHERE: no page names {key}" for key in KEYS_ELSEWHERE if key not in seen], len(seen)


IDENTIFIER = re.compile(r"\b(?:[A-Z][a-z]+[A-Z]\w+|[a-z]+[A-Z]\w*|[A-Z]+_[A-Z_]+|[a-z]+_[a-z_]+)\b")
SOURCES = (".cpp", ".hpp", ".h", ".c", ".cmake", ".txt", ".py", ".cs", ".glsl", ".vert", ".frag", ".comp")
# Words that look like names of the code and aren't, with what they are.
NO_NAMES = {
    "snake_case": "a way to write names", "PascalCase": "a way to write names", "camelCase": "a way to write names",
    "kName": "a way to write names", "minX": "a number in a file", "minY": "a number in a file", "minZ": "a number in a file",
    "maxX": "a number in a file", "maxY": "a number in a file", "maxZ": "a number in a file",
    "minimize_crash": "an option of libFuzzer", "exact_artifact_path": "an option of libFuzzer",
}
# Names that build scripts put together: programs and tests.
MADE_NAMES = re.compile(r"(?:cli|faults|fuzz)_\w+|\w+_fuzz")


def words_of(root):
    """Every word of the sources, without this script's own."""
    names = [name for name in markdown.tracked(root) if name.endswith(SOURCES) and name != "tests/docs/names_test.py"]
    stems = [pathlib.PurePosixPath(name).stem for name in markdown.tracked(root)]
    return set(re.findall(r"\w+", " ".join((root / name).read_text(errors="replace") for name in names))) | set(stems)


def identifier_problems(pages, words):
    """Names of types, functions and constants in backticks stand somewhere in the sources."""
    found, seen = [], set()
    for page in pages:
        if str(page.path) == "CHANGELOG.md":
            continue
        for line, code in markdown.inline_code(page):
            part = "*" in code  # a filter of tests: a part of a name
            for name in IDENTIFIER.findall(re.sub(r"--[\w-]+|-D", "", code)):
                seen.add(name)
                if name not in NO_NAMES and name not in words and not MADE_NAMES.fullmatch(name) and not (part and any(name in word for word in words)):
                    found.append(f"{page.path}:{line}: nothing in the sources is called {name}")
    return found + [f"NO_NAMES: no page says {name}" for name in NO_NAMES if name not in seen], len(seen)


PATH = re.compile(r"(?:\.\.?/)*[\w*][\w.*-]*(?:/[\w.*{},-]+)*/?")
SUFFIX = re.compile(r"\.(md|cpp|hpp|c|h|py|sh|json|png|glb|txt|glsl|vert|frag|comp|cmake|in|svg|hlsl|gltf|gd|cs)$")


def looks_like_path(code, tops):
    return bool(PATH.fullmatch(code)) and (SUFFIX.search(code) is not None or code.split("/")[0] in tops and "/" in code)


def path_problems(pages, files):
    folders = {parent.as_posix() for file in files for parent in pathlib.PurePosixPath(file).parents}
    tops = {folder for folder in folders if "/" not in folder and folder != "."}
    everything = files | folders
    found, count, used = [], 0, set()
    for page in pages:
        if str(page.path) == "CHANGELOG.md":
            continue
        codes = list(markdown.inline_code(page))
        near = [str(page.path.parent)] + [posixpath.dirname(code) for _, code in codes if "/" in code] + [
            posixpath.normpath(posixpath.join(str(page.path.parent), posixpath.dirname(link))) for _, _, link in markdown.links(page)]
        for line, code in codes:
            if not looks_like_path(code, tops):
                continue
            count += 1
            pattern = re.escape(code.rstrip("/")).replace(r"\*", "[^/]*").replace("NAME", "[^/]+")
            candidates = [pattern] + [re.escape(folder) + "/" + pattern for folder in set(near) if folder not in ("", ".")]
            if any(re.fullmatch(posixpath.normpath(c) if "[" not in c else c, name) for c in candidates for name in everything):
                continue
            made = next((entry for entry in MADE if re.fullmatch(entry, code)), None)
            used.add(made)
            if not made:
                found.append(f"{page.path}:{line}: there is no {code}")
    return found + [f"MADE: no page names {entry}" for entry in MADE if entry not in used], count


def self_check(root, known, files, words):
    """The checks bite: a page with a wrong option, key, path and name has all of them found."""
    page = markdown.Page(pathlib.PurePosixPath("wrong.md"), [(1, "`windloom bake --no-such` **Ctrl+F12** `engine/no/such.cpp` `noSuchName`")], [])
    lists = option_problems([page], known)[0], key_problems(root, [page])[0], path_problems([page], files)[0], identifier_problems([page], words)[0]
    return [f"self check: a wrong {what} is not found" for what, found in zip(("option", "key", "path", "name"), lists)
            if not any(problem.startswith("wrong.md:1") for problem in found)]


def main():
    root = pathlib.Path(sys.argv[1])
    pages = markdown.pages(root)
    known, files = known_options(root, *sys.argv[2:5]), set(markdown.tracked(root))
    options, option_count = option_problems(pages, known)
    keys, key_count = key_problems(root, pages)
    paths, path_count = path_problems(pages, files)
    words = words_of(root)
    identifiers, identifier_count = identifier_problems(pages, words)
    found = self_check(root, known, files, words) + options + keys + paths + identifiers
    for line in found:
        print(line)
    print(f"{option_count} different options, {key_count} different keys, {path_count} paths, "
          f"{identifier_count} different names of the code, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
