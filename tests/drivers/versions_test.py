"""What the program asks of a driver: OpenGL 4.5 and nothing more. No extension is named in a shader; the few that C++ asks
for are optional; the program runs on a driver that tells of version 4.5 and has none of them; on 4.4, without a usable EGL
device and without a display it says so and ends with 3.

usage: versions_test.py REPOSITORY WINDLOOM [WINDLOOM_EDITOR]
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).parents[1] / "ui"))
from editor_driver import display

# Each with what the program does without it.
OPTIONAL = {
    "GL_EXT_texture_filter_anisotropic": "textures are sampled without it",
    "GL_ARB_pipeline_statistics_query": "bench counts nothing",
}


def fail(message):
    print(f"FAILED: {message}", file=sys.stderr)
    sys.exit(1)


def check_sources(repository):
    named = {}
    for room in ("engine", "editor", "shaders"):
        for file in (repository / room).rglob("*"):
            if not file.is_file():
                continue
            text = file.read_text(errors="replace")
            if room == "shaders" and re.search(r"^\s*#\s*extension", text, re.M):
                fail(f"{file} asks for an extension")
            for name in re.findall(r'has_gl_extension\("(\w+)"\)', text):
                named.setdefault(name, file)
    if set(named) != set(OPTIONAL):
        fail(f"asked for {sorted(named)}, known here {sorted(OPTIONAL)}")


def run(command, **variables):
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1", WINDLOOM_GL_DEBUG="1")
    for name, value in variables.items():
        if value is None:
            environment.pop(name, None)
        else:
            environment[name] = value
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=240)
    return done.returncode, done.stdout + done.stderr


def expect(what, command, status, *words, **variables):
    code, text = run(command, **variables)
    if code != status:
        fail(f"{what}: ended with {code}, not {status}: {text}")
    for word in words:
        if word not in text:
            fail(f"{what}: doesn't say '{word}': {text}")
    if "Sanitizer" in text or "terminate called" in text or "error: OpenGL:" in text:
        fail(f"{what}: {text}")


def main():
    repository, windloom = pathlib.Path(sys.argv[1]), sys.argv[2]
    check_sources(repository)
    project = str(repository / "projects/canyon/canyon.wind.json")
    with tempfile.TemporaryDirectory(prefix="windloom-drivers-") as folder:
        render = [windloom, "render", project, "--out", f"{folder}/a.png", "--size", "96x64", "--time", "0.05", "--backend", "gpu"]
        without = " ".join(f"-{name}" for name in OPTIONAL)
        expect("4.5 without extensions", render, 0, MESA_GL_VERSION_OVERRIDE="4.5", MESA_EXTENSION_OVERRIDE=without)
        if not pathlib.Path(folder, "a.png").exists():
            fail("no picture was drawn on 4.5")
        expect("4.4", render, 3, "OpenGL 4.5", MESA_GL_VERSION_OVERRIDE="4.4")
        expect("no device", render, 3, "OpenGL 4.5", "WINDLOOM_EGL_DEVICE=99", WINDLOOM_EGL_DEVICE="99")
        home = dict(XDG_CONFIG_HOME=f"{folder}/c", XDG_STATE_HOME=f"{folder}/s")
        if len(sys.argv) > 3:
            expect("no display", [sys.argv[3], project], 3, "No display", DISPLAY=None, WAYLAND_DISPLAY=None, **home)
            shot = [sys.argv[3], project, "--screenshot", f"{folder}/b.png", "--frames", "3"]
            with display() as server:
                home.update(DISPLAY=server["DISPLAY"], WAYLAND_DISPLAY=None)
                expect("editor on 4.4", shot, 3, "OpenGL 4.5", "Found", MESA_GL_VERSION_OVERRIDE="4.4", **home)
                expect("editor on 4.5", shot, 0, MESA_GL_VERSION_OVERRIDE="4.5", MESA_EXTENSION_OVERRIDE=without, **home)
    print("4.5 without any extension does; 4.4, no device and no display are told")


if __name__ == "__main__":
    main()
