"""Format, lint and types: the steps of a check that run along with the tests."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
STATIC = (
    ("format", ("ruff", "format", "--check", "--quiet", ".")),
    ("lint", ("ruff", "check", "--quiet", ".")),
    ("types", ("mypy", "--no-error-summary")),
)


def start_static() -> dict[str, subprocess.Popen[str]]:
    """Start the steps; the output of each goes to a pipe."""
    return {
        name: subprocess.Popen([sys.executable, "-m", *command], cwd=ROOT, text=True, stdout=-1, stderr=-2)
        for name, command in STATIC
    }


def conclude(started: dict[str, subprocess.Popen[str]], tests_passed: bool) -> int:
    """Print the output of the steps and which of them failed; return 1 if any did."""
    failed = [] if tests_passed else ["tests"]
    for name, process in started.items():
        output = process.communicate()[0]
        print(f"== {name}\n{output}", end="", flush=True)
        if process.returncode:
            failed.append(name)
    print(f"== {'failed: ' + ', '.join(failed) if failed else 'all passed'}", flush=True)
    return 1 if failed else 0
