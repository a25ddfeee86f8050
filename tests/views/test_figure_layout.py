"""The layout of figures, and their files."""

from __future__ import annotations

import importlib
import sys
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import pytest

from motionlang.commands.plot.view import run_figure
from motionlang.kernel.tools import MissingExtra
from motionlang.views.figure import (
    FAINT,
    Band,
    ColourScale,
    Curve,
    Figure,
    Lane,
    MarkedTime,
    Panel,
    PanelLabel,
)
from motionlang.views.figure_files import svg, write_figure
from motionlang.views.figure_layout import Item, Shape, TextLine, Ticks, layout, text_width
from tests.views.runs import ballscrew, pick

LINE = Panel([Curve([0.0, 10.0], [0.0, 5.0], "#010203")], x_limits=(0.0, 10.0))


def items(panel: Panel) -> list[Item]:
    return layout(Figure([[panel]]))[2]


def texts(panel: Panel) -> dict[str, TextLine]:
    return {item.text: item for item in items(panel) if isinstance(item, TextLine)}


def shapes(panel: Panel, colour: str) -> list[Shape]:
    found = [item for item in items(panel) if isinstance(item, Shape)]
    return [shape for shape in found if colour in (shape.fill, shape.stroke)]


def ends(panel: Panel) -> tuple[float, float]:
    """Return the left and the right end of the panel on the paper."""
    (shape,) = shapes(replace(panel, curves=LINE.curves), "#010203")
    return shape.paths[0][0][0], shape.paths[0][-1][0]


@pytest.mark.parametrize(
    ("low", "high", "most", "names"),
    [
        (-8.0, 108.0, 6, ["0", "20", "40", "60", "80", "100"]),
        (-1.0, 1.0, 5, ["−1.0", "−0.5", "0.0", "0.5", "1.0"]),
        (0.0, 1.0, 4, ["0.00", "0.25", "0.50", "0.75", "1.00"]),
        (0.0, 999_000.0, 2, ["0", "500000"]),
        (-2e6, 0.0, 2, ["−2", "−1", "0"]),  # with 1e6 above
    ],
)
def test_ticks_are_round(low: float, high: float, most: int, names: list[str]) -> None:
    assert Ticks(low, high, most).names == names


def test_a_million_has_a_power_of_ten() -> None:
    panel = Panel([Curve([0.0, 1.0], [0.0, 1e6], "#010203")])
    assert "1e6" in texts(panel)
    assert "1e6" not in texts(LINE)


def test_bands_are_at_least_a_point_wide_and_short_ones_on_top() -> None:
    bands = [Band(2.0, 2.0001, "#00ff00"), Band(2.0, 6.0, "#0000ff")]
    filled = [item.fill for item in items(replace(LINE, bands=bands)) if isinstance(item, Shape)]
    assert filled.index("#0000ff") < filled.index("#00ff00")
    (short,) = shapes(replace(LINE, bands=bands), "#00ff00")
    xs = [x for x, _ in short.paths[0]]
    assert max(xs) - min(xs) == pytest.approx(1.0)


def test_the_head_of_an_arrow_is_behind_its_tip() -> None:
    """An arrow upwards: both corners are 7 · cos 0.4 below the tip, and 7 · sin 0.4 to the left and to the right."""
    (head,) = (
        each.paths[0]
        for each in shapes(
            replace(LINE, curves=[Curve([5.0, 5.0], [0.0, 5.0], "#010203", marker="arrow")]), "#010203"
        )
        if each.fill
    )
    (x, y), *corners = head
    assert [xy for x1, y1 in corners for xy in (x1 - x, y1 - y)] == pytest.approx(
        [2.726, 6.447, -2.726, 6.447], abs=1e-3
    )


def test_a_curve_with_arrows_has_a_head_at_both_ends() -> None:
    """The heads are equally long, and point away from each other: downwards at the start, upwards at the end."""
    curve = Curve([5.0, 5.0], [0.0, 5.0], "#010203", marker="arrows")
    (heads,) = (each.paths for each in shapes(replace(LINE, curves=[curve]), "#010203") if each.fill)
    away = [[xy for x1, y1 in corners for xy in (x1 - x, y1 - y)] for (x, y), *corners in heads]
    assert away == [
        pytest.approx([dx, dy, -dx, dy], abs=1e-3) for dx, dy in ((-2.726, -6.447), (2.726, 6.447))
    ]


