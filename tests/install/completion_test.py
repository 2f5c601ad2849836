"""Completion in real shells: bash's function is called as readline calls it, zsh is typed into through a terminal of its own.

usage: completion_test.py WINDLOOM [WINDLOOM_EDITOR]
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

WINDLOOM = sys.argv[1]
EDITOR = sys.argv[2] if len(sys.argv) > 2 else ""

CALL = r"""
source "$1"; shift
function=$1; shift
cd "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
"$function" "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD-1]}"
printf '%s\n' "${COMPREPLY[@]}"
"""

# Types a line and twice the key Tab into a zsh that completes as a user's does, and prints the screen once the words ($4 and
# on) are on it, or after ten seconds.
ZSH = r"""
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "cd '$2'; fpath=('$1' \$fpath); autoload -Uz compinit; compinit -u -D; PS1=; LISTMAX=1000; bindkey '^I' complete-word; setopt no_beep; print -r -- REA''DY"
zpty -r -m shell shown '*READY*'
zpty -w -n shell "$3"$'\t\t'
shown="" ending=$((SECONDS + 10)) found=0
shift 3
while ((SECONDS < ending && ! found)); do
  zpty -r -t shell piece && shown+=$piece || sleep 0.05
  found=1
  for word in "$@"; do [[ $shown == *$word* ]] || found=0; done
