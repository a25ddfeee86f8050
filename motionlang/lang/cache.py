"""Compiled programs, kept between runs as Python keeps its .pyc files.

An entry is a file of the user's cache folder, named after the digest of everything that went into it (text, dialect,
settings, the compiler, the version of Python). It is used only if its own digest fits: a damaged or foreign entry is
ignored, never executed.
"""

from __future__ import annotations

import os
import sys

from motionlang import user_cache

try:  # hashlib's front costs more to import than a whole cached run
    from _sha2 import sha256  # type: ignore[import-not-found,unused-ignore]
except ImportError:
    try:
        from _sha256 import sha256  # type: ignore[import-not-found,unused-ignore]
    except ImportError:
        from hashlib import sha256

# What compiling takes besides a language's own package; a test holds it to what a compilation imports.
SHARED = ("lang", "errors.py", "source.py", "controller/faults.py")
# What of that package no compilation takes: the operations of keywords, and what looks programs over.
RUN, ASIDE = "_operations.py", ("__pycache__", "lint")


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
    file = user_cache.opened(name)
    if file is None:
        return None
    try:
        with open(file, "rb") as entry:
            data: bytes = entry.read()
    except OSError:
        return None
    digest, payload = data[:32], data[32:]
    return payload if sha256(name.encode() + payload).digest() == digest else None


def put(name: str, payload: bytes) -> None:
    """Keep a payload; no reader sees half of it."""
    user_cache.write(name, (sha256(name.encode() + payload).digest(), payload))
