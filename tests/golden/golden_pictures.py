"""Renders the samples small and compares them with the pictures beside this script.

Made and compared on Mesa llvmpipe. Two releases of it differ by a rounded colour here and there, and a blade's edge may fall on
the next pixel; so a picture passes if its mean difference is at most MEAN_LIMIT of 255 and at most FAR_SHARE of its pixels
are off by more than FAR of 255. A changed camera, light, blade shape or wind is far above both (self_check shows it).

usage: golden_pictures.py --windloom PROGRAM --projects FOLDER [--renew]
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile

import numpy

MEAN_LIMIT = 2.0
FAR = 40
FAR_SHARE = 0.02
SIZE = (320, 180)
HERE = pathlib.Path(__file__).parent / "pictures"
# name, project, more arguments
PICTURES = [
    ("meadow-hero", "meadow", ["--camera", "hero", "--time", "3"]),
    ("meadow-hill-arrows", "meadow", ["--camera", "hill", "--time", "5", "--overlay", "arrows"]),
    ("colliding-top-speed", "colliding-winds", ["--camera", "top", "--time", "3", "--overlay", "arrows,vectors,speed"]),
    ("canyon-top-streamlines", "canyon", ["--camera", "above", "--time", "3", "--overlay", "vorticity,streamlines"]),
    ("meadow-hill-lic", "meadow", ["--camera", "hill", "--time", "3", "--overlay", "lic,arrows"]),
    ("colliding-above-divergence", "colliding-winds", ["--camera", "above", "--time", "3", "--overlay", "divergence"]),
    ("hills-hero", "hills", ["--camera", "hero", "--time", "3"]),
    ("canyon-hero", "canyon", ["--camera", "hero", "--time", "2"]),
    ("meadow-quadratic", "meadow", ["--camera", "hero", "--time", "3", "--deformation", "quadratic"]),
    ("meadow-inertial", "meadow", ["--camera", "hero", "--time", "3", "--deformation", "inertial"]),
    ("flowers-near", "flowers", ["--camera", "near", "--time", "2"]),
    ("rolling-ball-hero", "rolling-ball", ["--camera", "hero", "--time", "3"]),
    ("footsteps-hero", "footsteps", ["--camera", "hero", "--time", "3"]),
    ("nature-hero", "nature", ["--camera", "hero", "--time", "3"]),
    ("helicopter-hero", "helicopter", ["--camera", "hero", "--time", "3"]),
    ("moebius-hero", "moebius", ["--camera", "hero", "--time", "3"]),
    ("fur-near", "fur", ["--camera", "near", "--time", "3"]),
    ("fur-patches", "fur", ["--camera", "near", "--time", "1", "--grass-view", "patches"]),
    ("moebius-culled", "moebius", ["--camera", "hero", "--time", "1", "--grass-view", "culled"]),
    ("fur-strength", "fur", ["--camera", "hero", "--time", "4", "--grass-view", "strength"]),
    ("prairie-near", "prairie", ["--camera", "near", "--time", "4"]),
    ("prairie-hero", "prairie", ["--camera", "hero", "--time", "7"]),
    ("prairie-air", "prairie", ["--camera", "air", "--time", "7"]),
    ("prairie-grazing", "prairie", ["--camera", "grazing", "--time", "7"]),
    ("knoll-hero", "knoll", ["--camera", "hero", "--time", "4"]),
    ("knoll-near", "knoll", ["--camera", "near", "--time", "4"]),
    ("fur-wireframe", "fur", ["--camera", "near", "--time", "1", "--grass-view", "wireframe"]),
]
# Of forms.wind.json: name, form, part of the blades that are dandelions.
FORMS = [("form-quad", "quad", 0), ("form-triangle", "triangle", 0), ("form-quadratic", "quadratic", 0),
         ("form-triangle-tip", "triangle-tip", 0), ("form-dandelion", "quad", 1)]


def form_projects(folder):
    """A project for each form."""
    text = (pathlib.Path(__file__).parent / "forms.wind.json").read_text()
    made = []
    for name, form, dandelions in FORMS:
        file = pathlib.Path(folder) / f"{name}.wind.json"
        file.write_text(text.replace("FORM", form).replace('"dandelions": 0', f'"dandelions": {dandelions}'))
        made.append((name, file, ["--camera", "near", "--time", "1"]))
    return made


def render(windloom, file, more, out):
    command = [windloom, "render", str(file), "--out", str(out), "--size",
               f"{SIZE[0]}x{SIZE[1]}", "--resolution", "128x128", "--backend", "cpu", *more]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\nexit {done.returncode}\n{done.stderr}")


def pixels(path):
    raw = subprocess.run(["convert", str(path), "-depth", "8", "rgb:-"], check=True, capture_output=True).stdout
    return numpy.frombuffer(raw, numpy.uint8).reshape(SIZE[1], SIZE[0], 3).astype(int)


def problem(made, stored):
    """What is wrong with a picture, or nothing."""
    difference = numpy.abs(made - stored)
    mean = difference.mean()
    share = (difference.max(axis=2) > FAR).mean()
    if mean > MEAN_LIMIT or share > FAR_SHARE:
        return f"mean difference {mean:.2f} (at most {MEAN_LIMIT}), {100 * share:.1f}% far off (at most {100 * FAR_SHARE}%)"
    return None


def self_check(stored):
    """The comparison must tell apart what an eye does: a shifted picture and a darker one."""
    found = []
    if problem(numpy.roll(stored, 3, axis=1), stored) is None:
        found.append("self check: a picture moved by three pixels passes")
    if problem(stored * 95 // 100, stored) is None:
        found.append("self check: a picture darker by 5% passes")
    if problem(stored, stored) is not None:
        found.append("self check: a picture differs from itself")
    return found


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--windloom", required=True)
    parser.add_argument("--projects", required=True, type=pathlib.Path)
    parser.add_argument("--renew", action="store_true")
    options = parser.parse_args()
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        samples = [(name, options.projects / project / f"{project}.wind.json", more) for name, project, more in PICTURES]
        for name, file, more in samples + form_projects(folder):
            target = HERE / f"{name}.png"
            out = target if options.renew else pathlib.Path(folder) / target.name
            render(options.windloom, file, more, out)
            if options.renew:
                continue
            stored = pixels(target)
            failures += [f"{name}: {text}" for text in self_check(stored)]
            made = pixels(out)
            black = (made.max(axis=2) == 0).mean()
            if black > 0.001:
                failures.append(f"{name}: {100 * black:.2f}% of the pixels are black")
            wrong = problem(made, stored)
            print(f"{name}: {wrong or 'as stored'}")
            if wrong:
                failures.append(f"{name}: {wrong}")
    for line in failures:
        print(line)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
