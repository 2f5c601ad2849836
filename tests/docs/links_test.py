"""Every link of every page leads somewhere, every page is found from the index, every picture is shown and can be made again.

usage: links_test.py REPOSITORY

Relative links are resolved as on a file system that tells capitals apart; anchors as code hosts make them of headings. Links to
other hosts are only looked at, never fetched.
"""
import pathlib
import posixpath
import re
import sys
import urllib.parse

import markdown

INDEX = "docs/README.md"
# Pictures that no command in a document makes: the script or program that does, from the repository's root.
MADE_BY = {
    r"docs/images/tutorial-[\w-]+\.png": "tests/ui/tutorial.py",
    r"docs/images/solver-[\w-]+\.png": "tests/proof/solver_pictures.cpp",
    r"docs/images/export\.png": "tests/ui/export_test.py",
    r"docs/images/rooms\.svg": "tests/rules/draw_rooms.py",
}
EXTERNAL = re.compile(r"https?://[\w.-]+\.[a-z]{2,}(:\d+)?(/[\w./?%&=#~:+,;@!*'()-]*)?$")


class Tree:
    """The repository's files and pages."""

    def __init__(self, root):
        self.root = root
        self.files = set(markdown.tracked(root))
        self.folders = {parent.as_posix() for file in self.files for parent in pathlib.PurePosixPath(file).parents}
        self.pages = {str(page.path): page for page in markdown.pages(root)}
        self.anchors = {path: markdown.anchors(page) for path, page in self.pages.items()}

    def target(self, page, link):
        """(path from the root, anchor) that a relative link of a page means."""
        path, _, anchor = urllib.parse.unquote(link).partition("#")
        if not path:
            return str(page.path), anchor
        return posixpath.normpath(posixpath.join(str(page.path.parent), path)), anchor


def problem_of(tree, page, link):
    """What is wrong with a link; '' where nothing is."""
    if re.match(r"[a-z][a-z0-9+.-]*:", link, re.I):
        return "" if EXTERNAL.match(link) else "is no address that a browser opens"
    path, anchor = tree.target(page, link)
    if path.startswith("..") or link.startswith("/"):
        return "leaves the repository"
    if path not in tree.files and path not in tree.folders:
        alike = [file for file in tree.files if file.lower() == path.lower()]
        return f"leads nowhere; there is {alike[0]}" if alike else "leads nowhere"
    if anchor:
        page_path = path if path in tree.pages else f"{path}/README.md"
        if anchor not in tree.anchors.get(page_path, []):
            return f"has no such heading in {page_path}"
    return ""


def link_problems(tree):
    found, count = [], {"links": 0, "anchors": 0, "pictures": 0, "addresses": 0}
    for path, page in tree.pages.items():
        for line, picture, link in markdown.links(page):
            outside = re.match(r"[a-z]+:", link) is not None
            count["addresses" if outside else "pictures" if picture else "anchors" if "#" in link else "links"] += 1
            problem = problem_of(tree, page, link)
            if problem:
                found.append(f"{path}:{line}: {link} {problem}")
    return found, count


def index_problems(tree):
    """Every file of docs is linked from the index, or lies in a folder whose README is."""
    linked = {tree.target(tree.pages[INDEX], link)[0] for _, _, link in markdown.links(tree.pages[INDEX]) if ":" not in link}
    found = []
    for file in sorted(tree.files):
        if not file.startswith("docs/") or file == INDEX or file.startswith(("docs/images/", "docs/pictures/")):
            continue
        readme = f"docs/examples/{file.split('/')[2]}/README.md" if file.startswith("docs/examples/") and file.count("/") > 2 else ""
        if file not in linked and readme not in linked and file != "docs/examples/README.md":
            found.append(f"{INDEX} doesn't link {file}")
    readme_links = {tree.target(tree.pages["README.md"], link)[0] for _, _, link in markdown.links(tree.pages["README.md"])}
    return found + [f"README.md doesn't link {page}" for page in (INDEX, "docs/tutorial.md", "CONTRIBUTING.md") if page not in readme_links]


def picture_problems(tree):
    """Every picture of docs/images is shown somewhere, and a command on a page that shows it, or a script, makes it."""
    shown = {}
    for path, page in tree.pages.items():
        for _, picture, link in markdown.links(page):
            if picture and ":" not in link:
                shown.setdefault(tree.target(page, link)[0], set()).add(path)
    commands = {path: "\n".join([block.text for block in page.blocks] + [code for _, code in markdown.inline_code(page)])
                for path, page in tree.pages.items()}
    found, matched = [], set()
    for file in sorted(f for f in tree.files if f.startswith("docs/images/")):
        if file not in shown:
            found.append(f"{file} is shown nowhere")
        script = next((pattern for pattern in MADE_BY if re.fullmatch(pattern, file)), None)
        if script:
            matched.add(script)
            made = re.sub(r"(?:.*/)?([a-z]+)-.*|.*/", r"\1", file)
            if MADE_BY[script] not in tree.files:
                found.append(f"{file} is said to be made by {MADE_BY[script]}, which isn't there")
            elif made not in (tree.root / MADE_BY[script]).read_text():
                found.append(f"{MADE_BY[script]} doesn't speak of {made}")
        elif not any(file in text for text in commands.values()):
            found.append(f"{file}: no command in a document and no script makes it")
    return found + [f"MADE_BY: nothing matches {pattern}" for pattern in MADE_BY if pattern not in matched], len(shown)


def self_check(tree):
    """The checks bite: each of these links must be refused on README.md, and the good ones not."""
    page = tree.pages["README.md"]
    bad = ["docs/Tutorial.md", "docs/nothing.md", "docs/bake.md#no-such-heading", "../outside.md", "/docs/bake.md", "#nowhere",
           "htp:/x", "https://no-dot/"]
    good = ["docs", "docs/bake.md", "docs/bake.md#is-it-right-in-the-game", "#start", "https://www.example.org/a?b=c#d"]
    return [f"self check: not refused: {link}" for link in bad if not problem_of(tree, page, link)] + [
        f"self check: refused: {link}" for link in good if problem_of(tree, page, link)]


def main():
    tree = Tree(pathlib.Path(sys.argv[1]))
    links, count = link_problems(tree)
    pictures, shown = picture_problems(tree)
    found = self_check(tree) + links + index_problems(tree) + pictures
    for line in found:
        print(line)
    print(f"{len(tree.pages)} pages, {count['links']} links, {count['anchors']} with an anchor, {count['pictures']} pictures shown "
          f"({shown} different), {count['addresses']} addresses elsewhere, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
