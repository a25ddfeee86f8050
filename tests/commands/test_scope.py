"""The scope page: its contents, and its arithmetic in a JavaScript engine."""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Callable
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from motionlang.commands.scope import _packed, page, write_scope
from motionlang.kernel import Run, Source, run
from motionlang.kernel.servo import Loop, make_plant, simulate
from tests.generated.motion import generate
from tests.views.runs import ballscrew, ended, new_run, pick, short_shift, switched

PROGRAM = "SPEED(0) = 50\nMOVER(0) = 100 ' </script><script>alert(1)\nGO(0)\n"


def data_of(text: str) -> Any:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.DOTALL)
    assert found is not None
    return json.loads(found[1])


class Engine:
    """The model of the page, whose functions are called with JSON."""

    def __init__(self, made: Run) -> None:
        racer = pytest.importorskip("py_mini_racer")
        self._context = racer.MiniRacer()
        self._context.eval(
            files("motionlang.commands.scope").joinpath("model.js").read_text(encoding="utf-8")
        )
        self._context.eval(f"const data = expand({json.dumps(data_of(page(made)))}); 0")

    def __call__(self, expression: str) -> Any:
        return json.loads(self._context.eval(f"JSON.stringify({expression})"))


@pytest.mark.parametrize("make", [ballscrew, pick, short_shift])
def test_every_value_under_the_cursor_is_that_of_the_trace(make: Callable[[], Run]) -> None:
    made = make()
    engine = Engine(made)
    quantities = ("position", "velocity", "acceleration", "jerk")
    samples = made.trace.sample(1201.3 / made.trace.end, quantities=quantities)
    for k, axis in enumerate(made.trace.axes):
        for order, quantity in enumerate(quantities):
            values = samples.get(axis, quantity)[:-1]
            times = json.dumps(samples.time[:-1].tolist())
            found = engine(f"{times}.map((time) => valueAt(data.axes[{k}].track, time, {order}))")
            assert found == pytest.approx(values.tolist(), rel=1e-9, abs=1e-9 * (1 + np.abs(values).max()))


@pytest.mark.parametrize(
    ("values", "packed"),
    [
        ([2.0, 0.5, 2.0, 2.0], {"of": [2, 0.5], "at": [0, 1, 0, 0]}),
        ([2.0, 0.5, 3.0], [2, 0.5, 3]),
        ([math.nan, math.inf, -math.inf], [0, sys.float_info.max, -sys.float_info.max]),
        ([1e15, -0.0], [1e15, 0]),
    ],
)
def test_numbers_that_recur_are_written_once(values: list[float], packed: object) -> None:
    assert json.dumps(_packed(values)) == json.dumps(packed)


@pytest.mark.parametrize("make", [ballscrew, pick, short_shift])
@pytest.mark.parametrize("columns", [40, 1000])
def test_what_is_drawn_holds_every_peak(make: Callable[[], Run], columns: int) -> None:
    made = make()
    engine = Engine(made)
    for k, axis in enumerate(made.trace.axes):
        for order, quantity in enumerate(("position", "velocity", "acceleration")):
            points = np.array(engine(f"trackPoints(data.axes[{k}].track, {order}, 0, data.end, {columns})"))
            fine = made.trace.sample(2000.0, (axis,), quantities=(quantity,)).get(axis, quantity)
            reach = float(np.abs(fine).max())
            assert points[:, 1].max() >= fine.max() - 2e-3 * reach
            assert points[:, 1].min() <= fine.min() + 2e-3 * reach
            assert np.all(np.diff(points[:, 0]) >= 0.0)
            assert points[[0, -1], 0].tolist() == [0.0, pytest.approx(made.trace.end)]
            assert len(points) <= 4 * columns + 8


def test_zooming_in_shows_more_not_less() -> None:
    """A thousandth of the picture has as many points as the complete one."""
    engine = Engine(pick())
    points = engine("trackPoints(data.axes[1].track, 1, 0.2, 0.2001, 1000)")
    assert (points[0][0], points[-1][0]) == (0.2, 0.2001)
    assert len(points) > 40


def test_channels_hold_their_values() -> None:
    engine = Engine(switched())
    assert engine("data.lanes.map((lane) => lane.name)") == ["in3", "in12", "out1", "ain0"]
    out = "data.lanes[2].times, data.lanes[2].values, true"
    assert engine(f"[0.1, 0.15, 0.16, 0.7].map((time) => seriesAt({out}, time))") == [0, 0, 1, 0]
    assert engine(f"seriesPoints({out}, 0, 1.5, 100)") == [
        [0, 0], [0.150000001, 0], [0.150000001, 1], [0.6, 1], [0.6, 0], [1.5, 0]]  # fmt: skip
    assert engine(f"seriesPoints({out}, 0.2, 0.3, 100)") == [[0.2, 1], [0.3, 1]]


