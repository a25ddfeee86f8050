"""Two reports that differ in one place, and the difference that is found there.

The reports are written by hand: a move of 10 uu in 1 s.
"""

from __future__ import annotations

import random
import re
from typing import Any

import pytest

from motionlang import diff
from motionlang.commands.diff.align import aligned

Report = dict[str, Any]


def move(line: int = 1, axis: int = 0, begin: float = 0.0, **fields: Any) -> Report:
    phases = [{"name": "accel", "duration": 0.5, "distance": 5.0}]
    return {
        "axis": axis, "command": "MOVER", "line": line, "start_time": begin, "duration": 1.0, "distance": 10.0,
        "phases": phases, **fields,
    }  # fmt: skip


def report(*moves: Report, **fields: Any) -> Report:
    return {"schema": "motionlang.report/2", "time": 5.0, "status": "ended", "moves": list(moves), **fields}


def phases(name: str = "accel", duration: float = 0.5, distance: float = 5.0) -> list[Report]:
    return [{"name": name, "duration": duration, "distance": distance}]


@pytest.mark.parametrize(
    ("fields", "figures"),
    [
        ({}, {}),
        ({"duration": 1.5}, {"duration": (1.0, 1.5)}),
        ({"duration": 1.0 + 1e-12}, {}),
        ({"start": 1.0}, {"start": (None, 1.0)}),
        ({"ended": "stop"}, {"ended": (None, "stop")}),
        ({"profile": "scurve"}, {"profile": (None, "scurve")}),
        ({"phases": phases("slew")}, {"phases": ("accel", "slew")}),
        ({"phases": phases(duration=0.25)}, {"accel": (0.5, 0.25)}),
        ({"phases": phases(distance=4.0)}, {"accel distance": (5.0, 4.0)}),
        ({"phases": phases(duration=0.25, distance=4.0)}, {"accel": (0.5, 0.25)}),
        ({"motor": {"rms": 2.0}}, {"rms": (None, 2.0)}),
        ({"motor": None}, {}),
    ],
)
def test_the_figures_of_a_move(fields: Report, figures: dict[str, tuple[object, object]]) -> None:
    found = diff(report(move()), report(move(**fields)))
    assert [change.figures for change in found.lines] == ([figures] if figures else [])
    assert found.same is not bool(figures)
    assert found.first == ((0.0, 0) if figures else None)
    assert not found.is_commanded


def test_figures_of_a_motor() -> None:
    old, new = ({"rms": 2.0, "peak": 3.0, "settle_time": 1.0}, {"rms": 2.5, "peak": 3.0, "settle_time": 1.0})
    found = diff(report(move(motor=old)), report(move(motor=new)))
    assert found.lines[0].figures == {"rms": (2.0, 2.5)}


def test_a_commanded_speed_is_no_motion() -> None:
    found = diff(report(move(commanded_speed=5.0)), report(move(commanded_speed=6.0)))
    assert (found.same, found.first, found.is_commanded) == (False, None, True)
    assert not diff(report(), report()).is_commanded


def test_the_moves_of_a_line_together() -> None:
    """The durations add up, the first figures are shown.

    A later start alone is a wait.
    """
    old = report(move(), move(begin=1.0), move(begin=2.0))
    new = report(move(duration=1.25), move(begin=1.25, duration=1.5), move(begin=3.0))
    (change,) = diff(old, new).lines
    assert (change.old, change.new, change.axis, change.command, change.count) == (1, 1, 0, "MOVER", 3)
    assert change.duration == pytest.approx(0.75)
    # The third move begins at 3 instead of 2.75, where the second one ends.
    assert change.wait == pytest.approx(0.25)
    assert change.figures == {"duration": (1.0, 1.25)}
    assert change.is_motion


def test_a_later_motion_shifts_what_follows_and_is_reported_once() -> None:
    """The move takes 0.5 s longer.

    So the second one and the end of the run come 0.5 s later.
    """
    old = report(move(), move(2, begin=1.0))
    new = report(move(duration=1.5), move(2, begin=1.5), time=5.5)
    found = diff(old, new)
    assert [(change.old, change.wait) for change in found.lines] == [(1, 0.0)]
    assert (found.time, found.tail) == ((5.0, 5.5), 0.0)
    # When motion began and ended, and how much later that is.
    assert found.later == [(0.0, 0, 0.0), (1.0, 0, 0.5), (1.0, 0, 0.5), (2.0, 0, 0.5)]
    assert diff(old, {**new, "time": 6.0}).tail == pytest.approx(0.5)


def test_a_move_without_an_end_has_no_end_to_compare() -> None:
    old, new = report(move(duration=None)), report(move(duration=None, begin=0.5))
    found = diff(old, new)
    assert found.later == [(0.0, 0, 0.5)]
    assert found.lines[0].wait == pytest.approx(0.5)


