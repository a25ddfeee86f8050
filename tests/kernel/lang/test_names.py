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


def named(found: Names, name: str, kind: str) -> Definition:
    (one,) = (each for each in found.definitions if (each.name, each.kind) == (name, kind))
    return one


def lines(source: Source, definition: Definition) -> list[int]:
    return [source.location(start)[0] for start, _ in definition.uses]


def test_a_line_that_is_half_typed_hides_no_other_name() -> None:
    broken = PROGRAM.replace("Fill(x, size)", "Fill(x, ")
    found = dialect("mint").program(Source("a.mnt", broken)).names
    assert not found.complete
    assert lines(Source("a.mnt", broken), named(found, "i", "variable")) == [11, 12]
    assert lines(Source("a.mnt", broken), named(found, "x", "variable")) == [2, 8, 19, 25]


def test_a_keyword_may_be_a_name_where_it_can_be_no_keyword() -> None:
    source = Source("a.mnt", "Dim step As Integer\nstep = 2\nFor i = 1 To 9 Step 2\nNext\nPrint step\n")
    assert lines(source, named(dialect("mint").program(source).names, "step", "variable")) == [1, 2, 5]


def test_local_names_of_two_subs_are_apart() -> None:
    text = "Sub a\n  Dim n\n  n = 1\nEnd Sub\nSub b\n  Dim m\n  m = 1\nEnd Sub\n"
    found = dialect("mint").program(Source("a.mnt", text)).names
    assert found.problem(named(found, "n", "variable"), "m") == ""
    assert [each.name for each in found.visible(text.index("m = 1"))] == ["m", "a", "b"]


@pytest.mark.slow
@cases("path", GALLERY, ids=lambda path: path.name)
def test_the_gallery_with_other_names_gets_the_same_diagnostics(path: Path) -> None:
    """`check` reports the same for the same lines after every name has been changed."""
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
