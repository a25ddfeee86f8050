"""What differs on Windows and macOS, simulated: locks, signals, time limit, keys, serial devices, console encoding.

`tests/test_cache.py` has the folders of each system, `tests/test_environments.py` the C locale.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from motionlang.cli import main
from motionlang.kernel.files import InUse, Lock
from motionlang.views.single_keys import has_keys

MOVE = 'SPEED(0) = 50\nMOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nPRINT "5 µm"\n'


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(tmp_path)
    Path("a.mnt").write_text(MOVE, encoding="utf-8")
    return "a.mnt"


class Bytes:
    """The locked bytes of Windows: a byte of a file has one holder."""

    LK_NBLCK = 2

    def __init__(self) -> None:
        self.held: set[int] = set()

    def locking(self, file: int, mode: int, count: int) -> None:
        """Lock the first byte, or refuse like Windows."""
        assert (mode, count) == (self.LK_NBLCK, 1)
        inode = os.fstat(file).st_ino
        if inode in self.held:
            raise PermissionError(13, "Permission denied")
        self.held.add(inode)


def test_a_file_has_one_lock_on_windows(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path, windows = str(tmp_path / "nv"), Bytes()
    monkeypatch.setitem(sys.modules, "msvcrt", windows)
    with monkeypatch.context() as simulated:
        simulated.setattr("motionlang.kernel.files.os", SimpleNamespace(**{**vars(os), "name": "nt"}))
        first = Lock(path)
        with pytest.raises(InUse):
            Lock(path)
        first.release()
    assert os.listdir(tmp_path) == []


def test_a_run_without_the_signals_of_posix(
    program: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Windows has no SIGHUP and no interval timers, so `--cpu` is no limit there."""
    monkeypatch.delattr(signal, "SIGHUP", raising=False)
    monkeypatch.delattr(signal, "setitimer", raising=False)
    assert main(["run", program, "-q", "--cpu", "1"]) == 0
    assert capsys.readouterr().out == "5 µm\n"


def test_a_terminal_without_termios_has_no_keys(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", SimpleNamespace(isatty=lambda: True))
    monkeypatch.setitem(sys.modules, "termios", None)
    assert not has_keys()


def test_a_serial_device_on_windows_is_an_error(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in ("pty", "tty", "termios"):
        monkeypatch.setitem(sys.modules, name, None)
    assert main(["serve", "--pty"]) == 1
    assert "error[address]: this system has no pseudo-terminals; use --tcp" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("encoding", "printed"), [("cp1252", b"5 \xb5m"), ("cp437", b"5 \xe6m"), ("ascii", b"5 \\xb5m")]
)
def test_a_console_of_windows_gets_what_it_can_show(encoding: str, printed: bytes, program: str) -> None:
    """Lines of tables are no characters of the first code page, and become escapes."""
    ran = subprocess.run(
        [sys.executable, "-m", "motionlang", "run", program], capture_output=True, check=False,
        env={**os.environ, "PYTHONUTF8": "0", "PYTHONIOENCODING": encoding},
    )  # fmt: skip
    assert (ran.returncode, ran.stderr) == (0, b"")
    assert ran.stdout.splitlines()[0] == printed
