"""Guesses of a first machine file: inputs that a program waits for."""

from __future__ import annotations

import pytest

from motionlang.analysis.guesses import guessed
from motionlang.execution import dialect
from motionlang.source import Source

# The program, its inputs in the guessed machine file, and when it ends. An input changes 0.3 s after the program
# waits for it; one that has to come and go is on from 1 s to 2 s, from 3 s to 4 s and so on.
PROGRAMS: dict[str, tuple[str, list[dict[str, object]], float]] = {
    "an input": ("PAUSE INX(3) = 1", [{"channel": 3, "at": 0.3}], 0.3),
    "an input that is as wanted": ("PAUSE INX(3) = 0", [], 0.0),
    "a loop": ("While INX(2) = 0\nWend", [{"channel": 2, "at": 0.3}], 0.3),
    "two inputs": (
        "PAUSE INX(3) = 1\nPAUSE INX(4) = 1", [{"channel": 3, "at": 0.3}, {"channel": 4, "at": 0.6}], 0.6,
    ),
    "one that comes and goes, and another one": (
        "PAUSE INX(3) = 1\nPAUSE INX(4) = 1\nPAUSE INX(3) = 0",
        [{"channel": 3, "at": 1.0, "for": 1.0, "every": 2.0}, {"channel": 4, "at": 0.6}],
        2.0,
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PROGRAMS)
def test_an_input_changes_after_the_program_waits_for_it(name: str) -> None:
    text, inputs, time = PROGRAMS[name]
    source, mint = Source("wait.mnt", text + "\nPRINT 7\n"), dialect("mint")
    for reads in (None, mint.input_reads(source)):
        guesses, result = guessed(source, mint, 5.0, {}, reads)
        assert (result.status, result.output) == ("ended", ["7"])
        assert guesses.settings(5.0).get("input", []) == inputs
        assert result.time == pytest.approx(time, abs=1e-3)
