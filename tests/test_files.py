"""Atomic replacement of files."""

from __future__ import annotations

import ast
import errno
import os
import re
import stat
import sys
from collections.abc import Callable
from pathlib import Path
from typing import IO

import pytest

import motionlang
from motionlang.kernel import files
from motionlang.kernel.files import InUse, Lock, appending, create, reason, replacing, same_file, unwritable
from tests.trees import nodes_of

PACKAGE = Path(motionlang.__file__).parent
# Files that are not the user's: the null device, a history that prompt_toolkit appends to, a build.
ELSEWHERE = {
    "kernel/files.py",
    "cli/standard_streams.py",
    "repl/history.py",
    "_wheel.py",
}
# The flags of read-only access.
READ_FLAGS = {"O_RDONLY", "O_BINARY"}
WRITERS = {
    "write_text",
    "write_bytes",
    "replace",
    "rename",
    "symlink",
    "link",
    "mkstemp",
    "NamedTemporaryFile",
}


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


def test_what_may_not_be_written_is_known_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The folder counts, and for a device the device itself."""
    asked: list[str] = []

    def refuse(path: str, mode: int) -> bool:
        asked.append(path)
        return False

    monkeypatch.setattr(os, "access", refuse)
    file = tmp_path / "x.csv"
    file.touch()
    for path in (str(file), str(tmp_path / "new.csv"), os.devnull):
        assert unwritable(path) == f"{path} cannot be written: permission denied"
    assert asked == [str(tmp_path), str(tmp_path), os.devnull]


def test_a_folder_that_is_missing_is_named_as_given(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert unwritable("no/x.csv") == "there is no folder no"
    assert unwritable("x.csv") is None
    (tmp_path / "link.csv").symlink_to(tmp_path / "gone" / "x.csv")
    assert unwritable("link.csv") == f"there is no folder {tmp_path / 'gone'}"


def test_the_reason_of_an_error_is_that_of_the_system() -> None:
    assert reason(OSError(errno.EACCES, "Permission denied")) == "permission denied"
    assert reason(OSError("No Reason")) == "no reason"


def test_lines_are_appended_at_once(tmp_path: Path) -> None:
    path = tmp_path / "calls"
    for new, text in ((True, b"a"), (False, b"ab"), (True, b"a")):
        with appending(str(path), new=new) as file:
            file.write(text[-1:])
            assert path.read_bytes() == text


def test_a_new_file_replaces_none(tmp_path: Path) -> None:
    path = tmp_path / "new.mnt"
    create(str(path), b"x = 1")
    assert path.read_bytes() == b"x = 1"
    with pytest.raises(FileExistsError):
        create(str(path), b"")
    assert path.read_bytes() == b"x = 1"


def writes(node: ast.Call) -> bool:
    """True if a call opens a file for writing, or moves one."""
    called = ast.unparse(node.func)
    if called == "open" or called.endswith("fdopen"):
        modes = [*node.args[1:2], *(each.value for each in node.keywords if each.arg == "mode")]
        return not all(
            isinstance(each, ast.Constant) and isinstance(each.value, str) and set(each.value) <= set("rbt")
            for each in modes
        )
    if called == "os.open":
        flags = set(re.findall(r"\bO_\w+", ast.unparse(node)))
        return not flags or not flags <= READ_FLAGS
    where, _, name = called.rpartition(".")
    if name in ("replace", "rename", "symlink", "link"):
        return where in ("os", "path", "shutil")
    return name in WRITERS or (where in ("shutil", "tempfile") and name not in ("gettempdir", "which"))


@pytest.mark.usefixtures("package_trees")
def test_nothing_else_opens_a_file_for_writing() -> None:
    found = {
        path.relative_to(package).as_posix()
        for package in (PACKAGE, PACKAGE.parent / "extras" / "explore" / "motionlang_explore")
        for path in package.rglob("*.py")
        for node in nodes_of(path)
        if isinstance(node, ast.Call) and writes(node)
    }
    assert found == ELSEWHERE


def test_a_link_put_in_the_way_is_not_followed(tmp_path: Path) -> None:
    victim = tmp_path / "victim"
    victim.write_text("dear")
    (tmp_path / f".x.csv.{os.getpid()}.0").symlink_to(victim)
    (tmp_path / f".x.csv.{os.getpid()}.1").symlink_to(tmp_path / "nowhere")
    with replacing(str(tmp_path / "x.csv")) as file:
        file.write(b"new")
    assert (victim.read_text(), (tmp_path / "x.csv").read_text()) == ("dear", "new")
    assert not (tmp_path / "nowhere").exists()


def test_the_only_copy_is_on_the_disk_before_the_old_one_goes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    done: list[str] = []
    sync, replace = os.fsync, os.replace

    def noted(what: str, call: Callable[..., None]) -> Callable[..., None]:
        def do(*given: object) -> None:
            done.append(what)
            call(*given)

        return do

    monkeypatch.setattr(os, "fsync", noted("synced", sync))
    monkeypatch.setattr(os, "replace", noted("replaced", replace))
    for only_copy in (True, False):
        with replacing(str(tmp_path / "x.json"), only_copy=only_copy) as file:
            file.write(b"{}")
    assert done == ["synced", "replaced", "replaced"]


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_what_is_private_is_so_from_its_first_byte(tmp_path: Path) -> None:
    with replacing(str(tmp_path / "x"), private=True) as file:
        assert stat.S_IMODE(os.fstat(file.fileno()).st_mode) == 0o600


@pytest.mark.skipif(sys.platform == "win32", reason="POSIX permissions")
def test_a_new_file_is_no_program(tmp_path: Path) -> None:
    """Apart from that, the user's mask decides who may read and write it."""
    before = os.umask(0)
    try:
        with replacing(str(tmp_path / "x")) as file:
            file.write(b"new")
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "x").stat().st_mode) == 0o666


def test_a_file_is_held_once(tmp_path: Path) -> None:
    path = str(tmp_path / "nv.json")
    first = Lock(path)
    with pytest.raises(InUse):
        Lock(path)
    first.release()
    first.release()
    Lock(path).release()
    assert os.listdir(tmp_path) == []


def test_one_file_by_two_names(tmp_path: Path) -> None:
    one, link = str(tmp_path / "a"), str(tmp_path / "b")
    assert same_file(one, str(tmp_path / "." / "a"))
    assert not same_file(one, link)
    Path(one).write_text("")
    os.symlink(one, link)
    assert same_file(one, link)


def test_a_file_that_is_let_go_in_time_is_waited_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = str(tmp_path / "kept.json")
    first = Lock(path)
    monkeypatch.setattr(files, "sleep", lambda _: first.release())
    Lock(path, 10.0).release()
    assert list(tmp_path.iterdir()) == []


def test_a_file_that_cannot_take_its_place_is_an_error_of_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*given: str) -> None:
        raise OSError(errno.EACCES, "Permission denied")

    monkeypatch.setattr(os, "replace", refuse)
    path = str(tmp_path / "x.csv")
    with pytest.raises(OSError, match="Permission denied") as error, replacing(path) as file:
        file.write(b"new")
    assert error.value.filename == path
    assert os.listdir(tmp_path) == []


def test_an_error_of_the_writer_precedes_that_of_closing_the_file(tmp_path: Path) -> None:
    """The file is closed under its name already, so that it cannot be closed again."""

    def fail(file: IO[bytes]) -> None:
        os.close(file.fileno())
        raise ValueError("no more rows")

    with pytest.raises(ValueError, match="no more rows"), replacing(str(tmp_path / "x.csv")) as file:
        fail(file)
    assert os.listdir(tmp_path) == []