done
print -rn -- "$shown"
zpty -d shell
"""


class Completion(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory(prefix="windloom-completion-")
        cls.folder = pathlib.Path(cls.keep.name)
        cls.made = cls.folder / "made"
        cls.made.mkdir()
        subprocess.run([WINDLOOM, "docs", cls.made, "--completion"], check=True, capture_output=True)
        if EDITOR:
            subprocess.run([EDITOR, "--docs", cls.made], check=True, capture_output=True)
        cls.work = cls.folder / "work"
        (cls.work / "my samples").mkdir(parents=True)
        for name in ("meadow.wind.json", "two words.wind.json", "notes.json", "start.npy", "picture.png"):
            (cls.work / name).write_text("")

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def bash(self, *words, script="windloom.bash", function="_windloom"):
        done = subprocess.run(["bash", "--norc", "-c", CALL, "bash", self.made / script, function, self.work, *words],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return done.stdout.split("\n")[:-1] if done.stdout.strip() else []

    def help_of(self, *words):
        return subprocess.run([WINDLOOM, *words, "--help"], capture_output=True, text=True, check=True).stdout

    def test_verbs(self):
        verbs = [line.split()[0] for line in self.help_of().split("Subcommands:")[1].split("\n\n")[0].strip().splitlines()]
        self.assertEqual([word for word in self.bash("windloom", "") if not word.startswith("-")], verbs)
        self.assertEqual(self.bash("windloom", "re"), ["render"])
        self.assertEqual(self.bash("windloom", "--v"), ["--version"])

    def test_every_option_of_every_verb(self):
        for verb in [word for word in self.bash("windloom", "") if not word.startswith("-")]:
            offered = self.bash("windloom", verb, "-")
            options = re.findall(r"^  +(?:-\w,)?(--[a-z-]+)", self.help_of(verb), re.M)
            self.assertEqual(sorted(word for word in offered if word.startswith("--")), sorted(options), verb)

    def test_values(self):
        for words, wanted in [
                (("new", "--template", "ca"), ["canyon-funnel", "calibration"]),
                (("new", "-t", "whirl"), ["whirlwind"]),
                (("bake", "f.wind.json", "--preset", "un"), ["unreal", "unity", "unity-negz"]),
                (("bake", "--format", "wind"), ["windpack", "windpack-f32", "windpack-zstd"]),
                (("bake", "--format", "npy,ex"), ["npy,exr"]),
                (("bake", "--solver", ""), ["default", "cwd-sim"]),
                (("bake", "--space", ""), ["world", "uv"]),
                (("sample", "x", "--backend", ""), ["auto", "gpu", "cpu"]),
                (("render", "--grass", "b"), ["bezier"]),
                (("render", "--deformation", "qu"), ["quadratic"]),
                (("render", "--samples", ""), ["1", "2", "4", "8"]),
                (("render", "--overlay", "arrows,st"), ["arrows,streamlines"]),
                (("bench", "st"), ["startup"]),
                (("bake", "--fps", "1"), [])]:
            self.assertEqual(self.bash("windloom", *words), wanted, words)

    def test_value_behind_an_equals_sign(self):
        # bash breaks words at =
        self.assertEqual(self.bash("windloom", "bake", "--preset", "="), self.bash("windloom", "bake", "--preset", ""))
        self.assertEqual(self.bash("windloom", "bake", "--preset", "=", "go"), ["godot"])

    def test_files(self):
        projects = ["meadow.wind.json", "my samples", "two words.wind.json"]
        self.assertEqual(sorted(self.bash("windloom", "validate", "")), projects)
        self.assertEqual(sorted(self.bash("windloom", "edit", "")), projects)
        self.assertEqual(sorted(self.bash("windloom", "bake", "--initial", "")), ["my samples", "start.npy"])
        self.assertEqual(self.bash("windloom", "bake", "--out", ""), ["my samples"])
        self.assertEqual(sorted(self.bash("windloom", "render", "x.wind.json", "--out", "")), ["my samples", "picture.png"])
        self.assertEqual(self.bash("windloom", "render", "--json", "me"), ["meadow.wind.json"])

    @unittest.skipUnless(EDITOR, "a build without the editor")
    def test_editor(self):
        call = {"script": "windloom-editor.bash", "function": "_windloom_editor"}
        self.assertEqual(self.bash("windloom-editor", "me", **call), ["meadow.wind.json"])
        self.assertEqual(self.bash("windloom-editor", "--sc", **call), ["--scale", "--screenshot"])
        self.assertEqual(sorted(self.bash("windloom-editor", "--screenshot", "", **call)), ["my samples", "picture.png"])
        everything = sorted(path.name for path in self.work.iterdir())
        for option in ("--keys", "--ui-map"):
            self.assertEqual(sorted(set(self.bash("windloom-editor", option, "", **call))), everything)
        self.assertEqual(self.bash("windloom-editor", "--docs", "", **call), ["my samples"])

    @unittest.skipUnless(EDITOR, "a build without the editor")
    def test_the_editors_help_names_what_options_take(self):
        text = subprocess.run([EDITOR, "--help"], capture_output=True, text=True, check=True).stdout
        for option in ("--size WxH", "--scale S", "--select ID[,ID...]", "--screenshot PNG", "--frames N", "--keys FILE", "--ui-map FILE",
                       "--docs DIR"):
            self.assertRegex(text, "(?m)^  " + re.escape(option) + "(:| |$)")
        page = (self.made / "windloom-editor.1").read_text(encoding="utf-8")
        self.assertIn("--size\\fR \\fIWxH\\fR", page.replace("\\-", "-"))

    @unittest.skipUnless(EDITOR, "a build without the editor")
    def test_the_editor_says_what_it_does_not_know(self):
        for words, message in ((("--screenshoot", "a.png"), "no option --screenshoot; did you mean --screenshot?"),
                               (("a.wind.json", "b.wind.json"), "found 'b.wind.json', expected only options there"),
                               (("--screenshot", "a.jpg"), "--screenshot: found 'a.jpg', expected a name that ends in .png"),
                               (("--select", "1,x"), "--select: found 'x', expected a whole number from 0 to 4294967295"),
                               (("--keys",), "--keys: expected FILE after it")):
            done = subprocess.run([EDITOR, *words], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, words)
            self.assertEqual(done.stderr.splitlines()[0], "windloom-editor: " + message)

    # zsh

    def zsh(self, line, wanted):
        done = subprocess.run(["zsh", "-f", "-c", ZSH, "zsh", self.made, self.work, line, *wanted], capture_output=True, text=True,
                              errors="replace", env={**os.environ, "TERM": "dumb", "COLUMNS": "120"}, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        return re.sub("\x1b\\[[0-9;?]*[A-Za-z]|\r|\x07", "", done.stdout)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_takes_the_script(self):
        for script in self.made.glob("_windloom*"):
            subprocess.run(["zsh", "-n", script], check=True)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_completes(self):
        for line, wanted, unwanted in [
                ("windloom ", ["validate", "Checks project files"], ["docs"]),
                ("windloom ren", ["windloom render"], []),
                ("windloom bake --pre", ["--preset"], []),
                ("windloom bake --preset un", ["unreal", "unity-negz"], ["godot"]),
                ("windloom bake --format npy,ktx2-z", ["npy,ktx2-zstd"], []),
                ("windloom new -t whi", ["whirlwind"], []),
                ("windloom validate mea", ["meadow.wind.json"], ["notes"]),
                ("windloom bench start", ["startup"], [])]:
            shown = self.zsh(line, wanted)
            for word in wanted:
                self.assertIn(word, shown, line)
            for word in unwanted:
                self.assertNotIn(word, shown, line)


unittest.main(argv=sys.argv[:1])
