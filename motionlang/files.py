"""Writing a file whole or not at all."""

from __future__ import annotations

import os
import stat
from contextlib import contextmanager
from itertools import count
from typing import IO, TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator


@contextmanager
def replacing(path: str) -> Iterator[IO[bytes]]:
    """Write aside and rename at the end; whatever goes wrong, the old file stays and no half of a new one does.

    However many write at the same time, the file is that of the last one. A device or a pipe is written to directly.
    Raises OSError with the name of the file.
    """
    aside = ""
    try:
        if not _is_plain(path):
            with open(path, "wb", buffering=0) as file:
                yield file
            return
        target = os.path.realpath(path)
        with _aside(target) as file:
            aside = file.name
            yield file
        if os.path.exists(target):
            os.chmod(aside, stat.S_IMODE(os.stat(target).st_mode))
        os.replace(aside, target)
    except BaseException as error:
        if aside:
            _remove(aside)
        if isinstance(error, OSError) and error.filename in (None, aside):
            error.filename = path
        raise


def _aside(target: str) -> IO[bytes]:
    """A new file beside another one, which nobody else writes to: not even a process of the same number elsewhere."""
    folder, name = os.path.split(target)
    for number in count():
        try:
            return open(os.path.join(folder, f".{name}.{os.getpid()}.{number}"), "xb")
        except FileExistsError:
            continue
        except OSError as error:
            error.filename = None  # nobody has asked for a file of that name
            raise
    raise AssertionError


def unwritable(path: str) -> str | None:
    """Why `path` cannot be written, as far as can be told beforehand; None when nothing speaks against it."""
    folder = os.path.dirname(os.path.realpath(path))
    if os.path.isdir(path):
        return f"{path} is a folder"
    if not os.path.isdir(folder):
        return f"there is no folder {os.path.dirname(path) or folder}"
    if not os.access(path if os.path.exists(path) and not _is_plain(path) else folder, os.W_OK):
        return f"{path} cannot be written: permission denied"
    return None


def reason(error: OSError) -> str:
    """What the system says about an error, in its own words and without Python's number."""
    return (error.strerror or str(error)).lower()


def _is_plain(path: str) -> bool:
    try:
        return stat.S_ISREG(os.stat(path).st_mode)
    except OSError:
        return True


def _remove(path: str) -> None:
    try:
        os.remove(path)
    except OSError:
        pass
