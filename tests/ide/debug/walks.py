"""Random walks with the debugger change no result and replay every state.

    python -m tests.ide.debug.walks 500 --seed 1

walks through the gallery and through 500 generated programs of both languages.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from random import Random

from motionlang.ide.debug.breakpoints import Breakpoint
from motionlang.ide.debug.debugger import Debugger, Stop
from motionlang.ide.debug.moments import FILTERS, filtered
from motionlang.ide.debug.values import shown
from motionlang.kernel import Source, dialect_for, run, settings_next_to
from tests.generated.motion import UNTIL, generate
from tests.generated.tasks import program as tasks_of
from tests.golden.test_gallery import PROGRAMS
from tests.ide.debug.whole import whole

# Commands of one walk.
STEPS = 12


def go_to_number(debugger: Debugger, number: int) -> Stop | None:
    """Go to a statement by its number."""
    return debugger._arrive(max(number, 1), "goto")


def snapshot(debugger: Debugger) -> object:
    """Return everything that the debugger shows at a stop, except values "at …"."""
    state = debugger.state()
    tasks = state.tasks()
    calls = [
        (frame.name, frame.offset, [(each.name, shown(each.value)) for each in frame.variables])
        for task in tasks
        for frame in state.frames(task.task)
    ]
    scopes = [
        (each.name, shown(each.value))
        for scope in (state.module(), state.inputs(), state.outputs())
        for each in scope
    ]
    scopes += [
        (f"{axis.name} {each.name}", shown(each.value))
        for axis in state.axes()
        for each in axis.value  # type: ignore[attr-defined]
        if " at " not in each.name
    ]
    return state.time, [(each.name, each.why) for each in tasks], calls, scopes


def differences(
    source: Source, settings: Mapping[str, object], seed: int, until: float | None = None
) -> Iterator[str]:
    """Yield each difference that a walk through a program causes."""
    shown_text: list[str] = []
    plain = run(source, machine=settings, until=until)
    if plain.program is None:
        return
    draw = Random(seed)
    debugger = Debugger(source, dialect_for(source, None), settings, until=until, show=shown_text.append)
    stop = debugger.start(draw.random() < 0.8)
    seen: dict[int, tuple[Stop, object]] = {}
    for _ in range(STEPS):
        if stop is not None:
            here = snapshot(debugger)
            before = seen.setdefault(stop.number, (stop, here))
            if before[1] != here:
                yield f"statement {stop.number}: live and replayed state differ"
        stop = _move(debugger, draw, stop, shown_text)
    for number in list(seen)[::-1][:4]:
        again = go_to_number(debugger, number)
        if again is None or snapshot(debugger) != seen[number][1]:
            yield f"statement {number}: the replayed state differs"
    debugger.set_breakpoints([])
    debugger.searches.clear()
    while debugger.go_on() is not None:
        pass
    assert debugger.run is not None
    if whole(debugger.run) != whole(plain):
        yield "the report or the log differs"
    expected: list[str] = []
    run(source, machine=settings, until=until, show=expected.append)
    if "".join(shown_text) != "".join(expected):
        yield "the output differs"
    debugger.abandon()


def _move(debugger: Debugger, draw: Random, stop: Stop | None, output: list[str]) -> Stop | None:
    """Execute a random debugger command and return the stop."""
    commands = ["reverse", "step_back", "restart", "time", "breakpoint", "moment"]
    if stop is not None:
        commands += ["step_in", "next", "step_out", "go_on", "step_in", "next", "change"]
    command = draw.choice(commands)
    if command == "breakpoint":
        lines = draw.sample(debugger.lines, min(2, len(debugger.lines)))
        hits = draw.choice(["", "", "2", "% 3"])
        debugger.set_breakpoints([Breakpoint(debugger.offsets_at(line), "", hits) for line in lines])
        return stop if debugger.stop is not None else debugger.step_back()
    if command == "moment":
        debugger.searches = [filtered(kinds) for _, kinds in FILTERS.values()] if draw.random() < 0.5 else []
        return stop
    if command == "restart":
        output.clear()  # it is shown again
        return debugger.restart(debugger.source)
    if command == "time":
        return debugger.go_to_time(draw.random() * 2.0)
    if command == "change":
        names = [each.name for each in debugger.state().module() if each.set is not None]
        if not names:
            return stop
        return debugger.last_change(("module", draw.choice(names)))
    found: Stop | None = getattr(debugger, command)()
    return found


def of_gallery(seed: int) -> Iterator[str]:
    """Yield the differences of a walk through each program of the gallery."""
    for number, path in enumerate(PROGRAMS):
        found = list(differences(Source.read(path), settings_next_to(path), seed + number))
        yield from (f"{path.name}: {each}" for each in found)


def of_generated(seed: int) -> list[str]:
    """Return the differences of a walk through a generated program.

    One program in three has several tasks; the others are motion programs in Mint and in MCCL.
    """
    if seed % 3 == 0:
        text, settings = tasks_of(seed)
        return list(differences(Source("tasks.mnt", text), settings, seed, 1.5))
    made = generate(seed)
    return list(differences(Source(made.name, made.text), made.machine, seed, UNTIL))


def main() -> int:
    """Walk through the gallery and through generated programs; 1 if anything differs."""
    parser = argparse.ArgumentParser(prog="tests.ide.debug.walks", description=__doc__)
    parser.add_argument("count", type=int, nargs="?", default=500)
    parser.add_argument("--seed", type=int, default=0)
    arguments = parser.parse_args()
    found = list(of_gallery(arguments.seed))
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        found += [f"seed {seed}: {each}" for each in of_generated(seed)]
    print("\n".join(found) or "no differences")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
