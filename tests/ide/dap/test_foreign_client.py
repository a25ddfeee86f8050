"""A third-party client: DebugClient of @vscode/debugadapter-testsupport.

It requires `npm install @vscode/debugadapter-testsupport` in a folder, and NODE_PATH=FOLDER/node_modules.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.ide.debug.test_debugger import CALLS

SCRIPT = Path(__file__).parent / "debug_client.js"
PACKAGE = "@vscode/debugadapter-testsupport"


def test_a_session_of_debug_client(tmp_path: Path) -> None:
    """The breakpoint stops at n = 2; then step over, out, into n = 3, and back."""
    node = shutil.which("node")
    if node is None:
        pytest.skip("node is not installed")
    found = subprocess.run([node, "-e", f"require.resolve('{PACKAGE}')"], capture_output=True, check=False)
    if found.returncode:
        pytest.skip(f"{PACKAGE} is not in NODE_PATH")
    program = tmp_path / "calls.mnt"
    program.write_text(CALLS)
    ran = subprocess.run(
        [node, str(SCRIPT), sys.executable, str(program)],
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert (ran.returncode, ran.stderr) == (0, "")
    seen = json.loads(ran.stdout)
    assert seen["capabilities"] is True
    assert seen["verified"] == [True]
    assert seen["threads"] == ["ParentTask"]
    assert seen["scopes"] == ["Local", "Variables", "Axes", "Inputs", "Outputs"]
    assert seen["local"] == [["n", "2"], ["twice", "0"]]
    assert (seen["set"], seen["evaluated"]) == ("20", "22")
    assert seen["moves"] == [
        ["breakpoint", 4], ["step", 5], ["step", 9], ["step", 4], ["step", 9], ["breakpoint", 4], ["goto", 9],
    ]  # fmt: skip
    assert (seen["info"], seen["status"]) == ("always", 0)
