"""The scripts in `tests/lab/notes/scripts/`, run in this process."""

from __future__ import annotations

import contextlib
import io
import sys
from pathlib import Path
from runpy import run_module
from unittest.mock import patch

ROOT = Path(__file__).parents[3]
SCRIPTS = sorted(path for path in ROOT.glob("tests/lab/notes/scripts/*.py") if path.stem != "__init__")
# The scripts that print; the others only draw.
PRINTING = [path.stem for path in SCRIPTS if not path.stem.endswith("_drawn")]


def printed(name: str, *words: str) -> str:
    """Return the output of a script, such as "slip", with its arguments."""
    out = io.StringIO()
    with patch.object(sys, "argv", [name, *words]), contextlib.redirect_stdout(out):
        run_module(f"tests.lab.notes.scripts.{name}", run_name="__main__")
    return out.getvalue()
