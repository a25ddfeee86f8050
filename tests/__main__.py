"""The complete check in one command: format, lint, types, tests.

Further arguments go to pytest. `--quick [COMMIT]` runs only the tests that reach changes since a commit
(HEAD), within seconds; `--record` finds out which these are (`tests/quick.py`).
"""

from __future__ import annotations

import os
import subprocess
import sys

STATIC = (
    ("format", ("ruff", "format", "--check", "--quiet", ".")),
    ("lint", ("ruff", "check", "--quiet", ".")),
    ("types", ("mypy", "--no-error-summary")),
)


def main(arguments: list[str]) -> int:
    """Run every step, even after a failure; 1 if any failed."""
    if arguments[:1] == ["--record"]:
        from tests.quick import record

        return record(os.cpu_count() or 1)
    if arguments[:1] == ["--quick"]:
        from tests.quick import main as quick

        return quick(STATIC, *(arguments[1:] or ["HEAD"]))
    failed = []
    for name, command in (*STATIC, ("tests", ("pytest", "-n", "auto", "--prove", *arguments))):
        print(f"== {name}", flush=True)
        if subprocess.run([sys.executable, "-m", *command], check=False).returncode:
            failed.append(name)
    print(f"== {'failed: ' + ', '.join(failed) if failed else 'all passed'}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
