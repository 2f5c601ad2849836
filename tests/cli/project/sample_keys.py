"""The scripts beside the samples write just the keys that the samples hold.

usage: sample_keys.py PROJECTS
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCRIPTS = [("rolling-ball", "make_path.py"), ("footsteps", "make_steps.py"), ("nature", "make_paths.py"), ("fur", "make_path.py")]


def main():
    projects = pathlib.Path(sys.argv[1])
    problems = []
    with tempfile.TemporaryDirectory() as folder:
        for name, script in SCRIPTS:
            kept = projects / name / f"{name}.wind.json"
            made = pathlib.Path(shutil.copy(kept, folder))
            subprocess.run([sys.executable, str(projects / name / script), str(made)], check=True)
            if made.read_text() != kept.read_text():
                problems.append(f"{script} writes other keys than {kept} holds")
            other = made.read_text().replace('"name": "ball"', '"name": "stone"').replace("left foot", "hand").replace("large ball", "log")
            made.write_text(other)
            refused = subprocess.run([sys.executable, str(projects / name / script), str(made)], capture_output=True)
            if refused.returncode == 0 or made.read_text() != other:
                problems.append(f"{script} takes a project without its collider")
    if problems:
        raise SystemExit("\n".join(problems))


if __name__ == "__main__":
    main()
