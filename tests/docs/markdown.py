"""Reads Markdown as far as these tests need it: headings with their anchors, links, pictures, code.

Places are line numbers from 1. Fenced and indented code is told from text, since what stands in code is neither a link nor a
heading.
"""
import dataclasses
import pathlib
import re
import subprocess


@dataclasses.dataclass
class Block:
    """A block of code: fenced with its language, or indented with the language ''."""
    line: int
    language: str
    text: str


@dataclasses.dataclass
class Page:
    path: pathlib.PurePosixPath  # from the repository's root
    text: list  # (line, text) outside of blocks of code
    blocks: list  # Block


FENCE = re.compile(r"^\s*(```+|~~~+)\s*(\S*)")
LIST_ITEM = re.compile(r"^\s*([*+-]|\d+\.)\s")


def read_page(root, path):
    """The page at `path`, from the repository's root."""
    text, blocks = [], []
    fence = None  # the line that opened the block
    indented = False
    in_list = False
    before = ""
    for number, line in enumerate((root / path).read_text(encoding="utf-8").split("\n"), 1):
        opening = FENCE.match(line)
        if fence:
            if opening and opening.group(1).startswith(fence) and not opening.group(2):
                fence = None
            else:
                blocks[-1].text += line + "\n"
        elif opening:
            fence = opening.group(1)
            blocks.append(Block(number + 1, opening.group(2), ""))
        elif line.startswith("    ") and (indented or (not in_list and (not before.strip() or before.startswith("#")))):
            if not indented:
                blocks.append(Block(number, "", ""))
            blocks[-1].text += line[4:] + "\n"
            indented = True
        else:
            indented = False
            in_list = bool(LIST_ITEM.match(line)) or (in_list and (line.startswith(" ") or not line.strip()))
            text.append((number, line))
        before = line
    return Page(pathlib.PurePosixPath(path), text, blocks)


def tracked(root, *patterns):
    """Files of the repository that match; where there is no git (an unpacked archive), all that lie there."""
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True)
    if listed.returncode == 0 and listed.stdout:
        names = [name for name in listed.stdout.split("\0") if name and (root / name).exists()]
    else:
        names = [p.relative_to(root).as_posix() for p in root.rglob("*")
                 if p.is_file() and p.relative_to(root).parts[0] not in (".git", "build", "out")]
    return sorted(name for name in names if not patterns or any(pathlib.PurePosixPath(name).match(p) for p in patterns))


# What is not for readers of the repository: templates with @NAMES@, filled in by a bake.
TEMPLATES = "engine/bake/sidecars/"


def pages(root):
    """Every page of the repository."""
    return [read_page(root, name) for name in tracked(root, "*.md") if not name.startswith(TEMPLATES)]


def plain(heading):
    """A heading's text without marks: links become their text."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[*`]|(?<!\w)_|_(?!\w)", "", text).strip()


def anchors(page):
    """The anchors of a page's headings, as code hosts make them."""
    found, seen = [], {}
    for _, line in page.text:
        heading = re.match(r"^(#{1,6})\s+(.*?)\s*#*\s*$", line)
        if heading:
            name = re.sub(r"[^\w\- ]", "", plain(heading.group(2)).lower()).replace(" ", "-")
            count = seen.get(name, 0)
            seen[name] = count + 1
            found.append(name if count == 0 else f"{name}-{count}")
    return found


CODE = re.compile(r"(`+)(.+?)\1", re.S)


def paragraphs(page):
    """(line, text) of the text joined to paragraphs, so that what runs over a line's end is whole. Table rows stay lines."""
    start, joined, last = 0, [], 0
    for number, line in page.text + [(0, "")]:
        alone = line.startswith("|") or line.startswith("#")
        if joined and (not line.strip() or alone or LIST_ITEM.match(line) or number != last + 1):
            yield start, "\n".join(joined)
            joined = []
        if alone:
            yield number, line
        elif line.strip():
            start = start if joined else number
            joined.append(line)
        last = number


def inline_code(page):
    """(line, text) of every `code` in the text; ends of lines in it become blanks."""
    for start, text in paragraphs(page):
        for match in CODE.finditer(text):
            yield start + text.count("\n", 0, match.start()), re.sub(r"\s*\n\s*", " ", match.group(2)).strip()


LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")


def links(page):
    """(line, is a picture, target) of every link."""
    for start, text in paragraphs(page):
        bare = CODE.sub(lambda m: re.sub(r"[^\n]", " ", m.group(0)), text)
        # A picture may stand inside a link: look for pictures first, then at what is left.
        for match in LINK.finditer(bare):
            line = start + bare.count("\n", 0, match.start())
            yield line, match.group(1) == "!", match.group(3)
            for inner in LINK.finditer(match.group(2)):
                yield line, inner.group(1) == "!", inner.group(3)
        for match in re.finditer(r"<(?:img|a|source)\b[^>]*?\b(?:src|href|srcset)=\"([^\"]+)\"", bare):
            yield start + bare.count("\n", 0, match.start()), "<img" in match.group(0), match.group(1)
