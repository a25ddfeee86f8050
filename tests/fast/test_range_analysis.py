"""Omitting the checks that range analysis excludes makes no difference."""

from __future__ import annotations

import re
from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.fast.ranges import ranges
from motionlang.mint import DIALECT
from motionlang.mint.compile import intervals
from motionlang.mint.compile.compiler import compile_module
from motionlang.mint.syntax.parser import parse
from motionlang.source import Source
from tests.cases import examples
from tests.mint.programs import Writer
from tests.mint.reference import Reference

ENDS = re.compile(r"^ *(Next|End While|Until .*|End If)$", re.MULTILINE)


def compare(text: str, written: str = "") -> None:
    """Check that the compiled program, or `written`, acts like the reference.

    The reference interprets `text` with all checks.
    """
    source = Source("random.mnt", written or text)
    if DIALECT.check(source):
        return  # an error before the program runs
    slow = Reference(parse(Source("plain.mnt", text)))
    if slow.trouble == "limit":
        return
    fast = run(source, cache=False)
    assert fast.output == slow.printed, text
    # Of two errors in one expression either may be reported.
    assert bool(fast.diagnostics) is bool(slow.trouble), text


@settings(max_examples=examples(100))
@given(st.integers(0, 10**9))
def test_compiled_programs_agree_with_a_plain_interpreter(seed: int) -> None:
    compare(Writer(Random(seed)).program())


def with_labels(text: str) -> str:
    """Return the program with a label at the end of every block, to force jumps."""
    count = iter(range(1000))
    return ENDS.sub(lambda match: f"#here{next(count)}\n{match[1]}", text)


@settings(max_examples=examples(60))
@given(st.integers(0, 10**9))
def test_programs_of_jumps_agree_with_a_plain_interpreter(seed: int) -> None:
    text = Writer(Random(seed)).program()
    compare(text, with_labels(text))


@pytest.mark.long
def test_many_compiled_programs_agree_with_a_plain_interpreter() -> None:
    for seed in range(20_000):
        text = Writer(Random(seed)).program()
        compare(text)
        compare(text, with_labels(text))


def text_of(program: str) -> str:
    return compile_module(parse(Source("a.mnt", program)), None, ranges).code.text


LOOP = "For i = 1 To 1000000\n  x = x + i * 2\n  If x > 1000 Then x = 0\nNext"


@pytest.mark.parametrize(
    "declared", ["", "Dim i As Integer, x As Integer\n", "Dim i As Float, x As Integer\n"]
)
def test_a_bounded_loop_needs_no_check_and_no_float(declared: str) -> None:
    text = text_of(declared + LOOP)
    assert "v_x = v_x + v_i * 2" in text
    assert "v_i += 1" in text


def test_bits_of_a_counter_are_bounded_by_their_mask() -> None:
    head = "Dim i As Integer, x As Integer, y As Integer\n"
    text = text_of(f"{head}For i = 0 To 10\n  x = i & 7\n  y = x * 300000000\nNext")  # 7 * 300000000 fits
    assert "v_y = v_x * 300000000" in text


def test_sum_without_bound_retains_its_check() -> None:
    assert "(z := v_x + v_i)" in text_of("Dim i As Integer, x As Integer\nFor i = 1 To 10\n  x = x + i\nNext")


def test_a_float_without_bound_becomes_a_float() -> None:
    assert "v_x * 2.0" in text_of("x = 1\nLoop\n  x = x * 2\nEnd Loop")


def test_a_subscript_that_is_in_bounds_is_not_checked() -> None:
    text = text_of("Dim a(10) As Integer\nFor i = 1 To 10\n  a(i) = 1\nNext")
    assert "v_a[v_i] = 1" in text


def test_a_variable_of_a_program_with_labels_needs_no_check() -> None:
    text = text_of(
        "Dim n As Integer, a(9) As Integer\nn = 1\n#again\na(n) = n\nn = n + 1\nIf n < 10 Then Goto again"
    )
    assert "v_a[v_n] = v_n" in text
    assert "v_n = v_n + 1" in text


@pytest.mark.parametrize(("raises", "is_plain"), [(12, True), (23, True), (24, False)])
def test_a_bound_that_moves_with_each_iteration_is_followed_23_times(raises: int, is_plain: bool) -> None:
    """Each raises the bound of `x` by 10. From the 24th on, it is that of an Integer."""
    most = 10 * raises + 10
    steps = "".join(f"  If x = {k - 10} Then x = {k}\n" for k in range(most, 10, -10))
    text = text_of(f"Dim x As Integer, a({most}) As Integer\nx = 10\nLoop\n{steps}  a(x) = 1\nEnd Loop")
    assert ("v_a[v_x] = 1" in text) == is_plain