def test_one_scale_of_x_and_y_is_the_largest_that_fits() -> None:
    """The panel is wider than high, so its height limits a diagonal of 10 from a y of 100 on."""
    diagonal = Curve([0.0, 10.0], [100.0, 110.0], "#010203")
    panel = Panel([diagonal], x_limits=(0.0, 10.0), y_limits=(100.0, 110.0), is_equal=True)
    (shape,), (frame,) = shapes(panel, "#010203"), shapes(panel, "#b8c2cc")
    ((x0, y0), (x1, y1)), heights = shape.paths[0], [y for _, y in frame.paths[0]]
    assert x1 - x0 == pytest.approx(y0 - y1)
    assert y0 - y1 == pytest.approx(max(heights) - min(heights))


def test_labels_are_the_longest_that_fit_and_do_not_touch() -> None:
    """The third is too short for its name."""
    names = ("MOVER · line 7", "MOVER 7", "7")
    labels = [
        PanelLabel(0.0, 4.0, names),
        PanelLabel(4.0, 4.8, names),
        PanelLabel(4.8, 4.81, names),
        PanelLabel(5.0, 12.0, names),
    ]
    found = [item for item in items(replace(LINE, labels=labels)) if isinstance(item, TextLine)]
    left, right = ends(LINE)
    shown = [
        (text.text, round((text.x - left) / (right - left) * 10.0, 6))
        for text in found
        if text.colour == FAINT
    ]
    assert shown == [("MOVER · line 7", 2.0), ("MOVER 7", 4.4), ("MOVER · line 7", 7.5)]


def test_a_legend_has_a_square_of_9_points_3_points_before_each_name() -> None:
    legend = layout(Figure([[LINE]], legend=[("#00ff00", "commanded"), ("#0000ff", "measured")]))[2][:4]
    names = [item for item in legend if isinstance(item, TextLine)]
    squares = [item.paths[0] for item in legend if isinstance(item, Shape)]
    for name, square in zip(names, squares, strict=True):
        xs, ys = zip(*square, strict=True)
        begin = name.x - text_width(name.text, name.size)
        assert [max(xs) - min(xs), max(ys) - min(ys), begin - max(xs)] == pytest.approx([9.0, 9.0, 3.0])


@pytest.mark.parametrize(("x", "side"), [(3.0, "start"), (7.0, "end")])
def test_an_event_is_named_towards_the_middle(x: float, side: str) -> None:
    panel = replace(LINE, events=[MarkedTime(x, "limit"), MarkedTime(5.0, "")])
    assert texts(panel)["limit"].side == side
    assert len([shape for shape in shapes(panel, "#b3261e") if shape.is_dashed]) == 2


def test_a_curve_is_cut_at_the_limits() -> None:
    """From (-10, 0) to (10, 20), the panel shows the half from x = 0 on."""
    panel = Panel([Curve([-10.0, 10.0, 30.0], [0.0, 20.0, 20.0], "#010203")], x_limits=(0.0, 10.0))
    (shape,) = shapes(panel, "#010203")
    ((x0, y0), *_, (x1, y1)) = shape.paths[0]
    (frame,) = shapes(panel, "#b8c2cc")
    assert [x0, x1] == pytest.approx([x for x, _ in frame.paths[0][1:]])
    heights = texts(panel)
    assert y1 + 3.0 == pytest.approx(heights["20"].y)
    assert y0 - y1 == pytest.approx(2.0 * (heights["15"].y - heights["20"].y))


def test_a_stepped_curve_holds_its_values() -> None:
    (shape,) = shapes(replace(LINE, curves=[replace(LINE.curves[0], is_stepped=True)]), "#010203")
    (a, b, c) = shape.paths[0]
    assert (a[1], b[0]) == (b[1], c[0])


