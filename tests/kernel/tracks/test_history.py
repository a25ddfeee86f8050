"""Motor data after a run, from blocks of four samples whose numbers are known."""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from motionlang.kernel import Controller
from motionlang.kernel.controller.feedback import Feedback
from motionlang.kernel.servo import ServoTrace
from motionlang.kernel.servo.samples import REST_ERROR
from motionlang.kernel.tracks import history, recall, servo_trace
from motionlang.kernel.tracks.history import MotorFigures, Reader, figures, motors, notes, window_of
from tests.kernel.servo.test_trace_figures import trace

# A sample every millisecond, from 8 ms on: sample k has the error k, the output 10 k and the torque k / 2.
FIRST, COUNT = 8, 4


def blocks(number: int) -> list[tuple[float, ServoTrace]]:
    made = []
    for first in range(FIRST, FIRST + number * COUNT, COUNT):
        values = [float(k) for k in range(first, first + COUNT)]
        made.append((first / 1000.0, trace(values, [10.0 * k for k in values], values)))
    return made


@pytest.fixture
def replays(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Have an axis with four blocks; return the ends of the replays that were started."""
    ends: list[float] = []

    def chunks(a: Any, until: float) -> Any:
        ends.append(until)
        return iter(blocks(4))

    monkeypatch.setattr(history, "chunks", chunks)
    return ends


def read(reader: Reader, quantity: str, *milliseconds: float) -> list[float]:
    out = np.empty(len(milliseconds))
    reader.fill(quantity, np.array(milliseconds) / 1000.0, out)
    found: list[float] = out.tolist()
    return found


AXIS: Any = SimpleNamespace(position=lambda time: 100.0 + time, feedback=True)
CONTROLLER: Any = SimpleNamespace(axes={0: AXIS}, clock=SimpleNamespace(now=9.0))


@pytest.mark.usefixtures("replays")
@pytest.mark.parametrize(
    ("quantity", "factor"), [("following error", 1.0), ("output", 10.0), ("torque", 0.5), ("actual", -1.0)]
)
def test_a_column_has_the_value_of_the_sample_before(quantity: str, factor: float) -> None:
    found = read(Reader(AXIS, 9.0), quantity, 8.0, 8.9, 9.0, 11.9, 12.0, 15.999999, 19.2, 23.0, 40.0)
    assert found == [factor * k for k in (8, 8, 9, 11, 12, 16, 19, 23, 23)]


def test_blocks_are_replayed_again_only_for_earlier_times(replays: list[float]) -> None:
    """The blocks begin at 8, 12, 16 and 20 ms."""
    reader = Reader(AXIS, 9.0)

    def held() -> list[int]:
        return [round(1000.0 * first) for first, _ in reader._loaded]

    assert (read(reader, "output", 8.0, 9.0), held()) == ([80.0, 90.0], [8])
    assert (read(reader, "output", 9.0, 11.9), held()) == ([90.0, 110.0], [8])
    assert (read(reader, "output", 8.5, 12.0), held()) == ([80.0, 120.0], [8, 12])
    assert (read(reader, "output", 12.0, 13.0), held()) == ([120.0, 130.0], [12])
    assert (read(reader, "output", 18.0, 20.5), held()) == ([180.0, 200.0], [16, 20])
    assert (read(reader, "output", 16.0, 18.0), held()) == ([160.0, 180.0], [16, 20])
    assert replays == [9.0]
    assert (read(reader, "output", 15.0, 16.0), held()) == ([150.0, 160.0], [12, 16])
    assert replays == [9.0, 9.0]
    assert (read(reader, "output", 30.0, 90.0), held()) == ([230.0, 230.0], [20])
    assert replays == [9.0, 9.0]


def test_times_before_the_first_sample_do_not_replay_again(replays: list[float]) -> None:
    reader = Reader(AXIS, 9.0)
    for _ in range(2):
        assert read(reader, "output", 1.0, 8.0, 13.0) == [80.0, 80.0, 130.0]
    assert replays == [9.0]


def test_an_axis_without_samples_is_where_it_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(history, "chunks", lambda a, until: iter(()))
    assert recall(CONTROLLER, 0, "actual", [1.0, 2.0]) == [109.0, 109.0]
    assert recall(CONTROLLER, 0, "torque", [1.0, 2.0]) == [0.0, 0.0]
    assert recall(CONTROLLER, 0, "torque", []) == []


@pytest.mark.usefixtures("replays")
def test_values_are_recalled_as_a_list() -> None:
    assert recall(CONTROLLER, 0, "torque", [0.009, 0.0135]) == [4.5, 6.5]


def moved(begin: float, duration: float | None, axis: int = 0, overlaid: bool = False) -> Any:
    profile = None if duration is None else SimpleNamespace(duration=duration / 1000.0)
    return SimpleNamespace(axis=axis, start_time=begin / 1000.0, profile=profile, overlaid=overlaid)


@pytest.mark.usefixtures("replays")
def test_the_figures_of_moves_across_blocks() -> None:
    """A move ends with its duration, as the next one begins, or with the run.

    The run ends at 22 ms. The root mean square of the torque of the samples 9 to 11 is half of
    sqrt((81 + 100 + 121) / 3). The window is one count, so a motor settles only if the next move begins at once.
    """
    windows = {"program": SimpleNamespace(error=inf, announced=False)}
    axes = {0: SimpleNamespace(feedback=SimpleNamespace(windows=windows)), 1: SimpleNamespace(feedback=None)}
    log = [
        moved(9.0, 2.0),
        moved(9.5, 2.0, axis=1),
        moved(13.0, 90.0),
        moved(13.5, 2.0, overlaid=True),
        moved(14.0, None),
        moved(15.5, 0.5),
        moved(19.0, 90.0),
        moved(25.0, 90.0),
    ]
    controller: Any = SimpleNamespace(
        axes=axes, log=SimpleNamespace(moves=log), clock=SimpleNamespace(now=0.022)
    )
    found = figures(controller)
    assert motors(controller) == {0: axes[0].feedback}

    def expected(*samples: int, settled: float | None = None) -> MotorFigures:
        mean: Any = pytest.approx(0.5 * (sum(k * k for k in samples) / len(samples)) ** 0.5)
        return MotorFigures(max(samples), 10.0 * max(samples), mean, settled)

    assert [found.get(number) for number in range(len(log))] == [
        expected(9, 10, 11),
        None,
        expected(13, 14, 15, settled=0.0),
        None,
        None,
        expected(15, 16),
        expected(19, 20, 21, 22),
        MotorFigures(0.0, 0.0, 0.0, 0.0),
    ]
    assert len(found) == 5
    assert [number in found for number in (0, 1, 7, 8, 99, "0")] == [True, False, True, False, False, False]


@pytest.mark.parametrize("end", [15, 16, 17])
@pytest.mark.usefixtures("replays")
def test_the_sample_at_the_end_of_a_move_counts_in_any_block(end: int) -> None:
    """Blocks begin each 4 ms from 8 ms on; the move ends as the next one begins."""
    windows = {"program": SimpleNamespace(error=inf, announced=False)}
    controller: Any = SimpleNamespace(
        axes={0: SimpleNamespace(feedback=SimpleNamespace(windows=windows))},
        log=SimpleNamespace(moves=[moved(13.0, 90.0), moved(float(end), 2.0)]),
        clock=SimpleNamespace(now=0.022),
    )
    found = figures(controller).get(0)
    assert found is not None
    assert (found.peak_error, found.peak_output) == (end, 10.0 * end)


@pytest.mark.parametrize(
    ("error", "announced", "window"),
    [(7.0, True, 7.0), (7.0, False, REST_ERROR), (inf, True, REST_ERROR), (inf, False, REST_ERROR)],
)
def test_the_settling_window_of_a_motor(error: float, announced: bool, window: float) -> None:
    feedback: Any = SimpleNamespace(windows={"program": SimpleNamespace(error=error, announced=announced)})
    assert window_of(feedback) == window == (7.0 if announced and error < inf else 1.0)


def fitted(section: dict[str, object]) -> Controller:
    controller = Controller(2)
    a = controller.axes[0]
    a.feedback = Feedback(a, {"load_inertia": 4e-5}, section)
    return controller


def test_a_trace_in_one_object_has_a_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    """At 1 kHz, 100 samples are 0.1 s."""
    monkeypatch.setattr(history, "MAX_SAMPLES", 100)
    controller = fitted({"proportional": 0.02})
    a = controller.axes[0]
    assert servo_trace(a, 0.1) is None  # never used
    controller.move_to(0, 100.0)
    controller.clock.advance(0.1)
    found = servo_trace(a, 0.1)
    assert found is not None
    assert found.loop.servo_rate == 1000.0
    assert len(found) in (100, 101)
    assert servo_trace(a, 0.1011) is None
    assert servo_trace(controller.axes[1], 0.1) is None
    assert list(history.servo_traces(controller)) == [0]
    assert [first for first, _ in history.chunks(a, 0.1)][:1] == [0.0]
    assert list(history.chunks(controller.axes[1], 0.1)) == []


@pytest.mark.parametrize(
    ("section", "note"),
    [
        (
            {"bandwidth": 20.0},
            ["axis 0: its motor has no gains; it ran with those suggested for 20 Hz"],
        ),
        (
            {"proportional": 0.02},
            [
                "axis 0: the gains of the machine file act 1000 times a second here, and 4000 times in motionlang "
                "servo; servo_rate = 1000 in [axis.0.servo] tunes them for this rate"
            ],
        ),
        ({"proportional": 0.02, "servo_rate": 1000.0}, []),
        ({"proportional": 0.0}, ["axis 0: all gains of its motor are 0, so it does not follow its demand"]),
    ],
)
def test_notes_on_gains(section: dict[str, object], note: list[str]) -> None:
    controller = fitted(section)
    assert notes(controller) == []
    controller.move_to(0, 100.0)
    controller.clock.advance(0.1)
    assert notes(controller) == note
