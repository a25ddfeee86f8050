"""The channels that runs use are in the maps of their programs, those of the gallery and generated ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from motionlang.kernel import Machine, ProgramError, Run, Source, dialect_for, run, settings_next_to
from motionlang_explore.map.program_map import ProgramMap, program_map
from tests.cases import examples
from tests.generated import handlers, polls, tasks
from tests.generated.motion import generate

ROOT = Path(__file__).parents[4]
GALLERY = sorted(
    path
    for folder in ("scripts/mint", "scripts/mccl", "examples/old")
    for path in (ROOT / folder).iterdir()
    if path.suffix in (".mnt", ".mcl", ".mccl", ".prg")
)
SLICE = 200
UNTIL = 6.0
# The end of programs that poll at every statement.
MAX_POLLS = 0.4
# The families of generated programs in turn.
FAMILIES = ("motion", "words", "tasks", "handlers", "polls")


@pytest.mark.slow
def test_channels_of_the_gallery_are_in_their_maps() -> None:
    found = {path.name: unlisted(Source.read(path), settings_next_to(path)) for path in GALLERY}
    assert {name: each for name, each in found.items() if each} == {}
    assert len(found) > 75


@pytest.mark.slow
def test_channels_of_generated_programs_are_in_their_maps() -> None:
    assert {seed: found for seed in range(examples(SLICE)) if (found := unlisted(*drawn(seed)))} == {}


def unlisted(source: Source, settings: Mapping[str, object], until: float = UNTIL) -> list[str]:
    """Return the channels that a run uses and the map does not list, as sentences."""
    language = dialect_for(source, None)
    try:
        made = program_map(language.program(source, settings), language)
    except ProgramError:
        return []
    read: list[set[int]] = [set(), set()]
    result = run(
        source,
        dialect=language,
        machine=settings,
        until=until,
        begun=lambda machine: _watch_inputs(machine, *read),
    )
    return list(_missing_channels(made, result, *read))


def _watch_inputs(machine: Machine, digital: set[int], analogue: set[int]) -> None:
    """Record the inputs that the controller reads for the program."""
    controller = machine.controller
    one, other = controller.input, controller.analogue_input

    def read(channel: int) -> float:
        digital.add(channel)
        return one(channel)

    def read_analogue(channel: int) -> float:
        analogue.add(channel)
        return other(channel)

    controller.input = read  # type: ignore[method-assign]
    controller.analogue_input = read_analogue  # type: ignore[method-assign]


def _missing_channels(made: ProgramMap, result: Run, digital: set[int], analogue: set[int]) -> Iterator[str]:
    listed = {(each.kind, each.number) for each in made.channels}
    kinds = {kind for kind, number in listed if "bank" in kind or number == "?"}
    log = result.machine.log
    touched = {("output", each.channel) for each in log.outputs}
    touched |= {("analogue output", each.channel) for each in log.analogue_outputs}
    touched |= {("input", channel) for channel in digital} | {
        ("analogue input", channel) for channel in analogue
    }
    for kind, channel in sorted(touched):
        either = (kind, "output") if kind == "input" else (kind,)  # an output of MCCL can be read, too
        if not any((each, str(channel)) in listed for each in either) and not (
            kind in kinds or f"{kind} bank" in kinds
        ):
            yield f"{kind} {channel} is not listed"


def drawn(seed: int) -> tuple[Source, Mapping[str, object], float]:
    """Return a generated program, its machine, and the end of its run; five families take turns."""
    family = FAMILIES[seed % len(FAMILIES)]
    seed //= len(FAMILIES)
    if family in ("motion", "words"):
        made = generate(seed, family)
        return Source(made.name, made.text), made.machine, UNTIL
    text, machine = {"tasks": tasks, "handlers": handlers, "polls": polls}[family].program(seed)
    suffix = "mcl" if family == "polls" and text.lstrip()[:1].isdigit() else "mnt"
    return Source(f"drawn.{suffix}", text), machine, MAX_POLLS
