"""What an installation tells the desktop and the reader: desktop entry, MIME type, icons, AppStream, manual pages; each asked with
the tools that desktops use.

usage: desktop_test.py CMAKE BUILD
"""
import gzip
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import unittest

from installed import Installed, run

CMAKE, BUILD = sys.argv[1:3]
HAS_EDITOR = (pathlib.Path(BUILD) / "bin" / "windloom-editor").exists()
TYPE = "application/vnd.windloom.project+json"


def needs(program):
    return unittest.skipUnless(shutil.which(program), f"{program} is not installed")


def plain(page):
    """A manual page as it is read in a terminal, without bold and line ends."""
    shown = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-l", page], capture_output=True, text=True,
                           env={**os.environ, "MANWIDTH": "400", "MAN_KEEP_FORMATTING": "", "LANG": "C.UTF-8"})
    assert shown.returncode == 0 and shown.stderr == "", f"{page}: {shown.stderr}"
    return re.sub(".\b", "", shown.stdout)


class Desktop(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.installed = Installed(CMAKE, BUILD)
        cls.share = cls.installed.prefix / "share"

    @classmethod
    def tearDownClass(cls):
        cls.installed.close()

    def help_of(self, program, *words):
        return self.installed.run(program, *words, "--help")

    # Manual pages

    def pages(self):
        return sorted((self.share / "man" / "man1").iterdir())

    def verbs(self):
        listed = self.help_of("windloom").split("Subcommands:")[1].split("\n\n")[0]
        return [line.split()[0] for line in listed.strip().splitlines()]

    def test_every_verb_has_a_page(self):
        names = {page.name.split(".")[0] for page in self.pages()}
        wanted = {"windloom", *("windloom-" + verb for verb in self.verbs())} | ({"windloom-editor"} if HAS_EDITOR else set())
        self.assertEqual(names, wanted)
        self.assertGreater(len(wanted), 8)

    @needs("man")
    def test_pages_are_sound_and_name_every_option(self):
        for page in self.pages():
            name = page.name.split(".")[0]
            text = plain(page)
            words = [name] if name in ("windloom", "windloom-editor") else ["windloom", name.split("-", 1)[1]]
            options = re.findall(r"^  +(?:-\w,)?(--[a-z-]+)", self.help_of(*words), re.M)
            self.assertIn("--help", options)
            for option in options:
                self.assertRegex(text, rf"(?<![\w-]){option}(?![\w-])", f"{name}: {option}")
            for section in ("NAME", "SYNOPSIS", "OPTIONS", "EXIT STATUS", "FILES", "SEE ALSO"):
                self.assertIn("\n" + section + "\n", text, name)
            for other in re.findall(r"(windloom[a-z-]*)\(1\)", text):
                self.assertTrue(any(p.name.startswith(other + ".1") for p in self.pages()), f"{name} refers to {other}")

    @needs("man")
    def test_pages_say_what_help_says(self):
        bake = plain(next(p for p in self.pages() if p.name.startswith("windloom-bake.1")))
        self.assertIn("Count in solver steps: write the one field N steps after --from", bake)
        self.assertRegex(bake, r"windpack +half floats|windpack\n? +wind\.windpack: half floats")
        self.assertIn("From 1 to 128. Default: 8.", bake)
        self.assertIn("Not together with --seconds.", bake)
        self.assertIn("Ctrl+C ends a bake without leaving files.", bake)

    @needs("man")
    def test_environment_is_documented(self):
        read = set()
        for folder in ("engine", "editor"):
            for path in (self.installed.source / folder).rglob("*.cpp"):
                read |= set(re.findall(r'getenv\("(WINDLOOM_\w+)"', path.read_text()))
        text = "".join(plain(page) for page in self.pages())
        self.assertIn("WINDLOOM_DATA", read)
        for name in read:
            self.assertIn(name, text)

    @needs("groff")
    def test_groff_has_no_complaint(self):
        for page in self.pages():
            data = gzip.decompress(page.read_bytes()) if page.suffix == ".gz" else page.read_bytes()
            done = subprocess.run(["groff", "-man", "-ww", "-z", "-Kutf8", "-Tutf8"], input=data, capture_output=True)
            self.assertEqual((done.returncode, done.stderr), (0, b""), page.name)

    # The desktop

    @unittest.skipUnless(HAS_EDITOR, "a build without the editor")
    @needs("desktop-file-validate")
    def test_desktop_entry(self):
        entry = self.share / "applications" / "windloom.desktop"
        self.assertEqual(run("desktop-file-validate", entry), "")
        text = entry.read_text()
        self.assertIn("Exec=windloom-editor %f\n", text)
        self.assertIn(f"MimeType={TYPE};\n", text)
        icon = re.search("^Icon=(.+)$", text, re.M).group(1)
        self.assertTrue((self.share / "icons" / "hicolor" / "48x48" / "apps" / f"{icon}.png").is_file())

    @unittest.skipUnless(HAS_EDITOR, "a build without the editor")
    def test_icons(self):
        for file in (self.share / "icons").rglob("*.png"):
            data = file.read_bytes()
            width, height, depth, colours = struct.unpack(">IIBB", data[16:26])
            self.assertEqual(file.parent.parent.name, f"{width}x{height}")
            self.assertEqual((depth, colours), (8, 6), "8 bits with alpha")

    @unittest.skipUnless(HAS_EDITOR, "a build without the editor")
    @needs("appstreamcli")
    def test_appstream(self):
        said = subprocess.run(["appstreamcli", "validate", "--no-net", "--no-color", self.share / "metainfo" / "org.windloom.Windloom.metainfo.xml"],
                              capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stdout + said.stderr)
        self.assertNotRegex(said.stdout, r"(?m)^[EW]:", said.stdout)

    @unittest.skipUnless(HAS_EDITOR, "a build without the editor")
    @needs("update-mime-database")
    @needs("gio")
    @needs("xdg-mime")
    def test_mime_type(self):
        data = self.installed.folder / "data"
        shutil.copytree(self.share / "mime", data / "mime")
        for system in ("freedesktop.org.xml",):
            shutil.copy(f"/usr/share/mime/packages/{system}", data / "mime" / "packages")
        shutil.copytree(self.share / "applications", data / "applications")
        run("update-mime-database", data / "mime")
        if shutil.which("update-desktop-database"):
            run("update-desktop-database", data / "applications")
        home = self.installed.home
        env = {"PATH": f"{self.installed.prefix}/bin:/usr/bin:/bin", "HOME": str(home), "XDG_DATA_HOME": str(home / "data"),
               "XDG_DATA_DIRS": str(data), "XDG_CONFIG_HOME": str(home / "config"), "LANG": "C.UTF-8"}

        def type_of(file):
            return re.search(r"standard::content-type: (\S+)",
                             run("gio", "info", "-a", "standard::content-type", file, env=env)).group(1)

        sample = home / "meadow.wind.json"
        shutil.copy(self.share / "windloom" / "projects" / "meadow" / "meadow.wind.json", sample)
        self.assertEqual(type_of(sample), TYPE)
        self.assertEqual(type_of(shutil.copy(sample, home / "upper.WIND.JSON")), TYPE)
        # By what is in it, where no name helps; and no other JSON file is taken for one.
        self.assertEqual(type_of(shutil.copy(sample, home / "nameless")), TYPE)
        other = home / "other.json"
        other.write_text('{"format": "something-else"}\n')
        self.assertEqual(type_of(other), "application/json")
        self.assertEqual(run("xdg-mime", "query", "default", TYPE, env=env).strip(), "windloom.desktop")
        self.assertIn("windloom.desktop", run("gio", "mime", TYPE, env=env))


unittest.main(argv=sys.argv[:1])
