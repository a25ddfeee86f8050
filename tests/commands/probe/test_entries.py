"""The files of evidence are complete, and a run never reads them."""

from __future__ import annotations

import re
import subprocess
import sys

from motionlang.commands.probe.entries import assumptions, chapters, entries_naming
from motionlang.kernel import dialect, dialects
from tools.fidelity_page import PAGE

# Names outside the tables and grammars: a machine with a motor, any program, the name of a handler.
OTHER_NAMES = {"@motor", "@always", "ONERROR"}
# Of docs/fidelity.md, which a user reads in five minutes.
MAX_WORDS = 1200


def test_every_assumption_is_complete() -> None:
    assert len(assumptions()) > 400
    for name, each in assumptions().items():
        assert re.fullmatch(r"[a-z]+\.[a-z0-9]+(-[a-z0-9]+)*", name), name
        assert each.question, name
        assert each.chosen, name
        assert each.chosen not in each.alternatives, name


def test_no_question_is_asked_twice_in_a_chapter() -> None:
    for chapter in chapters():
        questions = [each.question for section in chapter.sections for each in section.assumptions]
        assert sorted(questions) == sorted(set(questions)), chapter.title


def test_an_assumption_depends_on_keywords_of_a_language() -> None:
    known = {row.name for name in dialects() for row in dialect(name).table()} | OTHER_NAMES
    signs = {"control", "operator", "separator"}
    for name, each in assumptions().items():
        for word in set(each.words) - known:
            assert {kind for kind, _, _ in dialect("mint").tokens(word)} <= signs, (name, word)


def test_the_short_page_has_the_figures_of_the_entries() -> None:
    text = PAGE.read_text(encoding="utf-8")
    probed = [each for each in assumptions().values() if each.probe is not None and not each.own]
    rows = re.findall(r"^\| \[.+\| (\d+) \| \d+ \|$", text, re.MULTILINE)
    assert sum(map(int, rows)) == len(probed)


def test_the_short_page_is_short() -> None:
    assert len(PAGE.read_text(encoding="utf-8").split()) <= MAX_WORDS


def test_no_run_loads_the_evidence() -> None:
    text = (
        "import sys; from motionlang import run; from motionlang.kernel.source import Source; "
        "run(Source('a.mnt', 'SPEED(0)=1\\nPRINT POS(0)\\n')); "
        "run(Source('a.mcl', '1TP\\n')); "
        "print({'motionlang.commands.probe.entries', 'tomllib'} & set(sys.modules) or 'none')"
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
        assert each.probe is not None, name
        if switch.choices:
            assert len(switch.choices) == 1 + len(each.alternatives), name
        assert len(switch.choices or [1]) == len(each.probe.answers), name


def test_the_entries_of_a_keyword_are_those_that_name_it() -> None:
    """`help WORD` parses only the entries that name the keyword.

    They are the same as with all files, for each keyword of both languages.
    """
    for language in ("mint", "mccl"):
        for row in dialect(language).table():
            names = [each.name for each in assumptions().values() if row.name in each.words]
            assert [each.name for each in entries_naming(row.name)] == names, row.name
