"""Run the C program at the end of chapter 12 on the drive of the book, and print some of its updates.

With the name of a .svg or .png file, the example draws the run, too.
"""

from __future__ import annotations

import sys

from motionlang.views.table import filled
from tests.lab.notes.vendor.chapter12 import EXAMPLE, ListingRun, run_listing


def tidy(value: float) -> float:
    """Return 0.0 for what is only rounding noise, so that no minus sign appears."""
    return 0.0 if abs(value) < 5e-4 else value


def draw(made: ListingRun, path: str) -> None:
    """Draw position, velocity and DAC of each update into a file."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 5.4), layout="constrained")
    first, second, third = figure.subplots(3, 1, sharex=True)
    first.plot(made.demand, label="demand")
    first.plot(made.position, label="motor")
    first.legend()
    first.set_ylabel("position (counts)")
    second.plot(made.velocity)
    second.set_ylabel("velocity (counts/update)")
    third.step(range(len(made.dac)), made.dac, where="post")
    third.set(xlabel="update", ylabel="DAC (steps)")
    figure.savefig(path)


made = run_listing()
last = len(made.demand) - 1
updates = sorted({0, 1, 2, *(round(last * k / 10) for k in range(11))})
print(
    *filled(
        {
            "update": str,
            "demand, counts": lambda k: str(made.demand[k]),
            "position, counts": lambda k: f"{tidy(made.position[k]):.2f}",
            "velocity, counts/update": lambda k: f"{tidy(made.velocity[k]):.3f}",
            "DAC, steps": lambda k: str(made.dac[k]),
        },
        updates,
        width=120,
    ),
    sep="\n",
)
print(
    f"\ndemanded acceleration {EXAMPLE.accel / EXAMPLE.hold:.7g} counts/update²; largest over an update "
    f"{made.peak_mean:.7g}, just after a DAC change {made.peak_onset:.7g}"
)
for path in sys.argv[1:]:
    draw(made, path)
