"""Value change dumps: the complete file, and its values as read by pyvcd."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from motionlang.log import trace as trace_module
from motionlang.result import Run
from motionlang.views.export import write_trace
from motionlang.views.lanes import lanes
from tests.views.runs import ballscrew, ended, new_run, pick

SWITCHED = """\
$version motionlang 0.1.0 $end
$timescale 1 ns $end
$scope module axis0 $end
$var real 64 ! position_uu $end
$var real 64 " velocity_uu_per_s $end
$var real 64 # acceleration_uu_per_s2 $end
$upscope $end
$scope module inputs $end
$var wire 1 $ in3 $end
$var wire 1 % in12 $end
$upscope $end
$scope module outputs $end
$var wire 1 & out1 $end
$upscope $end
$scope module analogue_inputs $end
$var real 64 ' ain0 $end
$upscope $end
$enddefinitions $end
#0
$dumpvars
r0.0 !
r0.0 "
r0.0 #
0$
1%
0&
r0.0 '
$end
#150000001
1&
#250000000
1$
#500000000
r2.5 !
r10.0 "
#600000000
0&
r12.5 '
#1000000000
r7.5 !
r10.0 "
#1500000000
r10.0 !
r0.0 "
"""


def switched() -> Run:
    """Return a run of 10 units at 10 units/s with minimal ramps and switched channels."""
    run, controller = new_run()
    controller.set_scale(0, 100.0)
    for name, value in (("speed", 1000.0), ("accel", 1e12), ("decel", 1e12)):
        controller.configure(0, name, value)
    controller.inputs[12] = 1
    controller.clock.advance(0.150000001)
    controller.outputs[1] = 1
    controller.clock.advance(0.25)
    controller.inputs[3] = 1
    controller.move_by(0, 1000.0)
    controller.clock.advance(0.6)
    controller.outputs[1] = 0
    controller.analogue_inputs[0] = 12.5
    controller.clock.advance(1.5)
    return ended(run)


def test_a_whole_file(tmp_path: Path) -> None:
    write_trace(switched().trace, str(tmp_path / "x.vcd"), 2.0)
    assert (tmp_path / "x.vcd").read_text() == SWITCHED


@pytest.mark.parametrize("make", [ballscrew, pick, switched])
def test_another_program_reads_the_samples_in_it(tmp_path: Path, make: object) -> None:
    run: Run = make()  # type: ignore[operator]
    write_trace(run.trace, str(tmp_path / "x.vcd"), 1000.0)
    found, end = read(tmp_path / "x.vcd")
    assert end == round(run.trace.end * 1e9)
    samples = run.trace.sample(1000.0)
    grid = np.rint(samples.time * 1e9).astype(np.int64)
    for column, values in zip(samples.columns[1:], samples.data[1:], strict=True):
        times, states = found[column.name.replace("_", ".", 1)]
        shown = np.array(states)[np.searchsorted(times, grid, "right") - 1]
        np.testing.assert_allclose(shown, values, rtol=0, atol=1e-6)
        # A viewer that draws straight lines shows the same: no slope during standstill.
        np.testing.assert_allclose(np.interp(grid, times, states), values, rtol=0, atol=1e-6)
    for lane in lanes(run.controller):
        times, states = found[f"{lane.group.replace(' ', '_')}.{lane.name}"]
        assert (times, states) == ([round(time * 1e9) for time in lane.times], lane.values)


def read(path: Path) -> tuple[dict[str, tuple[list[int], list[float]]], int]:
    """Return times (ns) and values of every variable, as pyvcd reads them."""
    reader = pytest.importorskip("vcd.reader")
    kinds = reader.TokenKind
    scope: list[str] = []
    names: dict[str, str] = {}
    found: dict[str, tuple[list[int], list[float]]] = {}
    now = 0
    with path.open("rb") as file:
        for token in reader.tokenize(file):
            if token.kind is kinds.SCOPE:
                scope.append(token.scope.ident)
            elif token.kind is kinds.UPSCOPE:
                scope.pop()
            elif token.kind is kinds.VAR:
                names[token.var.id_code] = ".".join([*scope, token.var.reference])
            elif token.kind is kinds.CHANGE_TIME:
                assert token.time_change >= now
                now = token.time_change
            elif token.kind in (kinds.CHANGE_REAL, kinds.CHANGE_SCALAR):
                change = token.real_change if token.kind is kinds.CHANGE_REAL else token.scalar_change
                times, values = found.setdefault(names[change.id_code], ([], []))
                times.append(now)
                values.append(float(change.value))
    return found, now


def test_chunks_do_not_show(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_trace(pick().trace, str(tmp_path / "one.vcd"), 200.0)
    monkeypatch.setattr(trace_module, "ROWS", 600)
    write_trace(pick().trace, str(tmp_path / "two.vcd"), 200.0)
    assert (tmp_path / "one.vcd").read_bytes() == (tmp_path / "two.vcd").read_bytes()


def test_many_variables_have_names_of_their_own() -> None:
    from motionlang.views.vcd import _identifier

    assert [_identifier(i) for i in (0, 93, 94)] == ["!", "~", '!"']
    assert len({_identifier(i) for i in range(20_000)}) == 20_000
