"""`python -m tests.mutants [COUNT] [SEED]`: how many of so many mutants are killed, and which live."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.mutants.mutate import PACKAGE, ROOT, Mutant, chosen

# Seconds after which a run of the tests counts as one that does not end, which is a difference, too.
LONGEST = 300.0
# Those that change nothing that can be seen, each with the reason.
EQUIVALENT: dict[str, str] = {}
# The tests of a place: those of its folder first, then the pages and the gallery, which use everything.
_ALL = ("tests/spec", "tests/mint/test_spec.py", "tests/golden/test_gallery.py", "tests/mccl/test_spec.py")


def runs_of(path: Path) -> list[list[str]]:
    """Runs of the tests, the nearest first."""
    parts = path.relative_to(PACKAGE).parts
    near = [f"tests/{'/'.join(parts[:depth])}" for depth in (2, 1) if len(parts) > depth]
    stem = path.stem.removesuffix("_operations")
    named = sorted(str(each.relative_to(ROOT)) for each in (ROOT / "tests").rglob(f"test_{stem}*.py"))
    groups = [named, near[:1], near[1:], [each for each in _ALL if (ROOT / each).exists()]]
    if parts[0] == "profile":
        groups.append(["tests/controller"])
    return [group for group in groups if group and all((ROOT / each).exists() for each in group)]


def is_killed(mutant: Mutant, tree: Path) -> bool:
    """Whether a test fails in a copy of the project that has the change."""
    place = tree / mutant.path.relative_to(ROOT)
    before = place.read_bytes()
    place.write_text(mutant.text(), encoding="utf-8")
    try:
        for group in runs_of(mutant.path):
            command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider", *group]
            environment = os.environ | {"MOTIONLANG_NO_CACHE": "1", "PYTHONDONTWRITEBYTECODE": "1"}
            try:
                ran = subprocess.run(
                    command, cwd=tree, env=environment, capture_output=True, timeout=LONGEST, check=False
                )
            except subprocess.TimeoutExpired:
                return True
            if ran.returncode not in (0, 5):
                return True
    finally:
        place.write_bytes(before)
    return False


def main(count: int, seed: int) -> int:
    """Print a line a mutant and the share that was killed; 1 where less than 95 % were."""
    with tempfile.TemporaryDirectory() as folder:
        tree = Path(folder) / "motionlang"
        left_out = shutil.ignore_patterns(".git", ".venv", "__pycache__", ".*_cache", "*.egg-info")
        shutil.copytree(ROOT, tree, ignore=left_out)
        lived = []
        mutants = [each for each in chosen(count, seed) if str(each) not in EQUIVALENT]
        for number, mutant in enumerate(mutants, 1):
            killed = is_killed(mutant, tree)
            print(f"{number} {'killed' if killed else 'LIVED '} {mutant}", flush=True)
            if not killed:
                lived.append(mutant)
    killed_share = 1.0 - len(lived) / max(len(mutants), 1)
    print(
        f"{len(mutants)} mutants, seed {seed}: {killed_share:.1%} killed; those that lived:", *lived, sep="\n"
    )
    return 0 if killed_share >= 0.95 else 1


if __name__ == "__main__":
    numbers = [int(word) for word in sys.argv[1:]]
    sys.exit(main(*(numbers + [300, 0][len(numbers) :])))
