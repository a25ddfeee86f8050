"""Print TN1069's comparison of four velocity profiles: that of the note with its misprints, and another move's.

With the name of a .svg or .png file, the example draws the profiles of the note, too.
"""

from __future__ import annotations

import sys
import textwrap
from operator import itemgetter

from motionlang.views.table import Column, Table
from tests.lab.notes.vendor.tn1069 import ERRATA, NOTE, Demand, comparison, profiles

MEANINGS = {
    "T_A": "acceleration time",
    "S_A": "acceleration distance",
    "T_D": "deceleration time",
    "S_D": "deceleration distance",
    "S_V": "slew distance",
    "T_V": "slew time",
    "peak": "peak velocity",
    "the whole move": "duration",
}


def table(demand: Demand) -> list[str]:
    """Return the table of a move, with the printed figures where the note has them."""
    rows = []
    for row in comparison(demand):
        exact = ["none" if value is None else f"{value:.10g}" for value in row.exact]
        rows.append([row.name, MEANINGS[row.name], *exact, row.unit])
        if row.printed:
            rows.append(["", "as printed", *(f"{value:.10g}" for value in row.printed), ""])
    titles = ["", "", *demand.columns, ""]
    columns = [Column("", title, get=itemgetter(k), left=not title) for k, title in enumerate(titles)]
    return Table("figures", columns, rows).lines(1000)


def show(demand: Demand) -> None:
    """Print the figures of a move and its table."""
    slowing = "" if demand.symmetric else f"D = {demand.deceleration:.10g} counts/s², "
    print(
        f"A = {demand.acceleration:.10g} counts/s², {slowing}V = {demand.velocity:.10g} counts/s, "
        f"S = {demand.distance:.10g} counts; 1000 cycles per second\n"
    )
    print(*table(demand), "", sep="\n")


def draw(path: str) -> None:
    """Draw position, velocity and acceleration of the four profiles into a file."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(10.0, 7.0), layout="constrained")
    panels = figure.subplots(3, 1, sharex=True)
    for name, profile in zip(NOTE.columns, profiles(), strict=True):
        end = profile.duration
        times = [-1e-9, *(end * k / 1000.0 for k in range(1001)), end + 1e-9]
        for panel, curve in zip(
            panels, (profile.position, profile.velocity, profile.acceleration), strict=True
        ):
            panel.plot(times, [curve(time) for time in times], label=name)
    for panel, label in zip(
        panels, ("position (counts)", "velocity (counts/s)", "acceleration (counts/s²)"), strict=True
    ):
        panel.set_ylabel(label)
    panels[0].legend()
    panels[-1].set_xlabel("time (s)")
    figure.savefig(path)


print("TN1069: one move in four profiles")
show(NOTE)
print("the printed figure is wrong")
for number, erratum in enumerate(ERRATA, 1):
    print(textwrap.fill(erratum, 100, initial_indent=f"{number}. ", subsequent_indent="   "))
print("\nanother move")
show(Demand(acceleration=200.0, deceleration=100.0, velocity=50.0, distance=1000.0, ramp=0.25))
for path in sys.argv[1:]:
    draw(path)
