"""The names of a program for an editor: declarations, uses, scopes, blocks."""

from __future__ import annotations

import pytest

from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT as MINT
from motionlang.kernel.mint.resolve.symbols import Scope
from tests.cases import cases
from tests.counted_calls import count_calls

PAIRS = """\
Type inner
  Dim x As Float, N As Float
End Type
Type pair
  Dim c(2) As inner, n As Integer
End Type
Dim a(2) As pair, b As pair
a(1).c(2).x = b.n
b.c(b.n).x = 1
b.c(1).N = 2
"""
SUBS = """\
Function f(x, ByRef y As Integer, z() As Float) As Integer
  f = x
End Function
Sub g()
  Dim k
  k = 1
End Sub
PRINT f(1, n, q)
Dim n As Integer, q(3)
g()
"""
TASK = """\
Task t
  Dim k
  k = 1
  Sub inner(k)
    k = 2
  End Sub
  inner(k)
End Task
k = 3
Run t
"""
LABELS = """\
Fill()
End
Sub Fill()
#a
GoTo a
End Sub
Sub Other()
#a
GoTo A
End Sub
"""

# A text, and its names: kind, scope and home if not the whole text, line:column of each use, the declaration with
# an asterisk, and its text.
FOUND = [
    ("#a\nGoTo a\nGoTo #a\nGoSub A", ["label a: *1:2 2:6 3:7 4:7 | #a"]),
    ("a:\nGoTo a\nb:\nGoTo b", ["label a: *1:1 2:6 | a:", "label b: *3:1 4:6 | b:"]),
    ("a:\n  b:\nGoTo c", ["label a: *1:1 | a:", "label b: *2:3 | b:", "label c: 3:6 | "]),
    ("a = 1\nPRINT a\na:\nGoTo a", [
        "variable a: *1:1 2:7 | a As Float, declared by its first assignment", "label a: *3:1 4:6 | a:",
    ]),
    ("Fill : PRINT 1\nEnd\nSub Fill()\nEnd Sub", ["sub Fill: 1:1 *3:5 | Sub Fill()"]),
    ("#d\nPRINT 1 : #e\nIf 1 Then #f Else #g\nGoTo d\nGoTo e\nGoTo f\nGoTo g", [
        "label d: *1:2 4:6 | #d", "label e: *2:12 5:6 | #e", "label f: *3:12 6:6 | #f", "label g: *3:20 7:6 | #g",
    ]),
    ("#loop\nGoTo loop\nGoTo #loop\n#step\nGoSub step", [
        "label loop: *1:2 2:6 3:7 | #loop", "label step: *4:2 5:7 | #step",
    ]),
    ("#ONERROR\nReturn\n#other\nGoTo other", ["label ONERROR: *1:2 | #ONERROR", "label other: *3:2 4:6 | #other"]),
    (LABELS, [
        "sub Fill: 1:1 *3:5 | Sub Fill()", "label a in 3-6 of Fill: *4:2 5:6 | #a",
        "sub Other: *7:5 | Sub Other()", "label a in 7-10 of Other: *8:2 9:6 | #a",
    ]),
    ("Dim n\nPRINT #n, 5\nPRINT #n, n", ["variable n: *1:5 2:8 3:8 3:11 | Dim n As Float"]),
    (PAIRS, [
        "type inner: *1:6 5:15 | Type inner: x, n",
        "member x of inner: *2:7 8:11 9:10 | inner.x As Float",
        "member N of inner: *2:19 10:8 | inner.N As Float",
        "type pair: *4:6 7:13 7:24 | Type pair: c, n",
        "member c of pair: *5:7 8:6 9:3 10:3 | pair.c As inner",
        "member n of pair: *5:22 8:17 9:7 | pair.n As Integer",
        "variable a: *7:5 8:1 | Dim a(2) As pair",
        "variable b: *7:19 8:15 9:1 9:5 10:1 | Dim b As pair",
    ]),
    ("x = 1\nPRINT x\nType p\n  Dim x As Float\nEnd Type : PRINT x\nDim b As p\nb.x = x", [
        "variable x: *1:1 2:7 5:18 7:7 | x As Float, declared by its first assignment",
        "type p: *3:6 6:10 | Type p: x", "member x of p: *4:7 7:3 | p.x As Float", "variable b: *6:5 7:1 | Dim b As p",
    ]),
    ("Dim a(3)\na.1 = 5\na.1 = 6\nPRINT a.1, SPEED.0", ["variable a: *1:5 2:1 3:1 4:7 | Dim a(3) As Float"]),
    ("Dim b(2, 4) As Integer, s As String * 5, u As String, began As Time", [
        "variable b: *1:5 | Dim b(2, 4) As Integer", "variable s: *1:25 | Dim s As String * 5",
        "variable u: *1:42 | Dim u As String", "variable began: *1:55 | Dim began As Time",
    ]),
    ('Const k = 5, t = "x", f = 2.5\nPRINT k; t; f', [
        "constant k: *1:7 2:7 | Const k = 5", 'constant t: *1:14 2:10 | Const t = "x"',
        "constant f: *1:23 2:13 | Const f = 2.5",
    ]),
    ("Define k = 5\nDefine e = INX(1) + k : PRINT e; k", [
        "define k: *1:8 2:21 2:34 | Define k = 5", "define e: *2:8 2:31 | Define e = INX(1) + k",
    ]),
    ("For i = 1 To 3\n  PRINT i\nNext i", [
        "variable i: *1:5 2:9 3:6 | i As Float, declared by its first assignment",
    ]),
    (SUBS, [
        "function f: *1:10 2:3 8:7 | Function f(x As Float, ByRef y As Integer, z() As Float) As Integer",
        "parameter x in 1-3 of f: *1:12 2:7 | x As Float",
        "parameter y in 1-3 of f: *1:21 | ByRef y As Integer",
        "parameter z in 1-3 of f: *1:35 | z() As Float",
        "sub g: *4:5 10:1 | Sub g()",
        "variable k in 4-7 of g: *5:7 6:3 | Dim k As Float",
        "variable n: 8:12 *9:5 | Dim n As Integer",
        "variable q: 8:15 *9:19 | Dim q(3) As Float",
    ]),
    (TASK, [
        "task t: *1:6 10:5 | Task t",
        "variable k in 1-8 of t: *2:7 3:3 7:9 | Dim k As Float",
        "sub inner in 1-8 of t: *4:7 7:3 | Sub inner(k As Float)",
        "parameter k in 4-6 of inner: *4:13 5:5 | k As Float",
        "variable k: *9:1 | k As Float, declared by its first assignment",
    ]),
    ("Sub f(f)\n  PRINT f\nEnd Sub\nf(1)", [
        "sub f: *1:5 4:1 | Sub f(f As Float)", "parameter f in 1-3 of f: *1:7 2:9 | f As Float",
    ]),
    ("Task t\n  Dim t\n  t = 1\nEnd Task\nRun t", [
        "task t: *1:6 5:5 | Task t", "variable t in 1-4 of t: *2:7 3:3 | Dim t As Float",
    ]),
    ("a:\nGoTo a\n#A", ["label a: *1:1 2:6 3:2 | a:"]),
    ("Dim n\nDim n As Integer\nn = 1", ["variable n: *1:5 2:5 3:1 | Dim n As Float"]),
    ("Type p\n  Dim x As Float, X As String\nEnd Type\nDim a As p\na.x = 1", [
        "type p: *1:6 4:10 | Type p: x", "member x of p: *2:7 2:19 5:3 | p.x As Float",
        "variable a: *4:5 5:1 | Dim a As p",
    ]),
    ("Event IN1\n  x = 1\nEnd Event\nx = 2", [
        "event IN1: *1:7 | Event IN1", "variable x: 2:3 *4:1 | x As Float, declared by its first assignment",
    ]),
]  # fmt: skip


