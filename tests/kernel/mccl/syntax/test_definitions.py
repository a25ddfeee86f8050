"""The names of an MCCL file: macros and registers, their uses and new numbers."""

from __future__ import annotations

from motionlang.kernel import Source
from motionlang.kernel.mccl import DIALECT
from tests.cases import cases

PROGRAM = "MD1,AL5,AR20,MC2\nMD2, AA1 ,RA@20,TR10,AR9\nGT1,MC,RA0,AL@9\nMD3,NO\nMD3,1MR@20\n"
# Kind, number, text, the reason why it is fixed, the offset of the definition, and those of all uses.
DEFINITIONS = [
    ("macro", "1", "MD1,AL5,AR20,MC2", "", 2, [2, 44]),
    ("macro", "2", "MD2,AA1,RA@20,TR10,AR9", "", 19, [15, 19]),
    ("register", "20", "register 20", "", None, [10, 30, 73]),
    ("register", "10", "register 10", "", None, [35]),
    ("register", "9", "register 9; each task has its own", "", None, [40, 56]),
    ("macro", "0", "", "line 3 means macro 0 without its number", None, [46]),
    ("register", "0", "register 0, the accumulator", "register 0 is the accumulator", None, [51]),
    ("macro", "3", "MD3,NO", "macro 3 is defined more than once", 60, [60, 67]),
]


def test_the_macros_and_registers_of_a_file_with_all_their_uses() -> None:
    found = DIALECT.program(Source("a.mcl", PROGRAM)).names
    assert found.complete
    rows = [
        (
            each.kind,
            each.name,
            each.text,
            each.fixed,
            each.span and each.span[0],
            [start for start, _ in each.uses],
        )
        for each in found.definitions
    ]
    assert sorted(rows, key=str) == sorted(DEFINITIONS, key=str)
    # Each use is a number, or the command that means 0 without it; a register is used without its @.
    texts = [(each.name, PROGRAM[start:end]) for each in found.definitions for start, end in each.uses]
    assert [(name, text) for name, text in texts if text != name] == [("0", "MC")]
    assert {each.scope for each in found.definitions} == {(0, len(PROGRAM))}
    assert [
        (each.kind, each.name, PROGRAM[slice(*each.at)], PROGRAM[slice(*each.span)]) for each in found.blocks
    ] == [
        ("macro", "1", "1", "MD1,AL5,AR20,MC2"),
        ("macro", "2", "2", "MD2, AA1 ,RA@20,TR10,AR9"),
        ("macro", "3", "3", "MD3,NO"),
    ]


@cases(
    "line, complete",
    [("1MR5", True), ("1XX5", False), ("1TP," * 64, False), ("NO ; 1XX", True), ("AL@5", True)],
)
def test_the_names_of_a_file_with_an_invalid_command_are_not_complete(line: str, complete: bool) -> None:
    assert DIALECT.program(Source("a.mcl", f"MD1,NO\n{line}\n")).names.complete is complete


SHARED = "each task has its own registers below 10; the others are shared"
# The kind, its number, the new number, and the problem.
CHANGES: list[tuple[str, int, str, str]] = [
    ("macro", 1, "1", ""),
    ("macro", 1, "5", ""),
    ("macro", 1, "1000", ""),
    ("macro", 1, "1001", "macros are numbered 0 to 1000, not 1001"),
    ("macro", 1, "2", "there is already a macro 2"),
    ("macro", 1, "9999", "macros are numbered 0 to 1000, not 9999"),
    ("macro", 1, "00005", "00005 is not a number"),
    ("macro", 1, "-5", "-5 is not a number"),
    ("macro", 1, "\u0665", "\u0665 is not a number"),  # an Arabic digit
    ("macro", 1, "", " is not a number"),
    ("macro", 3, "5", "macro 3 is defined more than once"),
    ("macro", 0, "5", "line 3 means macro 0 without its number"),
    ("register", 20, "21", ""),
    ("register", 20, "255", ""),
    ("register", 20, "256", "registers are numbered 1 to 255, not 256"),
    ("register", 20, "0", "registers are numbered 1 to 255, not 0"),
    ("register", 20, "10", "register 10 is already in use"),
    ("register", 20, "8", SHARED),
    ("register", 10, "9", SHARED),
    ("register", 10, "11", ""),
    ("register", 9, "1", ""),
    ("register", 9, "10", SHARED),
    ("register", 0, "8", "register 0 is the accumulator"),
]


@cases("kind, old, new, problem", CHANGES)
def test_a_number_may_be_changed_if_its_meaning_stays(kind: str, old: int, new: str, problem: str) -> None:
    found = DIALECT.program(Source("a.mcl", PROGRAM)).names
    definition = next(each for each in found.definitions if (each.kind, each.name) == (kind, str(old)))
    assert found.problem(definition, new) == problem


def test_a_macro_that_a_register_may_call_keeps_its_number() -> None:
    found = DIALECT.program(Source("a.mcl", "MD1,NO\nMC@20\nMJ@21\n")).names
    definition = next(each for each in found.definitions if (each.kind, each.name) == ("macro", "1"))
    assert found.problem(definition, "1") == ""
    assert found.problem(definition, "2") == "line 2 calls a macro by a register, so MD1 must keep its number"


@cases(
    "file, settings, most",
    [
        ("a.mcl", {}, 1000),
        ("a.pc1", {}, 255),
        ("a.pc1", {"controller.model": "multiflex"}, 1000),
        ("a.mcl", {"controller.model": "dcx-pc100"}, 255),
        ("a.mcl", {"controller.model": "unknown"}, 1000),
    ],
)
def test_the_board_limits_the_numbers_of_macros(file: str, settings: dict[str, object], most: int) -> None:
    found = DIALECT.program(Source(file, "MD1,NO\n"), settings).names
    (definition,) = found.definitions
    assert found.problem(definition, str(most)) == ""
    assert found.problem(definition, str(most + 1)) == f"macros are numbered 0 to {most}, not {most + 1}"
