"""Print what one DAC step demands of a motor, and the effect of the override of chapter 12.

With the name of a .svg or .png file, the example draws the start of each run, too.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

from motionlang.kernel.tools import count_of
from motionlang.views.table import filled
from tests.lab.notes.vendor.dac_override import OverrideRun, demonstrate
from tests.lab.notes.vendor.dissect import dac_timing
from tests.lab.notes.vendor.figures import LIMIT, SPEED

if TYPE_CHECKING:
    from motionlang.views.table import Cells

TIMINGS: Cells = {
    "DAC": lambda timing: f"{timing.bits} bits",
    "steps": lambda timing: f"±{timing.steps}",
    "one step, ft/min": lambda timing: f"{timing.step_speed * 60.0:.9g}",
    "takes at least, µs": lambda timing: f"{timing.step_time * 1e6:.4f}",
    "time constant, µs": lambda timing: f"{timing.electrical_time_constant * 1e6:.4f}",
    "hold, µs": lambda timing: f"{timing.hold_time * 1e6:.4f}",
}
RUNS: Cells = {
    "<DAC": lambda run: run.name,
    "<override": lambda run: f"{count_of(run.steps, 'step')}, held {run.hold}" if run.steps else "none",
    "onset, × limit": lambda run: f"{run.onset / run.limit:.3f}",
    "over an update, × limit": lambda run: f"{run.mean / run.limit:.3f}",
    "slid, ft": lambda run: f"{run.slid:.6f}",
    "largest error, ft": lambda run: f"{run.error:.6f}",
}


def draw(runs: list[OverrideRun], path: str) -> None:
    """Draw the first 60 ms of each run: acceleration against the limit, and the DAC in steps of 12 bits."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 8.4), layout="constrained")
    grid = figure.subplots(len(runs), 2, sharex=True, sharey="col", width_ratios=(1.6, 1.0))
    for (left, right), run in zip(grid, runs, strict=True):
        trace = run.trace
        early = trace.time < 0.06
        time, scale = trace.time[early] * 1000.0, float(abs(trace.onset).max()) / run.onset
        left.vlines(time, 0.0, trace.onset[early] / scale, color="tab:red")
        left.axhline(run.limit, color="black", linestyle="--")
        left.axhline(-run.limit, color="black", linestyle="--")
        left.set_ylabel(f"{run.name}\nacceleration (ft/s²)")
        steps = trace.output[early] / trace.loop.dac_step * 2.0 ** (12 - run.bits)
        right.step(time, steps, where="post")
        right.set_ylabel("DAC (12-bit steps)")
    grid[-1][0].set_xlabel("time (ms); dashed: beyond this the load slips")
    grid[-1][1].set_xlabel("time (ms)")
    figure.savefig(path)


runs = demonstrate()
print(*filled(TIMINGS, [dac_timing(SPEED, LIMIT, bits) for bits in (12, 16)], width=120), sep="\n")
print("", *filled(RUNS, runs, width=120), sep="\n")
print(f"\nlimit {LIMIT:.7g} ft/s²; beyond it the load slips")
for path in sys.argv[1:]:
    draw(runs, path)
