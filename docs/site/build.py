"""Assembles the pages of the website: build.py REPOSITORY FROBC PAGES.

The website keeps the Markdown pages of the repository at the same paths, so that their links
stay valid. Any other file that a page links to, such as a program, becomes a page. The
reference pages, which reference.py generates, go to docs/reference/.
"""

import os
import re
import shutil
import sys
from pathlib import Path

import reference

ROOTS = [
    "README.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "docs",
    "examples",
    "sim/README.md",
    "compiler/README.md",
    "tests/README.md",
]
LANGUAGES = {
    ".frob": "haskell",
    ".c": "c",
    ".h": "c",
    ".cc": "cpp",
    ".cpp": "cpp",
    ".toml": "toml",
    ".hs": "haskell",
    ".csv": "text",
    ".sh": "sh",
}
PICTURES = {".png", ".svg"}
LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s#]+)([^)]*\))")
FENCE = re.compile(r"^(\s*)```frob(-error)?\b.*?( title=\"[^\"]*\")?$")
SESSION = re.compile(r"^(\s*)```console$")


def pages_of(repository):
    """The paths of all Markdown pages, relative to the repository."""
    for root in ROOTS:
        path = repository / root
        found = [path] if path.is_file() else sorted(path.rglob("*.md"))
        for page in found:
            yield page.relative_to(repository)


def source_page(path, text):
    """A page that shows a file."""
    language = LANGUAGES.get(path.suffix, "text")
    return f"# {path.name}\n\n`{path}`\n\n````{language}\n{text}\n````\n"


def folder_page(path, folder):
    """A page that lists the contents of a folder."""
    names = sorted(e.name + ("/" if e.is_dir() else "") for e in folder.iterdir())
    return f"# {path}/\n\n" + "".join(f"- `{name}`\n" for name in names)


class Site:
    def __init__(self, repository, out):
        self.repository, self.out = repository, out
        self.pages = set(pages_of(repository))
        self.made = {}

    def target(self, page, link):
        """Returns the target of a link on the website, as a path relative to the page's folder."""
        whole = os.path.normpath(os.path.join(page.parent, link))
        path = Path(whole)
        there = self.repository / path
        if path in self.pages or path in self.made:
            goal = path
        elif not there.exists():
            sys.exit(f"{page}: the file {link} does not exist")
        elif path.suffix in PICTURES:
            self.copy(path)
            goal = path
        elif there.is_dir() and path / "README.md" in self.pages:
            goal = path / "README.md"
        elif there.is_dir():
            goal = path / "README.md"
            self.made[goal] = folder_page(path, there)
        else:
            goal = path.with_name(path.name + ".md")
            self.made[goal] = source_page(path, there.read_text())
        return os.path.relpath(goal, page.parent or ".")

    def copy(self, path):
        (self.out / path).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(self.repository / path, self.out / path)

    def write(self, path, text):
        (self.out / path).parent.mkdir(parents=True, exist_ok=True)
        (self.out / path).write_text(text)

    def page(self, page, text):
        """Adapts the page's links to the website, and its code fences to the highlighter."""
        lines, code = [], False
        for line in text.splitlines():
            if line.lstrip().startswith("```"):
                line = FENCE.sub(r"\1```haskell\3", line)
                line = SESSION.sub(r"\1```text", line)
                code = not code
            elif not code and not line.startswith("    "):
                line = LINK.sub(lambda m: self.link(page, m), line)
            lines.append(line)
        return "\n".join(lines) + "\n"

    def link(self, page, match):
        before, goal, after = match.groups()
        if re.match(r"[a-z]+:", goal):
            return match.group(0)
        return before + self.target(page, goal) + after


def main():
    repository, frobc, out = Path(sys.argv[1]), sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(out, ignore_errors=True)
    site = Site(repository, out)
    for name, text in reference.pages(repository, frobc).items():
        site.made[Path("docs/reference") / name] = text
    site.write(Path("docs/site/style.css"), Path(__file__).with_name("style.css").read_text())
    for page in sorted(site.pages):
        site.write(page, site.page(page, (repository / page).read_text()))
    for page, text in site.made.items():
        site.write(page, text)


main()