@pytest.mark.parametrize(
    ("written", "python"),
    [
        ("x + y * x - y", "v_x + v_y * v_x - v_y"),
        ("x - (y - x)", "v_x - (v_y - v_x)"),
        ("(x - y) - x", "v_x - v_y - v_x"),
        ("x / (y * x)", "v_x / (v_y * v_x)"),
        ("x * (y / x)", "v_x * (v_y / v_x)"),
        ("x * y / x", "v_x * v_y / v_x"),
        ("(x + y) * (x - y)", "(v_x + v_y) * (v_x - v_y)"),
    ],
)
def test_brackets_are_written_where_python_would_group_differently(written: str, python: str) -> None:
    program = f"Dim x As Float, y As Float, z As Float\nx = TIME : y = TIME\nz = {written}\nPRINT z"
    assert f"v_z = {python}" in text_of(program)


@pytest.mark.parametrize(
    ("dividend", "divisor", "is_plain"),
    [(0, 1, True), (1, 1, True), (5, 2, True), (-1, 1, False), (0, 0, False), (0, -3, False)],
)
@pytest.mark.parametrize(("op", "python"), [("\\", "//"), ("Mod", "%")])
def test_numbers_without_a_sign_are_divided_like_those_of_python(
    dividend: int, divisor: int, is_plain: bool, op: str, python: str
) -> None:
    """Mint rounds a negative quotient toward zero, and Python rounds it down.

    A divisor of 0 is an error that the program can handle.
    """
    loops = f"For i = {dividend} To 10\n  For j = {divisor} To 3\n    k = i {op} j\n  Next\nNext"
    text = text_of(f"Dim i As Integer, j As Integer, k As Integer\n{loops}")
    assert (f"v_i {python} v_j" in text) == is_plain


@pytest.mark.parametrize(
    ("first", "bits", "is_plain"),
    [
        (0, "& 7", True),
        (1, "& 7", True),
        (0, "& 8", False),
        (-1, "& 7", False),
        (0, "| 7", False),
        (0, "& -1", False),
    ],
)
def test_a_mask_without_a_sign_bounds_its_result(first: int, bits: str, is_plain: bool) -> None:
    """300 000 000 times 7 fits into 32 bits, times 8 does not.

    A mask of -1 has no effect.
    """
    text = text_of(
        f"Dim i As Integer, y As Integer\nFor i = {first} To 10\n  y = (i {bits}) * 300000000\nNext"
    )
    assert ("v_y = (v_i & 7) * 300000000" in text) == is_plain
    assert ("z :=" in text) != is_plain


def test_what_fails_under_onerror_leaves_what_was() -> None:
    """The condition of the If fails, so neither branch is executed."""
    text = """
    Dim a(3) As Integer, x As Integer, z As Integer, i As Integer
    For i = 1 To 2
      x = 30
      If 1 / z > 0 Then x = 1 Else x = 2
      a(x) = 7
    Next
    Event ONERROR
      PRINT ERRCODE
    End Event
    """
    assert run(Source("failing.mnt", text), cache=False).diagnostics == []


BOUNDS = st.integers(-(2**33), 2**33)


@given(BOUNDS, BOUNDS, BOUNDS, BOUNDS, st.sampled_from(["+", "-", "*"]), st.booleans(), st.data())
def test_the_range_of_a_result_holds_every_result(
    a: int, b: int, c: int, d: int, op: str, integer: bool, data: st.DataObject
) -> None:
    first, second = (min(a, b), max(a, b), "i"), (min(c, d), max(c, d), "i")
    known, how = intervals.arithmetic(op, integer, first, second)
    x = data.draw(st.integers(first[0], first[1]))
    y = data.draw(st.integers(second[0], second[1]))
    result = x + y if op == "+" else x - y if op == "-" else x * y
    survives = how == intervals.CHECKED and intervals.INT_LOW <= result <= intervals.INT_HIGH
    if how == intervals.PLAIN or survives:
        assert known[0] <= result <= known[1]


@given(st.integers(-1000, 1000), st.integers(-1000, 1000), st.data())
def test_quotients_and_remainders_stay_in_their_ranges(a: int, b: int, data: st.DataObject) -> None:
    from motionlang.mint.runtime.functions import divide, modulo

    first = (min(a, b), max(a, b), "i")
    low = data.draw(st.integers(-20, 20))
    second = (low, low + data.draw(st.integers(0, 20)), "i")
    x, y = data.draw(st.integers(first[0], first[1])), data.draw(st.integers(second[0], second[1]))
    if y:
        known = intervals.quotient(first, second)
        assert known[0] <= divide(x, y) <= known[1]
        known = intervals.remainder(first, second)
        assert known[0] <= modulo(x, y) <= known[1]
