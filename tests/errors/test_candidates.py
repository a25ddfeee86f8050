"""Names that the user may have meant, as data."""

from __future__ import annotations

from motionlang.commands.check import check
from motionlang.kernel import Source, dialect
from tests.cases import cases

# Language, text, the text that the first such finding marks, and what may have been meant.
CANDIDATES = (
    ("mint", "SPEDE = 3\n", "SPEDE", ("SPEED",)),
    ("mint", "counter = 2\nPrint cuonter\n", "cuonter", ("counter",)),
    ("mint", "Dim a As Integr\na = 1 : Print a\n", "Integr", ("Integer",)),
    ("mccl", "MD1,WA1\nMD2,1RM100\nXA5\n", "XA5", ("AX5",)),
    ("mint", "Sleep 100\n", "Sleep", ("WAIT",)),
    ("mint", "Print VELOCITY(0)\n", "VELOCITY", ("SPEED", "VEL")),
    ("mccl", "1MN\n1VELOCITY3\n", "1VELOCITY3", ("1SV3",)),
    ("mint", "Event ONEROR\nEnd Event\n", "Event", ()),  # the whole heading is marked
)  # fmt: skip


@cases("language, text, marked, candidates", CANDIDATES)
def test_a_misspelt_name_has_candidates(
    language: str, text: str, marked: str, candidates: tuple[str, ...]
) -> None:
    source = Source("a", text)
    found = [each for each in check(dialect(language).program(source)) if each.candidates or not candidates]
    assert [each.candidates for each in found[:1]] == [candidates]
    line = source.line(found[0].line)
    assert line[found[0].column - 1 :].startswith(marked)
    assert all(not each.fix for each in found)
