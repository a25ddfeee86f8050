"""Fast-path moves: a run is equal if all moves are objects, to the last bit."""

from __future__ import annotations

from random import Random
from typing import Any

import pytest

from motionlang import run
from motionlang.controller.axis import Axis
from motionlang.controller.move import Move
from motionlang.fast.moves import FastAxis
from motionlang.log.track import WholeTrack
from motionlang.report import text
from motionlang.result import Run
from motionlang.source import Source
from tests.cases import cases, examples
from tests.mint.motion_programs import program

# A travel limit that some of the random moves reach, a switch, and a fault.
MACHINE: dict[str, object] = {
    "axis.0.travel": [-9.0, 19.0],
    "axis.1.travel": [-30.0, 40.0],
    "input": [{"channel": 3, "axis": 1, "between": [2.0, 5.0]}, {"channel": 4, "at": 0.5}],
    "fault": [{"axis": 2, "kind": "drive", "at": 3.0}],
}
# Readings of an axis that has just begun a move, and commands to it.
LOOKS = (
    "PRINT POS({k}); VEL({k}); POSREMAINING({k})",
    "PRINT IDLE({k}); MOVEBUFFERFREE({k})",
    "SPEED({k}) = {v}",
    "STOP({k})",
    "CANCEL({k})",
    "SUSPEND({k}) = 1 : WAIT({v}) : SUSPEND({k}) = 0",
    "POS({k}) = {v}",
    "MOVER({k}) = {v} : GO({k})",
    "INCR({k}) = {v}",
    "DRIVEENABLE({k}) = 0 : DRIVEENABLE({k}) = 1",
    "PAUSE POS({k}) > {v} - 60 Or IDLE({k})\n",
    "FOLLOW({o}) = 1 : MASTERSOURCE({o}) = 0 : WAIT({v}) : STOP({o})",
    "WAIT({v})",
    "PAUSE IDLE({k})\n",
    "PAUSE IDLE(0) And IDLE(1) And IDLE(2)\n",
    "OUTX(1) = 1",
    "ABORTMODE = 1",
)


def is_read(seed: int) -> str:
    """Return a program of fast-path moves whose axes are read at any time."""
    random = Random(seed)
    lines = ["SPEED(0, 1, 2) = 20, 35, 50", "ACCEL(0, 1, 2) = 300;", "DECEL(0, 1, 2) = 200, 400, 300"]
    for _ in range(random.randint(4, 14)):
        for k in random.sample(range(3), random.randint(1, 3)):
            word, value = random.choice((("MOVER", random.uniform(-4, 6)), ("MOVEA", random.uniform(-3, 8))))
            lines.append(f"{word}({k}) = {value:.3f} : GO({k})")
        for _ in range(random.randint(0, 2)):
            statement = random.choice(LOOKS).format(k=random.randrange(3), v=random.randint(1, 90), o=3)
            lines.extend(each for each in statement.split("\n") if each)
        if random.random() < 0.6:
            lines.append("PAUSE IDLE(0) And IDLE(1) And IDLE(2)")
    return "\n".join(lines) + "\nPRINT TIME; POS(0); POS(1); POS(2)\n"


def all_of(result: Run) -> list[object]:
    """Return the complete result of a run."""
    c, log = result.controller, result.machine.log
    tracks = [
        (start, profile.shape, profile.start, profile.end, profile.duration, profile.knots, profile.pieces)
        for a in c.axes.values()
        for start, profile in zip(*WholeTrack(a).between(0.0, result.time), strict=True)
    ]
    streams = (log.waits, log.slices, log.events, log.settings, log.prints, log.outputs, log.inputs)
    moves = [
        (
            m.axis,
            m.command,
            m.line,
            m.target,
            m.commanded_speed,
            m.base,
            m.id,
            m.speed,
            m.released,
            m.start_time,
            m.ended,
        )
        for stream in (log.moves, log.dropped)
        for m in stream
    ]
    rest = [(a.target, a.last_id, a.datum, a.move is None, len(a.buffer)) for a in c.axes.values()]
    return [text(result), c.clock.fired, c.clock.now, tracks, [list(each) for each in streams], moves, rest]


def orders(result: Run) -> list[object]:
    """Return the records that a run makes for the proof."""
    expected = result.expected_motion
    assert expected is not None
    found = [
        each._replace(tie=each.tie and each.tie._replace(master=each.tie.master.index, curve=None))  # type: ignore[arg-type]
        for each in (order for orders in expected.of.values() for order in orders)
    ]
    return [found, expected.data, expected.standstills]


def held_apart(
    text: str, monkeypatch: pytest.MonkeyPatch, machine: dict[str, object] | None, file: str = "a.mnt"
) -> list[Run]:
    """Return the runs of a program with fast-path moves and without them."""
    source = Source(file, text)
    first = run(source, cache=False, until=6.0, machine=machine, prove=True)
    with monkeypatch.context() as patch:
        patch.setattr(FastAxis, "loader", Axis.loader)
        patch.setattr(FastAxis, "start_at_once", Axis.start_at_once)
        second = run(source, cache=False, until=6.0, machine=machine, prove=True)
    return [first, second]


