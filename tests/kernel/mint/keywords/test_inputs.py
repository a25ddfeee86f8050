"""Digital inputs of Mint against a sampling model, the log of outputs, and errors in fault entries.

The fault entries are those of the machine file.
"""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.kernel import Machine, Source
from motionlang.kernel.mint import DIALECT
from motionlang.kernel.mint.keywords.io_inputs import Inputs
from motionlang.kernel.mint.runtime.environment import Environment
from motionlang.kernel.mint.steps.places import Places
from tests.cases import examples

edges = st.lists(st.integers(1, 200), min_size=1, max_size=12, unique=True).map(sorted)


def sampled(times: list[int], samples: int) -> list[tuple[int, bool]]:
    """Return the changes of the debounced state, with times in half milliseconds.

    The state changes after `samples` equal samples of the level, one each millisecond.
    """
    found, state, level, count = [], False, False, 0
    for now in range(300):
        level = level is not (now in times)
        if samples == 1 or now % 2 == 0:
            count = count + 1 if level is not state else 0
            if count == samples:
                state, count = level, 0
                found.append((now, state))
    return found


@settings(max_examples=examples(200))
@given(edges, st.integers(1, 10))
def test_debouncing_is_what_sampling_would_see(times: list[int], samples: int) -> None:
    machine = Machine()
    environment = Environment(machine, Places())
    inputs, levels = environment.component(Inputs), machine.controller.inputs
    inputs.set_debounce(0, samples)
    seen: list[tuple[int, bool]] = []
    inputs.listeners.append(lambda channel, on: seen.append((round(machine.clock.now * 2000), on)))
    for k, time in enumerate(times):
        machine.clock.at(time / 2000, lambda k=k: levels.__setitem__(3, (k + 1) % 2))  # type: ignore[misc]
    machine.clock.advance(1.0)
    assert seen == sampled(times, samples)


def test_a_fault_at_a_line_without_a_statement_is_a_mistake_of_the_machine_file() -> None:
    fault = {"axis": 0, "kind": "error-input", "line": 2}
    result = run(Source("a.mnt", "PRINT 1\n' nothing here\nPRINT 3\n"), machine={"fault": [fault]})
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
    result = run(Source("a.mnt", text), machine={"fault": faults})
    assert (result.diagnostics, result.output) == ([], ["222", "three", "222"])


def test_a_hidden_word_is_no_word() -> None:
    assert "(line)" not in DIALECT.table().names()


def test_an_output_is_logged_as_1_or_0_when_it_changes() -> None:
    text = "OUTX(5) = 7 : OUTX(5) = 1 : OUTX(6) = -1 : OUTX(5) = 0 : OUT(1) = 5"
    result = run(Source("a.mnt", text))
    assert [(each.channel, each.value) for each in result.controller.log.outputs] == [
        (5, 1),
        (6, 1),
        (5, 0),
        (32, 1),
        (34, 1),
    ]
