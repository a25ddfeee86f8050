"""The C library: built from the package, used by C hosts, and used as a recorder."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from motionlang_mcapi.build import TARGETS, CannotBuild, build
from test_mcapi.conftest import COMPILER, FUNCTIONS, SOURCE, Serve, needs_compiler

HERE = Path(__file__).parent


def run(program: Path, library: Path, address: str, **more: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "MCAPI_HOST": address, "LD_LIBRARY_PATH": str(library.parent), **more}
    return subprocess.run(
        [program],
        env=environment,
        capture_output=True,
        text=True,
        timeout=60,
        check=False,
        cwd=program.parent,
    )


def test_the_hand_written_part_is_small() -> None:
    """At most 400 lines without blank lines and comments; the rest is generated."""
    text = re.sub(r"/\*.*?\*/", "", (SOURCE / "mcapi.c").read_text(encoding="utf-8"), flags=re.DOTALL)
    assert len([line for line in text.splitlines() if line.strip()]) <= 400


def test_the_source_is_in_the_wheel() -> None:
    project = (HERE.parent / "pyproject.toml").read_text(encoding="utf-8")
    assert '"library/*"' in project
    assert all((SOURCE / name).exists() for name in ("mcapi.c", "mcapi.h", "stubs.h"))


@needs_compiler
def test_it_exports_every_function(library: Path) -> None:
    """It exports nothing else; its soname is the one that linked programs require."""
    names = subprocess.run(["nm", "-D", library], capture_output=True, text=True, check=True).stdout
    assert set(re.findall(r" T (\w+)", names)) == set(FUNCTIONS)
    assert (library.parent / "libmcapi.so").resolve() == library
    dynamic = subprocess.run(["readelf", "-d", library], capture_output=True, text=True, check=True).stdout
    assert "soname: [libmcapi-4.4.1.so]" in dynamic


@needs_compiler
def test_it_compiles_without_a_warning(tmp_path: Path) -> None:
    """All warnings of the compilers are on; the header compiles as C++, too."""
    options = ["-Wall", "-Wextra", "-Werror"]
    done = subprocess.run(
        [str(COMPILER), "-std=c99", *options, "-fsyntax-only", SOURCE / "mcapi.c"],
        capture_output=True,
        check=False,
    )
    assert done.stderr == b""
    (tmp_path / "host.cpp").write_text('#include "mcapi.h"\nint main() { return MCOpen(0, 1, 0) > 0; }\n')
    done = subprocess.run(
        [str(COMPILER), *options, f"-I{SOURCE}", "-fsyntax-only", tmp_path / "host.cpp"],
        capture_output=True,
        check=False,
    )
    assert done.stderr == b""


@needs_compiler
def test_a_c_host(serve: Serve, library: Path, chost: Path) -> None:
    """The host checks its results itself, see host.c."""
    done = run(chost, library, serve(clock="real").name)
    assert (done.returncode, done.stdout, done.stderr) == (0, "5001\n", "")


@needs_compiler
def test_no_board_listens(library: Path, tmp_path: Path) -> None:
    done = host(tmp_path, library, 'h = MCOpen(0, 2, 0); printf("%d %d", h, MCStopNot());', "127.0.0.1:1")
    assert done.stdout == "-32 32"


@needs_compiler
def test_a_server_that_is_killed(serve: Serve, library: Path, tmp_path: Path) -> None:
    """Within a second every function with an error code returns 32.

    Meanwhile the host waits for a line from the test.
    """
    board = serve(clock="real")
    code = (
        'h = MCOpen(0, 2, 0); printf("%d\\n", MCStopNot()); fflush(stdout); getchar();'
        'printf("%d %d %d ", MCStopNot(), MCGetError(h), MCIsStopped(h, 1, 60.0));'
        'printf("%d %d", (int)pmclock(h, 0), MCOpen(0, 2, 0));'
    )
    program = compiled(tmp_path, library, code)
    environment = {**os.environ, "MCAPI_HOST": board.name, "LD_LIBRARY_PATH": str(library.parent)}
    with subprocess.Popen(
        [program], env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as done:
        assert done.stdout is not None
        assert done.stdout.readline() == "0\n"
        board.end()
        rest, _ = done.communicate("\n", timeout=60)
    assert rest == "32 32 0 32 -32"
    assert done.returncode == 0


@needs_compiler
def test_a_second_copy_as_the_real_library(serve: Serve, library: Path, chost: Path, tmp_path: Path) -> None:
    """The host gets the same results."""
    copy = tmp_path / "real" / library.name
    copy.parent.mkdir()
    shutil.copy(library, copy)
    log = tmp_path / "real.log"
    done = run(chost, library, serve(clock="real").name, MCAPI_REAL=str(copy), MCAPI_LOG=str(log))
    assert (done.returncode, done.stderr) == (0, "")
    lines = log.read_text(encoding="latin-1").splitlines()
    assert lines[0] == "mcapi-log 1"
    calls = [line.split(" ", 3)[3] for line in lines[1:]]
    assert calls[0] == "MCGetMotionConfigEx 6 1 + = 13"
    assert "MCGetInstalledModules 1 + 3 = 0 252 252 252" in calls
    assert "MCEnableAxis 1 1 1 = -" in calls
    assert sum(call == "MCGetPositionEx 1 2 + = 0 0.0" for call in calls) == 8 * 200


@needs_compiler
def test_a_real_library_that_is_not_there(library: Path, tmp_path: Path) -> None:
    """MCOpen fails instead of recording another board."""
    done = host(tmp_path, library, 'printf("%d", MCOpen(0, 2, 0));', "127.0.0.1:1", MCAPI_REAL="/nowhere.so")
    assert done.stdout == "-6"
    assert "cannot load /nowhere.so of MCAPI_REAL" in done.stderr


def compiled(folder: Path, library: Path, code: str) -> Path:
    """Return a compiled program whose main function has this code."""
    source, program = folder / "small.c", folder / "small"
    source.write_text(
        '#include <stdio.h>\n#include "mcapi.h"\nstatic HCTRLR h;\n'
        "static int MCStopNot(void) { double p; return MCGetPositionEx(h, 1, &p); }\n"
        f"int main(void) {{ (void)MCStopNot; {code} return 0; }}\n"
    )
    command = [
        str(COMPILER),
        "-o",
        str(program),
        str(source),
        f"-I{SOURCE}",
        f"-L{library.parent}",
        "-lmcapi",
    ]
    subprocess.run(command, check=True)
    return program


def host(
    folder: Path, library: Path, code: str, address: str, **more: str
) -> subprocess.CompletedProcess[str]:
    return run(compiled(folder, library, code), library, address, **more)


@pytest.fixture
def no_tools(monkeypatch: pytest.MonkeyPatch) -> None:
    """A system without a compiler."""
    monkeypatch.setattr(shutil, "which", lambda name: None)
    monkeypatch.delenv("CC", raising=False)


@pytest.mark.usefixtures("no_tools")
@pytest.mark.parametrize(("target", "package"), [("linux", "gcc"), ("win64", "mingw-w64")])
def test_without_a_compiler_it_says_what_to_install(tmp_path: Path, target: str, package: str) -> None:
    if target == "linux" and sys.platform != "linux":
        pytest.skip("the message of Linux needs Linux")
    with pytest.raises(CannotBuild) as caught:
        build(TARGETS[target], tmp_path)
    assert str(caught.value).startswith("there is no ")
    assert package in caught.value.hint


def test_a_compiler_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CC", "false")
    with pytest.raises(CannotBuild, match="false failed: exit status 1"):
        build(TARGETS["linux"], tmp_path)
    monkeypatch.setenv("CC", "no-such-compiler")
    with pytest.raises(CannotBuild, match="'no-such-compiler' of CC is not there"):
        build(TARGETS["linux"], tmp_path)
