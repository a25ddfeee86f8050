"""Conditions, hit counts, log points and destinations, as a user types them."""

from __future__ import annotations

import pytest

from motionlang.ide.debug.breakpoints import Breakpoint
from motionlang.ide.debug.destinations import destination
from motionlang.ide.debug.expressions import WrongExpression, parse
from motionlang.ide.debug.moments import Occurrence, search, together
from motionlang.ide.debug.values import shown
from tests.ide.debug.test_debugger import MOVE, line_of, mint

MAX_LENGTH = 1000
READINGS = {
    "time": 5.0,
    "position": 10.0,
    "velocity": 20.0,
    "target": 30.0,
    "idle": 1.0,
    "input": 40.0,
    "output": 50.0,
}


class State:
    """Variables `a` = 2, `t` = "x", the array `v` and the register R10.

    Every reading has a value of its own.
    """

    def variable(self, name: str, subscripts: list[float]) -> float | str | None:
        if name == "v":
            return 100.0 + subscripts[0] + 10.0 * sum(subscripts[1:])
        known: dict[str, float | str] = {"a": 2.0, "t": "x", "R10": 7.0}
        return None if subscripts else known.get(name)

    def reading(self, what: str, number: int) -> float:
        return READINGS[what] + number


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("1 + 2 * 3", 7.0),
        ("(1 + 2) * 3", 9.0),
        ("7 - 2 - 1", 4.0),
        ("12 / 2 / 3", 2.0),
        ("2 ^ 3 ^ 2", 512.0),
        ("-2 ^ 2", -4.0),
        ("2 ^ -1", 0.5),
        ("+3 - -2", 5.0),
        ("7 \\ 2", 3.0),
        ("-7 \\ 2", -3.0),
        ("7 Mod 3", 1.0),
        ("-7 Mod 3", -1.0),
        ("5.5 Mod 2", 1.5),
        ("1.5e2 + .5", 150.5),
        ("1e-1", 0.1),
        ("1 = 1", 1.0),
        ("1 == 2", 0.0),
        ("1 <> 1", 0.0),
        ("1 != 2", 1.0),
        ("1 < 1", 0.0),
        ("1 <= 1", 1.0),
        ("1 > 1", 0.0),
        ("1 >= 1", 1.0),
        ("1 + 1 = 2", 1.0),
        ("Not 0", 1.0),
        ("Not 1 = 2", 1.0),
        ("Not Not 5", 1.0),
        ("0 Or 2", 1.0),
        ("0 Or 0", 0.0),
        ("3 And 0", 0.0),
        ("3 And 4", 1.0),
        ("1 Or 0 And 0", 1.0),
        ("Not 0 And 0", 0.0),
        ('t = "x"', 1.0),
        ('t + "y"', "xy"),
        ('"b" > "a"', 1.0),
        ('""', ""),
        ("a * a", 4.0),
        ("@10 + R10", 14.0),
        ("v(3)", 103.0),
        ("v[1, 2]", 121.0),
        ("v(0 Or 2)", 101.0),
        ("v(1, 0 Or 2)", 111.0),
        ("(0 Or 2) + 1", 2.0),
        ("v.4", 104.0),
        ("position(0) + pos(1)", 21.0),
        ("VELOCITY(0) + vel(0)", 40.0),
        ("target(2)", 32.0),
        ("idle(0)", 1.0),
        ("input(1) + in(1) + INX(1)", 123.0),
        ("output(1) + out(1) + OUTX(1)", 153.0),
        ("position.3", 13.0),
        ("time", 5.0),
        ("  TIME  ", 5.0),
    ],
)
def test_the_value_of_an_expression(text: str, wanted: float | str) -> None:
    """The operators and their precedence are those of Mint.

    `mod` and `\\` round towards 0.
    """
    assert parse(text)(State()) == wanted


