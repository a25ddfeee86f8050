"""Writing a file whole or not at all."""

from __future__ import annotations

import errno
import os
import stat
import sys
from pathlib import Path
from typing import IO

import pytest

from motionlang.files import replacing, unwritable


def test_two_who_write_at_once_do_not_meet(tmp_path: Path) -> None:
    path = tmp_path / "no_effect.json"
    with replacing(str(path)) as one:
        one.write(b"one")
        with replacing(str(path)) as two:
            two.write(b"two")
        assert path.read_bytes() == b"two"
    assert path.read_bytes() == b"one"
    assert os.listdir(tmp_path) == ["no_effect.json"]


def test_what_another_left_behind_is_not_in_the_way(tmp_path: Path) -> None:
    left = tmp_path / f".x.csv.{os.getpid()}.0"
    left.write_text("half")
    with replacing(str(tmp_path / "x.csv")) as file:
        file.write(b"new")
    assert (left.read_text(), (tmp_path / "x.csv").read_text()) == ("half", "new")


@pytest.mark.parametrize("old", ["old", None])
def test_where_the_disk_is_full_the_error_names_the_file(
    old: str | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "x.csv"
    if old is not None:
        path.write_text(old)

    def fill(file: IO[bytes]) -> None:
        file.write(b"half")
        raise OSError(errno.ENOSPC, "No space left on device")

    with pytest.raises(OSError, match="No space left") as error, replacing(str(path)) as file:
        fill(file)
    assert error.value.filename == str(path)
    assert {each.name: each.read_text() for each in tmp_path.iterdir()} == ({"x.csv": old} if old else {})


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_the_permissions_of_the_old_file_stay(tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text("old")
    path.chmod(0o640)
    with replacing(str(path)) as file:
        file.write(b"new")
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_a_link_is_followed_and_stays(tmp_path: Path) -> None:
    (tmp_path / "real.csv").write_text("")
    (tmp_path / "link.csv").symlink_to("real.csv")
    with replacing(str(tmp_path / "link.csv")) as file:
        file.write(b"new")
    assert (tmp_path / "link.csv").is_symlink()
    assert (tmp_path / "real.csv").read_text() == "new"


def test_a_device_is_written_to_directly() -> None:
    with pytest.raises(OSError, match="No space left"), replacing("/dev/full") as file:
        file.write(b"x")
    assert os.path.exists("/dev/full")


def test_what_cannot_be_written_is_known_before(tmp_path: Path) -> None:
    assert unwritable(str(tmp_path / "x.csv")) is None
    assert unwritable(str(tmp_path)) == f"{tmp_path} is a folder"
    assert unwritable(str(tmp_path / "no" / "x.csv")) == f"there is no folder {tmp_path / 'no'}"
