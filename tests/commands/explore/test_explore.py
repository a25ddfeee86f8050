"""What an exploration finds in small machines: each program has its states, transitions and cycles in a `.txt`.

The first cycle is the one that a person would name. `pytest --update` rewrites the texts.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.commands.explore import explore
from motionlang.commands.explore.view import exploration_text
from motionlang.kernel import Source, dialect_of

MACHINES = sorted(path for path in Path(__file__).parent.glob("*.*") if dialect_of(path.name) is not None)


@pytest.mark.parametrize("path", MACHINES, ids=lambda path: path.name)
def test_the_states_of_a_machine(path: Path, golden: Callable[[Path, str], None]) -> None:
    language = dialect_of(path.name)
    assert language is not None
    program = language.program(Source.read(path), is_debug=True)
    golden(path.with_suffix(".txt"), exploration_text(explore(program), program))


def test_an_exploration_ends_when_its_trials_are_used_up() -> None:
    path = Path(__file__).parent / "timeout.mnt"
    language = dialect_of(path.name)
    assert language is not None
    few = explore(language.program(Source.read(path), is_debug=True), trials=5)
    assert few.trials == 5
