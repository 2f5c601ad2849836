"""The GPU is reset, or OpenGL has no memory for a texture, while the real editor and the command line work: a message, the work
kept in a side file that the next start offers, exit status 3, and no file that looks like a result. The failures are injected by
a preloaded library (gl_fail.c) that answers for the driver.

usage: loss_test.py GL_FAIL_LIBRARY WINDLOOM WINDLOOM_EDITOR UI_TESTS
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

LIBRARY, WINDLOOM, EDITOR = sys.argv[1:4]
sys.path.insert(0, sys.argv[4])
from editor_driver import check, display, editor, run  # noqa: E402

PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Loss test",
    "field": {"centre": [0, 0], "size": [50, 50], "resolution": [64, 64]},
    "ambient": {"speed": 4}, "grass": {"density": 2}, "solver": {"backend": "gpu"},
    "probes": [{"id": 1, "position": [0, 0]}],
}
PRELOAD = {"LD_PRELOAD": LIBRARY, "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"}


def side_files(folder):
    return list((folder / "state" / "windloom" / "autosave").glob("*.rescue.json"))


def rescued_probes(folder):
    return [len(json.loads(json.loads(file.read_text())["project"])["probes"]) for file in side_files(folder)]


def copies(app, count, steps):
    app.key(*["ctrl+d"] * count)
    app.wait_fact("steps", str(steps))


def lose_memory(app, folder, project):
    """A larger window wants a larger picture, for which there is no memory; the work goes on."""
    (folder / "texture").touch()
    app.xdotool("windowsize", app.window, 1300, 820)
    app.wait("the message", lambda: "can't make the texture" in app.fact("message"))
    app.wait("the side file", lambda: rescued_probes(folder) == [4])
    app.press("outliner/1")
    copies(app, 1, 4)
    app.key("ctrl+s")
    app.wait_fact("dirty", "no")
    check(len(json.loads(project.read_text())["probes"]) == 5, "the work must be saved without memory for textures")
    (folder / "texture").unlink()
    frame = int(app.fact("frame"))
    app.wait("the window to go on", lambda: int(app.fact("frame")) > frame + 5)
    check(app.fact("health.gl errors") == "0", f"OpenGL: {app.fact('health.gl last')}")


def lose_gpu(app, folder):
    copies(app, 2, 6)
    (folder / "reset").touch()
    check(app.wait_end() == 3, "the loss of the GPU must end the editor with 3")
    log = app.log_file.read_text()
    check("OpenGL context is lost" in log and str(side_files(folder)[0]) in log, f"the log must say why and where the work is: {log}")
    check(rescued_probes(folder) == [7], f"the side file must have all the work: {rescued_probes(folder)}")
    (folder / "reset").unlink()


def in_the_window(environment, folder, project):
    broken = dict(environment, GL_FAIL_FOLDER=str(folder), **PRELOAD)
    with editor(EDITOR, broken, folder, str(project), size="1100x700") as app:
        app.wait_fact("scene", "yes")
        app.press("outliner/1")
        copies(app, 3, 3)
        lose_memory(app, folder, project)
        lose_gpu(app, folder)
    with editor(EDITOR, environment, folder, str(project)) as app:
        app.wait_fact("dialog", "rescue")
        app.press("dialog/Restore")
        app.wait_fact("dialog", "")
        app.key("ctrl+s")
        app.wait_fact("dirty", "no")
        check(len(json.loads(project.read_text())["probes"]) == 7, "the next start must bring all the work back")
        app.key("ctrl+q")
        app.wait_end()


def on_the_command_line(folder, project):
    """Neither a picture nor a recording is left by a GPU that is gone or has no memory."""
    environment = dict(os.environ, GL_FAIL_FOLDER=str(folder), LIBGL_ALWAYS_SOFTWARE="1", **PRELOAD)
    out, wind = folder / "picture.png", folder / "wind"
    deeds = {"render": ["--out", str(out), "--size", "96x64", "--time", "0.1"],
             "bake": ["--out", str(wind), "--format", "npy", "--seconds", "0.2", "--fps", "10", "--backend", "gpu"]}
    for failure, words in (("reset", "OpenGL context is lost"), ("texture", "can't make the texture")):
        (folder / failure).touch()
        for verb, options in deeds.items():
            done = subprocess.run([WINDLOOM, verb, str(project), *options], env=environment, capture_output=True, text=True)
            check(done.returncode == 3, f"{verb} with {failure}: ended with {done.returncode}: {done.stdout}{done.stderr}")
            check(words in done.stderr, f"{verb} with {failure}: {done.stderr}")
            check(not out.exists() and not (wind / "manifest.json").exists(), f"{verb} with {failure} left a file")
        (folder / failure).unlink()
    for verb, options in deeds.items():  # and it was not the library itself
        done = subprocess.run([WINDLOOM, verb, str(project), *options], env=environment, capture_output=True, text=True)
        check(done.returncode == 0, f"{verb} without a failure: {done.stderr}")


def main():
    with tempfile.TemporaryDirectory(prefix="windloom-loss-") as name:
        folder = pathlib.Path(name)
        project = folder / "loss.wind.json"
        project.write_text(json.dumps(PROJECT))
        on_the_command_line(folder, project)
        with display() as environment:
            in_the_window(environment, folder, project)
    print("no memory: told, kept, saved; GPU lost: told, kept, offered again; no result of either")


if __name__ == "__main__":
    run(main)