@pytest.mark.parametrize(("last", "is_low"), [(3.0, True), (1.0, False)])
def test_names_of_curves_lie_where_they_do_not_end(last: float, is_low: bool) -> None:
    curves = [Curve([0.0, 1.0, 2.0], [0.0, 4.0, last], "#010203", "motor")]
    name, top = texts(Panel(curves))["motor"], texts(Panel(curves))["4"]
    assert (name.y > top.y + 20.0) is is_low
    (_, key) = shapes(Panel(curves), "#010203")
    assert [y for _, y in key.paths[0]] == [name.y - 3.0] * 2


def test_lanes_are_named_bars() -> None:
    panel = Panel(lanes=[Lane("in1", [(2.0, 4.0), (6.0, 99.0)]), Lane("in2", [])], x_limits=(0.0, 10.0))
    bars = [sorted({x for x, _ in shape.paths[0]}) for shape in shapes(panel, "#658ab1")]
    assert len(bars) == 2
    assert (bars[1][1] - bars[1][0]) / (bars[0][1] - bars[0][0]) == pytest.approx(2.0)  # up to the end at 10
    assert {"in1", "in2"} <= set(texts(panel))


def test_rows_share_y_if_the_figure_says_so() -> None:
    rows = [[LINE, replace(LINE, curves=[Curve([0.0, 10.0], [0.0, 50.0], "#040506")])]]
    counts = [
        sum(isinstance(item, TextLine) for item in layout(Figure(rows, has_shared_y=shared))[2])
        for shared in (False, True)
    ]
    assert counts[0] > counts[1]


def test_colours_of_a_scale() -> None:
    scale = ColourScale("", 0.0, 10.0, "000000 808080 ffffff")
    assert [scale.colour(value) for value in (-1.0, 2.5, 5.0, 10.0)] == [
        "#000000", "#404040", "#808080", "#ffffff"]  # fmt: skip


@pytest.mark.parametrize("figure", [run_figure(pick()), Figure([[Panel()]], title="<$x^{$&漢>")])
def test_an_svg_is_xml_with_its_texts(figure: Figure) -> None:
    root = ElementTree.fromstring(svg(figure))
    found = [each.text for each in root.iter("{http://www.w3.org/2000/svg}text")]
    assert figure.title in found
    assert svg(figure) == svg(figure)


@pytest.mark.parametrize(("suffix", "head"), [(".png", b"\x89PNG"), (".svg", b"<svg ")])
def test_the_same_run_gives_the_same_bytes(suffix: str, head: bytes, tmp_path: Path) -> None:
    if suffix == ".png":
        pytest.importorskip("matplotlib")
    for name in ("one", "two"):
        write_figure(run_figure(ballscrew()), str(tmp_path / f"{name}{suffix}"))
    made = [(tmp_path / f"{name}{suffix}").read_bytes() for name in ("one", "two")]
    assert made[0] == made[1]
    assert made[0].startswith(head)


def test_the_base_line_of_an_upright_text_of_a_png_is_in_its_middle(monkeypatch: pytest.MonkeyPatch) -> None:
    """A letter of 10 points is 6 high, so its middle is 3 left of its base line."""
    axes = pytest.importorskip("matplotlib.axes").Axes
    drawn = importlib.import_module("motionlang.views.figure_matplotlib")
    shown: list[tuple[float, float, str]] = []
    monkeypatch.setattr(axes, "text", lambda _, x, y, text, **how: shown.append((x, y, text)))
    lines = [TextLine(100.0, 50.0, "up", 10.0, is_upright=True), TextLine(100.0, 50.0, "along", 10.0)]
    monkeypatch.setattr(drawn, "layout", lambda figure: (200.0, 100.0, lines))
    drawn.png(Figure([[LINE]]))
    assert shown == [(97.0, 50.0, "up"), (100.0, 50.0, "along")]


def test_only_a_png_needs_matplotlib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    write_figure(Figure([[LINE]]), str(tmp_path / "x.svg"))
    with pytest.raises(MissingExtra, match="matplotlib"):
        write_figure(Figure([[LINE]]), str(tmp_path / "x.png"))


def test_a_missing_folder_is_reported_with_the_requested_file(tmp_path: Path) -> None:
    path = str(tmp_path / "nowhere" / "x.svg")
    with pytest.raises(FileNotFoundError) as caught:
        write_figure(Figure([[LINE]]), path)
    assert caught.value.filename == path
