"""The bare wheel in users' environments: options, homes, locales, streams.

Each environment is a row of a table, and every row runs the same few real uses.
"""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

import pytest

from motionlang.kernel import cache
from tests.cli.programs import MAX_SECONDS
from tests.installed import PROJECT, STRICT, Install, closure, first_uses, needed

posix = pytest.mark.skipif(os.name == "nt", reason="POSIX descriptors, homes and locales")
pytestmark = [posix, pytest.mark.slow]


@pytest.fixture
def install(wheel: Path, tmp_path: Path) -> Install:
    """Return the wheel with the libraries that it depends on.

    `-X dev` would also check each allocation in C, which the package has none of.
    """
    install = Install(tmp_path, wheel, closure(PROJECT["dependencies"]))
    install.environment |= {"PYTHONMALLOC": "default"}
    return install


# One use of each command that needs no extra.
FIRST_USES = [each for each in first_uses() if not needed()[each]]


def works(install: Install, uses: Sequence[str], *flags: str, **changes: str | None) -> None:
    """Run commands; none may leave an unexpected file."""
    for command, (status, _, err) in install(uses, *flags, **changes).items():
        assert (status, "error" in err) == (0, False), (command, err)
    given, made = {"move.mnt", "recorded.csv"}, {each.name for each in install.folder.iterdir()}
    assert given <= made <= given | {"move.golden.json", "move.csv", "move.html", "rows.csv"}


def test_every_command_with_warnings_as_errors(install: Install) -> None:
    """`python -m tests.lowest` also runs them without assertions and docstrings (-OO)."""
    works(install, FIRST_USES, *STRICT)


def test_every_command_without_a_home(install: Install, tmp_path: Path) -> None:
    """The cache folder is named, so that the test does not use that of the user."""
    works(install, FIRST_USES, **without_a_home(tmp_path))


def without_a_home(caches: Path) -> dict[str, str | None]:
    return {
        "HOME": None,
        "MOTIONLANG_CACHE": None,
        "XDG_CACHE_HOME": str(caches),
        "XDG_STATE_HOME": str(caches),
    }


HOMES = ("read-only", "a file", "relative")


@pytest.mark.parametrize("kind", HOMES)
def test_every_command_with_a_home_that_takes_no_file(kind: str, install: Install, tmp_path: Path) -> None:
    """Each command has one of the three, in turn."""
    works(install, FIRST_USES[HOMES.index(kind) :: 3], **home_of(kind, tmp_path))


def home_of(kind: str, tmp_path: Path) -> dict[str, str | None]:
    """Return the environment with a home that takes no file."""
    home = tmp_path / "home"
    if kind == "a file":
        home.touch()
    else:
        home.mkdir(0o555)
    name = "nowhere" if kind == "relative" else str(home)
    return {"HOME": name, "MOTIONLANG_CACHE": None, "XDG_CACHE_HOME": "too", "XDG_STATE_HOME": None}


def test_a_user_without_a_home_has_no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    """An example is a container started with `--user 1234`.

    Python then returns ~ unexpanded, which once created a folder of that name.
    """
    for name in ("MOTIONLANG_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(os.path, "expanduser", lambda path: path)
    assert cache.folder() is None
    monkeypatch.setenv("XDG_CACHE_HOME", "/var/caches")
    monkeypatch.setattr("sys.platform", "linux")
    assert cache.folder() == os.path.join("/var/caches", "motionlang")


# ------------------------------------------------------------------------------------------- streams and locale

# Real uses, and the exit status of each: two that print, one with a file error, one with a command line
# error.
USES = {
    "run move.mnt": 0,
    "plan --distance 10 --time 1 --rule third": 0,
    "run none.mnt": 1,
    "run": 2,
}
PRINTS = {use for use, status in USES.items() if status == 0}
FULL = "motionlang: cannot write the output: no space left on device\n"


def result(
    install: Install,
    use: str,
    closed: str = "",
    *,
    stdout: int = subprocess.PIPE,
    stderr: int = subprocess.PIPE,
) -> tuple[int, str, str]:
    """Return exit status, output and errors of one use, including warnings of Python.

    `closed` lists the streams to close in shell notation, such as ">&-".
    """
    command = [*install.python(*STRICT), "-m", "motionlang", *use.split()]
    ran = subprocess.run(
        ["sh", "-c", f'exec "$@" {closed}', "sh", *command], cwd=install.folder, env=install.environment,
        text=True, encoding="utf-8", check=False, timeout=MAX_SECONDS, stdout=stdout, stderr=stderr,
    )  # fmt: skip
    return ran.returncode, ran.stdout or "", ran.stderr or ""


@contextmanager
def unread() -> Iterator[int]:
    """Yield the writing end of a pipe whose reader has gone."""
    reader, writer = os.pipe()
    os.close(reader)
    yield writer
    os.close(writer)


@contextmanager
def full() -> Iterator[int]:
    """Yield a file on a full disk."""
    disk = os.open("/dev/full", os.O_WRONLY)
    yield disk
    os.close(disk)


needs_full = pytest.mark.skipif(not os.path.exists("/dev/full"), reason="this system has no /dev/full")


@pytest.mark.parametrize("closed", ["<&-", ">&-", "2>&-", "<&- >&- 2>&-"])
def test_streams_that_are_closed(closed: str, install: Install) -> None:
    """The exit status is unchanged, and the other streams are written."""
    for use, status in USES.items():
        got, out, err = result(install, use, closed)
        assert got == status, (use, err)
        assert bool(out) == (use in PRINTS and ">&-" not in closed.split()), use
        assert ("error" in err) == (status > 0 and "2>&-" not in closed), use
        assert "Warning" not in err, use


@pytest.mark.parametrize(
    ("broken", "status", "message"), [(unread, 141, ""), pytest.param(full, 1, FULL, marks=needs_full)]
)
def test_standard_output_that_takes_nothing(
    broken: type, status: int, message: str, install: Install
) -> None:
    for use in PRINTS:
        with broken() as stream:
            assert result(install, use, stdout=stream) == (status, "", message), use


@pytest.mark.parametrize("broken", [unread, pytest.param(full, marks=needs_full)])
def test_standard_error_that_takes_nothing(broken: type, install: Install) -> None:
    """The message is lost, but the exit status is right."""
    for use, status in USES.items():
        with broken() as stream:
            got, out, _ = result(install, use, stderr=stream)
        assert (got, bool(out)) == (status, use in PRINTS), use


def test_the_c_locale(install: Install) -> None:
    """Characters outside ASCII in a file name or a text are printed as escapes."""
    (install.folder / "größe.mnt").write_text('PRINT "5 µm"\n', encoding="utf-8")
    install.environment |= {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    assert result(install, "run größe.mnt --format none") == (0, "5 \\xb5m\n", "")
    works_too = result(install, "run move.mnt")
    assert works_too[0] == 0
    assert works_too[1].isascii()
