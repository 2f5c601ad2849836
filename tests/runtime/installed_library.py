"""Installs the library into a folder of its own, moves that, and builds a game with it: by CMake and by pkg-config.

usage: installed_library.py BUILD CMAKE C_COMPILER CXX_COMPILER
"""
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PATIENCE = int(os.environ.get("WINDLOOM_TEST_PATIENCE", 1))
BUILD, CMAKE, CC, CXX = sys.argv[1:5]
SOURCES = pathlib.Path(__file__).parent / "outside" / "game"


def run(*words, **kwargs):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300 * PATIENCE, **kwargs)
    assert done.returncode == 0, f"{words}: {done.stdout}{done.stderr}"
    return done.stdout


def pack():
    """A pack of 2 x 2 cells after docs/windpack.md: vx 0 1 / 2 4, vz -1."""
    head = struct.pack("<8s6I4f2fd2QI2fI", b"WINDPACK", 2, 0x01020304, 0, 2, 2, 1, 0, 0, 2, 2, 10, 5, 0, 16, 0, 0, 2, 0.03, 0)
    assert len(head) == 96
    body = head + struct.pack("<8e", 0, -1, 1, -1, 2, -1, 4, -1)
    return body + struct.pack("<I", zlib.crc32(body))


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.keep = tempfile.TemporaryDirectory(prefix="windloom-install-")
        folder = pathlib.Path(cls.keep.name)
        run(CMAKE, "--install", BUILD, "--component", "runtime", "--prefix", folder / "first")
        # Whatever was written down must still be right elsewhere.
        cls.prefix = (folder / "first").rename(folder / "somewhere else")
        cls.folder = folder
        cls.file = folder / "wind.windpack"
        cls.file.write_bytes(pack())
        library_folder = next(cls.prefix.rglob("libwindloom_runtime.a")).parent
        cls.pkg = {**os.environ, "PKG_CONFIG_PATH": str(library_folder / "pkgconfig")}

    @classmethod
    def tearDownClass(cls):
        cls.keep.cleanup()

    def check(self, program):
        lines = run(program, self.file).splitlines()
        self.assertEqual(lines, ["1.75 -1 1", "follow 1", "live 0"])

    def test_only_the_library_is_installed(self):
        names = sorted(path.name for path in self.prefix.rglob("*") if path.is_file())
        wanted = ["libwindloom_runtime.a", "windloom_runtime-config-version.cmake", "windloom_runtime-config.cmake",
                  "windloom_runtime.h", "windloom_runtime.hpp", "windloom_runtime.pc"]
        for name in wanted:
            self.assertIn(name, names)
        self.assertEqual([n for n in names if "runtime" not in n], [])

    def test_cmake_finds_it(self):
        build = self.folder / "build"
        run(CMAKE, "-S", SOURCES, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_C_COMPILER={CC}",
            f"-DCMAKE_CXX_COMPILER={CXX}", "-DCMAKE_BUILD_TYPE=Release")
        run(CMAKE, "--build", build)
        programs = ["game_c", "game_cpp"]
        if list(self.prefix.rglob("libwindloom_runtime_zstd.a")):
            programs.append("game_zstd")
        for program in programs:
            with self.subTest(program=program):
                self.check(build / program)

    def test_cmake_refuses_another_version(self):
        project = self.folder / "other"
        project.mkdir()
        (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.16)\nproject(other LANGUAGES C)\n"
                                                "find_package(windloom_runtime 99.0 REQUIRED)\n")
        done = subprocess.run([CMAKE, "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}"],
                              capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("99.0", done.stderr)

    def flags(self, library):
        out = run("pkg-config", "--cflags", "--libs", library, env=self.pkg)
        # As a shell would take them apart.
        return run("sh", "-c", f'for word in {out.strip()}; do printf "%s\\n" "$word"; done').splitlines()

    def test_one_line_with_pkg_config_builds_c_and_cpp11(self):
        libraries = ["windloom_runtime"]
        if list(self.prefix.rglob("windloom_runtime_zstd.pc")):
            libraries.append("windloom_runtime_zstd")
        for library in libraries:
            flags = self.flags(library)
            run(CC, "-std=c11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", SOURCES / "game.c", "-o", self.folder / "c", *flags)
            self.check(self.folder / "c")
            run(CXX, "-std=c++11", "-Wall", "-Wextra", "-Wpedantic", "-Werror", SOURCES / "game.cpp", "-o", self.folder / "cpp",
                *flags)
            self.check(self.folder / "cpp")


unittest.main(argv=sys.argv[:1])
