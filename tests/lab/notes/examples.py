"""The scripts in `examples/notes/`, run in this process."""

from __future__ import annotations

import contextlib
import io
import sys
from pathlib import Path
from runpy import run_path
from unittest.mock import patch

ROOT = Path(__file__).parents[3]
SCRIPTS = sorted(ROOT.glob("examples/notes/*.py"))
# The scripts that print; the others only draw.
PRINTING = [path.stem for path in SCRIPTS if not path.stem.endswith("_drawn")]


def printed(script: str, *words: str) -> str:
    """Return the output of a script, such as examples/notes/slip.py, with its arguments."""
    out = io.StringIO()
    with patch.object(sys, "argv", [script, *words]), contextlib.redirect_stdout(out):
        run_path(str(ROOT / script), run_name="__main__")
    return out.getvalue()
