"""The description of a picture: a figure of panels with curves, shades and texts.

A view makes a `Figure` from a result; `figure_files` writes it. Lengths on the paper are in points.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

INK, FAINT, AXIS = "#1c2733", "#6b7785", "#9aa6b2"
BLUE, GREEN, RED, VIOLET = "#1f5fae", "#0b7a5b", "#b4490f", "#6b4fa0"
COLOURS = (BLUE, GREEN, RED, VIOLET)
# A colour map, as colours at equal distances from the lowest value to the highest.
TURBO = "30123b 4454c4 448ffe 1fc9dd 2aefa1 7dff56 c1f334 f1cb3a fe932a ea4e0d be2102 7a0403"

Marker = Literal["", "circle", "diamond", "star", "arrow", "arrows"]


@dataclass(frozen=True)
class Curve:
    """Points joined by a line; `width` 0 draws their markers alone.

    With `is_stepped`, a value holds until the next. The marker "arrow" is at the end, "arrows" at both ends.
    """

    x: Sequence[float]
    y: Sequence[float]
    colour: str
    name: str = ""
    width: float = 1.6
    opacity: float = 1.0
    is_dashed: bool = False
    is_stepped: bool = False
    marker: Marker = ""
    size: float = 3.0


@dataclass(frozen=True)
class Area:
    """A filled polygon."""

    x: Sequence[float]
    y: Sequence[float]
    colour: str


@dataclass(frozen=True)
class Band:
    """A shade over the height of a panel, at least a point wide."""

    begin: float
    end: float
    colour: str


@dataclass(frozen=True)
class PanelLabel:
    """A text above a panel, centred between two x: the first of `texts` that fits."""

    begin: float
    end: float
    texts: tuple[str, ...]


@dataclass(frozen=True)
class MarkedTime:
    """A dashed vertical line with a name at its foot; "" draws the line alone."""

    x: float
    text: str


@dataclass(frozen=True)
class Note:
    """A text at a point of a panel; `side` is the side of the text at which the point is."""

    x: float
    y: float
    text: str
    colour: str = INK
    side: Literal["start", "middle", "end"] = "middle"
    size: float = 8.0


@dataclass(frozen=True)
class Lane:
    """A digital channel and the spans in which it is on."""

    name: str
    spans: Sequence[tuple[float, float]]


@dataclass(frozen=True)
class Panel:
    """One pair of axes; a panel with `lanes` has nothing else.

    `title` is above it at the left, `remark` at the right. Without limits the data decides, with a margin above
    and below. `has_zero` draws a line at 0. `is_equal` gives x and y one scale.
    """

    curves: Sequence[Curve] = ()
    label: str = ""
    unit: str = ""
    title: str = ""
    remark: str = ""
    height: float = 137.0
    areas: Sequence[Area] = ()
    bands: Sequence[Band] = ()
    labels: Sequence[PanelLabel] = ()
    events: Sequence[MarkedTime] = ()
    notes: Sequence[Note] = ()
    lanes: Sequence[Lane] = ()
    x_limits: tuple[float, float] | None = None
    y_limits: tuple[float, float] | None = None
    has_zero: bool = False
    is_equal: bool = False


@dataclass(frozen=True)
class ColourScale:
    """A range of values and its colours."""

    label: str
    low: float
    high: float
    colours: str

    def colour(self, value: float) -> str:
        """Return the colour of a value, as #rrggbb."""
        stops = self.colours.split()
        share = (value - self.low) / ((self.high - self.low) or 1.0)
        at = min(max(share, 0.0), 1.0) * (len(stops) - 1)
        left = min(int(at), len(stops) - 2)
        pairs = [(int(stops[left][i : i + 2], 16), int(stops[left + 1][i : i + 2], 16)) for i in (0, 2, 4)]
        return "#" + "".join(f"{round(a + (b - a) * (at - left)):02x}" for a, b in pairs)


@dataclass(frozen=True)
class Figure:
    """Rows of panels; the panels of a column have one x axis.

    `legend` has colours and their names, `has_shared_y` gives the panels of a row one y axis.
    """

    rows: Sequence[Sequence[Panel]]
    x_label: str = ""
    title: str = ""
    subtitle: str = ""
    legend: Sequence[tuple[str, str]] = ()
    scale: ColourScale | None = None
    width: float = 792.0
    has_shared_y: bool = False


def named(name: str, unit: str) -> str:
    """Return a name with its unit in brackets, if it has one."""
    return f"{name} ({unit})" if unit else name
