"""What the scripts that write colliders' keys share."""
import re


def number(value):
    return f"{round(value, 4) + 0.0:.4f}".rstrip("0").rstrip(".")


def put(text, name, made):
    """The project's text with other keys for the collider of this name."""
    wanted = re.compile(rf'("name": "{name}",[^{{}}]*?"keys": )\[\s*\[.*?\]\s*\]', re.S)
    listed = ", ".join("[" + ", ".join(number(v) for v in key) + "]" for key in made)
    text, found = wanted.subn(lambda match: f"{match.group(1)}[{listed}]", text)
    if found != 1:
        raise SystemExit(f"there is no collider '{name}' with keys")
    return text
