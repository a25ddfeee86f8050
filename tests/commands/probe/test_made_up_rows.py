"""Questions about made-up keywords: each kind of fact, with each kind of bound."""

from __future__ import annotations

import pytest

from motionlang.commands.probe.assumption import Assumption, Probe
from motionlang.commands.probe.probe import alone, meanings
from motionlang.commands.probe.rules import unsettled_facts
from motionlang.kernel import Keyword


def row(
    kind: str = "setting",
    access: str = "RW",
    index: str = "axis",
    unit: str = "uu",
    *,
    name: str = "NEW",
    short: str = "",
    verb: str = "new",
    example: str = "",
    effect: str = "",
    default: float | str | None = None,
    low: float | None = None,
    high: float | None = None,
) -> Keyword:
    """Return the row of a keyword without evidence: all of its facts are open."""
    return Keyword(
        name, short, kind, access, index, unit, verb, "Help.", example,
        effect=effect, default=default, low=low, high=high,
    )  # fmt: skip


def of(language: str, keyword: Keyword) -> dict[str, Assumption]:
    """Return the questions about a keyword by the end of their names."""
    return {each.name.partition("-")[2]: each for each in unsettled_facts(language, keyword)}


# An integer from 0 to 3: the comments and the program of each of its questions for axis 2.
INTEGER = {
    "short": """\
' mint.new-short: The short form of NEW
' What it shows, and what that says of the controller:
'   … the same                NW (chosen here)
'   (the compiler refuses it)
'                             no such short form is known
'   … another …               it is the short form of another word than NEW
PRINT "<mint.new-short|"; NW(2); " "; NEW(2); ">"
""",
    "type": """\
' mint.new-type: What NEW makes of a fraction
' First: switch the drive off, and restart the controller afterwards.
' What it shows, and what that says of the controller:
'   0         it is cut off: a whole number (chosen here)
'   0.75      it keeps a fraction
'   1         a fraction is rounded to the nearest whole number
'   an error  a fraction is an error
fa = 0.75
NEW(2) = fa
PRINT "<mint.new-type|"; NEW(2); ">"
Event ONERROR
  PRINT "<mint.new-type|"; "an error"; ">"
""",
    "default": """\
' mint.new-default: What NEW(axis) is at power-up
' What it shows, and what that says of the controller:
'   1               1 (chosen here)
'   another number  that is it
PRINT "<mint.new-default|"; NEW(2); ">"
""",
    "range-high": """\
' mint.new-range-high: The greatest value of NEW
' First: switch the drive off, and restart the controller afterwards.
' What it shows, and what that says of the controller:
'   refuses 4  3 (chosen here)
'   refuses 3  it ends before 3
'   4          4 is taken, too
'   3          4 becomes 3, without an error
fa = 3
NEW(2) = fa
fa = 4
NEW(2) = fa
PRINT "<mint.new-range-high|"; NEW(2); ">"
Event ONERROR
  PRINT "<mint.new-range-high|"; "refuses "; fa; ">"
""",
    "range-low": """\
' mint.new-range-low: The least value of NEW
' First: switch the drive off, and restart the controller afterwards.
' What it shows, and what that says of the controller:
'   refuses -1  0 (chosen here)
'   refuses 0   it ends before 0
'   -1          -1 is taken, too
'   0           -1 becomes 0, without an error
fa = 0
NEW(2) = fa
fa = -1
NEW(2) = fa
PRINT "<mint.new-range-low|"; NEW(2); ">"
Event ONERROR
  PRINT "<mint.new-range-low|"; "refuses "; fa; ">"
""",
}
# What each program has in common.
FRAME = (
    "Dim fa As Float, fb As Float, ia As Integer, ib As Integer",
    'PRINT "<probe|mint 1>"',
    'PRINT "<end|mint 1>"',
    "End",
    '  PRINT "<end|mint 1>"',
    "  End",
    "End Event",
)


def without_frame(text: str) -> str:
    """Return the lines of a program that depend on its question."""
    return "".join(
        f"{line}\n"
        for line in text.splitlines()
        if line not in FRAME and not line.startswith(("' Then:", "' is <"))
    )


def test_each_fact_of_an_integer_is_asked() -> None:
    found = of("mint", row(unit="integer", short="NW", default=1.0, low=0.0, high=3.0))
    assert {name: without_frame(alone(each, 2)) for name, each in found.items()} == INTEGER
    assert all(each.probe is not None and each.probe.alone for each in found.values())


