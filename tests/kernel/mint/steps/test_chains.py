"""Thousands of chained terms, conditions or statements run like a few."""

from __future__ import annotations

import sys
from math import fsum, nextafter

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Run, Source, dialect, run
from tests.cases import one_in

# More operands than Python's stack has frames.
LENGTH = 1500
HEAD = "Dim a As Integer, f As Float\n"
COUNTED = "\nFunction Counted(k As Integer) As Integer\na = a + 1\nCounted = k\nEnd Function"
# A condition that is true by its last operand alone, and one that is false by it alone.
ANY = " Or ".join([*(f"a = {n}" for n in range(1, LENGTH)), "a = 0"])
ALL = " And ".join([*(f"a <> {n}" for n in range(1, LENGTH)), "a <> 0"])

CHAINS = {
    "constants": ("PRINT 1" + " + 1" * LENGTH, "1501"),
    "integers": ("a = 1 : PRINT a" + " + a" * LENGTH, "1501"),
    "floats": ("f = 0.5 : PRINT f" + " - f" * LENGTH, "-749.5000"),
    # 1 / 3 / 3 … * 3 * 3 …, which other brackets would not bring back to 1.
    "products": ("f = 3 : PRINT 1" + " / f" * 600 + " * f" * 600, "1.0000"),
    "tight and loose": ("a = 3 : PRINT 1" + " + a * a - 8" * LENGTH, "1501"),
    "bits": ("a = 7 : PRINT a" + " & a" * LENGTH + " | 8", "15"),
    "texts": ('PRINT Len(""' + ' & "x"' * LENGTH + ")", "1500"),
    "comparisons": ("a = 1 : PRINT 0" + " = a" * LENGTH, "0"),
    "powers": ("f = 1 : PRINT 2" + " ^ f" * LENGTH, "2.0000"),
    "Or": (f"If {ANY} Then PRINT 5", "5"),
    "And": (f"If {ALL} Then PRINT 5 Else PRINT 6", "6"),
    "Or of And": ("If " + " Or ".join(f"a = {n} And a < 9" for n in range(LENGTH, -1, -1)) + " Then PRINT 5", "5"),
    # The first call that is not 0 decides an Or, and the first that is 0 an And.
    "Or of calls": (f"If {' Or '.join(f'Counted({n} > 79)' for n in range(150))} Then PRINT a{COUNTED}", "81"),
    "And of calls": (f"If {' And '.join(f'Counted({n} < 79)' for n in range(150))} Then End\nPRINT a{COUNTED}", "80"),
    "right of an Or": ("If a = 0 Or (1" + " + 1 / a" * LENGTH + ") > 0 Then PRINT 5", "5"),
    "Pause": (
        "Run T\nPAUSE a = 1 And (a" + " + a" * LENGTH + ") > 0\nPRINT a\nEnd\nTask T\nWAIT(10)\na = 1\nEnd Task",
        "1",
    ),
    # 1501 times true, an odd number of them.
    "Xor": ("PRINT 0" + " Xor a = 0" * (LENGTH + 1), "1"),
    "While": ("While a < 7 And " + " And ".join(["a <> 9"] * LENGTH) + "\na = a + 1\nEnd While\nPRINT a", "7"),
    "PAUSE": ("PAUSE " + " And ".join(["IDLE(0)"] * LENGTH) + "\nPRINT 5", "5"),
    "Const": ("Const c = 1" + " + 1" * LENGTH + "\nPRINT c", "1501"),
    "Define": ("Define d = 1" + " + a" * LENGTH + "\na = 2 : PRINT d", "3001"),
    "Case list": (f"Select Case a\nCase {', '.join(map(str, range(LENGTH, -1, -1)))}\nPRINT 5\nEnd Select", "5"),
    "Cases": ("a = 9\nSelect Case a\n" + "".join(f"Case {n}\nPRINT {n}\n" for n in range(LENGTH)) + "End Select", "9"),
    "PRINT": ("PRINT " + "; ".join(["a"] * LENGTH), "0" * LENGTH),
    "one line": (": ".join(["a = a + 1"] * 1100) + ": PRINT a", "1100"),
    "one-line If": ("If a = 0 Then " + ": ".join(["a = a + 1"] * LENGTH) + "\nPRINT a", "1500"),
    "Dim": ("Dim " + ", ".join(f"v{n} As Integer" for n in range(LENGTH)) + "\nPRINT v7", "0"),
}  # fmt: skip