NOT_ONE = " is not an expression such as position(0) > 120"
NEITHER = " is neither a variable here nor a reading that a condition may use"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a.", "'.' has no meaning in an expression"),
        ("1 2", f"'1 2'{NOT_ONE}"),
        ("1 +", f"'1 +'{NOT_ONE}"),
        ("", f"''{NOT_ONE}"),
        ("(1", f"'(1'{NOT_ONE}"),
        ("* 2", f"'* 2'{NOT_ONE}"),
        ("1 = Not 0", f"'1 = Not 0'{NOT_ONE}"),
        ("1 ! 2", "'!' has no meaning in an expression"),
        ('t + 1', "a text and a number cannot be combined"),
        ('t - "a"', 'a number is expected, not "x"'),
        ("Not t", 'a number is expected, not "x"'),
        ("1 / 0", "division by zero"),
        ("1 Mod 0", "division by zero"),
        ("1 \\ 0", "division by zero"),
        ("0 ^ -1", "division by zero"),
        ("(-1) ^ 0.5", "the power has no value"),
        ("10 ^ 400", "the result is too large"),
        ("1e308 * 10 \\ 1", "the result is too large"),
        ("position", "position needs one number in brackets"),
        ("position(1, 2)", "position needs one number in brackets"),
        ("positon(1)", f"positon{NEITHER}; did you mean position?"),
        ("qqqq", f"qqqq{NEITHER}"),
        ("time(1)", f"time{NEITHER}"),
    ],
)  # fmt: skip
def test_a_mistake_in_an_expression(text: str, message: str) -> None:
    with pytest.raises(WrongExpression) as caught:
        parse(text)(State())
    assert str(caught.value).partition("; did you mean time")[0] == message


def test_an_expression_has_a_largest_length() -> None:
    assert parse("1".rjust(MAX_LENGTH))(State()) == 1.0
    with pytest.raises(WrongExpression, match="the expression has 1001 characters; 1000 are allowed"):
        parse("1".rjust(MAX_LENGTH + 1))
    assert parse("-" * 100 + "1")(State()) == 1.0
    with pytest.raises(WrongExpression, match="is not an expression"):
        parse("-" * (MAX_LENGTH - 1) + "1")


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("", [1, 2, 3, 4, 5, 6]),
        ("3", [3]),
        (" = 3 ", [3]),
        ("==3", [3]),
        (">= 3", [3, 4, 5, 6]),
        ("> 3", [4, 5, 6]),
        ("<= 3", [1, 2, 3]),
        ("< 3", [1, 2]),
        (">= 0", [1, 2, 3, 4, 5, 6]),
        ("% 3", [3, 6]),
        ("% 1", [1, 2, 3, 4, 5, 6]),
    ],
)
def test_the_hits_at_which_a_breakpoint_stops(text: str, wanted: list[int]) -> None:
    breakpoint = Breakpoint((1,), hits=text)
    assert [count for count in range(1, 7) if breakpoint.counts(count)] == wanted
    assert breakpoint.is_counted == bool(text)


@pytest.mark.parametrize(
    "text", ["three", "% 0", "0", "= 0", "<= 0", "< 0", "< 1", "<01", "-1", "1234567890", "3 4"]
)
def test_a_hit_count_that_is_none(text: str) -> None:
    with pytest.raises(WrongExpression, match="is no hit count; write 5, >= 5 or % 5"):
        Breakpoint((1,), hits=text)


def test_the_text_of_a_log_point() -> None:
    """An expression that has no value shows why."""
    message = Breakpoint((1,), message="a is {a + 1}, {t}{v(2)}; {1 / 0}.").message
    assert message is not None
    assert message(State()) == 'a is 3, "x"102; <division by zero>.'
    assert Breakpoint((1,)).message is None


@pytest.mark.parametrize(
    ("value", "wanted"),
    [
        (None, "-"),
        (True, "1"),
        (False, "0"),
        (7, "7"),
        (2.5, "2.5"),
        (1 / 3, "0.3333333333"),
        (1e-13, "0"),
        (1e-12, "1e-12"),
        (-0.0, "-0"),
        ("x", '"x"'),
        ([1.0, "a"], '(1, "a")'),
        ((), "()"),
    ],
)
def test_a_value_as_text(value: object, wanted: str) -> None:
    """Numbers have 10 digits; those below 1e-12 are rounding errors."""
    assert shown(value) == wanted


# ------------------------------------------------------------------------------------------------------ moments

