"""The path and the permissions of the history file."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from prompt_toolkit.history import InMemoryHistory

from motionlang.repl.history import SafeHistory, history


@pytest.fixture(autouse=True)
def _home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("MOTIONLANG_HISTORY", raising=False)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setattr("sys.platform", "linux")


def test_each_dialect_has_its_own_and_only_the_user_can_read_it(tmp_path: Path) -> None:
    history("mint").store_string("MOVER = 12")
    stored = tmp_path / "state" / "motionlang" / "mint-history"
    assert "+MOVER = 12" in stored.read_text()
    assert stored.stat().st_mode & 0o777 == 0o600
    assert stored.parent.stat().st_mode & 0o777 == 0o700
    assert list(history("mint").load_history_strings()) == ["MOVER = 12"]
    assert list(history("mccl").load_history_strings()) == []


def test_a_file_that_others_could_read_is_closed_to_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "mine"
    path.touch(0o666)
    monkeypatch.setenv("MOTIONLANG_HISTORY", str(path))
    assert isinstance(history("mint"), SafeHistory)
    assert path.stat().st_mode & 0o777 == 0o600


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX pipes")
def test_a_pipe_is_no_history_and_stays_as_it_is(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "pipe"
    os.mkfifo(path)
    path.chmod(0o644)
    monkeypatch.setenv("MOTIONLANG_HISTORY", str(path))
    assert isinstance(history("mint"), InMemoryHistory)
    assert path.stat().st_mode & 0o777 == 0o644


@pytest.mark.parametrize("path", ["", "/proc/nowhere/history"])
def test_history_that_cannot_be_stored_is_dropped(path: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MOTIONLANG_HISTORY", path)
    assert isinstance(history("mint"), InMemoryHistory)


def test_a_link_is_not_followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "other").touch()
    (tmp_path / "link").symlink_to(tmp_path / "other")
    monkeypatch.setenv("MOTIONLANG_HISTORY", str(tmp_path / "link"))
    assert isinstance(history("mint"), InMemoryHistory)
