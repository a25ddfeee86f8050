"""The layout of a figure: shapes and texts with their positions on the paper.

Every medium draws the same shapes, so a picture is the same in all of them. Positions are in points from the upper
left corner. The widths of texts are estimates, because a file does not know the fonts of its reader.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby, pairwise
from math import atan2, ceil, cos, floor, fsum, log10, pi, sin

from motionlang.views.figure import AXIS, FAINT, INK, Curve, Figure, Panel

Point = tuple[float, float]
Limits = tuple[float, float]

# The gap between two labels, the margin of the picture and the height of a lane, in points.
GAP, MARGIN, LANE = 3.0, 12.0, 19.0
# The most points of a curve in each half point of its panel's width.
DENSITY = 4
GRID, ON, EVENT = "#dfe4e9", "#658ab1", "#b3261e"


@dataclass(frozen=True)
class Shape:
    """Lines or, with `fill`, polygons."""

    paths: Sequence[Sequence[Point]]
    stroke: str = ""
    width: float = 0.8
    fill: str = ""
    opacity: float = 1.0
    is_dashed: bool = False


@dataclass(frozen=True)
class TextLine:
    """A line of text; `y` is its base line, `is_upright` turns it by 90 degrees."""

    x: float
    y: float
    text: str
    size: float = 8.0
    colour: str = INK
    side: str = "middle"
    is_bold: bool = False
    is_upright: bool = False


Item = Shape | TextLine


def layout(figure: Figure) -> tuple[float, float, list[Item]]:
    """Return the width and the height of a picture and its shapes, the lowest first."""
    columns = list(zip(*figure.rows, strict=True))
    across = [_across(column) for column in columns]
    items: list[Item] = []
    left, right = _side(figure), 76.0 if figure.scale else MARGIN
    first = left if figure.has_shared_y else 0.0
    step = (figure.width - first - right) / len(columns)
    between = 10.0 if len(columns) > 1 else 0.0
    top = _head(figure, left, items)
    ends: list[_Axes] = []
    for row in figure.rows:
        top += max(map(_above, row))
        height = max(map(_height, row))
        up = [_limits(panel) for panel in row]
        if figure.has_shared_y:
            up = [(min(low for low, _ in up), max(high for _, high in up))] * len(row)
        ends = []
        for n, panel in enumerate(row):
            across_box = n * step + left, first + (n + 1) * step - between
            box = _Axes(panel, n * step, across_box, (top, top + height), across[n], up[n])
            items += box.items(has_names=n == 0 or not figure.has_shared_y)
            ends.append(box)
        top += height + 5.0
    for box in ends:
        items += box.times(figure.x_label)
    if figure.scale is not None:
        items += _scale(figure, ends[0])
    return figure.width, top + 30.0, items


def _head(figure: Figure, left: float, items: list[Item]) -> float:
    """Add title and legend; return the height that they take."""
    if figure.title:
        items.append(TextLine(left, 26.0, figure.title, 14.0, side="start", is_bold=True))
    if figure.subtitle:
        items.append(TextLine(left, 42.0, figure.subtitle, 9.0, FAINT, "start"))
    end = figure.width - MARGIN
    for colour, name in reversed(figure.legend):
        items.append(TextLine(end, 24.0, name, 8.5, FAINT, "end"))
        end -= text_width(name, 8.5) + 14.0
        items.append(_box(end + 2.0, 16.0, end + 11.0, 25.0, colour))
        end -= 8.0
    return 50.0 if figure.subtitle else 32.0 if figure.title or figure.legend else 8.0


def _side(figure: Figure) -> float:
    """Return the width of the texts at the left of the panels."""
    panels = [panel for row in figure.rows for panel in row]
    widest = max(text_width(text) for panel in panels for text in _names(panel))
    lines = max(bool(panel.label) + bool(panel.unit) for panel in panels)
    return MARGIN + widest + 6.0 + 12.0 * lines


def _names(panel: Panel) -> list[str]:
    if panel.lanes:
        return [lane.name for lane in panel.lanes]
    return _up_ticks(_limits(panel), panel.height).names


def _above(panel: Panel) -> float:
    return 6.0 + 22.0 * bool(panel.title) + 9.0 * bool(panel.labels or panel.remark)


def _height(panel: Panel) -> float:
    return LANE * len(panel.lanes) + 6.0 if panel.lanes else panel.height


def _across(panels: Iterable[Panel]) -> Limits:
    """Return the limits of the x axis of a column."""
    given = [panel.x_limits or _with_room(_range(_values(panel, "x")), 0.025) for panel in panels]
    return min(low for low, _ in given), max(high for _, high in given)


def _limits(panel: Panel) -> Limits:
    if panel.lanes:
        return 0.0, 1.0
    if panel.y_limits is not None:
        return panel.y_limits
    values = _values(panel, "y")
    return _with_room((min(values, default=0.0), max(values, default=0.0)), 0.08)


def _with_room(limits: Limits, share: float) -> Limits:
    low, high = limits
    room = share * ((high - low) or abs(high) or 1.0)
    return low - room, high + room


def _range(values: Sequence[float]) -> Limits:
    low, high = min(values, default=0.0), max(values, default=1.0)
    return (low, high) if low < high else (low - 0.5, high + 0.5)


def _values(panel: Panel, name: str) -> list[float]:
    drawn = (*panel.curves, *panel.areas)
    return [float(value) for each in drawn for value in getattr(each, name)]


def _up_ticks(limits: Limits, height: float) -> Ticks:
    return Ticks(*limits, max(6, int(height / 40.0)))


class Ticks:
    """Round values within limits, and their texts; `power` is the power of ten left out of these."""

    def __init__(self, low: float, high: float, most: int) -> None:
        rough = (high - low) / most
        ten = 10.0 ** floor(log10(rough))
        step = next(ten * each for each in (1.0, 2.0, 2.5, 5.0, 10.0) if ten * each >= rough * (1.0 - 1e-9))
        first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
        self.values = [n * step for n in range(first, last + 1)]
        largest = max(abs(low), abs(high))
        self.power = 0 if 1e-3 <= largest < 1e6 else floor(log10(largest))
        unit = step / 10.0**self.power
        digits = next((n for n in range(12) if abs(unit * 10**n - round(unit * 10**n)) < 1e-6), 12)
        self.names = [self._text(value / 10.0**self.power, digits) for value in self.values]

    @staticmethod
    def _text(value: float, digits: int) -> str:
        text = f"{value:.{digits}f}"
        return text.replace("-", "−") if float(text) else f"{0.0:.{digits}f}"


class _Axes:
    """A panel in its place."""

    def __init__(
        self, panel: Panel, origin: float, across: Limits, down: Limits, x: Limits, y: Limits
    ) -> None:
        self.panel, self.origin, self.x, self.y = panel, origin, x, y
        self.left, self.right = across
        self.top, self.bottom = down
        if panel.is_equal:
            point = max((x[1] - x[0]) / (across[1] - across[0]), (y[1] - y[0]) / (down[1] - down[0]))
            self.x = _widened(x, point * (across[1] - across[0]))
            self.y = _widened(y, point * (down[1] - down[0]))
        self.point = (self.x[1] - self.x[0]) / (self.right - self.left)

    @property
    def _ticks(self) -> Ticks:
        return Ticks(*self.x, min(10, max(2, int((self.right - self.left) / 45.0))))

    def at(self, x: float) -> float:
        return self.left + (x - self.x[0]) / self.point

    def height(self, y: float) -> float:
        low, high = self.y
        return self.bottom - (y - low) / (high - low) * (self.bottom - self.top)

    def items(self, *, has_names: bool) -> Iterator[Item]:
        panel = self.panel
        if panel.title:
            high = 16.0 if panel.labels or panel.remark else 6.0
            yield TextLine(self.left, self.top - high, panel.title, 10.0, side="start", is_bold=True)
        yield from self._shades()
        yield from self._grid(has_names=has_names)
        for area in panel.areas:  # with an edge, so that no gap is visible between two
            points = [(self.at(x), self.height(y)) for x, y in zip(area.x, area.y, strict=True)]
            yield Shape([points], area.colour, 0.5, fill=area.colour)
        if panel.has_zero:
            yield self._level(self.height(0.0), AXIS)
        yield from self._lanes()
        for curve in panel.curves:
            yield from self._curve(curve)
        frame = ((self.left, self.top), (self.left, self.bottom), (self.right, self.bottom))
        yield Shape([frame], "#b8c2cc")
        if panel.remark:
            yield TextLine(self.right, self.top - 3.0, panel.remark, 7.5, FAINT, "end")
        yield from self._labels()
        yield from self._events()
        for note in panel.notes:
            x = self.at(note.x) + {"start": 4.0, "middle": 0.0, "end": -4.0}[note.side]
            yield TextLine(x, self.height(note.y) - 3.5, note.text, note.size, note.colour, note.side)
        yield from self._legend()

    def times(self, name: str) -> Iterator[Item]:
        """Yield the texts below the panel."""
        ticks = self._ticks
        for value, text in zip(ticks.values, ticks.names, strict=True):
            yield TextLine(self.at(value), self.bottom + 12.0, text)
        name += f" · 1e{ticks.power}" if ticks.power else ""
        yield TextLine(0.5 * (self.left + self.right), self.bottom + 27.0, name, 9.0)

    def _level(self, y: float, colour: str) -> Shape:
        return Shape([((self.left, y), (self.right, y))], colour)

    def _shades(self) -> Iterator[Item]:
        for is_short in (False, True):  # the short ones on top
            for band in self.panel.bands:
                if (band.end - band.begin < self.point) is is_short:
                    begin, end = self.at(band.begin), self.at(max(band.end, band.begin + self.point))
                    begin, end = max(begin, self.left), min(end, self.right)
                    if begin < end:
                        yield _box(begin, self.top, end, self.bottom, band.colour)

    def _grid(self, *, has_names: bool) -> Iterator[Item]:
        across = self._ticks
        lines = [((self.at(x), self.top), (self.at(x), self.bottom)) for x in across.values]
        if self.panel.lanes:
            yield Shape(lines, GRID, 0.7)
            return
        up = _up_ticks(self.y, self.bottom - self.top)
        lines += [((self.left, self.height(y)), (self.right, self.height(y))) for y in up.values]
        yield Shape(lines, "#8496a8", 0.7, opacity=0.25)
        if not has_names:
            return
        for value, text in zip(up.values, up.names, strict=True):
            yield TextLine(self.left - 5.0, self.height(value) + 3.0, text, side="end")
        if up.power:
            yield TextLine(self.left, self.top - 3.0, f"1e{up.power}", 7.5, FAINT, "end")
        panel, middle = self.panel, 0.5 * (self.top + self.bottom)
        names = [text for text in (panel.label, f"({panel.unit})" if panel.unit else "") if text]
        for n, text in enumerate(names):
            yield TextLine(self.origin + MARGIN + 2.0 + 11.0 * n, middle, text, 8.5, is_upright=True)

    def _lanes(self) -> Iterator[Item]:
        for row, lane in enumerate(self.panel.lanes):
            middle = self.top + 3.0 + (row + 0.5) * LANE
            yield TextLine(self.left - 5.0, middle + 3.0, lane.name, side="end")
            yield self._level(middle + 0.34 * LANE, AXIS)
            for begin, end in visible(lane.spans, self.x, self.point):
                high = 0.34 * LANE
                yield _box(self.at(begin), middle - high, self.at(end), middle + high, ON)

    def _curve(self, curve: Curve) -> Iterator[Item]:
        pairs = [(float(x), float(y)) for x, y in zip(curve.x, curve.y, strict=True)]
        if curve.is_stepped:
            pairs = [each for a, b in pairwise(pairs) for each in (a, (b[0], a[1]))] + pairs[-1:]
        points = [(self.at(x), self.height(y)) for x, y in _clipped(pairs, *self.x)]
        if not curve.marker and len(points) > 2 * DENSITY * (self.right - self.left):
            points = list(_thinned(points))
        if curve.width:
            yield Shape([points], curve.colour, curve.width, opacity=curve.opacity, is_dashed=curve.is_dashed)
        if curve.marker:
            yield Shape(_markers(curve, points), fill=curve.colour, opacity=curve.opacity)

    def _labels(self) -> Iterator[Item]:
        free = self.left
        for label in self.panel.labels:
            begin, end = max(self.at(label.begin), self.left), min(self.at(label.end), self.right)
            text = next((each for each in label.texts if text_width(each) + GAP < end - begin), "")
            middle, half = 0.5 * (begin + end), 0.5 * text_width(text)
            if text and middle - half >= free:
                free = middle + half + GAP
                yield TextLine(middle, self.top - 3.0, text, 8.0, FAINT)

    def _events(self) -> Iterator[Item]:
        for event in self.panel.events:
            x = self.at(event.x)
            yield Shape([((x, self.top), (x, self.bottom))], EVENT, 1.0, is_dashed=True)
            is_late = x > 0.5 * (self.left + self.right)
            if event.text:
                at, side = (x - 4.0, "end") if is_late else (x + 4.0, "start")
                yield TextLine(at, self.bottom - 5.0, event.text, 7.5, EVENT, side)

    def _legend(self) -> Iterator[Item]:
        """Name the curves in the corner at the right in which they do not end."""
        curves = [curve for curve in self.panel.curves if curve.name]
        if not curves:
            return
        ends_high = self.height(float(curves[0].y[-1])) < 0.5 * (self.top + self.bottom)
        end, y = self.right - 2.0, self.bottom - 7.0 if ends_high else self.top + 10.0
        for curve in reversed(curves):
            yield TextLine(end, y, curve.name, 8.0, INK, "end")
            end -= text_width(curve.name) + 5.0
            points = [(end - 16.0, y - 3.0), (end, y - 3.0)]
            if curve.width:
                yield Shape([points], curve.colour, curve.width, is_dashed=curve.is_dashed)
            if curve.marker:
                yield Shape(_markers(curve, [(end - 8.0, y - 3.0)]), fill=curve.colour)
            end -= 26.0


def _scale(figure: Figure, box: _Axes) -> Iterator[Item]:
    """Yield the colours of the figure's scale, as a bar beside the panel."""
    scale = figure.scale
    assert scale is not None
    left, right, steps = box.right + 16.0, box.right + 27.0, 48
    low, high = box.top + 0.15 * (box.bottom - box.top), box.top + 0.85 * (box.bottom - box.top)
    step = (high - low) / steps
    for n in range(steps):
        colour = scale.colour(scale.high - (n + 0.5) / steps * (scale.high - scale.low))
        yield _box(left, low + n * step, right, low + (n + 1) * step + 0.5 * (n + 1 < steps), colour)
    ticks = Ticks(*_range([scale.low, scale.high]), 6)
    for value, text in zip(ticks.values, ticks.names, strict=True):
        y = high - (value - scale.low) / ((scale.high - scale.low) or 1.0) * (high - low)
        if low - 0.5 <= y <= high + 0.5:
            yield TextLine(right + 4.0, y + 3.0, text, side="start")
    name = scale.label + (f" · 1e{ticks.power}" if ticks.power else "")
    yield TextLine(figure.width - 8.0, 0.5 * (low + high), name, 8.5, is_upright=True)


