"""The cache folder of each system, and which files in it are trustworthy."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from motionlang.kernel import cache


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    path = tmp_path / "cache"
    monkeypatch.setenv("MOTIONLANG_CACHE", str(path))
    return path


@pytest.mark.parametrize(
    ("platform", "variables", "found"),
    [
        ("linux", {}, "/home/ann/.cache/motionlang"),
        ("linux", {"XDG_CACHE_HOME": "/var/caches"}, "/var/caches/motionlang"),
        ("linux", {"XDG_CACHE_HOME": "caches"}, "/home/ann/.cache/motionlang"),
        ("darwin", {"XDG_CACHE_HOME": "/var/caches"}, "/home/ann/Library/Caches/motionlang"),
        ("win32", {"LOCALAPPDATA": "/local"}, "/local/motionlang"),
        ("win32", {}, "/home/ann/AppData/Local/motionlang"),
        ("linux", {"MOTIONLANG_CACHE": "/mine"}, "/mine"),
    ],
)
def test_each_system_has_its_folder_for_caches(
    platform: str, variables: dict[str, str], found: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("MOTIONLANG_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("HOME", "/home/ann")
    monkeypatch.setattr("sys.platform", platform)
    assert cache.folder() == found


def test_the_folder_is_made_for_its_user_alone(folder: Path) -> None:
    assert cache.path_of("table") == str(folder / "table")
    if sys.platform != "win32":
        assert folder.stat().st_mode & 0o077 == 0


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
@pytest.mark.parametrize("permissions", [0o620, 0o602])
def test_a_file_that_others_may_write_is_not_used(folder: Path, permissions: int) -> None:
    folder.mkdir(0o700)
    (folder / "table").write_bytes(b"table")
    (folder / "table").chmod(permissions)
    assert cache.path_of("table") is None
    (folder / "table").chmod(0o644)
    assert cache.path_of("table") == str(folder / "table")


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
@pytest.mark.parametrize(("permissions", "writable"), [(0o777, True), (0o700, False)])
def test_a_folder_of_others_is_not_used(
    folder: Path, permissions: int, writable: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The user may be root, who may write to any folder."""
    folder.mkdir()
    folder.chmod(permissions)
    monkeypatch.setattr(os, "access", lambda path, mode: writable)
    assert cache.path_of("table") is None


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_a_file_of_another_user_is_not_used(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert cache.path_of("table") is not None
    monkeypatch.setattr(os, "getuid", lambda: 1)
    assert cache.path_of("table") is None
    monkeypatch.delattr(os, "getuid")  # as on Windows
    assert cache.path_of("table") == str(folder / "table")


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "file"))
    assert cache.path_of("table") is None
