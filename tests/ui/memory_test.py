"""Memory ends under the editor's window: the process may have hardly more address space than it has. What can't be done is told,
the window goes on, the work stays and can be saved; with memory again, all goes.

usage: memory_test.py WINDLOOM_EDITOR WINDLOOM
"""
import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

from editor_driver import check, display, editor, run

# A bake on so many cells asks for arrays of 60 MB; so much more than it has the editor gets.
CELLS, ROOM = 2000, 40_000_000
PROJECT = {
    "format": "windloom-project", "version": 1, "name": "Large",
    "field": {"centre": [0, 0], "size": [100, 100], "resolution": [CELLS, CELLS]},
    "grass": {"density": 5}, "ambient": {"speed": 3, "direction": 20},
    "graph": {"points": [{"id": 1, "position": [-20, 0]}, {"id": 2, "position": [10, 4]}],
              "arrows": [{"id": 11, "from": 1, "to": 2}]},
}


def address_space(app):
    status = pathlib.Path(f"/proc/{app.process.pid}/status").read_text()
    return int(re.search(r"VmSize:\s+(\d+)", status).group(1)) * 1024


def limit(app, most):
    resource.prlimit(app.process.pid, resource.RLIMIT_AS, (most, resource.RLIM_INFINITY))


def export(app):
    ended = app.fact("export.ended")
    app.press("export/start")
    app.wait("the export to begin or end", lambda: app.fact("export.ended") != ended or "export/progress" in app.read_map()[1])


def check_export_without_memory(app, folder):
    app.key("ctrl+shift+e")
    app.wait("the export's panel", lambda: app.fact("export.running") == "no")
    limit(app, address_space(app) + ROOM)
    ended = app.fact("export.ended")
    export(app)
    app.wait("the export's end", lambda: app.fact("export.ended") != ended)
    check("not enough memory" in app.fact("export.outcome"), f"what was missing must be told: {app.fact('export.outcome')}")
    check(not (folder / "large-wind").exists(), "nothing of it may be left")


def do(app, keys, dirty):
    """Presses the keys until they have done their work: the live wind may just have taken what memory there is."""
    for _ in range(10):
        app.key(*keys)
        app.wait("the work or a message", lambda: app.fact("dirty") == dirty or app.fact("dialog") == "error")
        if app.fact("dialog") == "error":
            check("not enough memory" in app.fact("dialog.text"), f"another message: {app.fact('dialog.text')}")
            app.key("Return")
            app.wait_fact("dialog", "")
        if app.fact("dirty") == dirty:
            return
    check(False, f"{keys} never had the memory")


def check_work_goes_on(app, windloom, project):
    frame = int(app.fact("frame"))
    app.wait("the window to go on", lambda: int(app.fact("frame")) > frame + 10)
    app.point_at(app.centre("viewport"))
    do(app, ["a", "ctrl+d"], "yes")
    do(app, ["ctrl+s"], "no")
    check(len(json.loads(project.read_text())["graph"]["arrows"]) == 2, "the edit must be in the file")
    told = subprocess.run([windloom, "validate", str(project)], capture_output=True, text=True)
    check(told.returncode == 0, told.stdout + told.stderr)


def check_with_memory_again(app):
    limit(app, resource.RLIM_INFINITY)
    export(app)
    app.wait("the recording", lambda: "export/progress" in app.read_map()[1])
    app.press("export/cancel")
    app.wait("its end", lambda: app.fact("export.running") == "no")
    check("cancelled" in app.fact("export.outcome"), app.fact("export.outcome"))


def main():
    program, windloom = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="windloom-memory-") as name, display("1400x900") as environment:
        folder = pathlib.Path(name)
        project = folder / "large.wind.json"
        project.write_text(json.dumps(PROJECT))
        with editor(program, environment, folder, str(project)) as app:
            app.wait_fact("scene", "yes")
            check_export_without_memory(app, folder)
            check_work_goes_on(app, windloom, project)
            check_with_memory_again(app)
            app.key("ctrl+q")
            check(app.wait_end() == 0, "it must end as always")


if __name__ == "__main__":
    run(main)
