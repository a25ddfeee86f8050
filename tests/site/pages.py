"""Write the pages of the site: `python -m tests.site.pages`.

It makes `build/pages` of README, which becomes the first page, and of `docs/`. A link is changed to where its
page is on the site; a link to a file that is not on the site becomes plain text. Each runnable Mint and MCCL
block gets a link that opens it in the playground, which is copied from `playground/dist`.
"""

from __future__ import annotations

import json
import os
import posixpath
import re
import shutil
from collections.abc import Callable
from pathlib import Path

from tests.site.fragments import fragment

ROOT = Path(__file__).parents[2]
DIST = ROOT / "playground" / "dist"
PAGES = ROOT / "build" / "pages"
# Pages with another name on the site, and the page of a folder.
MOVED = {
    "README.md": "index.md",
    "CONTRIBUTING.md": "CONTRIBUTING.md",
    "docs/README.md": "contents.md",
    "docs/keywords": "keywords/mint.md",
}
PLAYGROUND = ("playground", "playground/README.md")
_FENCE = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"(!?)\[((?:[^\[\]`]|`[^`]*`)*)\]\(([^()\s]+)\)")
_SCRIPT = re.compile(
    r"^\$ (?:cat|motionlang run) (scripts/(?:mint|mccl)/[\w.-]+\.(?:mnt|mcl))\b", re.MULTILINE
)


def site_path(path: str) -> str | None:
    """Return the path of a project file on the site; None if it is not there."""
    if path in MOVED:
        return MOVED[path]
    folder, _, name = path.partition("docs/")
    is_page = not folder or re.fullmatch(r"extras/\w+/", folder)
    return name if is_page and name and (ROOT / path).is_file() else None


def rewritten(text: str, page: str, run: Callable[[str, str], str]) -> str:
    """Return the text of a page, such as "docs/commands/README.md", for the site.

    `run` returns the playground fragment of a block by its kind and text, or "".
    """
    base = posixpath.dirname(site_path(page) or "")
    chunks, end = [], 0
    for block in _FENCE.finditer(text):
        chunks.append(_with_links(text[end : block.start()], page, base))
        chunks.append(block[0])
        program = run(block[1], block[2])
        if program:
            target = posixpath.relpath("playground/index.html", base or ".")
            chunks.append(
                f'\n\n<p class="run"><a href="{target}?docs#{program}">Run in the playground</a></p>\n'
            )
        end = block.end()
    return "".join([*chunks, _with_links(text[end:], page, base)])


def _with_links(text: str, page: str, base: str) -> str:
    def link(found: re.Match[str]) -> str:
        path, hash_, anchor = found[3].partition("#")
        if not path or "://" in path or path.startswith("mailto:"):
            return found[0]
        full = posixpath.normpath(posixpath.join(posixpath.dirname(page), path))
        if full in PLAYGROUND:
            target = posixpath.relpath("playground/index.html", base or ".")
            return f'<a href="{target}?docs">{found[2]}</a>'
        on_site = site_path(full)
        if on_site is None:
            return found[2]
        return f"{found[1]}[{found[2]}]({posixpath.relpath(on_site, base or '.')}{hash_}{anchor})"

    return _LINK.sub(link, text)


def runnable(gallery: dict[str, dict[str, str]]) -> Callable[[str, str], str]:
    """Return `run` of `rewritten`, given the programs of the gallery by path."""

    def run(kind: str, text: str) -> str:
        if kind in ("mint", "mccl"):
            return fragment(kind, text)
        found = _SCRIPT.search(text) if kind == "console" else None
        program = gallery.get(found[1]) if found else None
        if program is None or program["needs"]:
            return ""
        return fragment(program["dialect"], program["program"], program["name"], program["machine"])

    return run


def main() -> None:
    """Write all pages, and copy the playground, which must have been built."""
    contents = json.loads((DIST / "contents.json").read_text(encoding="utf-8"))
    gallery = {f"scripts/{each['dialect']}/{each['name']}": each for each in contents["gallery"]}
    shutil.rmtree(PAGES, ignore_errors=True)
    for path in sorted([*(ROOT / "docs").rglob("*"), *ROOT.glob("extras/*/docs/**/*"), *ROOT.glob("*.md")]):
        source = path.relative_to(ROOT).as_posix()
        target = site_path(source)
        if target is None or not path.is_file():
            continue
        destination = PAGES / target
        destination.parent.mkdir(parents=True, exist_ok=True)
        if path.suffix == ".md":
            text = rewritten(path.read_text(encoding="utf-8"), source, runnable(gallery))
            destination.write_text(text, encoding="utf-8", newline="\n")
        else:
            shutil.copy(path, destination)
    shutil.copytree(DIST, PAGES / "playground")


def build_name() -> str:
    """Return the version and the commit that each page shows."""
    contents = json.loads((DIST / "contents.json").read_text(encoding="utf-8"))
    return f"motionlang {contents['version']}, commit {contents['commit']}"


if __name__ == "__main__":
    os.chdir(ROOT)
    main()
