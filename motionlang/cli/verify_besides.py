"""What `motionlang verify` checks beside a program's golden files: expectations, its scenarios, its sweep."""

from __future__ import annotations

import csv
import io
import os
import sys
from functools import partial
from typing import TYPE_CHECKING

from motionlang.cli.complaints import complain, unreadable, unwritten
from motionlang.cli.golden import MOST_DIFFERENCES, differences, golden_files, same, update
from motionlang.errors import ProgramError
from motionlang.scenarios import Scenario, scenario_files, unmet
from motionlang.source import Source
from motionlang.sweeps import KEEP, Sweep
from motionlang.sweeps.description import SUFFIX as SWEEP_SUFFIX
from motionlang.sweeps.description import read_description

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from motionlang.result import Run


class Besides:
    """How many scenarios and sweeps there were, and how many of them failed."""

    __slots__ = ("failed", "scenarios", "sweeps")

    def __init__(self) -> None:
        self.failed = {"scenario": 0, "sweep": 0}
        self.scenarios = self.sweeps = 0

    def summary(self) -> str:
        """What is said of them behind the programs; nothing where there are none."""
        parts = []
        for name, count in (("scenario", self.scenarios), ("sweep", self.sweeps)):
            if count:
                parts.append(f"{count - self.failed[name]} of {count} {name}s")
        return "".join(f", {part}" for part in parts)

    def check(self, program: str, rewrite: bool) -> None:
        """Check, or write anew, what lies beside one program; whatever is wrong is told."""
        for path in scenario_files(program):
            self.scenarios += 1
            self.failed["scenario"] += _guarded(path, partial(_scenario, program, path, rewrite))
        path = os.path.splitext(program)[0] + SWEEP_SUFFIX
        if os.path.isfile(path):
            self.sweeps += 1
            self.failed["sweep"] += _guarded(path, partial(_sweep, program, path, rewrite))


def expectations(result: Run) -> list[str]:
    """What a run of the program on its own machine did not do of what the machine file expects."""
    expected = result.machine.settings.get("expect", [])
    return unmet(result, expected) if expected else []  # type: ignore[arg-type]


def tell(name: str, found: Sequence[str]) -> bool:
    """Say what differs; whether anything did."""
    if found:
        sys.stdout.write(f"{name}: differs\n")
        sys.stdout.writelines(f"  {each}\n" for each in found[:MOST_DIFFERENCES])
        if len(found) > MOST_DIFFERENCES:
            sys.stdout.write(f"  and {len(found) - MOST_DIFFERENCES} more\n")
    return bool(found)


def _guarded(path: str, work: Callable[[], bool]) -> bool:
    """Whether something failed; a file that cannot be read or is wrong is told as such."""
    try:
        return work()
    except OSError as error:
        complain([unreadable(str(error.filename or path), error)], None, path)
    except ProgramError as error:
        complain(error.diagnostics, Source.read(path), path)
    except ValueError as error:
        sys.stdout.write(f"{path}: {error}\n")
    return True


def _scenario(program: str, path: str, rewrite: bool) -> bool:
    """A scenario is as expected, and as its golden files say where it has any."""
    scenario = Scenario(program, path)
    result = scenario.run()
    found = unmet(result, scenario.expected)
    golden = os.path.exists(golden_files(path)[0])
    if rewrite:
        try:
            if update(path, result):
                sys.stdout.write(f"{path}: written\n")
        except OSError as error:
            complain([unwritten(str(error.filename), error)], None, path)
            return True
    elif golden:
        found += differences(path, result)
    elif not scenario.expected:
        found.append("it expects nothing, and has no golden file: write [[expect]], or --update")
    return tell(path, found)


def _sweep(program: str, path: str, rewrite: bool) -> bool:
    """The rows of a sweep are those of its golden file."""
    wishes = read_description(path)
    worlds = wishes.worlds()
    sweep = Sweep(
        program,
        wishes.space(worlds),
        keep=tuple(wishes.keep) or KEEP,
        worlds=worlds,
        until=wishes.until,
        prove=wishes.prove,
    )
    names = ["variant", *sweep.space.names, *sweep.job.keep, "problem"]
    rows = [
        [str(cell) for cell in (index, *sweep.space[index], *kept, problem["message"] if problem else "")]
        for index, kept, problem in sorted(sweep.results(), key=lambda row: row[0])
    ]
    golden = sweep_golden(path)
    if rewrite:
        return _write(golden, names, rows)
    if not os.path.exists(golden):
        return tell(path, [f"no {os.path.basename(golden)} beside it; --update writes one"])
    with open(golden, encoding="utf-8", newline="") as file:
        expected = list(csv.reader(file))
    found = [] if expected[:1] == [names] else [f"its columns are {', '.join(names)}"]
    if len(expected) - 1 != len(rows):
        found.append(f"it has {len(rows)} variants instead of {len(expected) - 1}")
    for old, new in zip(expected[1:], rows, strict=False):
        for name, was, is_ in zip(names, old, new, strict=False):
            if not _same(was, is_):
                found.append(f"variant {new[0]}: {name} is {is_} instead of {was}")
    return tell(path, found)


def _same(was: str, found: str) -> bool:
    try:
        return same(float(was), float(found))
    except ValueError:
        return was == found


def sweep_golden(path: str) -> str:
    """Where the rows of a sweep are kept."""
    return path.removesuffix(".toml") + ".golden.csv"


def _write(golden: str, names: list[str], rows: list[list[str]]) -> bool:
    from motionlang.files import replacing

    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows([names, *rows])
    try:
        if os.path.exists(golden):
            with open(golden, encoding="utf-8", newline="") as file:
                if file.read() == text.getvalue():
                    return False
        with replacing(golden, only_copy=True) as out:
            out.write(text.getvalue().encode())
    except OSError as error:
        complain([unwritten(str(error.filename), error)], None, golden)
        return True
    sys.stdout.write(f"{golden}: written\n")
    return False