def ran(text: str) -> Run:
    return run(Source("chain.mnt", f"{HEAD}{text}\n"))


@pytest.mark.parametrize("name", one_in(3, CHAINS))
def test_a_chain_of_thousands(name: str) -> None:
    text, shown = CHAINS[name]
    made = ran(text)
    assert (made.status, made.output, made.diagnostics) == ("ended", [shown], [])
    found = check(dialect("mint").program(Source("chain.mnt", f"{HEAD}{text}\n"), {}))
    assert [each for each in found if each.severity == "error"] == []


@pytest.mark.slow
@pytest.mark.parametrize("name", ["floats", "tight and loose", "Or", "While", "PRINT"])
def test_chain_does_not_depend_on_pythons_stack(name: str) -> None:
    """The result is equal deep in the call stack, and with a higher recursion limit."""
    text, shown = CHAINS[name]

    def deep(frames: int) -> list[str]:
        return deep(frames - 1) if frames else ran(text).output

    before = sys.getrecursionlimit()
    assert deep(before // 3) == [shown]
    sys.setrecursionlimit(20 * before)
    try:
        assert ran(text).output == [shown]
    finally:
        sys.setrecursionlimit(before)


@pytest.mark.parametrize("count", [49, 50, 51, 52, 100, 101, 102, 151])
def test_a_chain_is_worked_out_from_the_left(count: int) -> None:
    """Grouping a long chain of operations does not change the rounding of each step.

    Nor does it change an overflow.
    """
    terms = [f"{n % 7}.1" for n in range(count)]
    expected = 0.1
    for term in terms:
        expected += float(term)
    assert expected != fsum([0.1, *map(float, terms)])
    wide = " " * 400  # a text without long lines is not scanned
    chain = "".join(f" + {term}" for term in terms)
    shown = f"PRINT f = {expected!r}, f = {nextafter(expected, 0.0)!r}"
    assert ran(f"f = 0.1\nf = f{chain}{wide}\n{shown}").output == ["10"]
    over = ran(f"a = 2000000000\na = a{' + 0' * count} + a{' - a' * 2}{wide}\nPRINT a")
    assert [each.code for each in over.diagnostics] == ["overflow"]


@pytest.mark.parametrize("opening", ["(", "-", "Abs(", "(1 + "])
def test_what_is_nested_is_limited_as_before(opening: str) -> None:
    closing = ")" if "(" in opening else ""
    assert ran(f"a = {opening * 60}1{closing * 60}").status == "ended"
    made = ran(f"a = {opening * 1000}1{closing * 1000}")
    if opening != "(":  # brackets around brackets leave no trace in the tree
        assert [each.message for each in made.diagnostics] == ["the expression is nested more than 200 deep"]


@pytest.mark.parametrize("count", [50, 51])
def test_a_chain_of_more_than_50_operations_is_no_nesting(count: int) -> None:
    """Each sign is a level; up to 50 operations are levels, too, and a longer chain is one."""
    made = ran(f"a = {'-' * 150}1{' + 1' * count}\nPRINT a")
    messages = ["the expression is nested more than 200 deep"] if count == 50 else []
    assert [each.message for each in made.diagnostics] == messages
    assert made.output == ([] if count == 50 else ["52"])


def chosen(count: int, branch: int, between: str = "") -> str:
    """Return an If with `count` branches that takes only the branch `branch`.

    Every other branch would print another text.
    """
    branches = "".join(f"ElseIf a = {n} Then\nPRINT {n}\n{between}" for n in range(1, count))
    return f"a = {branch}\nIf a = 0 Then\nPRINT 0\n{branches}Else\nPRINT -1\nEnd If\n"


@pytest.mark.parametrize(
    ("count", "branch"), [(3, 2), (101, 100), (102, 101), (103, 102), (103, 103), (LENGTH, 2999)]
)
def test_a_chain_of_elseif_is_no_nesting(count: int, branch: int) -> None:
    """A statement takes 10 µs, and so does each test: in all `tests + 2` statements.

    The two others are the assignment and the PRINT.
    """
    made = ran(chosen(count, branch))
    assert (made.status, made.output) == ("ended", [str(branch) if branch < count else "-1"])
    tests = min(branch + 1, count)
    assert made.time == pytest.approx((tests + 2) * 1e-5, abs=1e-12)


@pytest.mark.parametrize("count", [5, 150])
def test_what_leaves_a_chain_of_elseif(count: int) -> None:
    """An Exit from the loop, Select or function around the chain leaves it."""
    loop = f"For f = 1 To 9\n{chosen(count, count - 1, 'If f = 3 Then Exit For' + chr(10))}Next\nPRINT f"
    assert ran(loop).output == [str(count - 1)] * 3 + ["3.0000"]
    bare = f"Loop\n{chosen(count, count - 1, 'Exit' + chr(10))}End Loop\nPRINT 7"
    assert ran(bare).output == [str(count - 1), "7"]
    select = f"Select Case 1\nCase 1\n{chosen(count, 1, 'Exit Select' + chr(10))}PRINT 8\nEnd Select\nPRINT 7"
    assert ran(select).output == ["1", "7"]
    sub = f"T\nPRINT 7\nSub T()\n{chosen(count, 1, 'Return' + chr(10))}PRINT 8\nEnd Sub"
    assert ran(sub).output == ["1", "7"]
    jump = f"{chosen(count, 1, 'Goto Out' + chr(10))}PRINT 8\n#Out\nPRINT 7"
    assert ran(jump).output == ["1", "7"]
    inside = chosen(count, 0).replace("PRINT 2\n", "#Inside\nPRINT 2\n")
    into = f"Goto Inside\n{inside}PRINT 7"
    assert ran(into).output == ["2", "7"]


def test_exit_select_leaves_the_loops_inside_it() -> None:
    loop = "For a = 1 To 5\nIf a = 3 Then Exit Select\nPRINT a\nNext\nPRINT 9\n"
    text = f"Select Case 1\nCase 1\n{loop}Case 2\nPRINT 8\nEnd Select\nPRINT 7"
    assert ran(text).output == ["1", "2", "7"]


@pytest.mark.parametrize(("mask", "least"), [("a & 3", 0), ("3 & a", 0), ("a | 3", 7)])
def test_a_mask_bounds_a_value_from_below_by_0(mask: str, least: int) -> None:
    """For a = 4, `a & 3` is 0, and 0 - 2147483649 overflows; `a | 3` is 7, and fits."""
    made = ran(f"a = 4\nPRINT {mask}\nPRINT ({mask}) - 2147483647 - 2")
    assert made.output[0] == str(least)
    assert [each.code for each in made.diagnostics] == (["overflow"] if least == 0 else [])


def test_a_mask_of_which_one_side_may_be_negative_has_no_bound_by_that_side() -> None:
    """7 & -1 is 7, more than the upper limit 3 of k: 7 * 500 000 000 overflows."""
    made = ran("For k = -1 To 3\nPRINT 7 & k\nPRINT (7 & k) * 500000000\nNext")
    assert made.output == ["7"]
    assert [each.code for each in made.diagnostics] == ["overflow"]