def _box(left: float, top: float, right: float, bottom: float, colour: str) -> Shape:
    return Shape([((left, top), (right, top), (right, bottom), (left, bottom))], fill=colour)


def text_width(text: str, size: float = 8.0) -> float:
    """Return an estimate of the width of a text in points."""
    return size * fsum(_letter_width(letter) for letter in text)


def _letter_width(letter: str) -> float:
    if letter in " .,:;|'()iIjlft":
        return 0.36
    return 0.92 if letter in "mwMW" else 0.68 if letter.isupper() else 0.6


def _widened(limits: Limits, length: float) -> Limits:
    middle = 0.5 * (limits[0] + limits[1])
    return middle - 0.5 * length, middle + 0.5 * length


def _clipped(points: Sequence[Point], low: float, high: float) -> list[Point]:
    """Return the points of a line from `low` to `high`; where it leaves them, those in between."""
    if all(low <= x <= high for x, _ in points):
        return list(points)
    found: list[Point] = []
    for (x0, y0), (x1, y1) in pairwise(points):
        for bound in sorted((low, high), reverse=x0 > x1):
            if min(x0, x1) < bound < max(x0, x1):
                found.append((bound, y0 + (y1 - y0) * (bound - x0) / (x1 - x0)))
        if low <= x1 <= high:
            found.append((x1, y1))
    return [*points[:1], *found] if points and low <= points[0][0] <= high else found


