"""The DLLs: built by mingw, with the names that hosts require.

The 64-bit one runs under Wine.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from motionlang.mcapi.build import SOURCE, TARGETS, build
from motionlang.mcapi.table import FUNCTIONS
from tests.mcapi.conftest import Serve

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
    words += MCDLG_SaveAxis(h, 1, 0, "saved.ini") + MCDLG_RestoreAxis(h, 1, 0, "saved.ini");
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


@pytest.mark.parametrize("target", ["win64", "win32"])
def test_a_dll_exports_every_function(target: str, tmp_path: Path) -> None:
    """The exported names are undecorated, even if the calls are stdcall."""
    tools = compiler(target).removesuffix("gcc")
    dll = build(TARGETS[target], tmp_path)
    assert dll.name == {"win64": "mcapi64.dll", "win32": "mcapi32.dll"}[target]
    done = subprocess.run([f"{tools}objdump", "-p", dll], capture_output=True, text=True, check=True)
    names = re.findall(r"^\s+\[ *\d+\] .*?(\S+)$", done.stdout.partition("Ordinal/Name")[2], re.MULTILINE)
    assert {name for name in names if not name.startswith("_")} >= set(FUNCTIONS)
    assert not [name for name in names if "@" in name]
    dialogs = tmp_path / dll.name.replace("mcapi", "mcdlg")
    done = subprocess.run([f"{tools}objdump", "-p", dialogs], capture_output=True, text=True, check=True)
    assert f"{dll.stem}.MCDLG_SaveAxis" in done.stdout


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("wine") is None, reason="the DLL runs under Wine")
def test_a_host_on_windows(serve: Serve, tmp_path: Path) -> None:
    """It moves an axis, and its DWORD has four bytes."""
    dll = build(TARGETS["win64"], tmp_path) if compiler("win64") else tmp_path
    (tmp_path / "host.c").write_text(HOST, encoding="utf-8")
    program = tmp_path / "host.exe"
    command = [
        compiler("win64"),
        "-o",
        program,
        tmp_path / "host.c",
        f"-I{SOURCE}",
        tmp_path / "mcdlg64.dll",
        dll,
    ]
    subprocess.run(list(map(str, command)), check=True)
    environment = {
        **os.environ,
        "MCAPI_HOST": serve(clock="real").name,
        "WINEPREFIX": str(tmp_path / "wine"),
        "WINEDEBUG": "-all",
        "DISPLAY": "",
    }
    done = subprocess.run(
        ["wine", str(program)],
        env=environment,
        capture_output=True,
        text=True,
        timeout=250,
        check=False,
        cwd=tmp_path,
    )
    assert done.stdout == "1 1 0 2001 0 1 20 axis number out of range\n", done.stderr
    subprocess.run(["wineserver", "-k"], env=environment, check=False, capture_output=True)
