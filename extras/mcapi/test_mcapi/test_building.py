"""The commands that build the C library."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from motionlang_mcapi.build import TARGETS, CannotBuild, build, default_path
from test_mcapi.conftest import SOURCE


class Compiler:
    """Writes an empty library for each command, and records the commands."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.commands: list[list[str]] = []
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setattr(
            shutil, "which", lambda name: None if name.startswith("-") else f"/usr/bin/{name}"
        )
        monkeypatch.setattr(subprocess, "run", self.run)
        monkeypatch.setattr("motionlang_mcapi.build.sys.platform", "linux")

    def run(self, command: list[str], **options: Any) -> subprocess.CompletedProcess[str]:
        assert (options["capture_output"], options["check"]) == (True, False)
        self.commands.append(command)
        Path(command[command.index("-o") + 1]).write_text("library")
        return subprocess.CompletedProcess(command, 0, "", "")


@pytest.fixture
def compiler(monkeypatch: pytest.MonkeyPatch) -> Compiler:
    return Compiler(monkeypatch)


def test_a_library_for_linux(compiler: Compiler, tmp_path: Path) -> None:
    """One command; hosts link with libmcapi.so and load libmcapi-4.4.1.so."""
    path = build(TARGETS["linux"], tmp_path / "new")
    assert path == tmp_path / "new" / "libmcapi-4.4.1.so"
    assert sorted(os.listdir(path.parent)) == ["libmcapi-4.4.1.so", "libmcapi.so"]
    assert os.readlink(path.parent / "libmcapi.so") == "libmcapi-4.4.1.so"
    (command,) = compiler.commands
    assert command[:4] == ["cc", "-std=c99", "-O2", "-shared"]
    assert command[-3:] == [str(SOURCE / "mcapi.c"), "-lpthread", "-ldl"]


@pytest.mark.parametrize(("target", "bits", "tool"), [("win64", 64, "x86_64"), ("win32", 32, "i686")])
def test_a_library_for_windows(
    compiler: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, target: str, bits: int, tool: str
) -> None:
    """CC is the compiler of Linux alone."""
    monkeypatch.setenv("CC", "clang")
    path = build(TARGETS[target], tmp_path)
    assert path == tmp_path / f"mcapi{bits}.dll"
    assert sorted(os.listdir(tmp_path)) == [f"mcapi{bits}.dll"]
    (command,) = compiler.commands
    assert (command[0], command[-1]) == (f"{tool}-w64-mingw32-gcc", "-lws2_32")


def test_the_compiler_of_the_environment(
    compiler: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CC", "gcc-12 -m64")
    build(TARGETS["linux"], tmp_path)
    assert compiler.commands[0][:3] == ["gcc-12", "-m64", "-std=c99"]


def test_another_system_builds_the_libraries_of_windows_only(
    compiler: Compiler, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("motionlang_mcapi.build.sys.platform", "darwin")
    with pytest.raises(CannotBuild, match="this system is not Linux"):
        build(TARGETS["linux"], tmp_path)
    assert build(TARGETS["win64"], tmp_path).exists()


def test_the_library_of_another_source_is_not_used(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The folder in the cache is named by 16 hexadecimal digits of the sources' hash."""
    monkeypatch.setenv("MOTIONLANG_CACHE", str(tmp_path))
    path = default_path(TARGETS["linux"])
    assert path is not None
    assert path.relative_to(tmp_path).parts[0] == "mcapi"
    assert len(path.parent.name) == 16
    assert int(path.parent.name, 16)
    other = tmp_path / "source"
    other.mkdir()
    for name in ("mcapi.c", "mcapi.h", "stubs.h"):
        (other / name).write_bytes((SOURCE / name).read_bytes() + b"\n")
    monkeypatch.setattr("motionlang_mcapi.build.SOURCE", other)
    assert default_path(TARGETS["linux"]) != path


def test_a_folder_that_cannot_be_written(compiler: Compiler, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(CannotBuild, match="folder cannot be written: Not a directory") as caught:
        build(TARGETS["linux"], tmp_path / "file" / "folder")
    assert caught.value.hint == "name a folder with --out DIR"


def test_no_home_for_a_cache(compiler: Compiler, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A folder of --out needs no home."""
    monkeypatch.setattr("motionlang_mcapi.build.folder", lambda: None)
    assert default_path(TARGETS["linux"]) is None
    with pytest.raises(CannotBuild, match="there is no home for a cache"):
        build(TARGETS["linux"])
    assert build(TARGETS["linux"], tmp_path).exists()


@pytest.mark.parametrize(
    ("target", "message", "hint"),
    [
        ("linux", "there is no cc or gcc or clang", "install gcc, such as: apt install gcc"),
        (
            "win64",
            "there is no x86_64-w64-mingw32-gcc",
            "install mingw-w64, such as: apt install mingw-w64",
        ),
    ],
)
def test_no_compiler(
    target: str, message: str, hint: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    Compiler(monkeypatch)
    monkeypatch.setattr(shutil, "which", lambda name: None)
    with pytest.raises(CannotBuild) as caught:
        build(TARGETS[target], tmp_path)
    assert (str(caught.value), caught.value.hint) == (message, hint)
