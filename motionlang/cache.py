"""The compile cache: compiled programs and parsed machine files of earlier runs.

It is in the user's cache folder. An entry is one file, named after its input; for a program this is its text, dialect,
settings and the version of Python. The entry contains the input, and the state of every file of the package that was
loaded to make the result. `get` ignores an entry for another input or changed files, a damaged entry, and an entry that
another user may write. A failure of the cache is never an error of a command. `files.replacing` writes an entry
atomically, and once there are more than `ENTRIES` the older half is removed.
"""

from __future__ import annotations

import os
import sys
from marshal import dumps, loads
from zlib import crc32

# Size, time of the content and time of the last status change of a file.
State = tuple[int, int, int]

OFF = "MOTIONLANG_NO_CACHE"
# How many files the folder may hold.
ENTRIES = 512
# The files that compiling uses in addition to a language's own package; a test compares it with the imports
# of a compilation. The files of keywords import the controller, but only for the keywords' functions in a
# run.
SHARED = (
    "lang" + os.sep,
    "fast" + os.sep,
    "errors.py",
    "record.py",
    "source.py",
    os.path.join("controller", "faults.py"),
)
# The grammars: inside an installed package, or next to it in a checkout.
GRAMMARS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "grammars")
if not os.path.isdir(GRAMMARS):
    GRAMMARS = os.path.join(os.path.dirname(os.path.dirname(GRAMMARS)), "grammars")
# Folders of that package that no compilation uses: linters, and evidence.
ASIDE = ("lint", "evidence")
# Bytes of the checksum at the beginning of an entry.
CHECKSUM = 4


class Entry:
    """The cached result of compiling some inputs with some files of the package."""

    def __init__(self, kind: str, makers: tuple[str, ...], *keys: str) -> None:
        """Store the inputs and the makers.

        `makers` are folders, which end with a separator, and files of the package. The result depends on those that are
        loaded.
        """
        self._makers = makers
        self._whose = (sys.version, *makers, *keys)
        text = "\0".join(self._whose).encode("utf-8", "surrogatepass")
        # Two inputs with one name replace each other's file: `get` compares the complete input.
        self._name = f"{kind}-{crc32(text):08x}-{len(text):x}"
        # The files that made the cached result.
        self._states: dict[str, State] = {}

    def get(self) -> bytes | None:
        """Return the stored payload; None if there is none for the current package files."""
        data = _read(self._name)
        if data is None or checksum(data[CHECKSUM:]) != data[:CHECKSUM]:
            return None
        whose, states, payload = loads(data[CHECKSUM:])
        if whose != self._whose or not _unchanged(states):
            return None
        self._states = dict(states)
        found: bytes = payload
        return found

    def put(self, payload: bytes) -> None:
        """Cache a new result, or an extended one.

        Nothing is cached if the package has no files to compare, as in a zip archive.
        """
        try:
            loaded = _loaded(self._makers)
        except OSError:
            return
        states = {**self._states, **loaded}
        if any(states[path] != state for path, state in self._states.items()):
            return  # the cached result is of other files than the extension
        self._states = states
        data = dumps((self._whose, [*states.items()], payload))
        _write(self._name, checksum(data) + data)


def program_entry(package: str, *keys: str) -> Entry:
    """Return the entry of a program, compiled by the language in the folder `package`."""
    root = os.path.dirname(package) + os.sep
    return Entry("program", (package + os.sep, *(root + name for name in SHARED)), *keys)


def machine_entry(text: str, language: str) -> Entry:
    """Return the entry of a machine file's settings, checked for a language or, with "", for any.

    Any loaded file of the package may have checked them.
    """
    return Entry("machine", (os.path.dirname(__file__) + os.sep,), language, text)


def wanted() -> bool:
    """True unless the environment disables the cache."""
    return not os.environ.get(OFF)


def folder() -> str | None:
    """Return the user's cache folder; None without a home.

    `MOTIONLANG_CACHE` overrides it.
    """
    return os.environ.get("MOTIONLANG_CACHE") or own_folder("Caches", "XDG_CACHE_HOME", ".cache")


