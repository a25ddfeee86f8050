"""Format, lint, types and imports: the steps of a check that run along with the tests."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
STATIC = (
    ("format", ("-m", "ruff", "format", "--check", "--quiet", ".")),
    ("lint", ("-m", "ruff", "check", "--quiet", ".")),
    ("types", ("-m", "mypy", "--no-error-summary")),
    # import-linter has no `__main__`.
    (
        "imports",
        ("-c", "from importlinter.cli import lint_imports as run; exit(run(no_cache=True, no_logo=True))"),
    ),
)


def start_static() -> dict[str, subprocess.Popen[str]]:
    """Start the steps; the output of each goes to a pipe."""
    return {
        name: subprocess.Popen([sys.executable, *command], cwd=ROOT, text=True, stdout=-1, stderr=-2)
        for name, command in STATIC
    }


def conclude(started: dict[str, subprocess.Popen[str]], tests_passed: bool) -> int:
    """Print the output of steps that failed, and their names; return 1 if any did."""
    failed = [] if tests_passed else ["tests"]
    for name, process in started.items():
        output = process.communicate()[0]
        print(f"== {name}\n{output if process.returncode else ''}", end="", flush=True)
        if process.returncode:
            failed.append(name)
    print(f"== {'failed: ' + ', '.join(failed) if failed else 'all passed'}", flush=True)
    return 1 if failed else 0
