"""Crash reports: the circumstances of an internal error, stored in a folder.

The folder is named in the message. This is the last guard of the command line: no error ends in a traceback,
and none loses a computed result.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Sequence

from motionlang.kernel import MAX_BYTES, STDIN, Diagnostic, Source, dialect_of, machine_of
from motionlang.kernel.files import replacing
from motionlang.kernel.tools import missing
from motionlang.kernel.version import __version__

# The exit status after an internal error, as in sysexits, and without a library that the package depends on.
CRASHED = 70
UNAVAILABLE = 69
MACHINE = ".toml"
REPORT = "crash.txt"
# The maximum of existing crash folders next to a new one.
MAX_FOLDERS = 1000


def crash(error: BaseException, arguments: Sequence[str], source: Source | None = None) -> Diagnostic:
    """Store the circumstances of an unexpected error and return its message.

    `source` is a program that has no file. An error caused by a missing library gets a message of its own, with
    the code "extra", and nothing is stored.
    """
    import traceback  # as slow as a fifth of `--version`, which never crashes here

    lacking = missing(error, "this run")
    if lacking is not None:
        return Diagnostic("extra", lacking.message, hint=lacking.hint)
    what = "".join(traceback.format_exception_only(error)).strip().split("\n", 1)[0]
    try:
        folder = _bundle(error, arguments, source)
    except OSError as problem:
        hint = f"the crash report could not be written: {problem.strerror or problem}"
    else:
        hint = f"the program, the machine file, the options and the traceback are in {folder}"
    return Diagnostic("crash", f"internal error: {what}", hint=hint)


def _bundle(error: BaseException, arguments: Sequence[str], source: Source | None) -> str:
    import traceback
    from platform import platform

    folder = _folder()
    lines = [
        f"motionlang {__version__}, Python {sys.version.split()[0]}, {platform()}",
        f"options: {' '.join(arguments)}",
        "",
        *traceback.format_exception(error),
    ]
    _write(folder, REPORT, "\n".join(lines).encode("utf-8", "backslashreplace"))
    if source is not None:
        _write(folder, os.path.basename(source.name).strip("<>") or "program", source.text.encode())
    for path in _inputs(arguments):
        if os.path.isfile(path) and os.path.getsize(path) <= MAX_BYTES:
            with open(path, "rb") as file:
                _write(folder, os.path.basename(path), file.read())
    return folder


def _folder() -> str:
    """Create a folder that no other user may read, and return its path."""
    from tempfile import gettempdir

    for number in range(MAX_FOLDERS):
        path = os.path.join(gettempdir(), f"motionlang-crash-{os.getpid()}-{number}")
        try:
            os.mkdir(path, 0o700)
        except FileExistsError:
            continue
        return path
    raise FileExistsError(17, "too many crash folders")


def _inputs(arguments: Sequence[str]) -> Iterable[str]:
    """Yield the programs and machine files of a command line.

    They include the machine files next to the programs.
    """
    for word in arguments:
        path = word.partition("=")[2] if word.startswith("--") else word
        if path == STDIN:
            continue
        if dialect_of(path) is not None:
            yield path
            machine = machine_of(path)
            if machine is not None:
                yield machine
        elif path.endswith(MACHINE):
            yield path


def _write(folder: str, name: str, data: bytes) -> None:
    with replacing(os.path.join(folder, name), private=True) as file:
        file.write(data)
