"""Values of names that are replaced before compilation: `--set NAME=VALUE`."""

from __future__ import annotations

from motionlang import run
from motionlang.kernel import Source
from tests.cases import cases


@cases(
    "text, values, printed",
    [
        ("Const C = 1\nPRINT C", {"c": 5}, "5"),
        ('Const t = "a"\nPRINT t', {"T": "b"}, "b"),
        ("Dim n As Integer = 3, m As Integer = 4\nPRINT n, m", {"m": 5}, "35"),
        # The first value alone, in the Dim or in an assignment.
        ("Dim n As Integer = 3\nPRINT n;\nn = 4\nPRINT n", {"n": 5}, "54"),
        ("Dim n As Integer\nn = 3 : PRINT n;\nn = 4\nPRINT n", {"n": 5}, "54"),
        ("n = 3\nPRINT n", {"n": 5}, "5.0000"),
        # A value that is computed from the name itself, or that the parent task does not assign, is put into the Dim.
        ("Dim n As Integer\nn = n + 1\nPRINT n", {"n": 5}, "6"),
        ("Dim n As Integer\nn = 2 * (1 + n)\nPRINT n", {"n": 5}, "12"),
        ("Dim n As Integer, m As Integer\nPRINT n, m", {"n": 5}, "50"),
        ("Dim n As Integer\nFill\nPRINT n\nSub Fill()\n n = n + 1\nEnd Sub", {"n": 5}, "6"),
        ("Dim n As Integer\nStartup\n n = 3\nEnd Startup\nPRINT n", {"n": 5}, "5"),
        # Elements are no names, and a keyword is one only if it is declared.
        ("Dim n As Integer, a(2) As Integer\na(1) = 3\nn = 4\nPRINT a(1), n", {"n": 5}, "35"),
        ("SPEED(0) = 3 : n = 4\nPRINT n", {"n": 5}, "5.0000"),
        ("Dim e As Float\nWAIT = 1\ne = 3\nPRINT e", {"e": 5}, "5.0000"),
        (
            "Const p = 1\nDim q As Integer = 2, r As Integer\nr = 3\nPRINT p, q, r",
            {"p": 4, "q": 5, "r": 6},
            "456",
        ),
    ],
)
def test_the_first_value_of_a_name_is_replaced(text: str, values: dict[str, float], printed: str) -> None:
    assert run(Source("a.mnt", text), overrides=values).output == [printed]


@cases(
    "text, name, hint",
    [
        ("Const width = 1\nn = 2", "spin", "the names of the program are width, n"),
        ("Const width = 1\nn = 2\nn = 3", "widht", "did you mean width?"),
        ("PRINT 1", "width", "the program declares no names"),
        ("Dim a(2) As Integer = 1, 2\nDim b(2) As Integer", "a", "the program declares no names"),
        ("SPEED = 5", "n", "the program declares no names"),
        ("SPEED(0, 1) = 5, 6 : WAIT = 3", "SPED", "did you mean SPEED?"),
        ("spd = 5 : SPEED(0) = spd", "spdd", "did you mean spd?"),
        ("n = n + 1", "n", "the program declares no names"),
    ],
)
def test_a_name_that_the_program_does_not_have(text: str, name: str, hint: str) -> None:
    (found,) = run(Source("a.mnt", text), overrides={name: 1.0}).diagnostics
    assert (found.code, found.message, found.hint, found.line) == (
        "unknown-word",
        f"the program has no constant or variable {name}",
        hint,
        0,
    )
