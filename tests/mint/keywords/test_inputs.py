"""Digital inputs of Mint against a plain model that samples them, and mistakes of the machine file's faults."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import assume, given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.lang.machine.machine import Machine
from motionlang.mint import DIALECT
from motionlang.mint.keywords.io_inputs import Inputs
from motionlang.mint.runtime.environment import Environment
from motionlang.source import Source

edges = st.lists(st.integers(1, 200), min_size=1, max_size=12, unique=True).map(sorted)


def sampled(times: list[int], samples: int) -> list[tuple[int, bool]]:
    """When the state changes, in half milliseconds: once the level has been another one for so many milliseconds."""
    found, state, level, since = [], False, False, 0
    for now in range(300):
        if now in times:
            level, since = not level, now
        if level is not state and now - since >= 2 * samples:
            state = level
            found.append((now, state))
    return found


@settings(max_examples=200)
@given(edges, st.integers(1, 20))
def test_debouncing_is_what_sampling_would_see(times: list[int], samples: int) -> None:
    assume(all(after - before != 2 * samples for before, after in pairwise(times)))  # a tie is anybody's
    machine = Machine()
    environment = Environment(machine)
    inputs, levels = environment.part(Inputs), machine.controller.inputs
    inputs.set_debounce(0, samples)
    seen: list[tuple[int, bool]] = []
    inputs.listeners.append(lambda channel, on: seen.append((round(machine.clock.now * 2000), on)))
    for k, time in enumerate(times):
        machine.clock.at(time / 2000, lambda k=k: levels.__setitem__(3, (k + 1) % 2))  # type: ignore[misc]
    machine.clock.advance(1.0)
    assert seen == sampled(times, samples)


def test_a_fault_at_a_line_without_a_statement_is_a_mistake_of_the_machine_file() -> None:
    fault = {"axis": 0, "kind": "error-input", "line": 2}
    result = run(
        Source("a.mnt", "PRINT 1\n' nothing here\nPRINT 3\n"), machine={"fault": [fault]}, cache=False
    )
    assert [(each.code, each.line) for each in result.diagnostics] == [("machine-file", 2)]
    assert result.output == []


def test_a_fault_at_a_line_inside_blocks_subs_and_events() -> None:
    text = """\
Dim n As Integer
For n = 1 To 3
  If n = 2 Then
    PRINT AXISERROR(0), AXISERROR(1), AXISERROR(2)
  End If
  work
Next
PRINT AXISERROR(0), AXISERROR(1), AXISERROR(2)
End

Sub work
  n = n
  If n = 3 Then PRINT "three"
End Sub
"""
    faults = [
        {"axis": 0, "kind": "error-input", "line": 4},
        {"axis": 1, "kind": "error-input", "line": 12},
        {"axis": 2, "kind": "error-input", "line": 13},
    ]
    result = run(Source("a.mnt", text), machine={"fault": faults}, cache=False)
    assert (result.diagnostics, result.output) == ([], ["222", "three", "222"])


def test_a_hidden_word_is_no_word() -> None:
    assert "(line)" not in DIALECT.table().names()


def test_an_input_comes_again_by_time_and_by_place() -> None:
    text = (
        "SPEED(0) = 100 : ACCEL(0) = 1e9 : DECEL(0) = 1e9\nMOVER(0) = 300 : GO(0)\nPAUSE IDLE(0)\nEnd\n"
        'Event IN1\nPRINT "at ", TIME\nEnd Event\nEvent IN2\nPRINT "on ", POS(0) USING 1, 1\nEnd Event'
    )
    entries = [
        {"channel": 1, "at": 0.25, "for": 0.1, "every": 1.25, "times": 3},
        {"channel": 2, "axis": 0, "between": [60.0, 62.0], "every": 100.0, "times": 2},
    ]
    result = run(Source("a.mnt", text), machine={"input": entries}, cache=False)
    assert result.output == ["at 250", "on 60.0", "at 1500", "on 160.0", "at 2750"]
