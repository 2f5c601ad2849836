"""The Debian packages: made twice with the same bytes, looked at, and installed, used and purged in a fresh system that has nothing
but what their dependencies bring.

usage: package_test.py CPACK BUILD [PICTURE]
PICTURE: keep the editor's picture there. Where no fresh system can be made, that part is skipped and says why.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from clean_system import CleanSystem, Impossible
from installed import run

CPACK, BUILD = sys.argv[1:3]
KEEP_PICTURE = sys.argv[3] if len(sys.argv) > 3 else ""
EPOCH = "1767225600"
HAS_EDITOR = (pathlib.Path(BUILD) / "bin" / "windloom-editor").exists()
# What lintian says of every package that is not made for Debian's archive, and why it stands.
KNOWN = {
    "initial-upload-closes-no-bugs": "there is no bug report in Debian's tracker for it",
    "bogus-mail-host": "who publishes the packages gives an address (WINDLOOM_MAINTAINER)",
    "bogus-mail-host-in-debian-changelog": "the same",
    "pkg-config-unavailable-for-cross-compilation": "the files lie in /usr/lib/pkgconfig, not in a folder of the processor",
}


def make_packages(folder):
    run(CPACK, "--config", f"{BUILD}/CPackConfig.cmake", "-B", folder, env={**os.environ, "SOURCE_DATE_EPOCH": EPOCH})
    return {path.name.split("_")[0]: path for path in pathlib.Path(folder).glob("*.deb")}


def field(package, name):
    return run("dpkg-deb", "-f", package, name).strip()


@unittest.skipUnless(shutil.which("dpkg-shlibdeps") and shutil.which("file"), "dpkg-dev or file is not installed")
class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory(prefix="windloom-packages-")
        cls.folder = pathlib.Path(cls.keep.name)
        cls.packages = make_packages(cls.folder / "first")

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def test_there_are_three(self):
        self.assertEqual(sorted(self.packages), ["libwindloom-runtime-dev", "windloom", "windloom-doc"])
        for name, package in self.packages.items():
            self.assertEqual(field(package, "Package"), name)
            for wanted in ("Maintainer", "Description", "Section", "Version", "Architecture", "Installed-Size"):
                self.assertNotEqual(field(package, wanted), "", f"{name}: {wanted}")
        self.assertEqual(field(self.packages["windloom-doc"], "Architecture"), "all")
        summaries = {field(package, "Description").split("\n")[0] for package in self.packages.values()}
        self.assertEqual(len(summaries), 3, summaries)
        self.assertEqual(field(self.packages["windloom"], "Recommends"), "xdg-utils" if HAS_EDITOR else "")
        self.assertRegex(field(self.packages["windloom"], "Maintainer"), r"^\S.* <\S+@\S+>$")

    def test_same_bytes_twice(self):
        time.sleep(1.1)  # a time in them would show
        again = make_packages(self.folder / "second")
        for name, package in self.packages.items():
            self.assertEqual(package.read_bytes(), again[name].read_bytes(), name)

    def test_every_library_has_its_package(self):
        depends = field(self.packages["windloom"], "Depends")
        for wanted in ("libc6 (>=", "libpng16", "libssl3", "libepoxy0", "libegl1", "libgl1"):
            self.assertIn(wanted, depends)
        if HAS_EDITOR:
            for wanted in ("libglfw3", "fonts-inter", "fonts-fork-awesome"):
                self.assertIn(wanted, depends)
        unpacked = self.folder / "unpacked"
        run("dpkg-deb", "-x", self.packages["windloom"], unpacked)
        for program in (unpacked / "usr/bin").iterdir():
            self.assertNotIn("not found", run("ldd", program))

    def test_nothing_runs_at_installation(self):
        for package in self.packages.values():
            scripts = run("dpkg-deb", "--ctrl-tarfile", package, encoding="latin-1")
            for name in ("preinst", "postinst", "prerm", "postrm"):
                self.assertNotIn(f"./{name}\0", scripts)

    @unittest.skipUnless(shutil.which("lintian"), "lintian is not installed")
    def test_lintian(self):
        said = subprocess.run(["lintian", "--allow-root", "--tag-display-limit", "0", *map(str, self.packages.values())],
                              capture_output=True, text=True)
        print(said.stdout + said.stderr)
        tags = re.findall(r"^[EW]: (\S+?):? (\S+)", said.stdout, re.M)
        self.assertEqual([tag for tag in tags if tag[1] not in KNOWN], [])

    def test_in_a_fresh_system(self):
        start = time.monotonic()
        try:
            system = CleanSystem(self.folder)
        except Impossible as reason:
            self.skipTest(str(reason))
        print(f"fresh system after {time.monotonic() - start:.0f} s")
        for package in self.packages.values():
            shutil.copy(package, system.root / "root")
        apt = "apt-get -qq -o Dpkg::Use-Pty=0 install -y --no-install-recommends "
        # What keeps MIME types, desktop entries and icons on a desktop, and a screen for the editor.
        system.run(f"apt-get -qq update && {apt} shared-mime-info desktop-file-utils xvfb xauth")
        # Its dependencies come, it goes: what is there now is what has to be left in the end.
        install = f"{apt} ./root/windloom_*.deb ./root/windloom-doc_*.deb ./root/libwindloom-runtime-dev_*.deb"
        names = "windloom windloom-doc libwindloom-runtime-dev"
        system.run(f"{install} && dpkg -P {names}")
        before = system.files()
        self.assertEqual([path for path in before if "windloom" in path and not path.startswith("/root/")], [])

        system.run(install)
        print(f"installed after {time.monotonic() - start:.0f} s")
        self.use(system)
        self.assertIn("application/vnd.windloom.project+json", (system.root / "usr/share/mime/types").read_text())
        self.assertIn("windloom.desktop", (system.root / "usr/share/applications/mimeinfo.cache").read_text())
        system.run(f"dpkg -P {names}")
        self.assertNotIn("windloom", (system.root / "usr/share/mime/types").read_text())
        left = system.files() - before
        self.assertEqual([path for path in left if not path.startswith("/root/")], [])
        self.assertEqual(before - system.files(), set())
        print(f"purged after {time.monotonic() - start:.0f} s")

    def use(self, system):
        """As a user of the fresh system would."""
        samples = "/usr/share/windloom/projects"
        system.run(f"windloom validate {samples}/*/*.wind.json")
        system.run("cd /root && windloom new breeze.wind.json --template breeze && windloom info breeze.wind.json")
        system.run("cd /root && windloom bake breeze.wind.json --out wind --format npy,windpack --steps 2 --resolution 16x16")
        system.run(f"cd /root && windloom render {samples}/meadow/meadow.wind.json --time 0.2 --resolution 128x128 --size 320x180 "
                   "--out meadow.png")
        self.assertGreater((system.root / "root/meadow.png").stat().st_size, 10000)
        system.run("bash -c '. /usr/share/bash-completion/completions/windloom && complete -p windloom'")
        if not HAS_EDITOR:
            return
        system.run(f"cd /root && xvfb-run -a -s '-screen 0 1400x900x24' windloom-editor {samples}/canyon/canyon.wind.json "
                   "--size 1280x720 --frames 30 --screenshot editor.png")
        picture = system.root / "root/editor.png"
        self.assertGreater(picture.stat().st_size, 100000)
        if KEEP_PICTURE:
            shutil.copy(picture, KEEP_PICTURE)


unittest.main(argv=sys.argv[:1], verbosity=2)
