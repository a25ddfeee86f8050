"""The syntax tree of a text: what `motionlang.parse` returns."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import motionlang
from motionlang.kernel import ProgramError, dialect
from motionlang.kernel.lang.syntax.word import Word
from motionlang.kernel.mccl import table, without_comment
from motionlang.kernel.mccl.syntax.parser import parse
from motionlang.kernel.mccl.syntax.tree import Command, Line, Module, Register, Wrong
from motionlang.kernel.mint.syntax import nodes
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


# The four commands that TN1069 prints: their forms, an example and its tree.
PROFILES = {
    "PT": (("aPT",), "1PT", Command(1, "PT", None)),
    "PP": (("aPP",), "2PP", Command(2, "PP", None)),
    "PS": (("aPS", "aPSn"), "1PS", Command(1, "PS", None)),
    "PS0.1": (("aPS", "aPSn"), "1ps0.1", Command(1, "PS", 0.1)),
}


def test_a_line_is_a_list_of_commands() -> None:
    text = '# comment\n1MR1000 , 2MR-.5;x\n\nLU"A, B",RL@5,0MC1\n'
    assert motionlang.parse(text, "mccl") == Module(
        [
            Line(2, [Command(1, "MR", 1000), Command(2, "MR", -0.5)]),
            Line(4, [Command(None, "LU", "A, B"), Command(None, "RL", Register(5)), Command(0, "MC", 1)]),
        ]
    )


def test_a_node_knows_its_offset() -> None:
    text = " 1MR5,2TP\n3TP\n"
    module = motionlang.parse(text, "mccl")
    assert isinstance(module, Module)
    assert [[text[each.start : each.end] for each in line.commands] for line in module.lines] == [
        ["1MR5", "2TP"],
        ["3TP"],
    ]
    word = module.lines[0].commands[1].word
    assert isinstance(word, Word)
    assert (word, text[word.start : word.end]) == ("TP", "TP")


def test_nodes_are_equal_if_all_but_their_offsets_are() -> None:
    command = Command(1, "MR", 5)
    assert command == Command(1, "MR", 5, start=7, end=11)
    for other in (
        Command(2, "MR", 5),
        Command(1, "MA", 5),
        Command(1, "MR", None),
        Line(1, [command]),
        "1MR5",
    ):
        assert command != other


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
    forms, text, tree = PROFILES[name]
    mccl = dialect("mccl")
    row = mccl.table().get(tree.word)
    assert row is not None
    assert mccl.forms(row) == forms
    assert motionlang.parse(text, "mccl") == Module([Line(1, [tree])])


@settings(max_examples=examples(200))
@given(files)
def test_a_tree_has_the_commands_of_each_line_up_to_its_comment(text: str) -> None:
    module = motionlang.parse(text, "mccl")
    assert isinstance(module, Module)
    found = {line.number: [text[each.start : each.end] for each in line.commands] for line in module.lines}
    for number, line in enumerate(text.split("\n"), 1):
        code = without_comment(line)
        if '"' not in code:
            assert found.get(number, []) == code.replace(",", " ").split()


@settings(max_examples=examples(300))
@given(st.text(alphabet='1aM.@",; -+e#\n', max_size=12))
def test_every_text_has_a_tree(text: str) -> None:
    """What is no command is in it, too; only separators and comments are left out."""
    module, end = parse(text), 0
    for line in module.lines:
        for command in line.commands:
            between = text[end : command.start]
            assert all(without_comment(each).strip(", \t") == "" for each in between.split("\n"))
            assert command.start < command.end
            assert not isinstance(command, Wrong) or text[command.start : command.end] == command.text
            end = command.end
    assert all(without_comment(each).strip(", \t") == "" for each in text[end:].split("\n"))


def test_every_syntax_error_is_in_the_exception() -> None:
    with pytest.raises(ProgramError) as error:
        motionlang.parse("1MR5,7,1MR1.2.3\n1XX5\n1M\n", "mccl")
    assert [(each.line, each.column) for each in error.value.diagnostics] == [(1, 6), (1, 8), (3, 1)]


def test_a_tree_of_mint_is_a_module() -> None:
    module = motionlang.parse("MOVER(0) = 5\n", "mint")
    assert isinstance(module, nodes.Module)
    assert repr(module.body) == "[Assign(False, Name([Number(0)], False, 'MOVER'), [Number(5)])]"
    with pytest.raises(ProgramError):
        motionlang.parse("MOVER(0) =\n", "mint")
