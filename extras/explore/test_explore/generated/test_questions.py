"""Answers about drawn programs that are known without the command: counts, times, recordings, and what a world does.

`python -m test_explore.generated.test_questions 1000` asks so many programs.
"""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import numpy as np
import pytest

from motionlang import compare
from motionlang.cli import main
from motionlang.comparison.texts import plain, without_figures
from motionlang.kernel import Run, Source, dialect_for, run
from motionlang.kernel.lang.debugging import Hook
from motionlang_explore.cover.worlds import Counts
from motionlang_explore.exploration import (
    explore,
    tables_of,
)
from tests.cases import examples
from tests.generated.compared import every_iteration
from tests.generated.machines import machine
from tests.generated.motion import generate
from tests.golden.test_gallery import assert_every_second_is_charged_once

UNTIL = 3.0


def ran(seed: int, hook: Hook | None = None, **more: Hook) -> Run:
    program = generate(seed)
    return run(Source(program.name, program.text), machine=program.machine, until=UNTIL, hook=hook, **more)  # type: ignore[arg-type]


def cover_counts_what_a_debugger_steps_through(seed: int) -> None:
    met: Counter[int] = Counter()
    with every_iteration():
        ran(seed, Hook(lambda task, time, offset: met.update([offset]), limit=0))
    counts = Counts()
    ran(seed, counts, observer=counts)
    begun = {at: count for (at, outcome, _), count in counts.events.items() if outcome == -1 and count}
    assert begun == met


def a_profile_charges_every_second_once(seed: int) -> None:
    assert_every_second_is_charged_once(ran(seed))


def a_run_agrees_with_its_own_recording(seed: int) -> None:
    """The recording is late, scaled, of another zero and of few rows; it may end before the last move has rested."""
    draw, result = Random(seed), ran(seed)
    delay, scale = round(draw.uniform(0.0, 0.5), 3), draw.choice((1.0, 2.5, -1.0))
    rate = draw.choice((100.0, 250.0, 1000.0))
    for axis in result.trace.axes[:1]:
        samples = result.trace.sample(rate, [axis], None, ["position"])
        positions = samples.get(axis, "position")
        if len(positions) < 3 or np.ptp(positions) < 1.0:
            continue
        rows = (
            f"{t + delay:.9f},{scale * x + 3.0:.6f}" for t, x in zip(samples.time, positions, strict=True)
        )
        source = Source("real.csv", "\n".join(["t,x", *rows]))
        found = compare(result, source, {f"position.{axis}": "x"})
        assert abs(found.delay - delay) <= max(1.0 / rate, 0.005)
        remarks = [each.message for each in found.remarks if "not recorded" not in each.message]
        # A scale shows in a whole move alone.
        assert len(remarks) <= (scale != 1.0)
        assert all("times as far as the run" in each for each in remarks)


def transitions_do_what_they_say(seed: int) -> None:
    """The changes of each transition are the entries of a machine file, and the program runs in that."""
    suffix, text, _ = machine(seed)
    source = Source(f"m{suffix}", text)
    program = dialect_for(source, None).program(source, is_debug=True)
    found = explore(program, seconds=1.0)
    for each in (each for node in found.nodes for each in node.transitions):
        world = {**found.switches.settings, **tables_of(each.visit.changed(each.causes))}
        since = each.visit.change_time if each.causes else each.visit.time
        log = run(source, machine=world, until=max(since, 0.0) + each.seconds + 0.001).machine.log
        assert {line for line, _ in each.does.moves} <= {m.line for m in log.moves if m.start_time >= since}
        said = (plain(p.text) for p in log.prints if p.time >= since)
        assert each.does.prints <= set(map(without_figures, said))


def a_world_makes_what_its_head_promises(seed: int) -> None:
    """Where init has found a good piece, verify finds that its file makes what it expects."""
    suffix, text, _ = machine(seed)
    with TemporaryDirectory() as folder, redirect_stdout(StringIO()), redirect_stderr(StringIO()):
        path = Path(folder, f"m{suffix}")
        path.write_text(text)
        if main(["init", str(path), "--seconds", "3"]) == 0:
            assert main(["verify", str(path)]) == 0


CHECKS = (
    cover_counts_what_a_debugger_steps_through,
    a_profile_charges_every_second_once,
    a_run_agrees_with_its_own_recording,
)
OF_MACHINES = (transitions_do_what_they_say, a_world_makes_what_its_head_promises)


@pytest.mark.parametrize("check", CHECKS)
def test_a_known_answer(check: Callable[[int], None]) -> None:
    for seed in range(examples(40)):
        check(seed)


@pytest.mark.slow
@pytest.mark.parametrize("check", OF_MACHINES)
def test_a_known_answer_about_a_machine(check: Callable[[int], None]) -> None:
    for seed in range(10):
        check(seed)


def differs(check: Callable[[int], None], seed: int) -> bool:
    try:
        check(seed)
    except AssertionError:
        return True
    return False


if __name__ == "__main__":
    for check in (*CHECKS, *OF_MACHINES):
        wrong = [seed for seed in range(int(sys.argv[1])) if differs(check, seed)]
        print(f"{check.__name__}: {len(wrong)} of {sys.argv[1]} differ", *wrong)
