"""Comparison of two runs of a shift of 20 000 moves: reports, motion, command.

`diff_command` is the CPU time of `motionlang diff shift.mnt way.mnt` with both programs already compiled;
`diff_command_by_run` is its ratio to the time of `motionlang run shift.mnt`.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path
from time import process_time

from shift import PROGRAM
from start import command, seconds

from motionlang.analysis.diff.motion import divergence
from motionlang.analysis.diff.reports import difference
from motionlang.execution import run
from motionlang.report import build
from motionlang.source import Source
from motionlang.views.diff import diff_lines

ROUNDS = 3
# The program unchanged, with an inserted line, with another rate in every move, and with another distance in
# every other one.
CHANGES = {
    "same": PROGRAM,
    "line": f"' a remark\n{PROGRAM}",
    "rate": PROGRAM.replace("ACCEL(0, 1, 2, 3) = 500;", "ACCEL(0, 1, 2, 3) = 500, 600;"),
    "way": PROGRAM.replace("20, 30, 40, 35", "20, 30, 41, 35"),
}


def main() -> None:
    """Print `name value unit` lines; the best of some rounds, in CPU time."""
    old = run(Source("shift.mnt", PROGRAM), cache=False)
    old_report = build(old)
    for name, program in CHANGES.items():
        new = run(Source("shift.mnt", program), cache=False)
        new_report = build(new)
        best = {"reports": float("inf"), "motion": float("inf")}
        lines: list[str] = []
        for _ in range(ROUNDS):
            began = process_time()
            lines = diff_lines(difference(old_report, new_report))
            best["reports"] = min(best["reports"], process_time() - began)
            began = process_time()
            divergence(old, new)
            best["motion"] = min(best["motion"], process_time() - began)
        print(f"diff_{name}_reports {best['reports']:.2f} s")
        print(f"diff_{name}_motion {best['motion']:.2f} s")
        print(f"diff_{name}_lines {len(lines)} lines")
    for figure in whole():
        print(figure)


def whole() -> list[str]:
    """Return the figures of complete processes: a comparison, and a run alone."""
    with tempfile.TemporaryDirectory() as folder:
        environment = {**os.environ, "MOTIONLANG_CACHE": folder, "PYTHONPYCACHEPREFIX": f"{folder}/pyc"}
        environment.pop("PYTHONDONTWRITEBYTECODE", None)
        for name, program in (("shift", PROGRAM), ("way", CHANGES["way"])):
            Path(folder, f"{name}.mnt").write_text(program, encoding="utf-8")
        run_alone = [*command(), "run", f"{folder}/shift.mnt"]
        compare = [*command(), "diff", f"{folder}/shift.mnt", f"{folder}/way.mnt"]
        taken = [
            (seconds(run_alone, environment), seconds(compare, environment, (1,))) for _ in range(ROUNDS + 1)
        ][1:]  # the first writes bytecode and fills the cache
    best = min(both for _, both in taken)
    ratio = sorted(both / alone for alone, both in taken)[ROUNDS // 2]
    return [f"diff_command {best:.2f} s", f"diff_command_by_run {ratio:.1f} x"]


if __name__ == "__main__":
    main()