@pytest.mark.parametrize(
    ("low", "high", "values", "decimals"),
    [
        (0, 1, [0, 0.2, 0.4, 0.6, 0.8, 1], 1),
        (-420, 420, [-400, -200, 0, 200, 400], 0),
        (0, 7.5, [0, 2, 4, 6], 0),
        (0.123, 0.124, [0.123, 0.1232, 0.1234, 0.1236, 0.1238, 0.124], 4),
        (5, 5, [5], 0),
    ],
)
def test_ticks_are_round(low: float, high: float, values: list[float], decimals: int) -> None:
    found = Engine(ballscrew())(f"ticks({low}, {high}, 5)")
    assert found == {"values": pytest.approx(values), "decimals": decimals}


def test_the_move_and_its_phase_at_a_time() -> None:
    engine = Engine(pick())
    found = engine(
        "[0.1, 0.5, 1.2, 1.7].map((time) => moveAt(data.axes[0], time)).map((m) => m && [m.move.line, m.phase])"
    )
    assert found == [[5, "accel"], [5, "slew"], None, [12, "accel"]]


def test_the_script_is_javascript() -> None:
    racer = pytest.importorskip("py_mini_racer")
    script = files("motionlang.commands.scope").joinpath("script.js").read_text(encoding="utf-8")
    assert racer.MiniRacer().eval(f"new Function({json.dumps(script)}); 1") == 1


def test_a_servo_is_in_it() -> None:
    made = ballscrew()
    loop = Loop(proportional=0.05, derivative=0.5, dac_bits=12)
    servo = simulate(made.controller.axes[0], loop, make_plant({}), until=made.time)
    (axis,) = data_of(page(made, {0: servo}))["axes"]
    assert [(each["quantity"], each["unit"]) for each in axis["servo"]] == [
        ("following error", "uu"),
        ("output", "DAC steps"),
    ]
    assert max(axis["motor"]["values"]) == pytest.approx(servo.position.max() / 1200.0)


def test_the_program_s_lines_come_with_their_moves_and_end_no_script() -> None:
    text = page(run(Source("<b>.mnt", PROGRAM), dialect="mint"))
    assert data_of(text)["source"]["2"] == "MOVER(0) = 100 ' </script><script>alert(1)"
    assert text.count("</script>") == 2
    assert "<title>&lt;b>.mnt</title>" in text


def test_it_asks_no_network() -> None:
    addresses = set(re.findall(r"\w+://[^\s\"'`)]+", page(pick())))
    assert addresses <= {"http://www.w3.org/2000/svg"}
    assert not re.search(r"<(link|img|iframe)|@import|\bfetch\b|XMLHttpRequest|src=", page(pick()))


def test_no_motion_and_figures_that_overflow(tmp_path: Path) -> None:
    still, _ = new_run("hello.mnt")
    write_scope(ended(still), str(tmp_path / "x.html"))
    assert data_of((tmp_path / "x.html").read_text(encoding="utf-8"))["axes"][0]["moves"]["which"] == []
    huge, controller = new_run()
    controller.set_scale(0, 1e-300)
    controller.move_by(0, 1e12)
    controller.clock.advance(1.0)
    assert data_of(page(ended(huge)))["end"] == 1


def test_the_same_run_gives_the_same_bytes(tmp_path: Path) -> None:
    for name in ("one", "two"):
        write_scope(pick(), str(tmp_path / name))
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()


def test_a_rounding_error_is_no_block_of_the_critical_path() -> None:
    """Two links of this run have a gap of 4e-19 s, which must not be shown as a time."""
    program = generate(14)
    bands = data_of(page(run(Source(program.name, program.text), machine=program.machine, until=3.0)))[
        "bands"
    ]
    assert [(begin, end) for begin, end, *_ in bands[0]["spans"] if end - begin < 1e-12] == []


def test_a_page_holds_200000_records(monkeypatch: pytest.MonkeyPatch) -> None:
    made = pick()
    monkeypatch.setattr("motionlang.commands.scope._records", lambda run: 200_000)
    assert data_of(page(made))["axes"]
    monkeypatch.setattr("motionlang.commands.scope._records", lambda run: 200_001)
    with pytest.raises(ValueError, match="has 200001 records, but a page holds at most 200000; "):
        page(made)


def test_more_than_a_page_holds_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made, path = pick(), tmp_path / "a.html"
    log = made.controller.log
    records = (
        len(log.moves)
        + len(log.waits)
        + len(log.events)
        + len(log.inputs)
        + len(log.outputs)
        + len(log.slices)
    )
    monkeypatch.setattr("motionlang.commands.scope.MAX_RECORDS", records)
    write_scope(made, str(path), against=made)
    monkeypatch.setattr("motionlang.commands.scope.MAX_RECORDS", records - 1)
    path.unlink()
    for against in (None, made):
        with pytest.raises(
            ValueError, match=f"the run has {records} records, but a page holds at most {records - 1}; "
        ):
            write_scope(made, str(path), against=against)
    assert not path.exists()
