"""Pictures as texts: what the package hands to matplotlib, call by call.

Nothing that matplotlib computes is in them, so they are the same with every version of it.
"""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Callable, Iterator, Mapping
from functools import wraps
from types import FunctionType
from typing import IO, Any

from tests.generated.command_lines import motor
from tests.generated.draw import Draw

# Numbers of a series in the text; longer series are sampled evenly.
POINTS = 48


@contextlib.contextmanager
def described() -> Iterator[None]:
    """Let figures write the package's calls of their methods instead of an image within the context."""
    from matplotlib.artist import Artist
    from matplotlib.axes import Axes
    from matplotlib.collections import LineCollection
    from matplotlib.figure import Figure
    from matplotlib.patches import FancyBboxPatch, Patch, Rectangle
    from mpl_toolkits.mplot3d.art3d import Line3DCollection
    from mpl_toolkits.mplot3d.axes3d import Axes3D

    calls: list[str] = []
    numbers: dict[int, int] = {}
    drawn: list[object] = []  # keeps what has a number alive
    saved: list[tuple[type, str, FunctionType]] = []

    def name_of(value: Any) -> str:
        kind = next((each for each in (Axes, Figure) if isinstance(value, each)), Artist)
        return f"{kind.__name__} {numbers.setdefault(id(value), len(numbers) + 1)}"

    def recorded(method: FunctionType) -> Callable[..., Any]:
        @wraps(method)
        def call(self: Any, *arguments: Any, **options: Any) -> Any:
            if sys._getframe(1).f_globals["__name__"].startswith("motionlang."):
                drawn.append(self)
                given = [*map(shown, arguments), *(f"{each}={shown(options[each])}" for each in options)]
                calls.append(f"{name_of(self)}.{method.__name__}({', '.join(given)})")
            return method(self, *arguments, **options)

        return call

    def shown(value: Any) -> str:
        return name_of(value) if isinstance(value, Artist) else _shown(value)

    def record(kind: type, name: str, method: FunctionType) -> None:
        saved.append((kind, name, method))
        setattr(kind, name, recorded(method))

    def save(figure: Figure, file: IO[bytes], **options: object) -> None:
        size = " by ".join(f"{each:g}" for each in figure.get_size_inches())
        file.write("".join(f"{line}\n" for line in [size, *calls]).encode())
        calls.clear()
        numbers.clear()
        drawn.clear()

    for kind in dict.fromkeys((*Axes3D.__mro__, *Axes.__mro__, *Figure.__mro__)):
        for name, method in list(vars(kind).items()):
            if isinstance(method, FunctionType) and not name.startswith("_"):
                record(kind, name, method)
    for kind in (LineCollection, Line3DCollection, Rectangle, FancyBboxPatch, Patch):
        record(kind, "__init__", kind.__init__)  # type: ignore[arg-type]
    Figure.savefig = save  # type: ignore[method-assign,assignment]
    try:
        yield
    finally:
        for kind, name, method in saved:
            setattr(kind, name, method)


def _shown(value: Any) -> str:
    """Return an argument as a text; series are sampled."""
    if isinstance(value, str | bool | int | float) or value is None:
        return f"{value:.9g}" if isinstance(value, float) else repr(value)
    if isinstance(value, Mapping):
        return f"{{{', '.join(f'{name}: {_shown(each)}' for name, each in value.items())}}}"
    if hasattr(value, "tolist"):
        value = value.tolist()
        if not isinstance(value, list):
            return _shown(value)
    if isinstance(value, list | tuple):
        step = len(value) / POINTS
        sampled = value if step <= 1.0 else [value[int(n * step)] for n in range(POINTS)] + [value[-1]]
        return f"{len(value)}: [{', '.join(map(_shown, sampled))}]"
    return "an object"


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
