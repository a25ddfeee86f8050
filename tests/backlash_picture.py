"""Drawing of docs/images/backlash.png: `python -m tests.backlash_picture`.

It needs the extra `plot`. The motor curve is the value of ENCODER while the program runs. The load curve is
computed from it: the motor pushes the load with one flank of the backlash or the other.
"""

from __future__ import annotations

from pathlib import Path

from motionlang.execution import run
from motionlang.source import Source
from motionlang.views.servo_plot import drawing

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


def main() -> None:
    """Draw the picture."""
    with drawing(str(PICTURE), 9.0, 4.0) as figure:
        panels = figure.subplots(1, 2, sharey=True)
        for axes, mode, title in zip(panels, (0, 1), ("without compensation", "BACKLASHMODE 1"), strict=True):
            times, positions = motor(mode)
            axes.plot(times, positions, label="motor (ENCODER)")
            axes.plot(times, load(positions), label="load", linestyle="--")
            for goal in (200.0, 400.0):
                axes.axhline(goal, color="0.7", linewidth=0.8, zorder=0)
            axes.set(title=title, xlabel="ms", xlim=(0, 700))
            axes.legend(frameon=False, loc="lower right")
        panels[0].set_ylabel("counts")


if __name__ == "__main__":
    main()
