"""What an exploration finds in small machines: each program has its states, transitions and cycles in a `.txt`.

The first cycle is the one that a person would name. `pytest --update` rewrites the texts.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from motionlang.kernel import Source, dialect, dialect_of, run
from motionlang_explore.exploration import Interrupted, explore
from test_explore.exploration.text import exploration_text

MACHINES = sorted(path for path in Path(__file__).parent.glob("*.*") if dialect_of(path.name) is not None)

# Machines whose exploration takes a second or more, in so many tests.
PARTS = 4
SLOW = (
    "bank", "cleaning", "crank", "ends", "feeder_marks", "flood", "flow", "handover", "hands", "helper", "host", "jog",
    "labeller", "limits", "mark", "mask", "order", "press", "ready", "robot", "selector", "sorter", "spin", "stages",
    "stopped", "table", "teeth", "third", "together", "turntable", "weigher", "winder",
)  # fmt: skip


def compare(path: Path, golden: Callable[[Path, str], None]) -> None:
    language = dialect_of(path.name)
    assert language is not None
    program = language.program(Source.read(path), is_debug=True)
    golden(path.with_suffix(".txt"), exploration_text(explore(program)))


@pytest.mark.parametrize(
    "path", [each for each in MACHINES if each.stem not in SLOW], ids=lambda path: path.name
)
def test_the_states_of_a_machine(path: Path, golden: Callable[[Path, str], None]) -> None:
    compare(path, golden)


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
def test_the_states_of_slow_machines(part: int, golden: Callable[[Path, str], None]) -> None:
    for path in [each for each in MACHINES if each.stem in SLOW][part::PARTS]:
        compare(path, golden)


def test_an_exploration_ends_when_its_work_is_done() -> None:
    path = Path(__file__).parent / "timeout.mnt"
    language = dialect_of(path.name)
    assert language is not None
    program = language.program(Source.read(path), is_debug=True)
    little = explore(program, seconds=0.001)
    assert not little.is_whole
    assert len(little.nodes) < len(explore(program, seconds=1.0).nodes)


def test_an_exploration_says_what_it_plays() -> None:
    program = dialect("mint").program(
        Source("gate.mnt", "Loop\nPause INX(1)\nMOVER(0) = 5 : GO(0)\nPause Not INX(1)\nEnd Loop\n"),
        is_debug=True,
    )
    said: dict[str, None] = {}
    shares: list[float] = []

    def progress(share: float, playing: str) -> None:
        shares.append(share)
        said[playing] = None

    found = explore(program, progress=progress)
    assert {"start", "input 1 on", "input 1 off", "a world"} <= said.keys()
    assert shares == sorted(shares)
    said.clear()
    found.show(lambda playing: said.update({playing: None}))
    found.turns(found.cycles[0], 2)
    assert list(said) == ["start", "input 1 on", "input 1 off"]


def test_ctrl_c_keeps_what_was_found() -> None:
    path = Path(__file__).parent / "timeout.mnt"
    language = dialect_of(path.name)
    assert language is not None
    program = language.program(Source.read(path), is_debug=True)
    shares: list[float] = []

    def interrupt(share: float, playing: str) -> None:
        shares.append(share)
        if len(shares) == 3:
            raise Interrupted(run(language.program(Source("a.mnt", "WAIT = 10"))))

    found = explore(program, progress=interrupt, keeps=True)
    assert (found.is_whole, len(found.nodes)) == (False, 4)
    assert found.interrupted is not None
    shares.clear()
    with pytest.raises(Interrupted):
        explore(program, progress=interrupt)


@pytest.mark.slow
def test_a_packer_of_the_gallery_runs_in_the_world_that_is_found() -> None:
    """The carton follows the stop, the clamp its valve; guard, start button and row are on."""
    source = Source.read(Path(__file__).parents[4] / "examples" / "old" / "packer.prg")
    language = dialect_of(source.name)
    assert language is not None
    world = explore(language.program(source, is_debug=True)).world
    assert world is not None
    assert world.settings["input"] == [
        {"channel": 0, "output": 1, "delay": 0.3},
        {"channel": 1, "output": 0, "delay": 0.3},
        *({"channel": channel, "at": 0.0} for channel in (2, 3, 4)),
    ]
    assert len([line for line in world.run.output if line.startswith("carton")]) == 17
