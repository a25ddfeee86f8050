"""What `run --profile` costs on a shift: eight hours run and reported, without and with where the time went.

The ratios are of the best of several interleaved rounds, in CPU time; the collector rests, as in a process of its own.
"""

from __future__ import annotations

import gc
from itertools import pairwise
from time import process_time

from shift import PROGRAM

from motionlang.cycle.profile import TimeProfile
from motionlang.execution import run
from motionlang.report import text
from motionlang.source import Source
from motionlang.views.cycle import render_profile
from motionlang.views.table import render

ROUNDS = 9


def main() -> None:
    """Print `name value unit` lines."""
    best = dict.fromkeys(("run", "table", "json", "profile"), float("inf"))
    for _ in range(ROUNDS):
        gc.collect()
        gc.disable()
        marks = [process_time()]
        ran = run(Source("shift.mnt", PROGRAM), cache=False)
        marks.append(process_time())
        render(ran)
        marks.append(process_time())
        text(ran)
        marks.append(process_time())
        render_profile(TimeProfile(ran))
        marks.append(process_time())
        gc.enable()
        for name, (begin, end) in zip(best, pairwise(marks), strict=True):
            best[name] = min(best[name], end - begin)
    print(f"cycle_profile {best['profile']:.3f} s")
    print(f"cycle_by_run_and_table {1.0 + best['profile'] / (best['run'] + best['table']):.3f} x")
    print(f"cycle_by_run_and_json {1.0 + best['profile'] / (best['run'] + best['json']):.3f} x")


if __name__ == "__main__":
    main()
