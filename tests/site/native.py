"""The output of the gallery and the time of a shift on native Python."""

from __future__ import annotations

import contextlib
import importlib
import io
import json
import os
import sys
import time
from pathlib import Path
from typing import Any

from motionlang.cli import main
from motionlang.kernel import Source, dialect, run
from motionlang.views.highlight import pieces
from motionlang.views.report import render

ROOT = Path(__file__).parents[2]
# The kinds of tokens that have a colour, and those that have another name in the editor.
COLOURED = ("move", "keyword", "not-simulated", "control", "axis", "register", "number", "string", "comment")
KINDS = {"text": "string"}


def printed(path: Path) -> str:
    """Return what `motionlang run` writes to a pipe."""
    out = io.BytesIO()
    text = io.TextIOWrapper(out, encoding="utf-8", newline="", write_through=True)
    with contextlib.redirect_stdout(text), contextlib.redirect_stderr(io.StringIO()):
        main(["run", str(path)])
    return out.getvalue().decode()


def kinds_of(path: Path) -> dict[str, Any]:
    """Return the text of a program, with offset, kind and text of its coloured tokens."""
    text = path.read_text(encoding="utf-8")
    tokens = [
        (offset, KINDS.get(kind, kind), piece)
        for offset, kind, piece in pieces(dialect(path.parent.name), text)
        if kind in KINDS or kind in COLOURED
    ]
    return {"text": text, "tokens": tokens}


def shift() -> dict[str, Any]:
    """Return the shift of `benchmarks/programs.py` and its best time of three runs."""
    program: str = importlib.import_module("benchmarks.programs").SHIFT
    times = []
    for _ in range(3):
        began = time.perf_counter()
        render(run(Source("program.mnt", program)), width=160)
        times.append(time.perf_counter() - began)
    return {"program": program, "seconds": min(times)}


def write(file: Path) -> None:
    """Write the outputs of all programs, by language and name, and the shift."""
    os.chdir(ROOT)
    sys.stdin = io.StringIO("")
    programs = [path for path in sorted(ROOT.glob("scripts/*/*")) if path.suffix in (".mnt", ".mcl")]
    found: dict[str, Any] = {f"{path.parent.name}/{path.name}": printed(path) for path in programs}
    kinds = {f"{path.parent.name}/{path.name}": kinds_of(path) for path in programs}
    file.write_text(json.dumps({**found, "shift": shift(), "kinds": kinds}), encoding="utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