def _thinned(points: Sequence[Point]) -> Iterator[Point]:
    """Yield the first, the lowest, the highest and the last point of each half point of the width."""
    for _, group in groupby(points, lambda point: int(2.0 * point[0])):
        column = list(group)
        heights = [y for _, y in column]
        chosen = {0, heights.index(min(heights)), heights.index(max(heights)), len(column) - 1}
        yield from (column[n] for n in sorted(chosen))


def _markers(curve: Curve, points: Sequence[Point]) -> list[list[Point]]:
    if curve.marker == "arrow":
        return [_head_of(points[-2], points[-1])]
    if curve.marker == "arrows":
        return [_head_of(points[1], points[0]), _head_of(points[-2], points[-1])]
    corners, inner = {"circle": (12, 1.0), "diamond": (4, 1.0), "star": (10, 0.4)}[curve.marker]
    radii = [curve.size * (inner if n % 2 else 1.0) for n in range(corners)]
    turns = [2.0 * pi * n / corners for n in range(corners)]
    return [
        [(x + r * sin(turn), y - r * cos(turn)) for r, turn in zip(radii, turns, strict=True)]
        for x, y in points
    ]


def _head_of(tail: Point, tip: Point) -> list[Point]:
    angle = atan2(tip[1] - tail[1], tip[0] - tail[0])
    ends = [(tip[0] - 7.0 * cos(angle + turn), tip[1] - 7.0 * sin(angle + turn)) for turn in (-0.4, 0.4)]
    return [tip, *ends]


# Begin and end.
Span = tuple[float, float]


def visible(spans: Iterable[Span], window: Span, pixel: float) -> list[Span]:
    """Return the `spans` in the `window`, in order, each at least `pixel` long.

    A gap shorter than a pixel is widened at the cost of the span before it, or of the span after it if that is
    too short. If both are too short, overlapping spans are merged. `visibleSpans` of the scope page does the same.
    """
    first, last = window
    made: list[Span] = []
    for start, stop in spans:
        if stop < first or start > last:
            continue
        begin, end = max(start, first), min(stop, last)
        if end - begin < pixel:
            begin = min(begin, last - pixel)
            end = begin + pixel
        if made and begin - made[-1][1] < pixel:
            previous, gap = made[-1]
            if begin - previous >= 2.0 * pixel:
                made[-1] = previous, begin - pixel
            elif end - gap >= 2.0 * pixel:
                begin = gap + pixel
            elif begin <= gap:
                made[-1] = previous, max(gap, end)
                continue
        made.append((begin, end))
    return made
