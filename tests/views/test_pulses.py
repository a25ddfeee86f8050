"""Items shorter than a pixel are drawn a pixel wide: pulses, gaps, phases, waits.

`PULSES` runs for 200 s, for which a picture has about 1000 columns. Output 1 has ten pulses of 1 to 10 ms.
Output 2 is on five times for 10 s, and then until the end except for ten gaps of 2 ms.
"""

from __future__ import annotations

import json
import re
from functools import cache
from importlib.resources import files
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from motionlang.commands.plot.view import run_figure
from motionlang.commands.scope import page
from motionlang.kernel import Run, Source, run
from motionlang.views.figure_files import svg
from motionlang.views.figure_layout import ON, Span, visible
from motionlang.views.window import WHOLE, Window
from tests.commands.test_scope import data_of

PULSES = """\
Dim i As Integer
SPEED(0) = 100 : ACCEL(0) = 100000 : DECEL(0) = 100000
For i = 1 To 10
  OUTX(1) = 1 : WAIT = i : OUTX(1) = 0
  OUTX(2) = 1 - OUTX(2)
  MOVER(0) = 0.5 : GO(0)
  WAIT = 10000
Next
OUTX(2) = 1
For i = 1 To 10
  OUTX(2) = 0 : WAIT = 2 : OUTX(2) = 1
  WAIT = 10000
Next
"""
# On for 10 s five times, on briefly before the first gap, and on after each gap.
BARS = {"out1": 10, "out2": 5 + 1 + 10}


@cache
def pulses() -> Run:
    return run(Source("pulses.mnt", PULSES))


SPANS: dict[str, tuple[list[Span], list[Span]]] = {
    "a long span stays": ([(10, 20)], [(10, 20)]),
    "a short one is a pixel": ([(10, 10.25)], [(10, 11)]),
    "one without length, too": ([(10, 10)], [(10, 11)]),
    "at the end it begins earlier": ([(99.75, 100)], [(99, 100)]),
    "outside the window there is none": ([(-5, -1), (101, 102)], []),
    "the window cuts": ([(-5, 2), (98, 105)], [(0, 2), (98, 100)]),
    "a gap takes a pixel from the span before it": ([(0, 10), (10.25, 20)], [(0, 9.25), (10.25, 20)]),
    "or from that after it": ([(10, 11), (11.25, 20)], [(10, 11), (12, 20)]),
    "a pulse beside a long span": ([(0, 10), (10.5, 10.75)], [(0, 9.5), (10.5, 11.5)]),
    "what has no room for a gap is one": ([(10, 10.25), (10.5, 10.75), (11, 11.25)], [(10, 12)]),
    "apart by two pixels": ([(10, 10.25), (12, 12.25)], [(10, 11), (12, 13)]),
}  # fmt: skip


@pytest.mark.parametrize("name", SPANS)
def test_spans_as_a_picture_shows_them(name: str) -> None:
    spans, shown = SPANS[name]
    assert visible(spans, (0.0, 100.0), 1.0) == shown


def test_a_random_train_is_shown_pixel_by_pixel() -> None:
    """Each pulse has a bar at least a pixel wide; bars are in order and in the window."""
    rng = np.random.default_rng(18)
    for scale in (0.1, 1.0, 10.0):
        edges = np.sort(rng.uniform(0.0, 100.0, int(200 / scale)))
        spans = [(float(a), float(b)) for a, b in zip(edges[::2], edges[1::2], strict=True)]
        made = visible(spans, (0.0, 100.0), 1.0)
        assert all(end - begin >= 1.0 - 1e-9 for begin, end in made)
        assert all(before[1] <= after[0] for before, after in pairwise(made))
        assert made[0][0] >= 0.0
        assert made[-1][1] <= 100.0
        for begin, end in spans:
            assert any(left < end + 1.0 and begin - 1.0 < right for left, right in made)


def bars_of(window: Window = WHOLE) -> list[list[float]]:
    """Return the left and the right end of each bar of the picture."""
    paths = re.findall(rf'<path d="([^"]*)" fill="{ON}"', svg(run_figure(pulses(), window=window)))
    return [sorted({float(x) for x in re.findall(r"[ML](\S+) ", path)}) for path in paths]


def test_each_pulse_and_each_gap_is_in_the_picture() -> None:
    """A unit of the picture is a point, which is more than a pixel of a screen."""
    bars = bars_of()
    assert len(bars) == BARS["out1"] + BARS["out2"]
    assert all(right - left >= 0.99 for left, right in bars)


def test_a_window_of_the_run_has_its_pulses() -> None:
    """Between 5 and 55 s there are five pulses, 10 s apart.

    They take 20, 30, 40, 50 and 60 ms.
    """
    assert len(bars_of(Window(begin=5.0, end=55.0))) == 5 + 3


class Page:
    """A page's drawing of the run from `begin` to `end`, `width` pixels wide."""

    def __init__(self, made: Run, begin: float, end: float, width: int = 1000) -> None:
        racer = pytest.importorskip("py_mini_racer")
        self._context = racer.MiniRacer()
        scripts = (
            files("motionlang.commands.scope").joinpath(f"{name}.js").read_text(encoding="utf-8")
            for name in ("model", "draw")
        )
        data = json.dumps(data_of(page(made)))
        self._context.eval(
            "\n".join(
                (
                    *scripts,
                    f"const data = expand({data}), END = data.end, LANE = 24, width = {width};",
                    f"const view = {{ begin: {begin}, end: {end} }}; 0",
                )
            )
        )

    def __call__(self, expression: str) -> Any:
        return json.loads(self._context.eval(f"JSON.stringify({expression})"))


def test_each_pulse_and_each_gap_is_in_the_page() -> None:
    drawn = Page(pulses(), 0.0, pulses().time)("lanesSvg({ top: 0, height: 48, lanes: data.lanes })")
    paths = re.findall(r'<path class="on" d="([^"]*)"/>', drawn)
    bars = [re.findall(r"M(\S+) \S+?V\S+?H([\d.]+)V", path) for path in paths]
    assert [len(each) for each in bars] == list(BARS.values())
    assert all(float(right) - float(left) >= 0.99 for each in bars for left, right in each)


def test_the_page_shows_spans_as_the_picture_does() -> None:
    scope = Page(pulses(), 0.0, 1.0)
    for spans, shown in SPANS.values():
        assert scope(f"visibleSpans({json.dumps(spans)}, 0, 100, 1)") == [list(each) for each in shown]


def test_each_short_move_and_each_wait_is_in_the_page() -> None:
    """Ten moves of 6 ms each, 10 s apart, have a band each in the panels of the axis."""
    scope = Page(pulses(), 0.0, pulses().time)
    phases = scope("phasesSvg({ axis: data.axes[0], top: 0, height: 100 })")
    shown = re.findall(r'x="([\d.]+)" y="0" width="([\d.]+)"', phases)
    assert len({round(float(x) / 10) for x, _ in shown}) == 10
    assert all(float(wide) >= 1.0 for _, wide in shown)
    bands = scope("bandsSvg({ top: 0, height: 24, bands: data.bands.slice(1) })")
    waits = re.findall(r'class="wait" x="[\d.]+" y="3" width="([\d.]+)"', bands)
    assert len(waits) == 40
    assert all(float(wide) >= 1.0 for wide in waits)
