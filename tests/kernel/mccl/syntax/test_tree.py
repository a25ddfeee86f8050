"""The syntax tree of a text: what `motionlang.parse` returns."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import motionlang
from motionlang.kernel import ProgramError, dialect
from motionlang.kernel.mccl import table, without_comment
from tests.cases import cases, examples

numbers = st.one_of(
    st.integers(-9999, 9999).map(str),
    st.decimals(-999, 999, places=3).map(str),
    st.sampled_from([".5", "5.", "+3", "-.25", "1e3", "2.5E-1", ""]),
)
parameters = st.one_of(
    numbers, st.integers(0, 255).map("@{}".format), st.sampled_from(['"A"', '"a;b,c d"', '""'])
)
names = st.sampled_from([row.name for row in table()]).flatmap(
    lambda name: st.sampled_from([name, name.lower()])
)
commands = st.builds("{}{}{}".format, st.sampled_from(["", "1", "2", "0", "08"]), names, parameters)
remarks = st.sampled_from(["", "; a remark", " ;1MR5", ";,\"'"])
lines = st.builds(
    "{}{}{}".format,
    st.sampled_from(["", " ", "\t", ","]),
    st.lists(commands, max_size=5).flatmap(
        lambda found: st.sampled_from([",", " ", ", ", ",,", "\t"]).map(
            lambda separator: separator.join(found)
        )
    ),
    remarks,
)
files = st.lists(st.one_of(lines, st.sampled_from(["", "# a whole line", "  #1MR5", ";"])), max_size=6).map(
    "\n".join
)


# The commands that TN1069 prints: their forms, an example and its tree.
PROFILES = {
    "PT": (("aPT",), "1PT", "Command(1, 'PT', None)"),
    "PP": (("aPP",), "2PP", "Command(2, 'PP', None)"),
    "PS": (("aPS", "aPSn"), "1ps0.1", "Command(1, 'PS', 0.1)"),
}


def tree(text: str) -> Any:
    return motionlang.parse(text, "mccl")


def shown(text: str) -> list[str]:
    """Return a text for each line: its number and its commands."""
    return [f"{line.number}: {', '.join(map(repr, line.commands))}" for line in tree(text).lines]


def test_a_line_is_a_list_of_commands() -> None:
    assert shown('# comment\n1MR1000 , 2MR-.5;x\n\nLU"A, B",RL@5,0MC1\n') == [
        "2: Command(1, 'MR', 1000), Command(2, 'MR', -0.5)",
        "4: Command(None, 'LU', 'A, B'), Command(None, 'RL', Register(5)), Command(0, 'MC', 1)",
    ]


def test_a_node_knows_its_offset_which_does_not_count_for_equality() -> None:
    text = " 1MR5,2TP\n3TP\n"
    found = [[text[each.start : each.end] for each in line.commands] for line in tree(text).lines]
    assert found == [["1MR5", "2TP"], ["3TP"]]
    assert tree("1MR5") == tree("  1MR5")
    assert all(tree("1MR5") != tree(other) for other in ("2MR5", "1MA5", "1MR", "1MR5,1MR5"))


@cases(
    "word, forms",
    [
        ("SA", ("aSA", "aSAn")),
        ("CN", ("CNn",)),
        ("US", ("aUSn",)),
        ("LU", ('LU"text"',)),
        ("MN", ("aMN",)),
        ("TP", ()),
    ],
)
def test_the_forms_of_a_command(word: str, forms: tuple[str, ...]) -> None:
    """A number that must not be 0 is not optional."""
    mccl = dialect("mccl")
    row = mccl.table().get(word)
    assert row is not None
    assert mccl.forms(row) == forms


@cases("name", PROFILES)
def test_the_profile_commands_have_the_forms_that_are_printed(name: str) -> None:
    forms, text, made = PROFILES[name]
    mccl = dialect("mccl")
    row = mccl.table().get(name)
    assert row is not None
    assert mccl.forms(row) == forms
    assert shown(text) == [f"1: {made}"]


@settings(max_examples=examples(200))
@given(files)
def test_a_tree_has_the_commands_of_each_line_up_to_its_comment(text: str) -> None:
    found = {
        line.number: [text[each.start : each.end] for each in line.commands] for line in tree(text).lines
    }
    for number, line in enumerate(text.split("\n"), 1):
        code = without_comment(line)
        if '"' not in code:
            assert found.get(number, []) == code.replace(",", " ").split()


def test_every_syntax_error_is_in_the_exception() -> None:
    with pytest.raises(ProgramError) as error:
        motionlang.parse("1MR5,7,1MR1.2.3\n1XX5\n1M\n", "mccl")
    assert [(each.line, each.column) for each in error.value.diagnostics] == [(1, 6), (1, 8), (3, 1)]


def test_a_tree_of_mint_has_a_body() -> None:
    module: Any = motionlang.parse("MOVER(0) = 5\n", "mint")
    assert repr(module.body) == "[Assign(False, Name([Number(0)], False, 'MOVER'), [Number(5)])]"
    with pytest.raises(ProgramError):
        motionlang.parse("MOVER(0) =\n", "mint")