@cases("text, expected", FOUND)
def test_each_name_has_its_declaration_and_its_uses(text: str, expected: list[str]) -> None:
    source = Source("names.mnt", text)

    def at(offset: int) -> str:
        return ":".join(map(str, source.location(offset)))

    shown = []
    for each in MINT.program(source).names.definitions:
        assert all(text[first:last].lower() == each.name.lower() for first, last in each.uses)
        first, last = each.scope
        lines = f"{source.location(first)[0]}-{source.location(last - 1)[0]}"
        scope = "" if (first, last) == (0, len(text)) else f" in {lines}"
        uses = " ".join(f"{'*' * (span == each.span)}{at(span[0])}" for span in each.uses)
        home = f" of {each.home}" if each.home else ""
        shown.append(f"{each.kind} {each.name}{scope}{home}: {uses} | {each.text}")
    assert shown == expected


def test_no_name_is_looked_up_after_the_check(monkeypatch: pytest.MonkeyPatch) -> None:
    program = MINT.program(Source("a.mnt", SUBS))
    program.require()
    looked_up = count_calls(monkeypatch, (Scope, "find"))
    assert program.names.definitions
    assert program.graph
    assert looked_up.calls == 0


@cases(
    "text, expected",
    [
        ("Event IN1\nEnd Event", {"IN1": True}),
        ("#ONERROR\nReturn\n#a\nGoTo a", {"ONERROR": True, "a": False}),
        ("n = 1 : Const k = 2", {"n": False, "k": False}),
    ],
)
def test_only_a_handler_has_the_name_of_its_event(text: str, expected: dict[str, bool]) -> None:
    assert {
        each.name: bool(each.fixed) for each in MINT.program(Source("a.mnt", text)).names.definitions
    } == expected


