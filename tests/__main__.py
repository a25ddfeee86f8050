"""The complete check in one command: format, lint, types, tests.

Further arguments go to pytest. `--quick [COMMIT]` runs only the tests that reach changes since a commit
(HEAD), within seconds; `--record` finds out which these are (`tests/quick.py`).
"""

from __future__ import annotations

import os
import subprocess
import sys

from tests.steps import ROOT, conclude, start_static


def main(arguments: list[str]) -> int:
    """Run the steps at the same time; 1 if any failed."""
    # The tests start hundreds of processes. Without bytecode each compiles what it imports.
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    sys.dont_write_bytecode = False
    if arguments[:1] == ["--record"]:
        from tests.quick import record

        return record(os.cpu_count() or 1)
    if arguments[:1] == ["--quick"]:
        from tests.quick import main as quick

        return quick(*(arguments[1:] or ["HEAD"]))
    static = start_static()
    print("== tests", flush=True)
    tests = [sys.executable, "-m", "pytest", "-n", "auto", "--prove", *arguments]
    return conclude(static, subprocess.run(tests, cwd=ROOT, check=False).returncode == 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
