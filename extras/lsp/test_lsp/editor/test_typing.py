"""Completion and signatures: the texts that may follow at the cursor."""

from __future__ import annotations

import pytest

from motionlang_lsp.editor.completion import Item, complete
from test_lsp.editor.pages import at_cursor
from tests.cases import cases

SUBS = "Dim speedy As Integer\nConst span = 3\nSub Spin(turns As Float, n)\nEnd Sub\nTask spare\nEnd Task\n"
TYPES = "Type Job\n  Dim size As Float\n  Dim skew As Float\nEnd Type\nDim j As Job\n"


def proposed(text: str, language: str = "mint") -> list[Item]:
    return complete(*at_cursor(text, language))


# Language, a text with the cursor, and labels among the proposals there.
PROPOSED = (
    ("mint", SUBS + "sp|\n", ("speedy", "span", "Spin", "spare", "SPEED")),
    ("mint", SUBS + "Run sp|\n", ("spare",)),
    ("mint", TYPES + "j.s|\n", ("size", "skew")),
    ("mint", TYPES + "Dim k As J|\n", ("Job",)),
    ("mint", "#START\n#STOPPED\nGoto ST|\n", ("START", "STOPPED")),
    ("mint", "Sub a\n  Dim local\nEnd Sub\nSub b\n  lo|\nEnd Sub\n", ("Loop",)),
    ("mint", "x = 3 ' sp|\n", ()),
    ("mint", 'Print "sp|\n', ()),
    ("mint", 'Print "a" sp|\n', ("SPEED",)),
    ("mint", "x = 0x1|\n", ()),
    ("mint", "Dim part2 As Float\npart2|\n", ("part2",)),
    ("mint", "Dim sp As Float\nx = 12sp|\n", ()),
    ("mccl", "1M|\n", ("MR", "MA", "MN")),
    ("mccl", "MD1,1MN\nMD12,1WS\nMC1|\n", ("1", "12")),
    ("mccl", "AL5,AR10,AA@1|\n", ("10",)),
    ("mccl", "1MR100 ; M|\n", ()),
)


@cases("language, text, wanted", PROPOSED)
def test_what_fits_is_proposed(language: str, text: str, wanted: tuple[str, ...]) -> None:
    found = [each.label for each in proposed(text, language)]
    assert [each for each in wanted if each not in found] == []
    assert bool(found) is bool(wanted)


# Language, a text with the cursor, and of some proposals there: label, kind, detail, text, snippet and rank.
WHOLE = (
    (
        "mint",
        SUBS + "sp|\n",
        2,
        (
            ("speedy", "variable", "Dim speedy As Integer", "speedy", "", 0),
            ("span", "constant", "Const span = 3", "span", "", 0),
            ("Spin", "sub", "Sub Spin(turns As Float, n As Float)", "Spin", "Spin(${1:turns}, ${2:n})", 0),
            ("spare", "task", "Task spare", "spare", "", 0),
        ),
    ),
    ("mint", TYPES + "j.s|\n", 1, (("size", "member", "Job.size As Float", "size", "", 0),)),
    ("mint", "#START\nGoto ST|\n", 2, (("START", "label", "#START", "START", "", 0),)),
    (
        "mint",
        "whil|\n",
        4,
        (
            ("While", "block", "block", "while", "While ${1:condition}\n\t$0\nEnd While", 1),
            ("While", "statement", "statement", "while", "", 2),
        ),
    ),
    (
        "mint",
        "MOVER|\n",
        5,
        (
            ("MOVER", "move", "move, uu", "MOVER", "MOVER(${1:0}) = $0", 2),
            (
                "MOVERTEST",
                "setting",
                "setting, not simulated",
                "MOVERTEST",
                "MOVERTEST(${1:axis, param}) = $0",
                3,
            ),
        ),
    ),
    ("mint", "Dim i As in|\n", 2, (("Integer", "type", "", "Integer", "", 1),)),
    (
        "mccl",
        "1M|\n",
        1,
        (
            ("MV", "setting", "setting, uu/s", "MV", "MV${1:n}", 2),
            ("MN", "command", "command", "MN", "", 2),
            ("MR", "move", "move, uu", "MR", "MR${1:n}", 2),
        ),
    ),
    (
        "mccl",
        "MD1,1MN\nMD12,1WS\nMC1|\n",
        1,
        (("1", "macro", "MD1,1MN", "1", "", 0), ("12", "macro", "MD12,1WS", "12", "", 0)),
    ),
    ("mccl", "AL5,AR10,AA@1|\n", 1, (("10", "register", "register 10", "10", "", 0),)),
)


