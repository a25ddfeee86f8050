"""The rows of a sweep on disk while it runs, so that it can be resumed.

Each is a line of JSON.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator

from motionlang.commands.sweep.job import Result
from motionlang.kernel.files import appending

SCHEMA = "motionlang.sweep/1"


class OtherSweep(Exception):
    """Raised if the file has the rows of another sweep."""


class RowJournal:
    """A file of rows: `add` writes a row at once, `remove` deletes the file."""

    def __init__(self, path: str, digest: str, *, resume: bool) -> None:
        """Create the file, or with `resume` continue it after `read`.

        Raises OSError if it cannot be written.
        """
        self.path = path
        old = resume and os.path.exists(path)
        self._file = appending(path, new=not old)
        if not old:
            self._write({"schema": SCHEMA, "digest": digest})
        else:
            # A truncated line ends here, and is ignored.
            self._file.write(b"\n")

    def add(self, result: Result) -> None:
        self._write(result)

    def close(self) -> None:
        self._file.close()

    def remove(self) -> None:
        """Close the file and delete it."""
        self.close()
        os.remove(self.path)

    def _write(self, value: object) -> None:
        self._file.write(json.dumps(value).encode("ascii") + b"\n")


def read(path: str, digest: str) -> Iterator[Result]:
    """Yield the rows of an earlier sweep; none if there is no file.

    Raises OtherSweep if the file belongs to another sweep.
    """
    try:
        file = open(path, "rb")  # noqa: SIM115 - closed below
    except FileNotFoundError:
        return
    with file:
        head = _line(file.readline())
        if not isinstance(head, dict) or head.get("schema") != SCHEMA or head.get("digest") != digest:
            raise OtherSweep(path)
        for line in file:
            row = _line(line)
            if (
                isinstance(row, list)
                and len(row) == 3
                and isinstance(row[0], int)
                and isinstance(row[1], list)
            ):
                yield row[0], tuple(row[1]), row[2]


def _line(text: bytes) -> object:
    try:
        found: object = json.loads(text)
    except (ValueError, RecursionError):
        return None
    return found