def test_moves_that_only_one_run_has() -> None:
    old = report(move(1), move(2, begin=1.0, distance=3.0), move(3, begin=2.0))
    extra = [move(2, axis=5, begin=1.0), move(2, axis=6, begin=1.0)]
    new = report(
        move(1), *extra, move(2, begin=1.0, distance=3.0), move(3, begin=2.0), move(4, axis=7, begin=3.0)
    )
    found = diff(old, new)
    assert [each["axis"] for each in found.new] == [5, 6, 7]
    assert found.removed == []
    assert found.moves == (3, 6)
    assert found.first == (1.0, 5)
    back = diff(new, old)
    assert [each["axis"] for each in back.removed] == [5, 6, 7]


def test_lines_with_other_numbers_are_no_diff() -> None:
    old = report(move(1), move(2, begin=1.0, distance=3.0))
    new = report(move(1), move(9, begin=1.0, distance=3.0))
    found = diff(old, new)
    assert (found.same, found.moved) == (True, {2: 9})


@pytest.mark.parametrize(
    ("old", "new", "prints"),
    [
        (["a 1"], ["a 1"], []),
        (["a 1"], ["a 2"], [(1, 1, "a 1", "a 2")]),
        (["a"], ["a", "b"], [(None, 2, "", "b")]),
        (["a", "b"], ["b"], [(1, None, "a", "")]),
    ],
)
def test_prints(old: list[str], new: list[str], prints: list[tuple[object, ...]]) -> None:
    found = diff(report(output=old), report(output=new))
    assert found.prints == prints


def event(time: float = 1.0, kind: str = "clamp", **fields: Any) -> Report:
    return {"kind": kind, "time": time, "axis": 0, "value": 5.0, "limit": 4.0, **fields}


@pytest.mark.parametrize(
    ("fields", "differs", "later"),
    [
        ({}, False, 0.0),
        ({"value": 6.0}, True, 0.0),
        ({"limit": 3.0}, True, 0.0),
        ({"text": "speed"}, True, 0.0),
        ({"time": 1.25}, True, 0.25),
        ({"time": 1.0 + 1e-12}, False, 0.0),
        ({"line": 7}, False, 0.0),
    ],
)
def test_an_event(fields: Report, differs: bool, later: float) -> None:
    found = diff(report(events=[event()]), report(events=[{**event(), **fields}]))
    assert [shift for _, _, shift in found.events] == ([later] if differs else [])


def test_figures_of_events_have_the_tolerance_of_positions_or_of_speeds() -> None:
    for kind, differs in (
        ("limit", False),
        ("soft limit", False),
        ("following error", False),
        ("clamp", True),
    ):
        old, new = report(events=[event(kind=kind)]), report(events=[event(kind=kind, value=5.5)])
        assert bool(diff(old, new, "position=1uu").events) is differs


@pytest.mark.parametrize(
    ("was", "time", "axis", "differs"),
    [
        (0.5, 0.5, 0, False),
        (0.5, 1.0, 0, True),
        (1.0, 1.0, 0, False),
        (1.0, 1.5, 0, False),
        (1.0, 1.5, 1, False),
        (1.0, 2.0, 0, True),
        (1.0, 2.0, 1, True),
    ],
)
def test_an_event_may_shift_with_the_motion_or_stay(
    was: float, time: float, axis: int, differs: bool
) -> None:
    """The only move ends 0.5 s later, at 1.5 s.

    An event at its end may come as much later, on any axis.
    """
    old = report(move(), events=[event(was, axis=axis)])
    new = report(move(duration=1.5), events=[event(time, axis=axis)])
    assert bool(diff(old, new).events) is differs


def test_events_and_errors_that_only_one_run_has() -> None:
    wrong = {"severity": "error", "code": "limit", "message": "stopped in line 5"}
    found = diff(
        report(events=[event()], diagnostics=[wrong]),
        report(
            events=[], diagnostics=[{**wrong, "message": "stopped in line 9"}, {**wrong, "code": "never"}]
        ),
    )
    assert [(was is None, is_ is None) for was, is_, _ in found.events] == [(False, True)]
    assert found.errors == [("added", "error[never]: stopped in line")]
    assert diff(report(diagnostics=[wrong]), report()).errors == [
        ("removed", "error[limit]: stopped in line"),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("old", "new", "lines"),
    [
        ({"a": 1}, {"a": 1}, []),
        ({"a": 1}, {"a": 2}, ["axes.a is 2 instead of 1"]),
        ({"a": 1}, {"b": 1}, ["axes.a is missing", "axes.b is new"]),
        ({"line": 1, "column": 2}, {"line": 5, "column": 6}, []),
        ([1, 2], [1, 3, 4], ["axes has 3 entries instead of 2", "axes[1] is 3 instead of 2"]),
        (None, [1], ["axes is new"]),
        ([1], None, ["axes is missing"]),
        ("see line 5", "see line 9", []),
        ("x", "y", ['axes is "y" instead of "x"']),
        (1, 1.0, ["axes is 1.0 instead of 1"]),
        ({"time": 1.0}, {"time": 1.0 + 1e-12}, []),
    ],
)
def test_other_fields_by_their_path(old: object, new: object, lines: list[str]) -> None:
    found = diff(report(axes=old), report(axes=new))
    assert found.others == lines
    assert found.same is not bool(lines)


