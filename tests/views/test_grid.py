"""The text of a table compared with the tables of rich: equal lines for any cells."""

from __future__ import annotations

import random
from dataclasses import replace
from io import StringIO
from operator import itemgetter

import pytest
from rich.box import Box
from rich.console import Console
from rich.table import Table
from rich.text import Text
from rich.theme import Theme

from motionlang.views import report
from motionlang.views.formatting import decimals_of
from motionlang.views.table import GAP, Column
from motionlang.views.table import Table as Ours
from motionlang.views.terminal import STYLES, styled

# Only a rule below the head, which runs through the gaps: rich's notation of a box, line by line.
BOX = "    \n    \n ── \n    \n    \n    \n    \n    \n"
WORDS = (
    "",
    "a",
    "12.50",
    "-3",
    "├ accel",
    "é",
    "e\u0301",
    "日本",
    "👍🏽",
    "…",
    "²",
    "two words",
    " x",
    "x ",
    "[b]x[/b]",
)
NAMES = ("", "word", "error", "dim", "accel", "stop", "no style")


def drawn_by_rich(columns: list[Column], rows: list[list[str]], styles: list[str], colour: bool) -> list[str]:
    """Return the lines of a table, which must fit the width, as rich draws it."""
    table = Table(box=Box(BOX), show_edge=False, pad_edge=False, padding=(0, GAP - 1, 0, 0), header_style="")
    units = any(column.unit for column in columns)
    for column in columns:
        head = [(column.heading, "bold"), *([("\n", ""), (column.unit, "dim")] if units else [])]
        table.add_column(Text.assemble(*head), justify="left" if column.left else "right", no_wrap=True)
    for i, row in enumerate(rows):
        style = styles[i] if styles else ""
        paints = [style or column.style for column in columns]
        table.add_row(*(Text.assemble(pair) for pair in zip(row, paints, strict=True)))
    screen = Console(
        file=StringIO(),
        width=1_000_000,
        height=25,
        color_system="standard" if colour else None,
        force_terminal=colour,
        no_color=False,
        theme=Theme(STYLES),
        legacy_windows=False,
        force_jupyter=False,
        markup=False,
        emoji=False,
        highlight=False,
    )
    with screen.capture() as captured:
        screen.print(table)
    lines = [line.rstrip() for line in captured.get().splitlines()]
    return [styled(line, "dim", colour) if set(line) == {"─"} else line for line in lines]


@pytest.mark.parametrize("colour", [False, True])
def test_a_grid_is_the_table_that_rich_draws(colour: bool) -> None:
    draw = random.Random(1)
    for _ in range(150):
        units = draw.random() < 0.5
        columns = [
            Column(
                "",
                draw.choice(WORDS[1:]),
                draw.choice(["", "s", "uu/s²"]) if units else "",
                get=itemgetter(k),
                text=str,
                left=draw.random() < 0.5,
                style=draw.choice(NAMES),
            )
            for k in range(draw.randint(1, 6))
        ]
        rows = [[draw.choice(WORDS) for _ in columns] for _ in range(draw.randint(0, 5))]
        styles = [draw.choice(NAMES) for _ in rows] if draw.random() < 0.5 else []
        paints = {id(row): style for row, style in zip(rows, styles, strict=False)}
        made = Ours("rows", columns, rows, style=lambda row: paints.get(id(row), ""))  # noqa: B023
        lines = made.lines(1000, colour=colour)
        assert lines == drawn_by_rich(columns, rows, styles, colour)


@pytest.mark.parametrize(
    ("values", "decimals"),
    [
        ([], 0), ([0.0], 0), ([12.0, 3.0], 0), ([1.5, 2.25], 2), ([1 / 3], 4), ([1 / 3, 7.0], 4),
        ([0.0101234567], 4), ([0.0091234567], 5), ([0.00091234567], 6), ([1.23456789e-8], 9),
    ],
)  # fmt: skip
def test_four_decimals_suffice_unless_all_values_are_below_a_hundredth(
    values: list[float], decimals: int
) -> None:
    assert decimals_of(values) == decimals


@pytest.mark.parametrize(
    ("table", "order"),
    [
        (report.events_table([]), ["line", "limit", "value", "motion of line", "times", ""]),
        (report.axes_table([]), ["feedback", "counts", "scale"]),
        (report.motors_table([], False), ["peak output", "line"]),
    ],
)
def test_a_narrow_table_drops_the_least_important_column_first(table: Ours, order: list[str]) -> None:
    assert order_of_dropped(table) == order


def order_of_dropped(table: Ours) -> list[str]:
    """Return the headings of a table in the order in which a narrower terminal drops their columns."""
    table.columns = [
        replace(column, get=lambda row, k=k: chr(65 + k) * 30, text=str, decimals=None)  # type: ignore[misc]
        for k, column in enumerate(table.columns)
    ]
    table.rows = [{}]
    dropped: list[str] = []
    for width in range(200, 0, -1):
        head = table.lines(width * 2)[-1]
        gone = [
            each.heading
            for k, each in enumerate(table.columns)
            if not each.data and chr(65 + k) * 30 not in head
        ]
        dropped += [title for title in gone if title not in dropped]
    return dropped
