"""All writing of files: atomic replacement, and locks where necessary.

It also reads data files of the package.
"""

from __future__ import annotations

import os
import stat
from time import monotonic, sleep
from typing import IO

# The permissions of a private file.
PRIVATE = 0o600


def replacing(path: str, *, only_copy: bool = False, private: bool = False) -> Replacement:
    """Return a context manager that atomically replaces a file; the last writer wins.

    The new content is written to another file, which is renamed at the end. After an error the old file remains. Links
    are followed, and the permissions of the old file are preserved. A device or a pipe is written to directly.
    `only_copy` waits until the content is on the disk, for data that cannot be recreated; `private` excludes other
    users. Raises OSError with the name of the file.
    """
    return Replacement(path, only_copy, PRIVATE if private else 0o666)


def package_text(path: str) -> str:
    """Return the text of a file in the package's folder, or in a zip file, without importing importlib.resources."""
    package = os.path.dirname(os.path.dirname(__file__))
    return __loader__.get_data(os.path.join(package, path)).decode("utf-8")  # type: ignore[name-defined,no-any-return]


class Replacement:
    """The context manager of `replacing`, without the slow import of contextlib."""

    __slots__ = ("_aside", "_file", "_mode", "_only_copy", "_path", "_target")

    def __init__(self, path: str, only_copy: bool, mode: int) -> None:
        self._path, self._only_copy, self._mode = path, only_copy, mode
        self._file: IO[bytes] | None = None
        self._aside = self._target = ""

    def __enter__(self) -> IO[bytes]:
        try:
            if is_plain(self._path):
                self._target = os.path.realpath(self._path)
                self._file, self._aside = _aside(self._target, self._mode)
            else:
                self._file = open(self._path, "wb", buffering=0)
        except OSError as error:
            raise self._named(error) from None
        return self._file

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: object) -> None:
        try:
            assert self._file is not None
            if kind is None and self._only_copy and self._aside:
                self._file.flush()
                os.fsync(self._file.fileno())
            self._file.close()
            if kind is None and self._aside:
                if os.path.exists(self._target):
                    os.chmod(self._aside, stat.S_IMODE(os.stat(self._target).st_mode))
                os.replace(self._aside, self._target)
                self._aside = ""
        except OSError as late:
            if error is None:
                raise self._named(late) from None
        finally:
            if self._aside:
                _remove(self._aside)
        if isinstance(error, OSError):
            self._named(error)

    def _named(self, error: OSError) -> OSError:
        """Return the error with the file name that the caller gave."""
        if error.filename in (None, self._aside):
            error.filename, error.filename2 = self._path, None
        return error


def _aside(target: str, mode: int) -> tuple[IO[bytes], str]:
    """Create a new file next to another one, and return it and its path.

    The creation is exclusive: it fails if the file exists. So the file is not shared with a process on another computer
    that has the same number, and a link planted under its name is not followed.
    """
    folder, name = os.path.split(target)
    number = 0
    while True:
        path = os.path.join(folder, f".{name}.{os.getpid()}.{number}")
        try:
            handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), mode)
        except FileExistsError:
            number += 1
        except OSError as error:
            error.filename = None
            raise
        else:
            return os.fdopen(handle, "wb"), path


# Seconds between two attempts to lock a file that another program holds.
_MOMENT = 0.02


class InUse(Exception):
    """Another program holds the lock."""


class Lock:
    """A lock on a file during its reading and writing, released when the process ends."""

    __slots__ = ("_file", "_path")

    def __init__(self, path: str, patience: float = 0.0) -> None:
        """Lock the file, waiting at most `patience` seconds.

        Raises InUse if another program still holds the lock, OSError if nothing can be written next to the file.
        """
        folder, name = os.path.split(os.path.realpath(path))
        self._path = os.path.join(folder, f".{name}.lock")
        until = monotonic() + patience
        while True:
            flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0)
            self._file = os.open(self._path, flags, PRIVATE)
            try:
                _hold(self._file)
                # The previous holder may have deleted the file between our opening and our locking it.
                if os.path.exists(self._path) and os.path.samestat(os.stat(self._path), os.fstat(self._file)):
                    return
                os.close(self._file)
            except InUse:
                os.close(self._file)
                if monotonic() >= until:
                    raise
                sleep(_MOMENT)
            except BaseException:
                os.close(self._file)
                raise

    def release(self) -> None:
        """Release the lock; a second time is a no-op."""
        if self._file < 0:
            return
        if os.name == "posix":
            _remove(self._path)  # while it is locked: no other program can have it
            os.close(self._file)
        else:
            os.close(self._file)
            _remove(self._path)
        self._file = -1


def _hold(file: int) -> None:
    try:
        if os.name == "posix":
            import fcntl

            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        else:
            import msvcrt

            msvcrt.locking(file, msvcrt.LK_NBLCK, 1)  # type: ignore[attr-defined,unused-ignore]
    except (BlockingIOError, PermissionError):
        raise InUse from None


def unwritable(path: str) -> str | None:
    """Return why `path` cannot be written, if detectable beforehand, or None."""
    folder = os.path.dirname(os.path.realpath(path))
    if os.path.isdir(path):
        return f"{path} is a folder"
    if not os.path.isdir(folder):
        return f"there is no folder {os.path.dirname(path) or folder}"
    if not os.access(path if os.path.exists(path) and not is_plain(path) else folder, os.W_OK):
        return f"{path} cannot be written: permission denied"
    return None


def same_file(one: str, other: str) -> bool:
    """True if two paths lead to the same file, through any links."""
    try:
        return os.path.samefile(one, other)
    except OSError:
        return os.path.realpath(one) == os.path.realpath(other)


def reason(error: OSError) -> str:
    """Return the system's text for an error, without Python's number."""
    return (error.strerror or str(error)).lower()


def is_plain(path: str) -> bool:
    """True if a path is a regular file, or leads to none yet; False for a device or a pipe."""
    try:
        return stat.S_ISREG(os.stat(path).st_mode)
    except OSError:
        return True


def _remove(path: str) -> None:
    try:
        os.remove(path)
    except OSError:
        pass


def appending(path: str, *, new: bool) -> IO[bytes]:
    """Open a file for appending lines during long work; each line is flushed at once.

    With `new` the file is emptied first. It is for data that are read again after an interruption. OSError names the
    file.
    """
    return open(path, "wb" if new else "ab", buffering=0)


def create(path: str, content: bytes) -> None:
    """Write a new file completely, or leave no file.

    Raises FileExistsError if it already exists, OSError with its name for other failures.
    """
    with open(path, "xb") as file:
        try:
            file.write(content)
            file.flush()
        except OSError as error:
            _remove(path)
            error.filename = path
            raise