# GO is the fourth statement; the ramps take 0.1 s and 2.5 uu each, and 95 uu at 50 uu/s take 1.9 s.
BEGIN = 5e-5


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("position(0) >= 20", BEGIN + 0.45),
        ("position(0) > 99.9999999", BEGIN + 2.1),
        ("velocity(0) >= 25", BEGIN + 0.05),
        ("velocity(0) < 50 And time > 1", BEGIN + 2.0),
        ("idle(0)", BEGIN + 2.1),
        ("Not idle(0)", BEGIN),
        ("output(2)", 3e-5),
        ("input(5) And position(0) > 10", 1.0),
        ("input(5) = 0 And time > 0.5", 0.5),
        ("time > 1.25", 1.25),
        ("axis 0 starts", BEGIN - 1e-5),
        ("AXIS 0 STOPS", BEGIN + 2.1),
        ("input 5 rises", 1.0),
        ("input 5 falls", 1.5),
        ("input 5 changes", 1.0),
        ("output 2 rises", 3e-5),
        ("axis 1 starts", None),
        ("axis 1 stops", None),
        ("input 4 rises", None),
        ("output 2 falls", None),
        ("position(0) > 101", None),
    ],
)
def test_the_time_of_a_moment(text: str, time: float | None) -> None:
    settings: dict[str, object] = {
        "input": [{"channel": 5, "at": 1.0, "value": 1}, {"channel": 5, "at": 1.5, "value": 0}]
    }
    debugger = mint(MOVE, settings)
    debugger.searches = [search(text, range(8))]
    stop = debugger.start(False)
    if time is None:
        assert stop is None
    else:
        assert stop is not None
        assert stop.moment == pytest.approx(time, abs=3e-5)
        assert stop.reason == "moment"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("n > 1", "n is neither a variable here"),
        ("target(0) > 50", "the target of an axis has no history; use position"),
        ("axis 0 turns", "is not an expression"),
    ],
)
def test_a_motion_breakpoint_that_is_none(text: str, message: str) -> None:
    with pytest.raises(WrongExpression) as caught:
        search(text, range(8))
    assert message in str(caught.value)
    assert str(caught.value).endswith(
        "a motion breakpoint is axis 0 starts, axis 0 stops, input 5 rises, output 2 falls or a condition such as "
        "position(0) > 120"
    )


def test_a_condition_may_divide_by_a_reading() -> None:
    """It has a value for the reading at which it is checked before the run."""
    assert search("1 / (position(0) - 1) > 5 Or 1 / velocity(0) > 5", range(8)) is not None
    with pytest.raises(WrongExpression, match="division by zero"):
        search("position(0) / 0 > 1", range(8))


@pytest.mark.parametrize("text", ["axis 8 starts", "axis 8 stops", "position(8) > 1"])
def test_an_axis_of_a_motion_breakpoint_that_does_not_exist(text: str) -> None:
    with pytest.raises(WrongExpression, match=r"^there is no axis 8; this controller has axes 0 to 7$"):
        search(text, range(8))


def test_an_axis_that_a_condition_reads_late_does_not_exist() -> None:
    debugger = mint(MOVE)
    debugger.searches = [search("position(0) > 1 And position(99) > 1", range(8))]
    with pytest.raises(WrongExpression, match="there is no axis 99"):
        debugger.start(False)


def test_the_axes_of_the_machine() -> None:
    assert mint(MOVE).axes == range(8)
    assert mint(MOVE, {"controller.axes": 3}).axes == range(3)


def test_moments_at_the_same_time_are_one() -> None:
    """Two different texts are shown; the rest is counted."""
    first = Occurrence(1.0, "a", 7, "exception")
    others = [Occurrence(1.0, text) for text in ("b", "a", "c", "d")]
    assert together([first]).text == "a"
    assert together([first, others[0]]).text == "a; b"
    found = together([first, *others, Occurrence(2.0, "e")])
    assert (found.time, found.text, found.at, found.reason) == (1.0, "a; b; 2 more", 7, "exception")


@pytest.mark.parametrize(
    ("text", "line"), [("line 3", 3), ("LINE  5", 5), (" 1.0 ", 6), ("0", 1), ("line 1", None)]
)
def test_a_destination(text: str, line: int | None) -> None:
    """Line 1 does not begin again, so the program stays where it is."""
    debugger = mint(MOVE)
    debugger.start()
    destination(debugger, text)()
    assert line_of(debugger) == (line or 1)
    debugger.abandon()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("line 99", "there is no statement in line 99 or below"),
        ("line", "line is no time, such as 2.5, and no line, such as line 12"),
        ("-1", "-1 is no time"),
        ("1e9", "1e9 is no time"),
        ("nan", "nan is no time"),
        ("x" * 50, f"{'x' * 40} is no time"),
    ],
)
def test_a_destination_that_is_none(text: str, message: str) -> None:
    debugger = mint(MOVE)
    debugger.start()
    with pytest.raises(ValueError, match=message):
        destination(debugger, text)
    debugger.abandon()
