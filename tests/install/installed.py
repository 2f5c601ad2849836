"""An installation to test: installs a build folder's programs, and runs them as on a machine that never saw their sources."""
import os
import pathlib
import subprocess
import tempfile

PATIENCE_S = 300


def run(*words, status=0, **options):
    """What a command writes to standard output; fails where it ends with another status."""
    words = [str(word) for word in words]
    done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE_S, **options)
    assert done.returncode == status, f"{words} ended with {done.returncode}: {done.stdout}{done.stderr}"
    return done.stdout if status == 0 else done.stdout + done.stderr


def tree(folder):
    """Everything below a folder, links not followed."""
    return sorted(str(path.relative_to(folder)) for path in pathlib.Path(folder).rglob("*"))


def cache_value(build, name):
    for line in (pathlib.Path(build) / "CMakeCache.txt").read_text().splitlines():
        if line.startswith(name + ":"):
            return line.split("=", 1)[1]
    return ""


class Installed:
    """Installs BUILD below a temporary folder by way of DESTDIR and moves it: nothing may know where it was put first."""

    def __init__(self, cmake, build):
        self.keep = tempfile.TemporaryDirectory(prefix="windloom-installed-")
        self.folder = pathlib.Path(self.keep.name)
        self.build = pathlib.Path(build)
        self.source = pathlib.Path(cache_value(build, "CMAKE_HOME_DIRECTORY"))
        run(cmake, "--install", build, "--prefix", "/opt/first", env={**os.environ, "DESTDIR": str(self.folder / "stage")})
        self.prefix = (self.folder / "stage" / "opt" / "first").rename(self.folder / "somewhere else")
        self.home = self.folder / "home"
        self.home.mkdir()
        self.hidden = self.can_hide()

    def close(self):
        self.keep.cleanup()

    def can_hide(self):
        """Whether this machine lets us mount an empty folder over the sources: for root, or where users have name spaces."""
        for unshare in (["unshare", "-m"], ["unshare", "-rm"]):
            self.unshare = unshare
            if subprocess.run([*unshare, *self.behind_empty_folders("true")], capture_output=True).returncode == 0:
                return True
        self.unshare = []
        return False

    def behind_empty_folders(self, *command):
        mounts = [f"mount -t tmpfs none '{folder}'" for folder in {self.source, self.build} if folder.is_dir()]
        # The inner of two nested folders is gone by then, which is as good.
        return ["sh", "-c", "cd / && { " + "; ".join(mounts) + "; } 2>/dev/null; "
                f"test ! -e '{self.source}/CMakeLists.txt' && test ! -e '{self.build}/CMakeCache.txt' || exit 97; "
                'cd "$WORK" && exec "$@"', "sh", *command]

    def command(self, *words):
        """The words as a command of a machine without our sources, where this one lets us make it so."""
        words = [str(word) for word in words]
        return [*self.unshare, *self.behind_empty_folders(*words)] if self.hidden else words

    def environment(self, **more):
        kept = {name: os.environ[name] for name in ("DISPLAY", "LIBGL_ALWAYS_SOFTWARE") if name in os.environ}
        return {"PATH": "/usr/bin:/bin:/usr/sbin:/sbin", "HOME": str(self.home), "WORK": str(self.home), "LANG": "C.UTF-8", **kept,
                **more}

    def run(self, program, *arguments, status=0, **more):
        """Runs PREFIX/bin/PROGRAM (or a path) in the home folder, with a clean environment."""
        path = program if "/" in str(program) else self.prefix / "bin" / program
        return run(*self.command(path, *arguments), status=status, env=self.environment(**more), cwd=self.home)
