"""Writer of `index.py` of both languages, which lists the keywords of each file."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path
from textwrap import fill

from motionlang.kernel.lang.keyword import Keyword

PACKAGES = ("motionlang.kernel.mint.keywords", "motionlang.kernel.mccl.keywords")
_HEAD = '''"""The keywords of each file, in lower case.

Written by `python -m tools.derived`; do not edit.
"""

from __future__ import annotations

FILES = {
'''


def index_path(package: str) -> Path:
    """Return the file of an index."""
    return Path(str(import_module(package).__file__)).with_name("index.py")


def written(package: str) -> str:
    """Return the text of an index; raise AssertionError for a duplicate keyword."""
    files = {name: import_module(f"{package}.{name}") for name in import_module(package).ORDER.split()}
    words = [word for file in files.values() for word in _words(_rows(file))]
    twice = {word for word in words if words.count(word) > 1}
    assert not twice, f"defined twice: {', '.join(sorted(twice))}"
    return _HEAD + "".join(_entry(name, _rows(file)) for name, file in files.items()) + "}\n"


def _rows(file: object) -> tuple[Keyword, ...]:
    return (*getattr(file, "ROWS", ()), *getattr(file, "HIDDEN", ()))


def _words(rows: tuple[Keyword, ...]) -> list[str]:
    return [spelling.lower() for row in rows for spelling in (row.name, row.short) if spelling]


def _entry(name: str, rows: tuple[Keyword, ...]) -> str:
    return f'    "{name}": """\n{fill(" ".join(_words(rows)), 110)}\n""",\n'


def files() -> dict[Path, str]:
    return {index_path(package): written(package) for package in PACKAGES}