@cases("seed", range(examples(60)))
@pytest.mark.slow
def test_samples_make_no_difference(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    for machine in (None, MACHINE):
        plain, ordinary = held_apart(is_read(seed), monkeypatch, machine)
        assert all_of(plain) == all_of(ordinary)
        assert orders(plain) == orders(ordinary)


@cases("seed", range(examples(40)))
def test_nor_do_random_programs(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    plain, ordinary = held_apart(program(seed), monkeypatch, None)
    assert all_of(plain) == all_of(ordinary)


def commands(seed: int) -> str:
    """Return an MCCL program whose moves are read, changed and stopped at any time."""
    random = Random(seed)
    lines = ["1MN,2MN", "0SV2000,0SA9000,0DS7000", "MD1,{k}WS,{k}TP".format(k=random.randint(1, 2))]
    for _ in range(random.randint(8, 25)):
        k, far, near = random.randint(1, 2), random.randint(-900, 900), random.randint(1, 90)
        lines.append(
            random.choice(
                (
                    f"{k}MR{far}",
                    f"{k}MA{far}",
                    f"{k}MR{near},{k}WS",
                    f"{k}MA{far},{k}WS0.{near:02d}",
                    f"{k}MR{far},WA0.{near:02d},{k}TP,{k}TT",
                    f"{k}MR{far},{k}WR{far // 2},{k}TV",
                    f"{k}MR{far},WA0.05,{k}ST,{k}WS",
                    f"{k}MR{far},{k}WT",
                    f"{k}MR{far},MC1",
                    f"{k}SV{10 * near},{k}MR{near},{k}WS",
                    "0WS",
                    f"{k}MR0,{k}WS",
                    f"{k}MR{near},{k}WS,RP2",
                )
            )
        )
    return "\n".join(lines) + "\n"


@cases("seed", range(examples(40)))
def test_moves_of_mccl_begin_at_once_and_are_the_same(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    travel: dict[str, object] = {"axis.1.travel": [-700.0, 1500.0]}
    for machine in (None, travel):
        plain, ordinary = held_apart(commands(seed), monkeypatch, machine, "a.mcl")
        assert all_of(plain) == all_of(ordinary)
        assert orders(plain) == orders(ordinary)


def test_unread_mccl_move_stays_a_row() -> None:
    result = run(Source("a.mcl", "1MN,1SV100,1SA500,1DS500\n1MR50,1WS\n1MA0,1TV,1WS"), cache=False)
    assert stored_types(result) == [tuple, Move]
    assert result.time == pytest.approx(2 * (50 / 100 + 100 / 500), abs=1e-3)


def there_and_back(seed: int) -> str:
    """Return a program of moves back and forth, some with another speed or rate."""
    random = Random(seed)
    lines = []
    for _ in range(30):
        word, value = random.choice(
            (("SPEED", 20), ("SPEED", 9), ("ACCEL", 300), ("ACCEL", 100), ("DECEL", 200))
        )
        if random.random() < 0.25:
            lines.append(f"{word}(0, 1) = {value}, {value + random.choice((0, 5))}")
        axis, distance = random.randrange(2), random.choice((5, -5, 5, -5, 3))
        lines.append(f"MOVER({axis}) = {distance} : GO({axis})\nPAUSE IDLE({axis})")
    return "\n".join(lines) + "\n"


@cases("seed", range(examples(20)))
def test_repeated_distance_is_planned_with_the_present_rates(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    plain, ordinary = held_apart(there_and_back(seed), monkeypatch, None)
    assert all_of(plain) == all_of(ordinary)


def test_axis_that_moves_to_and_fro_has_a_plan_for_each_direction() -> None:
    text = "".join(f"MOVEA(0) = {5 * (n % 2)} : GO(0)\nPAUSE IDLE(0)\n" for n in range(1, 9))
    log: list[Any] = list(run(Source("a.mnt", text), cache=False).controller.log.moves.as_stored())
    recipes = [row[5] for row in log]
    assert len({id(recipe) for recipe in recipes}) == 2
    assert recipes[0] != recipes[1]


def stored_types(result: Run) -> list[type]:
    return [type(each) for each in result.controller.log.moves.as_stored()]


def test_unread_move_stays_a_row() -> None:
    source = Source(
        "a.mnt", "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nMOVER(0) = 5 : GO(0)\nPRINT VEL(0)\nPAUSE IDLE(0)"
    )
    result = run(source, cache=False)
    assert stored_types(result) == [tuple, Move]
    assert result.controller.axes[0].position(result.time) == 10.0


def test_travel_limits_beyond_the_move_need_no_check() -> None:
    source = Source("a.mnt", "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nMOVER(0) = 9 : GO(0)\nPAUSE IDLE(0)")
    result = run(source, cache=False, machine={"axis.0.travel": [-1.0, 10.0]})
    assert stored_types(result) == [tuple, Move]
    assert [each.ended for each in result.controller.log.moves] == ["", "fault"]


def test_what_is_read_first_afterwards_is_what_there_was() -> None:
    source = Source("a.mnt", "MOVER(0) = 5 : GO(0)\nPAUSE IDLE(0)\nMOVER(0) = -2 : GO(0)\nPAUSE IDLE(0)")
    a = run(source, cache=False).controller.axes[0]
    ends = [(profile.shape, profile.end) for profile in a.profiles]
    assert ends == [("hold", 0.0), ("trapezoid", 5.0), ("hold", 5.0), ("trapezoid", 3.0), ("hold", 3.0)]
    assert a.starts == sorted(a.starts)
