"""Planning in a running program imports nothing slow."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

SLOW = {"numpy", "fractions", "decimal"}


def test_importing_the_planners_imports_nothing_slow() -> None:
    root = Path(__file__).parents[3]
    script = (
        f"import sys; sys.path.insert(0, {str(root)!r}); import motionlang; before = set(sys.modules); "
        "import motionlang.kernel.planners; print(*set(sys.modules) - before)"
    )
    run = subprocess.run([sys.executable, "-S", "-c", script], capture_output=True, text=True, check=True)
    assert not SLOW & set(run.stdout.split())
