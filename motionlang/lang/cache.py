"""Compiled programs, kept between runs as Python keeps its .pyc files.

An entry is a file named after the digest of everything that went into it (text, dialect, settings, the compiler, the
version of Python). It is used only if it belongs to this user, nobody else may write it, and its own digest fits: a
damaged or foreign entry is ignored, never executed. No trouble with the cache is ever an error of the run.
"""

from __future__ import annotations

import os
import sys

try:  # hashlib's front costs more to import than a whole cached run
    from _sha2 import sha256  # type: ignore[import-not-found,unused-ignore]
except ImportError:
    try:
        from _sha256 import sha256  # type: ignore[import-not-found,unused-ignore]
    except ImportError:
        from hashlib import sha256

ENTRIES = 512
# What compiling takes besides a language's own package; a test holds it to what a compilation imports.
SHARED = ("lang", "errors.py", "source.py", "controller/faults.py")
# What of that package no compilation takes: the operations of keywords, and what looks programs over.
RUN, ASIDE = "_operations.py", ("__pycache__", "lint")
OFF = "MOTIONLANG_NO_CACHE"


def wanted() -> bool:
    """Whether the environment leaves the cache on."""
    return not os.environ.get(OFF)


def folder() -> str:
    """The user's cache folder for motionlang; `MOTIONLANG_CACHE` names another one."""
    named = os.environ.get("MOTIONLANG_CACHE")
    if named:
        return named
    home = os.path.expanduser("~")
    if sys.platform == "win32":
        root = os.environ.get("LOCALAPPDATA") or os.path.join(home, "AppData", "Local")
    elif sys.platform == "darwin":
        root = os.path.join(home, "Library", "Caches")
    else:
        root = os.environ.get("XDG_CACHE_HOME") or os.path.join(home, ".cache")
    return os.path.join(root, "motionlang")


def key(*parts: str) -> str:
    """The name of an entry: the digest of everything that its content depends on."""
    digest = sha256(sys.version.encode())
    for part in parts:
        digest.update(b"\0")
        digest.update(part.encode("utf-8", "surrogatepass"))
    return str(digest.hexdigest())


def fingerprint(package: str) -> str:
    """The state of a compiler's source files and data, so that a changed one never meets what an older one made.

    `package` is the folder of the language. Empty where there are no such files to look at, as in a zip archive.
    """
    root = os.path.dirname(package)
    found: list[str] = []
    try:
        _note_all(package, found)
        for name in SHARED:
            place = os.path.join(root, name)
            if name.endswith(".py"):
                _note(place, os.stat(place), found)
            else:
                _note_all(place, found)
    except OSError:
        return ""
    return ",".join(sorted(found))


def _note_all(place: str, found: list[str]) -> None:
    with os.scandir(place) as entries:
        for entry in entries:
            name = entry.name
            if name.endswith((".py", ".txt")):
                if not name.endswith(RUN):
                    _note(entry.path, entry.stat(), found)
            elif name not in ASIDE and entry.is_dir():
                _note_all(entry.path, found)


def _note(place: str, status: os.stat_result, found: list[str]) -> None:
    """Note one file: the time of its last change, unlike that of its text, cannot be set by whoever installs it."""
    found.append(f"{place} {status.st_size} {status.st_mtime_ns} {status.st_ctime_ns}")


def get(name: str) -> bytes | None:
    """The payload of an entry, None where there is none that can be trusted."""
    if not wanted():
        return None
    try:
        place = folder()
        if not _private(os.stat(place)):
            return None
        with open(os.path.join(place, name), "rb") as file:
            if not _private(os.fstat(file.fileno())):
                return None
            data: bytes = file.read()
    except OSError:
        return None
    digest, payload = data[:32], data[32:]
    return payload if sha256(name.encode() + payload).digest() == digest else None


def put(name: str, payload: bytes) -> None:
    """Keep a payload; no reader sees half of it."""
    if not wanted():
        return
    from motionlang.files import replacing

    place = folder()
    try:
        os.makedirs(place, 0o700, exist_ok=True)
        if not _private(os.stat(place)):
            return
        with replacing(os.path.join(place, name), private=True) as file:
            file.write(sha256(name.encode() + payload).digest() + payload)
        _prune(place)
    except OSError:
        pass


def _private(status: os.stat_result) -> bool:
    """Whether a file or folder is this user's own and closed to writers; Windows folders are per user already."""
    if not hasattr(os, "getuid"):
        return True
    return status.st_uid == os.getuid() and not status.st_mode & 0o022


def _prune(place: str) -> None:
    """Drop the oldest half once there are too many."""
    entries = [entry for entry in os.scandir(place) if entry.is_file()]
    if len(entries) <= ENTRIES:
        return
    entries.sort(key=lambda entry: entry.stat().st_mtime)
    for entry in entries[: len(entries) - ENTRIES // 2]:
        _remove(entry.path)


def _remove(path: str) -> None:
    try:
        os.remove(path)
    except OSError:
        pass
