"""Digital inputs of Mint against a sampling model, and errors in fault entries.

The fault entries are those of the machine file.
"""

from __future__ import annotations

from hypothesis import given, settings
from hypothesis import strategies as st

from motionlang import run
from motionlang.lang.machine.machine import Machine
from motionlang.mint import DIALECT
from motionlang.mint.keywords.io_inputs import Inputs
from motionlang.mint.runtime.environment import Environment
from motionlang.source import Source
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
    environment = Environment(machine)
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


def test_input_repeats_by_time_and_by_position() -> None:
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


CONTACT = [{"channel": 0, "at": 0.0103}]


def first_seen(samples: int, text: str = "INX(0)") -> str:
    """Return the TIME, ms, at which a loop sees a contact that closes at 10.3 ms."""
    program = f"INPUTDEBOUNCE = {samples}\nRepeat\nUntil {text}\nPRINT TIME"
    return run(Source("a.mnt", program), machine={"input": CONTACT}, cache=False).output[0]


def test_one_sample_is_no_debouncing() -> None:
    """With 1, the default, a reading is the present level (manual MN1270 p. 95).

    With 2, two samples are needed, at 11 and 12 ms.
    """
    assert [first_seen(samples) for samples in (1, 2, 3, 10)] == ["10", "12", "13", "20"]
    assert run(Source("a.mnt", "PRINT INPUTDEBOUNCE, IDB(1)"), cache=False).output == ["11"]


def test_instate_shows_the_last_sample_of_a_debounced_bank() -> None:
    assert [first_seen(samples, "INSTATEX(0)") for samples in (1, 2, 10)] == ["10", "11", "11"]


def test_debouncing_takes_1_to_10_samples() -> None:
    for samples in (0, 11):
        result = run(Source("a.mnt", f"INPUTDEBOUNCE = {samples}"), cache=False)
        assert [(each.code, each.hint) for each in result.diagnostics] == [("range", "it takes 1 to 10")]


def test_an_input_shows_its_level_at_once_when_debouncing_ends() -> None:
    text = "INPUTDEBOUNCE = 10\nWAIT = 15\nPRINT INX(0)\nINPUTDEBOUNCE = 1\nPRINT INX(0)\nWAIT = 10\nPRINT INX(0)"
    assert run(Source("a.mnt", text), machine={"input": CONTACT}, cache=False).output == ["0", "1", "1"]


def test_a_sample_that_is_due_later_is_dropped_when_debouncing_ends() -> None:
    """A change at 2.5 ms is sampled at 3 ms; debouncing ends at 2.7 ms."""
    begin = "INPUTDEBOUNCE = 10\nWAIT = 2\n" + "n = 1\n" * 4
    text = f"{begin}PRINT INX(0)\nINPUTDEBOUNCE = 1\nPRINT INX(0)\nWAIT = 5\nPRINT INX(0)"
    machine = {"input": [{"channel": 0, "at": 0.0025}], "controller.instruction_time": 1e-4}
    assert run(Source("a.mnt", text), machine=machine, cache=False).output == ["0", "1", "1"]


def test_bank_is_the_bank_of_keywords_without_brackets() -> None:
    text = "BANK = 1\nINPUTDEBOUNCE = 3\nOUT = 5\nPRINT BANK, INPUTDEBOUNCE(0), INPUTDEBOUNCE(1), OUTX(32), OUTX(34)"
    assert run(Source("a.mnt", text), cache=False).output == ["11311"]


def test_a_program_may_declare_bank_itself() -> None:
    text = "Dim bank As Integer = 7\nOUT = 1\nPRINT bank, OUT(0), OUT(1)"
    assert run(Source("a.mnt", text), cache=False).output == ["710"]


def test_the_printed_errors_of_the_start_are_constants() -> None:
    text = "PRINT _ieFAILED_TO_READ_CARRIER_EEPROM, _ieFAILED_TO_SET_WATCHDOG, _ieEEPROM_DEFAULTS_USED, INITERROR"
    assert run(Source("a.mnt", text), cache=False).output == ["510110"]
