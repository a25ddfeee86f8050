"""Programs as text, and the states and transitions that their maps show."""

from __future__ import annotations

from pathlib import Path

import pytest

import motionlang
from motionlang.kernel import Source
from tests.cli.programs import Cell

CASES = Path(__file__).with_name("states.txt")


def cases() -> list[tuple[str, str, str, str]]:
    """Return name, language, program and expected states of each case of the file."""
    found = []
    for case in CASES.read_text(encoding="utf-8").split("\n=== ")[1:]:
        head, _, rest = case.partition("\n")
        language, _, name = head.partition(": ")
        program, _, states = rest.partition("\n---\n")
        found.append((name, language, program + "\n", states.strip("\n") + "\n"))
    return found


@pytest.mark.parametrize(("name", "language", "program", "states"), cases(), ids=lambda case: str(case)[:40])
def test_states(name: str, language: str, program: str, states: str, cell: Cell) -> None:
    file = f"a.{'mnt' if language == 'mint' else 'mcl'}"
    cell.write(file, program)
    assert cell("map", file).out.partition("\nStates\n\n")[2] == states, name


def sizes(program: str) -> tuple[int, int, int]:
    """Return the numbers of states, transitions and actions of a program."""
    made = motionlang.map(Source("a.mnt", program))
    transitions = [each for diagram in made.diagrams.diagrams for each in diagram.transitions]
    actions = sum(len(each.path) for each in transitions)
    return sum(len(diagram.states) for diagram in made.diagrams.diagrams), len(transitions), actions


# Each If may jump away, so that its sides do not meet; each waits on one side, so that paths multiply.
JUMPS = "If INX({0}) Then GOTO Away\n"
WAITS = "If INX({0}) Then WAIT = 10\n"
NESTED = "If INX({0}) Then\nOUTX({0}) = 1\n"


@pytest.mark.parametrize("line", [JUMPS, WAITS])
def test_the_diagram_grows_with_the_program_and_no_faster(line: str) -> None:
    def made(count: int) -> tuple[int, int, int]:
        body = "".join(line.format(k % 30) for k in range(count))
        return sizes(f"{body}PRINT 1\nEND\n#Away\nPRINT 2\n")

    small, large = made(100), made(400)
    assert all(4.2 * one >= other for one, other in zip(small, large, strict=True))


def test_at_most_a_few_paths_meet_at_a_step() -> None:
    """Of 20 Ifs with a WAIT on one side each, no state has more ways in than two for each path that may meet."""
    program = "".join(WAITS.format(k) for k in range(20)) + "PRINT 1\n"
    made = motionlang.map(Source("a.mnt", program))
    ways: dict[str, int] = {}
    for each in made.diagrams.diagrams[0].transitions:
        ways[each.target.id] = ways.get(each.target.id, 0) + 1
    assert max(ways.values()) <= 2 * 4


def test_ifs_without_a_wait_are_one_transition_however_deep() -> None:
    depth = 50
    program = "".join(NESTED.format(k % 30) for k in range(depth)) + "End If\n" * depth + "PAUSE IDLE(0)\n"
    states, transitions, _ = sizes(program)
    assert (states, transitions) == (3, 2)
