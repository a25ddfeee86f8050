"""The DLLs: built by mingw, with the names that hosts require."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import pytest

from motionlang_mcapi.build import TARGETS, build
from test_mcapi.conftest import FUNCTIONS, SOURCE, Serve

HOST = """
#include <stdio.h>
#include "mcapi.h"
int main(void)
{
    MCSTATUSEX status = {0};
    double position = -1.0;
    char text[64];
    HCTRLR h = MCOpen(0, MC_OPEN_BINARY, NULL);
    MCEnableAxis(h, 1, 1);
    MCMoveAbsolute(h, 1, 2000.5);
    int stopped = MCIsStopped(h, 1, 10.0), code = MCGetPositionEx(h, 1, &position);
    int words = MCGetStatusEx(h, 1, &status);
    MCTranslateErrorEx(MCGetPositionEx(h, 99, &position), text, sizeof text);
    printf("%d %d %d %g %d %lu %d %s\\n",
           h, stopped, code, position, words, status.ModeStatus, (int)sizeof status, text);
    return 0;
}
"""


def compiler(target: str) -> str:
    """Return the compiler of a target; skip the test if there is none."""
    found = next(filter(shutil.which, TARGETS[target].compilers), None)
    if found is None:
        pytest.skip(f"the DLL needs {TARGETS[target].compilers[0]}")
    return found


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Callable[[str], Path]:
    """Return a function that builds the DLL of a target once and returns its path."""
    return cache(lambda target: build(TARGETS[target], tmp_path_factory.mktemp(target)))


@pytest.mark.parametrize("target", ["win64", "win32"])
def test_a_dll_exports_every_function(target: str, built: Callable[[str], Path]) -> None:
    """The exported names are undecorated, even if the calls are stdcall."""
    tools = compiler(target).removesuffix("gcc")
    dll = built(target)
    assert dll.name == {"win64": "mcapi64.dll", "win32": "mcapi32.dll"}[target]
    done = subprocess.run([f"{tools}objdump", "-p", dll], capture_output=True, text=True, check=True)
    names = re.findall(r"^\s+\[ *\d+\] .*?(\S+)$", done.stdout.partition("Ordinal/Name")[2], re.MULTILINE)
    assert {name for name in names if not name.startswith("_")} >= set(FUNCTIONS)
    assert not [name for name in names if "@" in name]


@pytest.fixture
def wine(tmp_path: Path) -> Iterator[Callable[..., subprocess.CompletedProcess[str]]]:
    """Yield a function that runs a Windows program; skip the test without Wine.

    A Wine that cannot run its own programs counts as missing.
    """
    if shutil.which("wine") is None:
        pytest.skip("the DLL runs under Wine")
    wine_only = {"WINEPREFIX": str(tmp_path / "wine"), "WINEDEBUG": "-all", "DISPLAY": ""}

    def run(*command: str, **variables: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            ["wine", *command],
            env={**os.environ, **wine_only, **variables},
            capture_output=True,
            text=True,
            timeout=250,
            check=False,
            cwd=tmp_path,
        )

    # An installed Wine may be unable to start: "could not load kernel32.dll".
    own = run("cmd", "/c", "echo started")
    if own.stdout.strip() != "started":
        pytest.skip(f"Wine does not start here: {own.stderr.strip()}")
    yield run
    subprocess.run(["wineserver", "-k"], env={**os.environ, **wine_only}, check=False, capture_output=True)


@pytest.mark.slow
def test_a_host_on_windows(
    serve: Serve,
    built: Callable[[str], Path],
    tmp_path: Path,
    wine: Callable[..., subprocess.CompletedProcess[str]],
) -> None:
    """It moves an axis, and its DWORD has four bytes."""
    tool, dll = compiler("win64"), built("win64")
    (tmp_path / "host.c").write_text(HOST, encoding="utf-8")
    program = dll.parent / "host.exe"  # it finds the DLL in its own folder
    command = [
        tool,
        "-o",
        program,
        tmp_path / "host.c",
        f"-I{SOURCE}",
        dll,
    ]
    subprocess.run(list(map(str, command)), check=True)
    done = wine(str(program), MCAPI_HOST=serve(clock="real").name)
    assert done.stdout == "1 1 0 2001 0 1 20 axis number out of range\n", done.stderr
