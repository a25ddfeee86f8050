"""The one writer of files: each is written whole or not at all, and by one program at a time where that matters."""

from __future__ import annotations

import os
import stat
from time import monotonic, sleep

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import IO

# Who reads and writes what is nobody else's business.
PRIVATE = 0o600


def replacing(path: str, *, only_copy: bool = False, private: bool = False) -> Replacement:
    """A new content for a file, to be written in a `with`: aside, and renamed at its end.

    Whatever goes wrong, the old file stays and no half of a new one does. However many write at the same time, the file
    is that of the last one. A link is followed, the permissions of the old file stay, and a device or a pipe is written
    to directly. `only_copy` waits until the disk has it, for what nobody could make again; `private` keeps others out.
    Raises OSError with the name of the file.
    """
    return Replacement(path, only_copy, PRIVATE if private else 0o666)


def scratch() -> IO[bytes]:
    """A file without a name for what is too much for memory; it is gone when it is closed, or the process ends."""
    from tempfile import TemporaryFile

    return TemporaryFile(prefix="motionlang-")


class Replacement:
    """What `replacing` answers; its own context manager, because contextlib costs more to import than a short run."""

    __slots__ = ("_aside", "_file", "_mode", "_only_copy", "_path", "_target")

    def __init__(self, path: str, only_copy: bool, mode: int) -> None:
        self._path, self._only_copy, self._mode = path, only_copy, mode
        self._file: IO[bytes] | None = None
        self._aside = self._target = ""

    def __enter__(self) -> IO[bytes]:
        try:
            if _is_plain(self._path):
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
        """The error with the name that somebody knows: nobody has asked for the file aside."""
        if error.filename in (None, self._aside):
            error.filename, error.filename2 = self._path, None
        return error


def _aside(target: str, mode: int) -> tuple[IO[bytes], str]:
    """A new file beside another one, which nobody else writes to: not even a process of the same number elsewhere.

    It is never one that is there already, so that a link put in its way is not followed.
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


# Seconds between two looks at a file that another program holds.
_MOMENT = 0.02


class InUse(Exception):
    """Another program holds the file."""


class Lock:
    """A file held against others from its reading to its writing; the system lets go of it when the process dies."""

    __slots__ = ("_file", "_path")

    def __init__(self, path: str, patience: float = 0.0) -> None:
        """Hold the file, `patience` seconds from now at the latest.

        InUse where somebody holds it all that time, OSError where nothing can be written beside it.
        """
        folder, name = os.path.split(os.path.realpath(path))
        self._path = os.path.join(folder, f".{name}.lock")
        until = monotonic() + patience
        while True:
            flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0)
            self._file = os.open(self._path, flags, PRIVATE)
            try:
                _hold(self._file)
                # Who held it before may have taken the file away between our opening and our holding it.
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
        """Let go of the file; the second time is nothing."""
        if self._file < 0:
            return
        if os.name == "posix":
            _remove(self._path)  # while it is held: nobody else can have it
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
    """Why `path` cannot be written, as far as can be told beforehand; None when nothing speaks against it."""
    folder = os.path.dirname(os.path.realpath(path))
    if os.path.isdir(path):
        return f"{path} is a folder"
    if not os.path.isdir(folder):
        return f"there is no folder {os.path.dirname(path) or folder}"
    if not os.access(path if os.path.exists(path) and not _is_plain(path) else folder, os.W_OK):
        return f"{path} cannot be written: permission denied"
    return None


def same_file(one: str, other: str) -> bool:
    """Whether two paths lead to one file, by whatever links."""
    try:
        return os.path.samefile(one, other)
    except OSError:
        return os.path.realpath(one) == os.path.realpath(other)


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


def appending(path: str, *, new: bool) -> IO[bytes]:
    """A file that grows line by line while long work goes on, each line on the disk's side of this process at once.

    `new`: without what is in it. For what is read again after the work was cut off; OSError names the file.
    """
    return open(path, "wb" if new else "ab", buffering=0)
