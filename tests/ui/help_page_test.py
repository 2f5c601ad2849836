"""docs/keys.md is what the editor's table of actions says.

usage: help_page_test.py WINDLOOM_EDITOR DOCS_FOLDER
"""
import pathlib
import subprocess
import sys
import tempfile

from editor_driver import display

with tempfile.TemporaryDirectory(prefix="windloom-keys-") as folder, display() as environment:
    page = pathlib.Path(folder) / "keys.md"
    subprocess.run([sys.argv[1], "--keys", str(page)], env=environment, check=True)
    if page.read_text() != (pathlib.Path(sys.argv[2]) / "keys.md").read_text():
        sys.exit("FAILED: docs/keys.md is out of date: run windloom-editor --keys docs/keys.md")
