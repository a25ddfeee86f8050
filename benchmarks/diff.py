"""What a change did to a shift: two runs of 20 000 moves compared, their reports and their motion."""

from __future__ import annotations

from time import process_time

from shift import PROGRAM

from motionlang.diff.motion import parting
from motionlang.diff.reports import difference
from motionlang.execution import run
from motionlang.report import build
from motionlang.source import Source
from motionlang.views.diff import diff_lines

ROUNDS = 3
# The program as it is, with a line put in, with another rate in every move, and with another way in every other one.
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
            parting(old, new)
            best["motion"] = min(best["motion"], process_time() - began)
        print(f"diff_{name}_reports {best['reports']:.2f} s")
        print(f"diff_{name}_motion {best['motion']:.2f} s")
        print(f"diff_{name}_lines {len(lines)} lines")


if __name__ == "__main__":
    main()