# A row of Mint, and of each of its questions the chosen answer and the lines before the last one.
ASKED: tuple[tuple[Keyword, dict[str, tuple[str, list[str]]]], ...] = (
    # A scale is asked if 5 is a value of the setting.
    (row(), {"scale": ("2.5", ["SCALEFACTOR({a}) = 10", "NEW({a}) = 5", "SCALEFACTOR({a}) = 20"])}),
    (row(high=4.9), {"range-high": ("refuses 9.8", ["fa = 4.9", "NEW({a}) = fa", "fa = 9.8", "NEW({a}) = fa"])}),
    (row(low=5.1), {"range-low": ("refuses 0", ["fa = 5.1", "NEW({a}) = fa", "fa = 0", "NEW({a}) = fa"])}),
    (
        row(low=5.0, high=5.0),
        {
            "scale": ("2.5", ["SCALEFACTOR({a}) = 10", "NEW({a}) = 5", "SCALEFACTOR({a}) = 20"]),
            "range-high": ("refuses 6", ["fa = 5", "NEW({a}) = fa", "fa = 6", "NEW({a}) = fa"]),
            "range-low": ("refuses 4", ["fa = 5", "NEW({a}) = fa", "fa = 4", "NEW({a}) = fa"]),
        },
    ),
    # A fraction is written if there is a range of integers.
    (row(unit="bool"), {"type": ("0", ["fa = 0.75", "NEW({a}) = fa"])}),
    (row(unit="counts", low=-3.0), {
        "type": ("-3", ["fa = -2.25", "NEW({a}) = fa"]),
        "range-low": ("refuses -4", ["fa = -3", "NEW({a}) = fa", "fa = -4", "NEW({a}) = fa"]),
    }),
    (row(unit="integer", high=1.0), {
        "type": ("0", ["fa = 0.75", "NEW({a}) = fa"]),
        "range-high": ("refuses 2", ["fa = 1", "NEW({a}) = fa", "fa = 2", "NEW({a}) = fa"]),
    }),
    (row(unit="bool", high=0.0), {
        "range-high": ("refuses 1", ["fa = 0", "NEW({a}) = fa", "fa = 1", "NEW({a}) = fa"]),
    }),
    (row(unit="ms", low=-0.5, high=0.5), {
        "range-high": ("refuses 1", ["fa = 0.5", "NEW({a}) = fa", "fa = 1", "NEW({a}) = fa"]),
        "range-low": ("refuses -1", ["fa = -0.5", "NEW({a}) = fa", "fa = -1", "NEW({a}) = fa"]),
    }),
    # From 1e7 on a Float does not distinguish adjacent integers for long.
    (row(unit="number", low=-1e7, high=9_999_999.0), {
        "range-high": ("refuses 10000000", ["fa = 9999999", "NEW({a}) = fa", "fa = 10000000", "NEW({a}) = fa"]),
        "range-low": ("refuses -20000000", ["fa = -10000000", "NEW({a}) = fa", "fa = -20000000", "NEW({a}) = fa"]),
    }),
    # The brackets are those of the example.
    (row(index="channel", default=7.0, example="x = 1\nNEW(2, 3) = 1"), {"default": ("7", ["NEW(2, 3)"])}),
    (row(index="none", default=2.5, low=0.0), {"default": ("2.5", ["NEW"])}),
    (row(index="channel", default=7.0, short="NW"), {}),
    # What moves or switches is not written, and what cannot be read is not asked.
    (row(unit="integer", effect="go", low=0.0), {}),
    (row(verb="enable_output", low=0.0), {}),
    (row("setting", "W", default=0.0, low=0.0, short="NW"), {}),
    (row("setting", "R", low=0.0), {}),
    (row("reading", "R", default=0.0, low=0.0), {}),
    (row(unit="text", default="a"), {}),
    # The number of a constant is asked, but no other value.
    (row("constant", "R", "none", "integer", verb="-7"), {"number": ("-7", ["NEW"])}),
    (row("constant", "R", "none", "number", verb="2.5"), {}),
    (row("reading", "R", "none", "integer", verb="7"), {}),
)  # fmt: skip


@pytest.mark.parametrize(("keyword", "asked"), ASKED)
def test_a_question_depends_on_the_row(keyword: Keyword, asked: dict[str, tuple[str, list[str]]]) -> None:
    found = of("mint", keyword)
    shown = {}
    for name, each in found.items():
        assert each.probe is not None
        assert each.probe.alone
        shown[name] = each.probe.answers[0], [*each.probe.before] or [each.probe.ask]
    assert shown == asked


