"""The sample game builds outside of our tree, as a game would: a copy of its folder, find_package of the installed runtime.

usage: game_alone_test.py CMAKE BUILD_FOLDER GAME_FOLDER
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from editor_driver import check, run


def call(*arguments, status=0):
    done = subprocess.run(list(map(str, arguments)), capture_output=True, text=True)
    check(done.returncode == status, f"{arguments} ended with {done.returncode}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done


def main():
    cmake, build, game = sys.argv[1:4]
    with tempfile.TemporaryDirectory(prefix="windloom-alone-") as name:
        folder = pathlib.Path(name)
        shutil.copytree(game, folder / "leaves")
        call(cmake, "--install", build, "--component", "runtime", "--prefix", folder / "installed")
        call(cmake, "-S", folder / "leaves", "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={folder / 'installed'}",
             "-DCMAKE_CXX_FLAGS=-O0 -Wall -Wextra -Werror", "-DCMAKE_CXX_FLAGS_RELEASE=")
        call(cmake, "--build", folder / "build")
        done = call(folder / "build" / "windloom-leaves", folder / "none.windpack", status=1)
        check("none.windpack" in done.stderr, f"the message must name the file: {done.stderr}")
    print("the sample game builds alone")


run(main)
