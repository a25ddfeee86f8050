"""Compare the map of a program with runs of it: `python -m tests.commands.map.proof FIRST COUNT`."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator, Mapping

from motionlang.commands.map.observed import Observed
from motionlang.commands.map.program_map import ProgramMap, program_map
from motionlang.commands.map.units import UnitMap
from motionlang.kernel import Machine, ProgramError, Run, Source, dialect_for, run
from motionlang.kernel.mint.keywords.relays import FIRST
from tests.generated import handlers, polls, tasks
from tests.generated.motion import generate

UNTIL = 6.0
# Those of programs that poll at every statement.
MAX_POLLS = 0.4
# Seconds of real time that a program may take.
PATIENCE = 20
# The families of generated programs in turn, and how often each is drawn.
FAMILIES = ("motion", "words", "tasks", "handlers", "polls")


def problems(source: Source, settings: Mapping[str, object], until: float = UNTIL) -> list[str]:
    """Return what a run does that is not in the map, as sentences."""
    language = dialect_for(source, None)
    try:
        made = program_map(language.program(source, settings), language)
    except ProgramError:
        return []
    observed = Observed(made.diagrams)
    read: list[set[int]] = [set(), set()]

    def begun(machine: Machine) -> None:
        observed.attach(machine)
        _watch_inputs(machine, *read)

    result = run(source, dialect=language, machine=settings, until=until, observer=observed, begun=begun)
    found = [f"transition {a} to {b} is not in a diagram" for a, b in dict.fromkeys(observed.strays)]
    found += _missing_channels(made, result, *read)
    found += _missing_calls(made, observed)
    return found


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
    touched = {_numbered("output", "relay", each.channel) for each in log.outputs}
    touched |= {
        _numbered("analogue output", "auxiliary analogue output", each.channel)
        for each in log.analogue_outputs
    }
    touched |= {("input", channel) for channel in digital} | {
        ("analogue input", channel) for channel in analogue
    }
    for kind, channel in sorted(touched):
        either = (kind, "output") if kind == "input" else (kind,)  # an output of MCCL can be read, too
        if not any((each, str(channel)) in listed for each in either) and not (
            kind in kinds or f"{kind} bank" in kinds
        ):
            yield f"{kind} {channel} is not listed"


def _numbered(kind: str, other: str, channel: int) -> tuple[str, int]:
    """Return kind and number of a channel of the log, which numbers relays and auxiliary outputs from 1000 on."""
    return (other, channel - FIRST) if channel >= FIRST else (kind, channel)


def _missing_calls(made: ProgramMap, observed: Observed) -> Iterator[str]:
    units = {each.title: each for each in made.units}
    titles = [each.title for each in made.structure.units]
    for caller, callee in sorted(observed.calls):
        if not units[titles[callee]].is_reached:
            yield f"{titles[callee]} ran and is listed as never reached"
        if caller >= 0 and titles[callee] not in _called(units, titles[caller]):
            yield f"{titles[caller]} called {titles[callee]}, which the graph does not have"


def _called(units: Mapping[str, UnitMap], title: str) -> set[str]:
    """Return the units that a unit calls, also through others."""
    found, stack = set[str](), [title]
    while stack:
        for each in units[stack.pop()].calls:
            if each not in found:
                found.add(each)
                stack.append(each)
    return found


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


def main(first: int, count: int) -> int:
    """Check programs of seeds; print each finding."""
    wrong = late = 0
    signal.signal(signal.SIGALRM, _give_up)
    for seed in range(first, first + count):
        signal.alarm(PATIENCE)
        try:
            found = problems(*drawn(seed))
        except TimeoutError:
            found, late = [], late + 1
        finally:
            signal.alarm(0)
        wrong += bool(found)
        for each in found[:3]:
            print(f"seed {seed} ({FAMILIES[seed % len(FAMILIES)]}): {each}", flush=True)
    print(f"{count} programs, {wrong} with findings, {late} given up after {PATIENCE} s")
    return 1 if wrong else 0


def _give_up(signum: int, frame: object) -> None:
    raise TimeoutError


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), int(sys.argv[2])))
