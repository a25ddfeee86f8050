"""The names of a program: definitions, uses, blocks, and safe renaming."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang.commands.check import check
from motionlang.kernel import Source, dialect
from motionlang.kernel.lang import Changes, Definition, Names
from tests.cases import cases, examples

GALLERY = sorted(
    path for path in (Path(__file__).parents[3] / "scripts").rglob("*.m*") if path.suffix in (".mnt", ".mcl")
)
PROGRAM = """\
Dim part As Job, size(3) As Integer
Define twice = 2 * x
Const n = 3
Type Job
  Dim x As Float
End Type
part.x = n : SPEED.0 = 3
x = twice
#AGAIN
GoTo AGAIN
For i = 1 To 3
Next i
Fill(x, size)
Run mover
Sub Fill(ByRef n As Integer, b() As Float)
  n = n + b(1)
End Sub
Task mover
  y = x
  Sub inner
    y = 2
  End Sub
End Task
Event IN1
  x = 3
End Event
"""
MACROS = """\
MD1,1MR1000,AL5,AR10
MD2,AL@10,AA@11
MC1,TM1,GT2
"""


def named(found: Names, name: str, kind: str) -> Definition:
    (one,) = (each for each in found.definitions if (each.name, each.kind) == (name, kind))
    return one


def lines(source: Source, definition: Definition) -> list[int]:
    return [source.location(start)[0] for start, _ in definition.uses]


# Kind, name, and the lines on which it is written; counted by eye in `PROGRAM`.
USES = (
    ("variable", "part", [1, 7]),
    ("variable", "size", [1, 13]),
    ("define", "twice", [2, 8]),
    ("constant", "n", [3, 7]),
    ("type", "Job", [1, 4]),
    ("member", "x", [5, 7]),
    ("variable", "x", [2, 8, 13, 19, 25]),
    ("label", "AGAIN", [9, 10]),
    ("variable", "i", [11, 12]),
    ("sub", "Fill", [13, 15]),
    ("parameter", "n", [15, 16, 16]),
    ("parameter", "b", [15, 16]),
    ("task", "mover", [14, 18]),
    ("variable", "y", [19, 21]),
    ("sub", "inner", [20]),
    ("event", "IN1", [24]),
)


@cases("kind, name, wanted", USES)
def test_a_name_of_mint_has_every_use(kind: str, name: str, wanted: list[int]) -> None:
    source = Source("a.mnt", PROGRAM)
    assert lines(source, named(dialect("mint").program(source).names, name, kind)) == wanted


def test_nothing_else_is_a_name() -> None:
    found = dialect("mint").program(Source("a.mnt", PROGRAM)).names
    assert {(each.kind, each.name) for each in found.definitions} == {use[:2] for use in USES}


def test_declarations_are_shown_with_type_and_value() -> None:
    found = dialect("mint").program(Source("a.mnt", PROGRAM)).names
    assert named(found, "n", "constant").text == "Const n = 3"
    assert named(found, "twice", "define").value == "2 * x"
    assert named(found, "size", "variable").text == "Dim size(3) As Integer"
    assert named(found, "x", "variable").text == "x As Float, declared by its first assignment"
    assert named(found, "Fill", "sub").text == "Sub Fill(ByRef n As Integer, b() As Float)"


def test_a_line_that_is_half_typed_hides_no_other_name() -> None:
    broken = PROGRAM.replace("Fill(x, size)", "Fill(x, ")
    found = dialect("mint").program(Source("a.mnt", broken)).names
    assert not found.complete
    assert lines(Source("a.mnt", broken), named(found, "i", "variable")) == [11, 12]
    assert lines(Source("a.mnt", broken), named(found, "x", "variable")) == [2, 8, 19, 25]


def test_a_keyword_may_be_a_name_where_it_can_be_no_keyword() -> None:
    source = Source("a.mnt", "Dim step As Integer\nstep = 2\nFor i = 1 To 9 Step 2\nNext\nPrint step\n")
    assert lines(source, named(dialect("mint").program(source).names, "step", "variable")) == [1, 2, 5]


def test_a_terminal_is_no_label() -> None:
    source = Source("a.mnt", "Dim n\nInput #2, n\nPrint #n, 3\n")
    found = dialect("mint").program(source).names
    assert [each.kind for each in found.definitions] == ["variable"]
    assert lines(source, found.definitions[0]) == [1, 2, 3]


def test_blocks_are_found_with_their_names_and_lines() -> None:
    source = Source("a.mnt", PROGRAM)
    found = [
        (each.kind, each.name, source.location(each.span[0])[0], source.location(each.span[1])[0])
        for each in dialect("mint").program(source).names.blocks
    ]
    assert found == [
        ("type", "Job", 4, 6),
        ("for", "", 11, 12),
        ("sub", "Fill", 15, 17),
        ("task", "mover", 18, 23),
        ("sub", "inner", 20, 22),
        ("event", "IN1", 24, 26),
    ]


def test_one_line_ifs_and_else_ifs_open_no_block() -> None:
    text = "If a Then b = 1\nIf a Then\n  If b Then c = 1 Else c = 2\nElse If b Then\n  c = 3\nEnd If\n"
    source = Source("a.mnt", text)
    assert [
        (each.kind, source.location(each.span[0])[0], source.location(each.span[1])[0])
        for each in dialect("mint").program(source).names.blocks
    ] == [("if", 2, 6)]


def test_macros_and_registers_of_mccl_have_every_use() -> None:
    source = Source("a.mcl", MACROS)
    found = dialect("mccl").program(source).names
    written = {
        (each.kind, each.name): [MACROS[a - 2 : b] for a, b in each.uses] for each in found.definitions
    }
    assert written == {
        ("macro", "1"): ["MD1", "MC1", "TM1"],
        ("macro", "2"): ["MD2", "GT2"],
        ("register", "10"): ["AR10", "L@10"],
        ("register", "11"): ["A@11"],
    }
    assert [each.name for each in found.blocks] == ["1", "2"]


# A name of `PROGRAM` or `MACROS`, a new name, and the reason why it cannot have it.
REFUSED = (
    ("mint", "variable", "x", "speed", "SPEED is a keyword of Mint"),
    ("mint", "variable", "x", "2x", "2x is not a name: use letters, digits and _, and no keyword"),
    ("mint", "variable", "x", "for", "for is not a name: use letters, digits and _, and no keyword"),
    ("mint", "variable", "x", "N", "n is already declared as a constant"),
    ("mint", "parameter", "b", "i", "i is already declared as a variable"),
    ("mint", "event", "IN1", "IN2", "an event handler has the name of its event"),
    (
        "mint", "variable", "i", "x",
        "Define twice contains the name, and its meaning depends on where the Define is used",
    ),
    ("mccl", "macro", "1", "2", "there is already a macro 2"),
    ("mccl", "macro", "1", "1000", ""),
    ("mccl", "macro", "1", "1001", "macros are numbered 0 to 1000, not 1001"),
    ("mccl", "macro", "1", "10000", "10000 is not a number"),
    ("mccl", "macro", "1", "1", ""),
    ("mccl", "macro", "1", "5000", "macros are numbered 0 to 1000, not 5000"),
    ("mccl", "macro", "1", "one", "one is not a number"),
    ("mccl", "register", "10", "11", "register 11 is already in use"),
    ("mccl", "register", "10", "3", "each task has its own registers below 10; the others are shared"),
    ("mccl", "register", "10", "1", "each task has its own registers below 10; the others are shared"),
    ("mccl", "register", "10", "0", "registers are numbered 1 to 255, not 0"),
    ("mccl", "register", "10", "255", ""),
    ("mccl", "register", "11", "10", "register 10 is already in use"),
    ("mccl", "register", "10", "256", "registers are numbered 1 to 255, not 256"),
)  # fmt: skip


@cases("language, kind, name, new, reason", REFUSED)
def test_a_name_that_would_change_the_program_is_refused(
    language: str, kind: str, name: str, new: str, reason: str
) -> None:
    text = PROGRAM if language == "mint" else MACROS
    found = dialect(language).program(Source("a", text)).names
    assert found.problem(named(found, name, kind), new) == reason


@cases(
    "name, settings, last",
    [
        ("a.mcl", {}, 1000),
        ("a.pc1", {}, 255),
        ("a.mcl", {"controller.model": "dcx-pc100"}, 255),
        ("a.pc1", {"controller.model": "multiflex"}, 1000),
    ],
)
def test_the_last_macro_is_that_of_the_board(name: str, settings: dict[str, object], last: int) -> None:
    """The model of the machine file counts before the suffix of the program."""
    found = dialect("mccl").program(Source(name, MACROS), settings).names
    macro = named(found, "1", "macro")
    assert found.problem(macro, str(last)) == ""
    assert found.problem(macro, str(last + 1)) == f"macros are numbered 0 to {last}, not {last + 1}"


def test_a_macro_that_a_register_may_call_keeps_its_number() -> None:
    found = dialect("mccl").program(Source("a.mcl", MACROS + "MC@10\n")).names
    reason = "line 4 calls a macro by a register, so MD1 must keep its number"
    assert found.problem(named(found, "1", "macro"), "7") == reason


def test_local_names_of_two_subs_are_apart() -> None:
    text = "Sub a\n  Dim n\n  n = 1\nEnd Sub\nSub b\n  Dim m\n  m = 1\nEnd Sub\n"
    found = dialect("mint").program(Source("a.mnt", text)).names
    assert found.problem(named(found, "n", "variable"), "m") == ""
    assert [each.name for each in found.visible(text.index("m = 1"))] == ["m", "a", "b"]


@pytest.mark.slow
@cases("path", GALLERY, ids=lambda path: path.name)
def test_the_gallery_with_other_names_gets_the_same_diagnostics(path: Path) -> None:
    """`check` reports the same for the same lines after every name has been changed.

    The names come from another process.
    """
    source = Source.read(path)
    language = dialect("mint" if path.suffix == ".mnt" else "mccl")
    found = pickle.loads(pickle.dumps(language.program(source).names))
    assert found.complete
    edits = []
    for number, each in enumerate(found.definitions):
        new = str(200 + number) if language.name == "mccl" else f"zz{number}"
        if not found.problem(each, new):
            edits += [(start, end, new) for start, end in each.uses]
    text = source.text
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    before, after = (
        check(language.program(source)),
        check(language.program(Source(source.name, text))),
    )
    assert [(each.code, each.line) for each in after] == [(each.code, each.line) for each in before]


FRACTION = st.floats(0.0, 1.0)


@given(st.lists(st.tuples(FRACTION, st.integers(0, 60), st.text("ab1 :\n", max_size=4)), max_size=6))
@settings(max_examples=examples(200), deadline=None)
def test_a_name_that_no_change_touches_is_found_at_its_place(edits: list[tuple[float, int, str]]) -> None:
    """A name is untouched if it and its neighbours are still side by side.

    Each character of the text is followed by its old offset; -1 and the length are the ends.
    """
    found = dialect("mint").program(Source("a.mnt", PROGRAM)).names
    offsets: list[int | None] = [*range(-1, len(PROGRAM) + 1)]
    changes = Changes(len(PROGRAM))
    for where, removed, added in edits:
        at = int(where * (len(offsets) - 2))
        removed = min(removed, len(offsets) - 2 - at)
        offsets[at + 1 : at + 1 + removed] = [None] * len(added)
        changes.add(at, removed, len(added))

    def moved(span: tuple[int, int]) -> tuple[int, int] | None:
        """Return where a span is now, by looking for its characters."""
        near = [*range(span[0] - 1, span[1] + 1)]
        at = offsets.index(near[0]) if near[0] in offsets else len(offsets)
        return (at, at + span[1] - span[0]) if offsets[at : at + len(near)] == near else None

    shifted = found.shifted(changes)
    wanted = {
        each.name: [use for use in map(moved, each.uses) if use is not None]
        for each in found.definitions
        if each.span is None or moved(each.span) is not None
    }
    assert {each.name: each.uses for each in shifted.definitions} == {
        name: uses for name, uses in wanted.items() if uses
    }
    for each in shifted.definitions:
        assert each.span is None or each.span in each.uses
        assert all(shifted.at(start) == (each, (start, end)) for start, end in each.uses)
        assert each.home or each.kind == "sub" or each.scope == (0, len(offsets) - 2)


def test_a_scope_grows_with_what_is_typed_in_it() -> None:
    text = "Sub Work()\n  Dim n\n  n = 1\nEnd Sub\n"
    changes = Changes(len(text))
    changes.add(text.index("  n"), 0, 6)  # a line more
    changes.add(text.index("Sub"), 0, 3)  # a line above
    changes.add(len(text) + 9, 0, 5)  # a line below
    shifted = dialect("mint").program(Source("a.mnt", text)).names.shifted(changes)
    scopes = {each.name: each.scope for each in shifted.definitions}
    assert scopes == {"Work": (0, len(text) + 14), "n": (0, len(text) + 8)}
