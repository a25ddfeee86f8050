"""Check built sites for dead links and for resources of other hosts."""

from __future__ import annotations

from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# The attributes by which a page loads something by itself.
LOADED = {"script": "src", "img": "src", "iframe": "src", "link": "href", "source": "src", "video": "src"}
# Links of a page to itself for programs, which are no resources.
RELATIONS = {"canonical", "next", "prev"}


class Page(HTMLParser):
    """The links, the loaded resources and the anchors of an HTML page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Collect the addresses and the anchor of an element."""
        values = {name: value or "" for name, value in attrs}
        self.anchors |= {values[name] for name in ("id", "name") if name in values}
        if tag == "a" and "href" in values:
            self.links.append(values["href"])
        if tag in LOADED and LOADED[tag] in values and values.get("rel") not in RELATIONS:
            self.loaded.append(values[LOADED[tag]])


def problems(folder: Path) -> Iterator[str]:
    """Yield a sentence for each dead link and each resource of another host."""
    folder = folder.resolve()
    pages = {path: Page(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        name = path.relative_to(folder).as_posix()
        for address in page.loaded:
            url = urlsplit(address)
            if url.scheme not in ("", "data") or url.netloc:
                yield f"{name} loads {address}"
        if name == "404.html":  # a file server shows it for any address, so its links have no base
            continue
        for address in (*page.links, *page.loaded):
            url = urlsplit(address)
            if url.scheme or url.netloc:
                continue
            target = (path.parent / unquote(url.path)).resolve() if url.path else path
            if target.is_dir():
                target /= "index.html"
            if not target.exists():
                yield f"{name} links to {address}, which does not exist"
            elif url.fragment and target in pages and not _has(pages[target], url.fragment):
                yield f"{name} links to {address}, which has no such place"


def _has(page: Page, fragment: str) -> bool:
    return fragment.startswith(("v1.", "__")) or unquote(fragment) in page.anchors