def own_folder(on_a_mac: str, variable: str, elsewhere: str) -> str | None:
    """Return the user's motionlang folder of one kind.

    It is in ~/Library, in the folder that the environment `variable` names, or in the home. The result is None if that
    would be relative to the working folder: a user without an entry in the password file and without HOME, as in a
    container, has no home. A relative `variable` is ignored, as the XDG specification requires.
    """
    home = os.path.expanduser("~")
    if sys.platform == "win32":
        root = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
    elif sys.platform == "darwin":
        root = os.path.join(home, "Library", on_a_mac)
    else:
        root = os.environ.get(variable, "")
        if not os.path.isabs(root):
            root = os.path.join(home, elsewhere)
    return os.path.join(root, "motionlang") if os.path.isabs(root) else None


def state(path: str) -> State | None:
    """Return a value that changes when a file is edited; None if there is no file.

    It includes the time of the last status change, which cannot be set: an installer may give all files of all versions
    the same modification time.
    """
    try:
        status = os.stat(path)
    except OSError:
        return None
    return status.st_size, status.st_mtime_ns, status.st_ctime_ns


def checksum(data: bytes) -> bytes:
    """Return the checksum of an entry, to detect damage."""
    return crc32(data).to_bytes(CHECKSUM, "little")


def _unchanged(states: list[tuple[str, State]]) -> bool:
    stat = os.stat  # not `state`: a start compares a hundred files
    try:
        for path, (size, text, change) in states:
            status = stat(path)
            if status.st_ctime_ns != change or status.st_mtime_ns != text or status.st_size != size:
                return False
    except OSError:
        return False
    return True


def _loaded(makers: tuple[str, ...]) -> dict[str, State]:
    """Return the state of the package files that made a result.

    The grammars are among them. Raises OSError if one is missing.
    """
    paths = [
        path
        for module in [*sys.modules.values()]
        if (path := getattr(module, "__file__", None)) is not None and path.startswith(makers)
        if not any(f"{os.sep}{name}{os.sep}" in path for name in ASIDE)
    ]
    for parent, _, files in os.walk(makers[0], onerror=_raise):
        if os.path.basename(parent) not in ASIDE:
            paths += [os.path.join(parent, name) for name in files if name.endswith(".txt")]
    paths += [os.path.join(GRAMMARS, name) for name in os.listdir(GRAMMARS) if name.endswith(".lark")]
    found = {}
    for path in paths:
        now = state(path)
        if now is None:
            raise FileNotFoundError(path)
        found[path] = now
    return found


def _raise(error: OSError) -> None:
    raise error


def _read(name: str) -> bytes | None:
    """Return the content of a cache file; None if there is no trustworthy one."""
    directory = folder() if wanted() else None
    if directory is None:
        return None
    try:
        if not _is_private(os.stat(directory)):
            return None
        with open(os.path.join(directory, name), "rb") as file:
            return file.read() if _is_private(os.fstat(file.fileno())) else None
    except OSError:
        return None


def _write(name: str, data: bytes) -> None:
    """Write a cache file, and remove the oldest ones if there are too many."""
    directory = folder() if wanted() else None
    if directory is None:
        return
    from motionlang.files import replacing

    try:
        os.makedirs(directory, 0o700, exist_ok=True)
        if not _is_private(os.stat(directory)) or not os.access(directory, os.W_OK):
            return
        with replacing(os.path.join(directory, name), private=True) as file:
            file.write(data)
        _remove_oldest(directory)
    except OSError:
        pass


def _remove_oldest(directory: str) -> None:
    files = [file for file in os.scandir(directory) if file.is_file()]
    if len(files) <= ENTRIES:
        return
    files.sort(key=lambda file: file.stat().st_mtime)
    for file in files[: len(files) - ENTRIES // 2]:
        try:
            os.remove(file.path)
        except OSError:
            pass  # another process has removed it


def _is_private(status: os.stat_result) -> bool:
    """True if a file belongs to this user and no other user can write to it.

    Windows folders are per user already.
    """
    if not hasattr(os, "getuid"):
        return True
    return status.st_uid == os.getuid() and not status.st_mode & 0o022


def path_of(name: str) -> str | None:
    """Return the path of a file that a library keeps in the folder; None if the folder is not trustworthy."""
    directory = folder() if wanted() else None
    if directory is None:
        return None
    try:
        os.makedirs(directory, 0o700, exist_ok=True)
        if not _is_private(os.stat(directory)) or not os.access(directory, os.W_OK):
            return None
        path = os.path.join(directory, name)
        return path if not os.path.exists(path) or _is_private(os.stat(path)) else None
    except OSError:
        return None