def test_time_and_status() -> None:
    found = diff(report(), report(time=6.0, status="until"))
    assert (found.time, found.status, found.tail) == ((5.0, 6.0), ("ended", "until"), 1.0)
    assert diff(report(), report(time=5.5), "time=1s").same


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ([], "it is not a report of a run"),
        ({"schema": "other/1"}, "it is not a report of a run"),
        (report(output="x"), "its output are not a list"),
        (report(events=[{"kind": "x"}]), "its event 0 has no kind or time"),
        (report(move(), {}), "its move 1 lacks axis, command, line, start_time, phases, duration, distance"),
        (report(move(line="1")), "its move 0 lacks line"),  # type: ignore[arg-type]
        (report(move(phases=[{}])), "its move 0 lacks a field of a phase"),
        (report(1), "its move 0 lacks axis, command, line, start_time, phases"),  # type: ignore[arg-type]
    ],
)
def test_what_is_no_report(value: Any, message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        diff(value, report())


@pytest.mark.parametrize("event", [{"time": 1.0}, {"kind": "stop"}, {}, None])
def test_an_event_without_kind_or_time_is_no_event_of_a_report(event: object) -> None:
    with pytest.raises(ValueError, match="its event 1 has no kind or time"):
        diff(report(events=[{"kind": "stop", "time": 0.5}, event]), report())


@pytest.mark.parametrize(
    ("texts", "field", "expected", "found", "same"),
    [
        (["time=2ms"], "duration", 1.0, 1.0019, True),
        (["time=2ms"], "duration", 1.0, 0.9979, False),
        (["time=2ms"], "end", 1.0, 1.001, False),  # a position
        (["time=2ms", "position=0.1uu"], "end", -1.0, -1.09, True),
        (["speed=2%"], "peak_speed", 100.0, 98.1, True),  # 2 % of the larger one
        (["speed=2%"], "peak_speed", 98.1, 100.0, True),
        (["speed=2%"], "peak_speed", 100.0, 97.9, False),
        (["speed=2%", "speed=3uu/s"], "peak_speed", 100.0, 97.1, True),  # the wider one counts
        (["speed=2%"], "note", 100.0, 99.0, False),
        ([], "", 1e6, 1e6 + 0.5e-3, True),  # a billionth is rounding
        ([], "", 1e6, 1e6 + 2e-3, False),
        ([], "", 0.0, 0.9e-12, True),
        ([], "", 0.0, 2e-12, False),
        ([], "", 3, 3, True),
        ([], "", 3, 3.0, False),
        ([], "", "a", "b", False),
        ([], "", float("inf"), float("inf"), True),
    ],
)
def test_two_figures_are_the_same_within_a_tolerance(
    texts: list[str], field: str, expected: object, found: object, same: bool
) -> None:
    old, new = (report(axes=[{field or "figure": each}]) for each in (expected, found))
    assert diff(old, new, *texts).same is same


def common_length(a: list[str], b: list[str]) -> int:
    """Return the length of the longest common subsequence, by a table of all prefixes."""
    table = [[0] * (len(b) + 1) for _ in range(len(a) + 1)]
    for i, one in enumerate(a):
        for j, other in enumerate(b):
            best = max(table[i][j + 1], table[i + 1][j])
            table[i + 1][j + 1] = table[i][j] + 1 if one == other else best
    return table[-1][-1]


def test_what_two_outputs_have_in_common_is_the_longest_there_is_and_the_first_of_equal_lines() -> None:
    """Lines are put in and taken out as late as possible."""
    draw = random.Random(4)
    for _ in range(500):
        a, b = ([draw.choice("wxyz") for _ in range(draw.randrange(13))] for _ in range(2))
        found = aligned(a, b, str)
        pairs = [(i, j) for i, j in found if i is not None and j is not None]
        assert all(a[i] == b[j] for i, j in pairs)
        assert pairs == sorted(pairs)
        assert len({i for i, _ in pairs}) == len({j for _, j in pairs}) == common_length(a, b)
        assert sorted(i for i, _ in found if i is not None) == list(range(len(a)))
        assert sorted(j for _, j in found if j is not None) == list(range(len(b)))
        i_last = j_last = -1
        for i, j in pairs:
            assert not (i == i_last + 1 and j > j_last + 1 and b[j_last + 1] == a[i])
            assert not (j == j_last + 1 and i > i_last + 1 and a[i_last + 1] == b[j])
            i_last, j_last = i, j


def test_outputs_that_are_too_different_are_compared_line_by_line() -> None:
    """Both are of one kind, figures aside."""
    a, b = ([f"{sign}{n}" for n in range(3000)] for sign in ("a ", "b "))
    found = diff(report(output=a), report(output=b))
    assert len(found.prints) == 6000
    found = diff(report(output=a), report(output=a[::-1]))
    assert found.prints == [(n + 1, n + 1, a[n], a[-1 - n]) for n in range(3000)]
