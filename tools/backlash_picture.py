"""Drawing of docs/images/backlash.png: `python -m tools.backlash_picture`.

It needs the extra `plot`. The motor curve is the value of ENCODER while the program runs. The load curve is
computed from it: the motor pushes the load with one flank of the backlash or the other.
"""

from __future__ import annotations

from pathlib import Path

from motionlang.kernel.execution import run
from motionlang.kernel.source import Source
from motionlang.views.figure import AXIS, BLUE, RED, Curve, Figure, Panel
from motionlang.views.figure_files import write_figure

PICTURE = Path(__file__).parent.parent / "docs" / "images" / "backlash.png"
PLAY = 24.0
PROGRAM = """BACKLASH(0) = {play} : BACKLASHMODE(0) = {mode}
SPEED(0) = 2000 : ACCEL(0) = 20000 : DECEL(0) = 20000
MOVEBUFFERSIZE(0) = 5 : MOVEA(0) = 400 : MOVEDWELL(0) = 100 : MOVEA(0) = 200 : GO(0)
While TIME < 700
PRINT TIME, " ", ENCODER(0)
WAIT 1
End While
"""


def motor(mode: int) -> tuple[list[float], list[float]]:
    """Return the times, ms, and the positions of the motor, counts."""
    program = PROGRAM.format(play=PLAY, mode=mode)
    rows = [line.split() for line in run(Source("play.mnt", program)).output]
    return [float(time) for time, _ in rows], [float(position) for _, position in rows]


def load(positions: list[float]) -> list[float]:
    """Return the positions of the load for those of the motor, counts.

    The load rests until the motor is a full backlash above it or falls below it, and then moves with the
    motor.
    """
    found, here = [], 0.0
    for position in positions:
        here = min(max(here, position - PLAY), position)
        found.append(here)
    return found


def panel(mode: int, title: str) -> Panel:
    """Return the motor and the load, and the ends of the moves."""
    times, positions = motor(mode)
    goals = [Curve([0.0, 700.0], [goal, goal], AXIS, width=0.8) for goal in (200.0, 400.0)]
    curves = [
        Curve(times, positions, BLUE, "motor (ENCODER)"),
        Curve(times, load(positions), RED, "load", is_dashed=True),
    ]
    return Panel([*curves, *goals], "counts", title=title, height=220.0, x_limits=(0.0, 700.0))


def main() -> None:
    """Draw the picture."""
    panels = [panel(0, "without compensation"), panel(1, "BACKLASHMODE 1")]
    write_figure(Figure([panels], x_label="ms", width=648.0, has_shared_y=True), str(PICTURE))


if __name__ == "__main__":
    main()
