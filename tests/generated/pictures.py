"""Pictures as texts: what the package hands to the writer of figures."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any
from unittest.mock import patch

from motionlang.views import figure_files
from tests.generated.command_lines import motor
from tests.generated.draw import Draw

# Numbers of a series in the text; longer series are sampled evenly.
POINTS = 48


@contextlib.contextmanager
def described() -> Iterator[None]:
    """Let .svg files have the description of a figure instead of the picture within the context."""
    with patch.object(figure_files, "svg", lambda figure: f"{_shown(figure)}\n"):
        yield


def _shown(value: Any) -> str:
    """Return a value as a text: series are sampled, and each part of a figure has a line."""
    if is_dataclass(value):
        given = {each.name: getattr(value, each.name) for each in fields(value)}
        told = ", ".join(
            f"{name}={_shown(each)}" for name, each in given.items() if each not in ((), "", None)
        )
        return f"\n{type(value).__name__}({told})"
    if isinstance(value, list | tuple):
        step = len(value) / POINTS
        sampled = value if step <= 1.0 else [value[int(n * step)] for n in range(POINTS)] + [value[-1]]
        return f"{len(value)}: [{', '.join(map(_shown, sampled))}]"
    return f"{value:.9g}" if isinstance(value, float) else repr(value)


def picture_line(seed: int) -> list[str]:
    """Return the arguments of a command that draws `a.svg` and needs no program."""
    draw = Draw(seed)
    positions = ",".join(str(draw.randrange(-2000, 9000, 100)) for _ in range(draw.randrange(3, 7)))
    drive = [f"--positions={positions}", "--time", str(draw.randrange(5, 60))]
    distance, time, ramp = (
        draw.randrange(20, 90),
        draw.randrange(1, 4),
        draw.choice(("0.1", "0.3", "0.6")),
    )
    lines = (
        ["pvt", "plot", *drive, "--velocities", draw.choice(("zero", "average", "exact"))],
        ["servo", "step", "--size", f"{distance}0", "--time", "0.05"],
        ["servo", "step", *motor(draw), "--time", "0.05"],
        ["pvt", "plot", *drive, "--linear"],
        ["pvt", "refine", *drive, "--compare", "1,2,4"],
        [
            "plan",
            "--distance",
            str(distance),
            "--time",
            str(time),
            "--rule",
            draw.choice(("third", "quarter")),
        ],
        [
            "plan",
            "--distance",
            str(distance),
            "--time",
            str(time),
            "--accel-time",
            ramp,
            "--decel-time",
            "0.2",
        ],
        ["servo", "compare", *motor(draw)],
        ["pvt", "refine", *drive],
        ["servo", "step", "--plant", f"coulomb=0.00{ramp[-1]}", "--time", "0.05"],
    )
    return [*lines[seed % len(lines)], "--plot", "a.svg"]
