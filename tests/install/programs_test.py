"""The installed programs, moved to another place, with the sources out of reach: what is there, that it runs, that nothing in it
tells of the machine that built it, and that uninstalling leaves nothing.

usage: programs_test.py CMAKE BUILD UI_TESTS [PICTURE]
PICTURE: keep the editor's picture there.
"""
import os
import pathlib
import posixpath
import shutil
import struct
import subprocess
import sys
import unittest
import zlib

from installed import Installed, cache_value, run, tree

CMAKE, BUILD, UI_TESTS = sys.argv[1:4]
KEEP_PICTURE = sys.argv[4] if len(sys.argv) > 4 else ""
HAS_EDITOR = (pathlib.Path(BUILD) / "bin" / "windloom-editor").exists()
sys.path.insert(0, UI_TESTS)
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "docs"))
import markdown  # noqa: E402  (found only now)
from editor_driver import display, editor  # noqa: E402


def png_pixels(file):
    """Width, height and the distinct bytes of an 8-bit PNG, without another library."""
    data = pathlib.Path(file).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", f"{file} is no PNG"
    width, height = struct.unpack(">II", data[16:24])
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return width, height, len(set(zlib.decompress(packed)))


class Programs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.installed = Installed(CMAKE, BUILD)
        cls.samples = cls.installed.prefix / "share" / "windloom" / "projects"

    @classmethod
    def tearDownClass(cls):
        cls.installed.close()

    def test_the_sources_are_out_of_reach(self):
        if not self.installed.hidden:
            self.skipTest("this user can't mount anything: the programs ran with the sources in reach")
        out = run(*self.installed.command("sh", "-c", f"ls -A '{self.installed.source}' | wc -l"), env=self.installed.environment())
        self.assertEqual(out.strip(), "0")

    def test_files(self):
        prefix = self.installed.prefix
        there = tree(prefix)
        wanted = ["bin/windloom", "share/doc/windloom/README.md", "share/doc/windloom/CHANGELOG.md", "share/doc/windloom/copyright",
                  "share/doc/windloom/docs/tutorial.md", "share/doc/windloom/docs/images/tutorial-tree.png",
                  "share/doc/windloom/docs/examples/leaves/CMakeLists.txt", "share/windloom/shaders/shared/grid_mapping.h",
                  "share/bash-completion/completions/windloom", "share/zsh/site-functions/_windloom", "include/windloom_runtime.h"]
        source = self.installed.source
        wanted += [f"share/windloom/{path.relative_to(source)}" for path in (source / "shaders").rglob("*.vert")]
        if HAS_EDITOR:
            wanted += ["bin/windloom-editor", "share/applications/windloom.desktop", "share/mime/packages/windloom.xml",
                       "share/metainfo/org.windloom.Windloom.metainfo.xml", "share/windloom/icons/windloom-48.png",
                       "share/bash-completion/completions/windloom-editor", "share/zsh/site-functions/_windloom-editor"]
            wanted += [f"share/icons/hicolor/{size}x{size}/apps/windloom.png" for size in (16, 22, 24, 32, 48, 64, 128, 256, 512)]
        for name in wanted:
            self.assertIn(name, there)
        self.assertEqual(sorted(os.listdir(prefix / "bin")), sorted(["windloom", "windloom-editor"] if HAS_EDITOR else ["windloom"]))
        for name in there:
            self.assertFalse(name.endswith((".bak", ".autosave.json", ".o", ".gitignore")) or "__pycache__" in name, name)
            path = prefix / name
            if path.is_symlink():
                self.assertFalse(os.readlink(path).startswith("/"), name)
                self.assertTrue(path.exists(), f"{name} leads nowhere")
            else:
                program = path.is_dir() or name.startswith("bin/")
                self.assertEqual(path.stat().st_mode & 0o777, 0o755 if program else 0o644, name)

    def test_samples_are_those_of_the_repository(self):
        """All that git tracks but the scripts, and nothing that somebody saved there."""
        listed = subprocess.run(["git", "-C", self.installed.source, "ls-files", "projects"], capture_output=True, text=True)
        if listed.returncode != 0 or not listed.stdout:
            self.skipTest("the sources are no repository")
        wanted = [name.removeprefix("projects/") for name in listed.stdout.split("\n") if name and not name.endswith(".py")]
        found = [name for name in tree(self.samples) if (self.samples / name).is_file()]
        self.assertEqual(found, sorted(wanted))
        self.assertIn("meadow/meadow.wind.json", found)

    def test_links_between_installed_pages_hold(self):
        """As a browser resolves them, from the folder that a page is opened in."""
        share = self.installed.prefix / "share"
        found, count = [], 0
        for page in [path for path in share.rglob("*.md") if path.is_file()] + sorted((share / "doc/windloom/projects").glob("*/*.md")):
            for line, _, link in markdown.links(markdown.read_page(share, page.relative_to(share))):
                path = link.partition("#")[0]
                if not path or ":" in path:
                    continue
                count += 1
                if not os.path.exists(posixpath.normpath(posixpath.join(str(page.parent), path))):
                    found.append(f"{page.relative_to(share)}:{line}: {link}")
        self.assertEqual(found, [])
        self.assertGreater(count, 150)

    def test_licenses_of_what_is_compiled_in(self):
        text = (self.installed.prefix / "share/doc/windloom/copyright").read_text()
        for library in ("imgui", "CLI11", "nlohmann/json", "glm", "tinygltf", "highway", "oneTBB", "openvdb", "Imath"):
            self.assertIn(library, text)
        for name in sorted(set(" ".join(line for line in text.split("\n") if line.startswith("License: ")).split())
                           - {"License:", "and"}):
            self.assertRegex(text, rf"(?m)^License: {name}\n ", f"the text of {name}")

    def test_no_path_of_the_building_machine_is_left(self):
        if cache_value(BUILD, "CMAKE_BUILD_TYPE") != "Release":
            self.skipTest("debug information names the sources")
        marks = {str(path).encode() for path in (self.installed.source, self.installed.build)}
        found = []
        for name in tree(self.installed.prefix):
            path = self.installed.prefix / name
            if path.is_file() and not path.is_symlink():
                data = path.read_bytes()
                found += [f"{name}: {mark}" for mark in marks if mark in data]
        self.assertEqual(found, [])

    def test_command_line(self):
        run_there = self.installed.run
        for project in sorted(self.samples.glob("*/*.wind.json")):
            run_there("windloom", "validate", project)
        meadow = self.samples / "meadow" / "meadow.wind.json"
        run_there("windloom", "render", meadow, "--time", "0.1", "--resolution", "64x64", "--size", "96x64", "--density", "2",
                  "--backend", "cpu", "--out", "meadow.png")
        width, height, different = png_pixels(self.installed.home / "meadow.png")
        self.assertEqual((width, height), (96, 64))
        self.assertGreater(different, 30)
        run_there("windloom", "new", "breeze.wind.json", "--template", "breeze")
        run_there("windloom", "bake", "breeze.wind.json", "--out", "wind", "--format", "npy,windpack", "--steps", "2",
                  "--resolution", "16x16", "--backend", "cpu")
        for name in ("manifest.json", "wind.npy", "wind.windpack"):
            self.assertTrue((self.installed.home / "wind" / name).is_file(), name)

    def test_a_link_to_the_program_finds_the_same_files(self):
        folder = self.installed.home / "bin"
        folder.mkdir()
        (folder / "wl").symlink_to(self.installed.prefix / "bin" / "windloom")
        self.installed.run(folder / "wl", "render", self.samples / "meadow" / "meadow.wind.json", "--time", "0", "--resolution",
                           "32x32", "--size", "32x32", "--density", "1", "--backend", "cpu", "--out", "linked.png")
        self.assertTrue((self.installed.home / "linked.png").is_file())

    def test_without_its_files_it_says_where_it_looked(self):
        alone = self.installed.folder / "alone" / "bin"
        alone.mkdir(parents=True)
        shutil.copy(self.installed.prefix / "bin" / "windloom", alone / "windloom")
        said = self.installed.run(alone / "windloom", "render", self.samples / "meadow" / "meadow.wind.json", "--size", "32x32",
                                  "--out", "no.png", status=3)
        self.assertIn("can't find the folder 'shaders'", said)
        self.assertIn(str(alone.parent / "share" / "windloom" / "shaders"), said)
        self.assertNotIn(str(self.installed.source) + "/", said)
        data = self.installed.prefix / "share" / "windloom"
        self.installed.run(alone / "windloom", "render", self.samples / "meadow" / "meadow.wind.json", "--time", "0", "--resolution",
                           "32x32", "--size", "32x32", "--density", "1", "--out", "yes.png", "--backend", "cpu", WINDLOOM_DATA=str(data))

    @unittest.skipUnless(HAS_EDITOR, "a build without the editor")
    def test_editor(self):
        meadow = self.samples / "meadow" / "meadow.wind.json"
        with display("1400x900") as screen:
            env = {"DISPLAY": screen["DISPLAY"], "LIBGL_ALWAYS_SOFTWARE": "1"}
            # Through the command line's verb, which looks for the editor beside itself.
            self.assertIn("windloom-editor", self.installed.run("windloom-editor", "--version", **env))
            self.installed.run("windloom-editor", meadow, "--size", "1280x720", "--frames", "30", "--screenshot", "editor.png", **env)
        picture = self.installed.home / "editor.png"
        width, height, different = png_pixels(picture)
        self.assertEqual((width, height), (1280, 720))
        self.assertGreater(different, 200)
        if KEEP_PICTURE:
            shutil.copy(picture, KEEP_PICTURE)

    @unittest.skipUnless(HAS_EDITOR, "a build without the editor")
    def test_a_sample_is_saved_elsewhere(self):
        sample = self.samples / "canyon" / "canyon.wind.json"
        before = sample.read_bytes()
        folder = self.installed.folder / "window"
        folder.mkdir()
        start = folder / "start"
        words = self.installed.command(self.installed.prefix / "bin" / "windloom-editor")
        start.write_text("#!/bin/sh\nWORK=/ exec " + " ".join("'" + word.replace("'", "'\\''") + "'" for word in words) + ' "$@"\n')
        start.chmod(0o755)
        with display() as screen, editor(str(start), screen, folder, str(sample)) as app:
            app.wait("the sample", lambda: app.fact("title").startswith("canyon.wind.json"))
            self.assertIn("Saving will ask for a place", app.fact("message"))
            app.key("ctrl+s")
            app.wait_fact("dialog", "save as")
            self.assertEqual(app.fact("dialog.text"), "canyon.wind.json is a sample and stays as it is.")
            app.choose_path(folder / "mine.wind.json")
            app.wait("the copy", lambda: app.fact("title").startswith("mine.wind.json"))
        self.installed.run("windloom", "validate", folder / "mine.wind.json")
        self.assertEqual(sample.read_bytes(), before)

    def test_uninstalling_leaves_nothing(self):
        prefix = self.installed.folder / "used" / "prefix"
        (prefix / "share" / "applications").mkdir(parents=True)
        (prefix / "share" / "man").mkdir()
        (prefix / "share" / "applications" / "other.desktop").write_text("[Desktop Entry]\n")
        before = tree(self.installed.folder / "used")
        new = self.installed.folder / "new" / "deep"
        for folder in (prefix, new, prefix):
            run(CMAKE, "--install", BUILD, "--prefix", folder)
        self.assertGreater(len(tree(prefix)), 200)
        (prefix / "share" / "windloom" / "projects" / "meadow" / "mine.wind.json").write_text("{}")
        run(CMAKE, "--build", BUILD, "--target", "uninstall")
        mine = ["share/windloom/projects/meadow/mine.wind.json", "share/windloom/projects/meadow", "share/windloom/projects",
                "share/windloom"]
        self.assertEqual(tree(self.installed.folder / "used"), sorted(before + ["prefix/" + name for name in mine]))
        self.assertFalse((self.installed.folder / "new").exists(), tree(self.installed.folder)[:5])
        self.assertIn("Nothing was installed", run(CMAKE, "--build", BUILD, "--target", "uninstall"))


unittest.main(argv=sys.argv[:1])
