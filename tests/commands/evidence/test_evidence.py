"""The evidence of keywords and assumptions is complete, and none claims more than its source prints."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator

from motionlang.commands.evidence.assumption import Assumption
from motionlang.commands.evidence.entries import assumptions
from motionlang.commands.evidence.fact_evidence import of_word
from motionlang.kernel import dialect, dialects
from tests.commands.evidence.draw import FACTS, ROWS, drawn, line
from tools.fidelity_page import PAGE

# Names outside the tables and grammars: a machine with a motor, any program, the name of a handler.
OTHER_NAMES = {"@motor", "@always", "ONERROR"}
# Of docs/fidelity.md, which a user reads in five minutes.
MAX_WORDS = 1200
# The type library has names, arguments, types and read or write: no meaning, short form, default or range.
LIBRARIES = ("Mint type library", "Mint ActiveX type library, build 5626")
# A contents page and a blog print names; what they mean is remembered.
NAMES_ONLY = ("MN1955 contents", "Mint programming tutorial, part 5")
LARGEST = 8388607.0
# The printed default and range, copied from the pages; None if a page has none.
PRINTED: dict[str, tuple[float | None, tuple[float, float] | None]] = {
    "INPUTDEBOUNCE": (1, (1, 10)),
    "REMOTEMODE": (None, (0, 1)),
    "SPEED": (40000, (0, LARGEST)),
    "FEEDRATE": (40000, (0, LARGEST)),
    "FEEDRATEMODE": (0, (0, 3)),
    "GEARING": (100, (-LARGEST, LARGEST)),
    "GEARINGMODE": (0, (0, 1)),
    "HTA": (0, (-100, 100)),
    "HTADAMPING": (0, (-LARGEST, LARGEST)),
    "HTADEADBAND": (0, (0, 100)),
    "HTAKINT": (0, (-LARGEST, LARGEST)),
    "HTAKPROP": (0, (-LARGEST, LARGEST)),
    "AUXENCODERSPEED": (0, (-LARGEST, LARGEST)),
    "BACKLASH": (0, (-LARGEST, LARGEST)),
    "BACKLASHMODE": (0, (0, 1)),
    "MOVEBUFFERSIZE": (2, (2, 100)),
    "MOVEBUFFERSTATUS": (8, (0, 119)),
    "OFFSETMODE": (0, (0, 3)),
    "PRECISIONOFFSET": (0, (-LARGEST, LARGEST)),
    "LOOPTIME": (1000, None),
    "KINTMODE": (0, (0, 3)),
    "HOMEPOS": (None, (-LARGEST, LARGEST)),
    "SPLINETIME": (None, (4, 60000)),
    "UR": (1, None),
    "PS": (None, (0, 0.5)),
}
# The number of assumptions that no controller can confirm, because they are choices of this program.
OWN = 52


def facts(language: str) -> Iterator[tuple[str, str, str, str]]:
    """Yield each fact of each keyword, the strength of its evidence and its source."""
    for row in dialect(language).table():
        for fact, evidence in of_word(language, row).items():
            yield row.name, fact, evidence.strength, evidence.source


def test_every_assumption_is_complete() -> None:
    assert len(assumptions()) > 400
    for name, each in assumptions().items():
        assert re.fullmatch(r"[a-z]+\.[a-z0-9]+(-[a-z0-9]+)*", name), name
        assert each.question, name
        assert each.chosen, name
        assert each.chosen not in each.alternatives, name


def test_an_assumption_depends_on_keywords_of_a_language() -> None:
    known = {row.name for name in dialects() for row in dialect(name).table()} | OTHER_NAMES
    signs = {"control", "operator", "separator"}
    for name, each in assumptions().items():
        for word in set(each.words) - known:
            assert {kind for kind, _, _ in dialect("mint").tokens(word)} <= signs, (name, word)


def test_the_short_page_is_short() -> None:
    assert len(PAGE.read_text(encoding="utf-8").split()) <= MAX_WORDS


def test_the_alternatives_to_a_default_are_the_other_values_if_they_are_few() -> None:
    """HOMESTATUS is 0 or 1; STOPINPUTMODE is 3 of 0 to 3; ERRORINPUTMODE has six values."""
    for name, alternatives in (
        ("mint.homestatus-default", ["1"]),
        ("mint.stopinputmode-default", ["0", "1", "2"]),
        ("mint.errorinputmode-default", ["any other number"]),
    ):
        assert list(assumptions()[name].alternatives) == alternatives


def test_no_run_loads_the_evidence() -> None:
    text = (
        "import sys; from motionlang import run; from motionlang.kernel.source import Source; "
        "run(Source('a.mnt', 'SPEED(0)=1\\nPRINT POS(0)\\n')); "
        "run(Source('a.mcl', '1TP\\n')); "
        "print({'motionlang.commands.evidence.entries', 'tomllib'} & set(sys.modules) or 'none')"
    )
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, check=False)
    assert done.stdout == "none\n", done.stderr


def test_what_can_be_set_is_an_assumption_with_as_many_alternatives() -> None:
    settable = {
        name: switch for language in dialects() for name, switch in dialect(language).switches().items()
    }
    assert {name for name, each in assumptions().items() if each.key == f"assumptions.{name}"} == set(
        settable
    )
    for name, switch in settable.items():
        each = assumptions()[name]
        if switch.choices:
            assert len(switch.choices) == 1 + len(each.alternatives), name


def test_the_type_library_is_the_source_of_no_meaning() -> None:
    for word, fact, strength, source in facts("mint"):
        if source in LIBRARIES and strength == "code":
            assert fact in ("index", "unit"), word


def test_a_contents_page_and_a_blog_print_nothing() -> None:
    for word, _, strength, source in facts("mint"):
        if source in NAMES_ONLY:
            assert strength.startswith("memory"), word


def test_only_a_meaning_is_known_by_name_only() -> None:
    found = {fact for name in dialects() for _, fact, strength, _ in facts(name) if strength == "name only"}
    assert found == {"meaning"}


def test_a_keyword_known_by_name_only_has_no_meaning() -> None:
    """Its text is the group, a note that the host has it, or its name spelt out; a simulated one does what it says."""
    group = re.compile(r"group$|^host|^listed by the type library without a meaning$|obsolete")
    more = [
        row.name
        for row in dialect("mint").table()
        if of_word("mint", row)["meaning"].strength == "name only"
        and not row.simulated
        and not group.search(row.help)
        and not all(word[:4] in row.name.lower() for word in re.findall(r"[a-z]{3,}", row.help))
    ]
    assert more == []


def test_every_meaning_has_a_source() -> None:
    for language in dialects():
        known = [(row.name, of_word(language, row)["meaning"]) for row in dialect(language).table()]
        assert [name for name, each in known if not each.source and each.strength != "choice"] == []


def test_a_draw_is_repeatable() -> None:
    rows, found = drawn("2026-11-21")
    assert (len(rows), len(found)) == (ROWS, FACTS) == (60, 40)
    again = drawn("2026-11-21")
    assert [line(*each) for each in rows + found] == [line(*each) for each in again[0] + again[1]]
    assert drawn("2026-11-22") != (rows, found)


def test_what_is_marked_as_printed_is_what_the_pages_print() -> None:
    claimed = {}
    for language in dialects():
        for row in dialect(language).table():
            evidence = of_word(language, row)
            default = (
                row.default if "default" in evidence and evidence["default"].strength == "manual" else None
            )
            printed = "range" in evidence and evidence["range"].strength == "manual"
            span = (row.low, row.high) if printed else None
            if default is not None or span is not None:
                claimed[row.name] = (default, span)
    assert claimed == PRINTED


def open_ones() -> list[Assumption]:
    """Return the open assumptions that a controller can confirm."""
    return [each for each in assumptions().values() if each.is_open and not each.own]


def test_every_open_assumption_has_an_alternative() -> None:
    assert [each.name for each in open_ones() if not each.alternatives] == []


def test_what_is_our_own_is_open() -> None:
    own = [each for each in assumptions().values() if each.own]
    assert len(own) == OWN
    assert [each.name for each in own if not each.is_open] == []