@pytest.mark.parametrize(
    ("keyword", "others"),
    [
        (row(unit="integer", default=1.0, low=0.0, high=3.0), ("0", "2", "3")),
        (row(unit="integer", default=1.0, low=0.0, high=4.0), ("any other number",)),
        (row(unit="integer", default=1.0, high=2.0), ("0", "2")),
        (row(unit="integer", default=-3.0, low=-3.0, high=-2.0), ("-2",)),
        (row(unit="integer", default=1.0, low=1.0, high=1.0), ("any other number",)),
        (row(unit="bool", default=1.0), ("0",)),
        (row(unit="integer", default=1.0, low=0.0), ("any other number",)),
        (row(unit="uu", default=1.0, low=0.0, high=3.0), ("any other number",)),
    ],
)
def test_the_alternatives_to_a_default(keyword: Keyword, others: tuple[str, ...]) -> None:
    assert of("mint", keyword)["default"].alternatives == others


LINES, CODE = "it reports every axis, one per line", "it answers a code: an axis must be named"
# A row of MCCL, and of each of its questions: the question, the chosen answer, the alternative, the command.
BOARD: tuple[tuple[Keyword, dict[str, tuple[str, str, str, str, tuple[str, ...]]]], ...] = (
    (row(low=0.0, high=10.0), {
        "range-high": ("The greatest value of NEW", "10", "11 is taken, too", "{a}NEW11", ("?-1", "")),
        "range-low": ("The least value of NEW", "0", "-1 is taken, too", "{a}NEW-1", ("?-1", "")),
    }),
    (row(index="axes", low=1.0), {
        "range-low": ("The least value of NEW", "1", "0 is taken, too", "{a}NEW0", ("?-1", "")),
    }),
    (row(index="none", high=1.0), {
        "range-high": ("The greatest value of NEW", "1", "2 is taken, too", "NEW2", ("?-1", "")),
    }),
    (row(effect="go", low=0.0), {}),
    (row("command", low=0.0), {}),
    (row("reading", "R"), {
        "axis": ("NEW without an axis number", CODE, LINES, "NEW", (r"re:\?-?\d+", r"re:\d.*")),
    }),
    (row("reading", "R", "axes"), {
        "axis": ("NEW without an axis number", LINES, CODE, "NEW", (r"re:\d.*", r"re:\?-?\d+")),
    }),
    (row("reading", "RW", "axes"), {}),
    (row("reading", "R", "channel"), {}),
    (row("setting", "R"), {}),
)  # fmt: skip


@pytest.mark.parametrize(("keyword", "asked"), BOARD)
def test_a_question_for_a_board_depends_on_the_row(
    keyword: Keyword, asked: dict[str, tuple[str, str, str, str, tuple[str, ...]]]
) -> None:
    shown = {}
    for name, each in of("mccl", keyword).items():
        assert each.probe is not None
        (other,) = each.alternatives
        shown[name] = each.question, each.chosen, other, each.probe.ask, each.probe.answers
    assert shown == asked


@pytest.mark.parametrize(("length", "lines"), [(51, 1), (52, 2)])
def test_a_remark_has_110_characters(length: int, lines: int) -> None:
    """The name takes 8 of them, the first word and a blank 51."""
    probe = Probe("mint", "1", answers=("1",), alone=True)
    made_up = Assumption("mint.x", f"{'a' * 50} {'b' * length}", "1", "choice", probe=probe)
    remarks = [line for line in alone(made_up, 0).splitlines() if line.startswith("' ")]
    assert remarks.index("' What it shows, and what that says of the controller:") == lines


@pytest.mark.parametrize(("length", "lines"), [(40, 1), (41, 2)])
def test_a_meaning_has_110_characters(length: int, lines: int) -> None:
    """The answer takes 5 of them, the first word and a blank 51, the end 14."""
    probe = Probe("mint", "1", answers=("1",), alone=True)
    made_up = Assumption("mint.x", "", f"{'a' * 50} {'b' * length}", "choice", probe=probe)
    assert len(meanings(made_up)) == 1 + lines


@pytest.mark.parametrize(("length", "lines"), [(24, 1), (25, 2)])
def test_a_long_answer_has_a_line_of_its_own(length: int, lines: int) -> None:
    probe = Probe("mint", "1", answers=("x" * length,), alone=True)
    assert len(meanings(Assumption("mint.x", "", "1", "choice", probe=probe))) == 1 + lines


def test_the_name_of_a_question_has_no_underscore() -> None:
    (found,) = unsettled_facts("mint", row("constant", "R", "none", "integer", name="_egNEW_X", verb="3"))
    assert (found.name, found.words, found.strength) == ("mint.egnewx-number", ("_egNEW_X",), "choice")
