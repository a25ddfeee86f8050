"""Compare the work of this tree with that of an earlier commit, by counting.

Usage: `python -m benchmarks --against COMMIT`. Each style of `styles.py` is counted in both trees, by
function calls and by bytecode instructions. Counts repeat exactly, so a difference is always due to the code
and never to the machine. An increase of more than 10 % in either count fails. `COMMIT` may be `baseline`: the
commit named in the file `benchmarks/baseline`, in which a line with a reason allows an intended increase.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from fnmatch import fnmatchcase
from pathlib import Path
from typing import NamedTuple

from rich.console import Console
from rich.table import Table

from tests.commits import unpacked

FOLDER = Path(__file__).parent
ROOT = FOLDER.parent
BASELINE = FOLDER / "baseline"
# The highest ratio that needs no reason.
LIMIT = 1.10


class Allowed(NamedTuple):
    """An intended increase: a pattern of figures, the highest ratio, and the reason."""

    pattern: str
    limit: float
    reason: str


class Change(NamedTuple):
    """A figure's (calls, instructions) in both trees, and the allowed increase."""

    figure: str
    before: tuple[int, int]
    after: tuple[int, int]
    allowed: Allowed | None

    @property
    def ratio(self) -> float:
        """The larger of the two ratios."""
        return max(after / max(before, 1) for before, after in zip(self.before, self.after, strict=True))

    @property
    def limit(self) -> float:
        """The highest ratio that is accepted."""
        return self.allowed.limit if self.allowed else LIMIT


def read_baseline(text: str) -> tuple[str, list[Allowed]]:
    """Return the commit and the allowed increases of a baseline file.

    Raises ValueError if a line is invalid.
    """
    commit, allowed = "", []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split(maxsplit=2)
        if not words or words[0].startswith("#"):
            continue
        if words[0] == "commit" and len(words) == 2:
            commit = words[1]
            continue
        try:
            pattern, limit, reason = words
            allowed.append(Allowed(pattern, float(limit), reason))
        except ValueError:
            raise ValueError(
                f"line {number} is not 'commit COMMIT' or 'FIGURE RATIO REASON': {line}"
            ) from None
    if not commit:
        raise ValueError("no line names the commit: 'commit COMMIT'")
    return commit, allowed


def counts(package: Path) -> dict[str, tuple[int, int]]:
    """Return all figures of the package in a folder, counted in a separate process."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("MOTIONLANG_")}
    done = subprocess.run(
        [sys.executable, str(FOLDER / "counted.py"), str(package)],
        capture_output=True,
        text=True,
        check=False,
        cwd=package,
        env=environment | {"PYTHONPATH": str(FOLDER), "PYTHONHASHSEED": "0", "PYTHONDONTWRITEBYTECODE": "1"},
    )
    if done.returncode:
        raise RuntimeError(f"{package.name} cannot be counted: {done.stderr.strip()[-2000:]}")
    return {name: (calls, instructions) for name, (calls, instructions) in json.loads(done.stdout).items()}


def compare(
    before: dict[str, tuple[int, int]], after: dict[str, tuple[int, int]], allowed: list[Allowed]
) -> list[Change]:
    """Compare the figures of both trees.

    If several lines of the baseline match a figure, the last one applies.
    """
    return [
        Change(
            name,
            before[name],
            after[name],
            next((each for each in reversed(allowed) if fnmatchcase(name, each.pattern)), None),
        )
        for name in after
        if name in before
    ]


def _git(*arguments: str) -> str | None:
    """Return git's output; None if it fails or is missing."""
    try:
        done = subprocess.run(["git", *arguments], capture_output=True, text=True, check=False, cwd=ROOT)
    except OSError:
        return None
    return done.stdout.strip() if done.returncode == 0 else None


def show(changes: list[Change], commit: str) -> bool:
    """Print figures that differ by more than 2 %; True if none exceeds its limit."""
    table = Table("figure", "calls", "instructions", "limit", "", box=None)
    ratios = 1.0
    for change in sorted(changes, key=lambda each: -each.ratio):
        calls, instructions = (
            after / max(before, 1) for before, after in zip(change.before, change.after, strict=True)
        )
        ratios *= max(instructions, 1e-9) ** (1.0 / len(changes))
        if abs(calls - 1.0) <= 0.02 and abs(instructions - 1.0) <= 0.02:
            continue
        verdict = "" if change.ratio <= change.limit else "[red]exceeded[/]"
        reason = verdict or (change.allowed.reason if change.allowed and change.ratio > LIMIT else "")
        table.add_row(change.figure, f"{calls:.3f}", f"{instructions:.3f}", f"{change.limit:g}", reason)
    console = Console()
    if table.row_count:
        console.print(table)
    exceeded = [change.figure for change in changes if change.ratio > change.limit]
    console.print(
        f"{len(changes)} figures, instructions {ratios:.3f} of {commit} (geometric mean)", highlight=False
    )
    if exceeded:
        console.print(f"more than {LIMIT - 1.0:.0%} above {commit}: {', '.join(exceeded)}", highlight=False)
        console.print(f"an increase on purpose is a line in {BASELINE.relative_to(ROOT)}", highlight=False)
    return not exceeded


def main(commit: str) -> int:
    """Count both trees and compare; 1 if a figure exceeds its limit, 2 on failure."""
    try:
        named, allowed = read_baseline(BASELINE.read_text(encoding="utf-8"))
    except ValueError as error:
        sys.stderr.write(f"{BASELINE.relative_to(ROOT)}: {error}\n")
        return 2
    commit = named if commit == "baseline" else commit
    if _git("rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}") is None:
        if _git("rev-parse", "--is-shallow-repository") != "false":
            print(f"skipped: this clone does not contain commit {commit}")
            return 0
        sys.stderr.write(f"there is no commit {commit} in this repository\n")
        return 2
    with tempfile.TemporaryDirectory() as folder:
        try:
            with ThreadPoolExecutor() as pool:
                then = unpacked(commit, Path(folder), "motionlang", "grammars")
                before, after = pool.map(counts, [then, ROOT])
        except RuntimeError as error:
            sys.stderr.write(f"{error}\n")
            return 2
    return 0 if show(compare(before, after, allowed), commit) else 1
