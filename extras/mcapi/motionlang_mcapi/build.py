"""Build the C library from its source in the package.

The result is in the user's cache, in a folder named after this source, so that a library of another version of
the package is never used.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

from motionlang.kernel.cache import folder

SOURCE = Path(__file__).parent / "library"
FILES = ("mcapi.c", "mcapi.h", "stubs.h")
_COMMON = ("-std=c99", "-O2", "-shared")


class CannotBuild(Exception):
    """The library cannot be built; `hint` says what to do about it."""

    def __init__(self, message: str, hint: str) -> None:
        self.hint = hint
        super().__init__(message)


@dataclass(eq=False, slots=True)
class BuildTarget:
    """A system for which the library is built.

    `library` is the name of the file, `links` are further names for it. `compilers` are tried in this order.
    """

    name: str
    library: str
    links: tuple[str, ...]
    compilers: tuple[str, ...]
    options: tuple[str, ...]
    libraries: tuple[str, ...]


_TARGETS = (
    BuildTarget(
        "linux",
        "libmcapi-4.4.1.so",
        ("libmcapi.so",),
        ("cc", "gcc", "clang"),
        ("-fPIC", "-fvisibility=hidden", "-Wl,-Bsymbolic", "-Wl,-soname,libmcapi-4.4.1.so"),
        ("-lpthread", "-ldl"),
    ),
    BuildTarget(
        "win64",
        "mcapi64.dll",
        (),
        ("x86_64-w64-mingw32-gcc",),
        ("-static-libgcc", "-Wl,--kill-at"),
        ("-lws2_32",),
    ),
    BuildTarget(
        "win32",
        "mcapi32.dll",
        (),
        ("i686-w64-mingw32-gcc",),
        ("-static-libgcc", "-Wl,--kill-at"),
        ("-lws2_32",),
    ),
)
TARGETS = {each.name: each for each in _TARGETS}


def default_path(target: BuildTarget) -> Path | None:
    """Return the path of the library if no folder is given; None without a home."""
    cache = folder()
    if cache is None:
        return None
    source = sha256(b"\0".join((SOURCE / name).read_bytes() for name in FILES)).hexdigest()[:16]
    return Path(cache) / "mcapi" / source / target.library


def build(target: BuildTarget, out: Path | None = None) -> Path:
    """Compile the library and return its path; raise CannotBuild if that fails."""
    default = default_path(target)
    if out is None and default is None:
        raise CannotBuild("there is no home for a cache", "name a folder with --out DIR")
    to = out / target.library if out is not None else default
    assert to is not None
    compiler = _compiler(target)
    try:
        to.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=to.parent) as work:
            made = Path(work) / target.library
            command = [*compiler, *_COMMON, *target.options, "-o", str(made)]
            _run([*command, str(SOURCE / "mcapi.c"), *target.libraries])
            os.replace(made, to)
            for name in target.links:
                link = Path(work) / name
                link.symlink_to(target.library)
                os.replace(link, to.parent / name)
    except OSError as error:
        raise CannotBuild(
            f"{to.parent} cannot be written: {error.strerror or error}", "name a folder with --out DIR"
        ) from None
    return to


def _compiler(target: BuildTarget) -> list[str]:
    """Return the compiler command: CC (on Linux), or the first compiler installed."""
    given = os.environ.get("CC") if target.name == "linux" else None
    if given:
        words = shlex.split(given)
        if words and shutil.which(words[0]):
            return words
        raise CannotBuild(f"the compiler {given!r} of CC is not there", "set CC to a C compiler")
    if target.name == "linux" and sys.platform != "linux":
        raise CannotBuild("this system is not Linux", "choose --target win64 or win32")
    found = next(filter(shutil.which, target.compilers), None)
    if found is None:
        package = "gcc" if target.name == "linux" else "mingw-w64"
        raise CannotBuild(
            f"there is no {' or '.join(target.compilers)}",
            f"install {package}, such as: apt install {package}",
        )
    return [found]


def _run(command: Iterable[str]) -> None:
    words = list(command)
    done = subprocess.run(words, capture_output=True, errors="replace", check=False)
    if done.returncode:
        first = next(iter(done.stderr.splitlines()), f"exit status {done.returncode}")
        raise CannotBuild(f"{words[0]} failed: {first}", "its source is in the package; please report this")