@cases("language, text, begun, wanted", WHOLE)
def test_a_proposal_replaces_what_was_begun(
    language: str, text: str, begun: int, wanted: tuple[tuple[object, ...], ...]
) -> None:
    """The last `begun` characters before the cursor are replaced."""
    found = proposed(text, language)
    assert {each.start for each in found} == {text.index("|") - begun}
    rows = [(each.label, each.kind, each.detail, each.text, each.snippet, each.rank) for each in found]
    assert [row for row in wanted if row not in rows] == []


def test_only_tasks_follow_run_and_only_members_a_dot() -> None:
    assert [each.label for each in proposed(SUBS + "Run |\n")] == ["spare"]
    assert [each.label for each in proposed(TYPES + "j.|\n")] == ["size", "skew"]


def test_names_of_another_sub_are_not_proposed() -> None:
    found = proposed("Sub a\n  Dim local\nEnd Sub\nSub b\n  lo|\nEnd Sub\n")
    assert "local" not in [each.label for each in found]


def test_a_setting_is_completed_with_brackets_and_its_value() -> None:
    snippets = {each.label: each.snippet for each in proposed("SPEE|\n")}
    assert snippets["SPEED"] == "SPEED(${1:0}) = $0"
    read = {each.label: each.snippet for each in proposed("x = SPEE|\n")}
    assert read["SPEED"] == "SPEED(${1:0})"


@pytest.mark.parametrize(
    ("text", "label", "snippet"),
    [
        ("x = Sq|\n", "Sqrt", "Sqrt(${1:number})"),
        ("x = Rn|\n", "Rnd", "Rnd($1)"),
        ("TIM|\n", "TIME", "TIME = $0"),
        ("x = TIM|\n", "TIME", ""),
        ("GO|\n", "GO", "GO(${1:0})"),
        ("x = _trA|\n", "_trAUTO", ""),
    ],
)
def test_a_function_is_completed_with_brackets(text: str, label: str, snippet: str) -> None:
    assert {each.snippet for each in proposed(text) if each.label == label} == {snippet}


def test_a_block_is_completed_with_its_end() -> None:
    (loop,) = (each for each in proposed("Whil|\n") if each.kind == "block")
    assert loop.snippet == "While ${1:condition}\n\t$0\nEnd While"
    assert [each for each in proposed("x = Whil|\n") if each.kind == "block"] == []


def test_a_keyword_gets_the_case_that_was_begun() -> None:
    assert "mover" in [each.text for each in proposed("move|\n")]
    assert "MOVER" in [each.text for each in proposed("MOVE|\n")]


def test_brackets_that_are_there_are_not_added_again() -> None:
    for text in ("SPEE|(0) = 3\n", "SPEE|[0] = 3\n", "SPEE|.0 = 3\n", "SPEE|D = 3\n", "SPEE|_ = 3\n"):
        assert {each.snippet for each in proposed(text) if each.label == "SPEED"} == {""}, text


@pytest.mark.parametrize(
    ("text", "is_prose"),
    [
        ('Print "ab|', True), ('Print "ab|c"', True), ('Print "ab"|', False), ('Print ""|', False),
        ('Print "|', True), ("x = 3 ' wo|rd", True), ("x = 3 ' \"|", True), ("x = 3| ' word", False),
        ("|Print 3", False),
    ],
)  # fmt: skip
def test_text_in_a_comment_or_an_open_string_is_prose(text: str, is_prose: bool) -> None:
    found, offset = at_cursor(text)
    assert found.is_prose(offset) is is_prose


@pytest.mark.parametrize(
    ("text", "is_prose"), [('1MS"|', True), ('1MS"a|', True), ('1MS"a"|', False), ('1MS""|', False)]
)
def test_text_in_an_open_text_of_a_command_is_prose(text: str, is_prose: bool) -> None:
    found, offset = at_cursor(text, "mccl")
    assert found.is_prose(offset) is is_prose
