"""The cache of compiled programs: used when it can be trusted, ignored when it cannot, never in the way."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest

from motionlang import execution
from motionlang.lang import cache
from motionlang.source import Source

HELLO = Source("hello.mnt", 'PRINT "hello"\n')


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    place = tmp_path / "cache"
    monkeypatch.setenv("MOTIONLANG_CACHE", str(place))
    monkeypatch.delenv(cache.OFF, raising=False)
    return place


def test_what_was_put_comes_back() -> None:
    cache.put(cache.key("a"), b"program")
    assert cache.get(cache.key("a")) == b"program"
    assert cache.get(cache.key("b")) is None


def test_every_part_of_the_key_counts() -> None:
    assert len({cache.key("a", "b"), cache.key("ab", ""), cache.key("a"), cache.key("b", "a")}) == 4


def test_a_damaged_entry_is_ignored(folder: Path) -> None:
    name = cache.key("a")
    cache.put(name, b"program")
    data = (folder / name).read_bytes()
    for damaged in (data[:-1], data + b"x", data[:33], b"", b"\0" * len(data)):
        (folder / name).write_bytes(damaged)
        assert cache.get(name) is None


def test_an_entry_under_another_name_is_ignored(folder: Path) -> None:
    cache.put(cache.key("a"), b"program")
    os.rename(folder / cache.key("a"), folder / cache.key("b"))
    assert cache.get(cache.key("b")) is None


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_what_others_may_write_is_ignored(folder: Path) -> None:
    name = cache.key("a")
    cache.put(name, b"program")
    assert (folder / name).stat().st_mode & 0o077 == 0
    assert folder.stat().st_mode & 0o077 == 0
    (folder / name).chmod(0o666)
    assert cache.get(name) is None
    (folder / name).chmod(0o600)
    folder.chmod(0o777)
    assert cache.get(name) is None


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("in the way")
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path / "file"))
    cache.put(cache.key("a"), b"program")
    assert cache.get(cache.key("a")) is None
    assert execution.run(HELLO).output == ["hello"]


def test_the_environment_turns_it_off(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(cache.OFF, "1")
    cache.put(cache.key("a"), b"program")
    assert not folder.exists()


def test_old_entries_make_room(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cache, "ENTRIES", 4)
    for k in range(5):
        cache.put(cache.key(str(k)), b"program")
    assert len(list(folder.iterdir())) == 2


def test_a_changed_compiler_is_another_key(tmp_path: Path) -> None:
    (tmp_path / "compiler.py").write_text("one")
    before = cache.fingerprint(str(tmp_path))
    (tmp_path / "compiler.py").write_text("three")
    changed = cache.fingerprint(str(tmp_path))
    assert changed != before
    (tmp_path / "keywords").mkdir()
    (tmp_path / "keywords" / "axis.py").write_text("a = 1\n")
    assert cache.fingerprint(str(tmp_path)) != changed


def test_a_cached_run_is_the_same_run(folder: Path) -> None:
    first, second = execution.run(HELLO), execution.run(HELLO)
    assert len(list(folder.iterdir())) == 1
    assert (first.output, first.time) == (second.output, second.time)
    assert len(list(folder.iterdir())) == 1
    execution.run(HELLO, cache=False)


def test_a_cached_run_that_fails_names_its_place_too() -> None:
    source = Source("wrong.mnt", "x = 0\nPRINT 1 / x\n")
    places = [[(d.line, d.column, d.code) for d in execution.run(source).diagnostics] for _ in range(2)]
    assert places == [[(2, 1, "division-by-zero")]] * 2
