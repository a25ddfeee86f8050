"""The cycles of programs, as `cycles.txt` has them."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from motionlang.commands.quantities import cycle_of
from motionlang.kernel import Run, Source, read_machine, run

TEXT = Path(__file__).with_name("cycles.txt")
SUFFIXES = {"mint": ".mnt", "mccl": ".mccl"}


class Case(NamedTuple):
    """A program with its machine file and its cycle in words."""

    title: str
    source: Source
    machine: str
    expected: str


def cases() -> list[Case]:
    found = []
    for part in re.split(r"^== ", TEXT.read_text(), flags=re.MULTILINE)[1:]:
        title, *lines = part.rstrip().splitlines()
        machine = [line[2:] for line in lines if line.startswith("| ")]
        program = [line for line in lines if line[:2] not in ("| ", "= ")]
        expected = next(line[2:] for line in lines if line.startswith("= "))
        name = title.replace(" ", "-").replace(",", "").split(":")[0]
        source = Source(name + SUFFIXES[title.split(": ")[1]], "\n".join(program).rstrip() + "\n")
        found.append(Case(title, source, "\n".join(machine) + "\n", expected))
    return found


def played(case: Case) -> Run:
    settings = {"run.until": 60.0, **read_machine(Source("machine.toml", case.machine))}
    return run(case.source, machine=settings)


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.title)
def test_the_cycle_of_a_program(case: Case) -> None:
    made = played(case)
    assert not made.diagnostics
    found = made.cycle
    assert (str(found) if found else "none") == case.expected
    if found and found.name:
        assert cycle_of(made, found.name) == found.period


# The pieces of a pallet and those by data differ, and the median of what differs depends on how many there are. A lid
# opens every eleventh time, which only a long run shows.
SAME_FOR_ALL_TIMES = [
    case
    for case in cases()
    if not any(
        word in case.title
        for word in ("pallet", "data say", "now and then", "none", "ends after", "only a lamp", "cut off")
    )
]


@pytest.mark.parametrize("case", SAME_FOR_ALL_TIMES, ids=lambda case: case.title)
def test_the_cycle_does_not_depend_on_how_long_the_run_is(case: Case) -> None:
    settings = read_machine(Source("machine.toml", case.machine))
    found = [
        run(case.source, machine={**settings, "run.until": until}).cycle for until in (60.0, 70.0, 120.0)
    ]
    assert None not in found
    periods = {round(each.period, 3) for each in found if each}
    assert len(periods) == 1
    assert len({(each.name, each.lines) for each in found if each}) == 1