@cases(
    "text, expected",
    [
        ("Loop\nWAIT = 1\nEnd Loop", [("loop", "", "Loop", (1, 3))]),
        (
            "Sub f()\n  If 1 Then\n    n = 1\n  End If\nEnd Sub",
            [("sub", "f", "f", (1, 5)), ("if", "", "If", (2, 4))],
        ),
        ("n = 1\nTask t\nEnd Task", [("task", "t", "t", (2, 3))]),
    ],
)
def test_a_block_has_its_name_or_its_first_keyword(
    text: str, expected: list[tuple[str, str, str, tuple[int, int]]]
) -> None:
    """Kind and name, the text that an editor selects, and the first and last line."""
    source = Source("a.mnt", text)
    shown = [
        (each.kind, each.name, text[slice(*each.at)], tuple(source.location(at)[0] for at in each.span))
        for each in MINT.program(source).names.blocks
    ]
    assert shown == expected


RENAMED = """\
Type p
  Dim x As Float
End Type
Type q
  Dim y As Float
End Type
Dim a As p, b As q, n
Define twice = 2 * n
a.x = b.y : n = twice
Sub f(k)
  Dim m
  m = k
End Sub
Sub g(k)
  Dim n
  n = k
End Sub
f(1)
g(1)
#start
GoTo start
"""


@cases(
    "kind, name, new, problem",
    [
        ("variable", "a", "c", ""),
        ("variable", "a", "A", ""),
        ("variable", "a", "b", "b is already declared as a variable"),
        ("variable", "a", "m", "m is already declared as a variable"),
        ("variable", "m", "k", "k is already declared as a parameter"),
        ("variable", "m", "a", "a is already declared as a variable"),
        ("variable", "a", "start", ""),
        ("variable", "a", "p", ""),
        ("variable", "a", "x", ""),
        ("variable", "a", "SPEED", "SPEED is a keyword of Mint"),
        ("label", "start", "SPEED", ""),
        ("label", "start", "a", ""),
        ("member", "x", "y", ""),
        ("member", "x", "SPEED", ""),
        ("type", "p", "q", "q is already declared as a type"),
        ("variable", "a", "1a", "1a is not a name: use letters, digits and _, and no keyword"),
        ("variable", "a", "If", "If is not a name: use letters, digits and _, and no keyword"),
        (
            "variable",
            "b",
            "n",
            "Define twice contains the name, and its meaning depends on where the Define is used",
        ),
        ("define", "twice", "thrice", ""),
        ("parameter", "k", "j", ""),
    ],
)
def test_a_new_name_must_be_free_where_the_name_is_visible(
    kind: str, name: str, new: str, problem: str
) -> None:
    """Labels, members and types may have the names of variables.

    A Define is resolved where it is used.
    """
    found = MINT.program(Source("a.mnt", RENAMED)).names
    definition = next(each for each in found.definitions if (each.kind, each.name) == (kind, name))
    assert found.problem(definition, new) == problem
