"""Install the wheel as users do, with uvx, pipx and pip, from the file and from a package index on this machine."""

from __future__ import annotations

import os
import shutil
import sys
import threading
import time
from collections.abc import Iterator
from functools import partial
from importlib.util import find_spec
from pathlib import Path

from tests.release.artefacts import PRINTED, PROGRAM, Row, call, environment
from tests.site.__main__ import Quiet, Server


def simple_index(folder: Path, wheel: Path) -> Path:
    """Write the pages of an index with one project; return its folder."""
    project = folder / "index" / "simple" / "motionlang"
    project.mkdir(parents=True)
    shutil.copy(wheel, project)
    (project / "index.html").write_text(f'<a href="{wheel.name}">{wheel.name}</a>\n', encoding="utf-8")
    return folder / "index"


def check(folder: Path, wheel: Path) -> Iterator[Row]:
    """Run the first program by each installer; with the bare name, the wheel comes from an index on this machine."""
    served = partial(Quiet, directory=str(simple_index(folder, wheel)))
    with Server(("127.0.0.1", 0), served) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        index = f"http://127.0.0.1:{server.server_port}/simple/"
        here, own = [sys.executable, "-m"], {"PIPX_HOME": str(folder / "pipx")}
        uvx = [*here, "uv", "tool", "run", "--no-cache", "--python", sys.executable]
        pipx = [*here, "pipx", "run", "--no-cache", "--python", sys.executable]
        run = ["run", str(PROGRAM)]
        # What the user types, the package that runs it here, and the command.
        lines = [
            ("uvx --from WHEEL motionlang", "uv", [*uvx, "--from", str(wheel), "motionlang", *run]),
            ("uvx motionlang", "uv", [*uvx, "--index", index, "motionlang", *run]),
            ("pipx run --spec WHEEL motionlang", "pipx", [*pipx, "--spec", str(wheel), "motionlang", *run]),
            (
                "pipx run motionlang", "pipx",
                [*pipx, "--backend", "pip", f"--pip-args=--extra-index-url={index}", "motionlang", *run],
            ),
        ]  # fmt: skip
        for shown, tool, command in lines:
            if find_spec(tool) is None:
                yield Row(shown, f"skipped: the package {tool} is not installed")
                continue
            began = time.perf_counter()
            assert PRINTED in call(*command, folder=folder, **own)
            yield Row(shown, "runs a program", None, time.perf_counter() - began)
        for shown, words in (
            ("pip install --find-links FOLDER motionlang", ("--find-links", str(wheel.parent), "motionlang")),
            ("pip install motionlang", ("--extra-index-url", index, "motionlang")),
        ):
            yield installed(folder / f"pip-{'index' if index in words else 'folder'}", shown, *words)
        server.shutdown()


def installed(folder: Path, shown: str, *words: str) -> Row:
    """Install with pip into a new environment, and run the first program there."""
    began = time.perf_counter()
    programs = environment(folder, "pip")
    call(programs / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *words)
    name = "motionlang.exe" if os.name == "nt" else "motionlang"
    assert PRINTED in call(programs / name, "run", PROGRAM)
    return Row(shown, "runs a program", None, time.perf_counter() - began)
