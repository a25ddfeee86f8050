"""Checks of log entries, one rule at a time.

Axis 0 moves by line 1 from 0 s to 1 s, over 10 counts, and by line 2 from 2 s to 3 s.
"""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.entries import Ends, _is_at_end, _is_refused, _last, check_ends, take_entry
from motionlang.commands.prove.order import Order, Tie
from motionlang.kernel.planners import Profile, hold, plan_trapezoid, plan_velocity

SHORT = plan_trapezoid(0.0, 10.0, 50.0, 40.0, 40.0)
JOG = plan_velocity("trapezoid", 0.0, 0.0, 10.0, 40.0, 40.0)
REST, ONE, TWO = Order("rest", 0), Order("move", 1), Order("move", 2)
SLOW = plan_trapezoid(10.0, 50.0, 50.0, 20.0, 20.0)
# The first 1.25 counts of SHORT, in 0.25 s.
CUT = SHORT.cut(0.25)


def track(starts: list[float], profiles: list[Profile], **fields: object) -> Any:
    return SimpleNamespace(
        index=0,
        starts=starts,
        profiles=profiles,
        index_at=lambda time: max([k for k, start in enumerate(starts) if start <= time], default=0),
        **{"waiting": [], "move": None, "feedback": None, **fields},
    )


def entry(start: float, profile: Profile | None, line: int, **fields: object) -> Any:
    given = {"axis": 0, "ended": "", "overlaid": False, "offset": 0.0, "scale": 1.0, "zero": 0.0, **fields}
    return SimpleNamespace(start_time=start, profile=profile, line=line, **given)


def violations(
    entries: list[Any],
    orders: tuple[Order, ...] = (ONE, REST, TWO, REST),
    a: Any = None,
    **given: Any,
) -> list[str]:
    """Return the violations of entries, without the start of the messages."""
    if a is None:
        a = track([0.0, 1.0, 2.0, 3.0], [SHORT, hold(10.0), SHORT.shifted(10.0), hold(20.0)])
    stops, until = given.get("stops", []), given.get("until", 9.0)
    expected: Any = SimpleNamespace(
        of={0: list(orders)},
        begun={0: given.get("begun", {0.0, 2.0})},
        was_cut=given.get("was_cut", False),
        scale=lambda axis, time: given.get("scales", {(1.0, 0.0)}),
        stopped=lambda axis, first, last: [each for each in stops if first <= each[0] <= last],
        was_stopped=lambda axis, word, time: any(each[1] == word and each[0] <= time for each in stops),
        refused=given.get("refused", {}),
        data={0: given.get("data", [0.0] * len(orders))},
    )

    def span(a: Any, i: int) -> tuple[float, float]:
        following = a.starts[i + 1] if i + 1 < len(a.starts) else until
        return a.starts[i], min(following, until)

    run: Any = SimpleNamespace(
        axes={0: a},
        expected_motion=expected,
        until=until,
        offsets={},
        span=span,
        order_of=lambda move: orders[a.index_at(move.start_time)],
        rest_of=lambda move: None,
        is_continued=lambda move: False,
        track=lambda master: a,
    )
    proof, ends = Proof(), dict[int, Ends]()
    for each in entries:
        take_entry(proof, ends, run, each)
    check_ends(proof, run, ends)
    return [each.message.removeprefix("axis 0 from ") for each in proof.violations]


FIRST, SECOND = entry(0.0, SHORT, 1), entry(2.0, SHORT.shifted(10.0), 2)
MASTER: Any = None


def at_rest(time: float) -> float:
    """Return the position at a time within a profile of 1 s."""
    assert 0.0 <= time <= 1.0
    return 10.0


WITHIN: Any = SimpleNamespace(position=at_rest, duration=1.0)
# The entries, what differs in the run, and the violations.
CASES: dict[str, tuple[list[Any], dict[str, Any], list[str]]] = {
    "as commanded": ([FIRST, SECOND], {}, []),
    "by another line": (
        [entry(0.0, SHORT, 7), SECOND], {}, ["0.000000 s: it is commanded by line 1"],
    ),
    "of another scale": (
        [FIRST, SECOND], {"scales": {(4.0, 0.0)}},
        ["0.000000 s: it has 1 counts per unit from 0, unlike its axis",
         "2.000000 s: it has 1 counts per unit from 0, unlike its axis"],
    ),
    "before any scale": ([FIRST, SECOND], {"scales": set()}, []),
    "one is missing": (
        [FIRST], {},
        ["2.000000 s: it moves without an entry in the log", "2.000000 s: it has no entry in the log",
         "0.000000 s: the last entry ends at 10, the axis is at 20"],
    ),
    "the first is missing": (
        [SECOND], {},
        ["0.000000 s: it moves without an entry in the log", "0.000000 s: it has no entry in the log"],
    ),
    "more motion than is stored": ([FIRST], {"was_cut": True}, []),
    "one too many": (
        [FIRST, entry(1.5, plan_trapezoid(10.0, 10.0, 1.0, 1.0, 1.0), 0), SECOND], {}, [],
    ),
    "motion that did not begin": (
        [FIRST, SECOND], {"begun": {0.0}}, ["2.000000 s: no motion without another entry begins then"],
    ),
    "a stop that was not commanded": (
        [entry(0.0, SHORT, 1, ended="stop"), SECOND], {},
        ["0.000000 s: it is logged as ended by a stop that was not commanded"],
    ),
    "a stop as commanded": ([entry(0.0, SHORT, 1, ended="stop"), SECOND], {"stops": [(0.5, "stop")]}, []),
    "a fault instead of a stop": (
        [entry(0.0, SHORT, 1, ended="fault"), SECOND], {"stops": [(0.5, "stop")]},
        ["0.000000 s: it is logged as ended by a fault that was not commanded"],
    ),
    "a stop that is not logged": (
        [FIRST, SECOND], {"stops": [(0.5, "stop")]},
        ["0.000000 s: a stop was commanded at 0.500000 s, but is not logged"],
    ),
    "a stop as the move begins": (
        [FIRST, SECOND], {"stops": [(2.0, "stop")]},
        ["2.000000 s: a stop was commanded at 2.000000 s, but is not logged"],
    ),
    "a stop as it ends": ([FIRST, SECOND], {"stops": [(3.0, "stop")]}, []),
    "a stop at rest": ([FIRST, SECOND], {"stops": [(1.5, "stop")]}, []),
    "replaced, with nothing that follows at once": (
        [entry(0.0, SHORT, 1, ended="retarget"), SECOND], {},
        ["0.000000 s: it is logged as replaced, but reaches its end",
         "2.000000 s: it does not start at 1.000000 s, when the previous one ends"],
    ),
    "replaced, and nothing follows": (
        [FIRST, entry(2.0, SHORT.shifted(10.0), 2, ended="retarget")], {},
        ["2.000000 s: it is logged as replaced, but reaches its end",
         "2.000000 s: nothing follows the replaced move"],
    ),
    "continued, although it is not full": (
        [FIRST, entry(2.0, SHORT.shifted(10.0), 2, ended="continued")], {},
        ["2.000000 s: it is logged as continued, but its entry is not full",
         "2.000000 s: nothing follows the replaced move"],
    ),
    "its points end elsewhere": (
        [FIRST, SECOND],
        {"orders": (ONE, REST, TWO._replace(points=([10.0, 21.0], [0.0, 0.0], [1.0])), REST)},
        ["2.000000 s: it is logged as complete, but its end is 21"],
    ),
    "its points end there by rounding": (
        [FIRST, SECOND],
        {"orders": (ONE, REST, TWO._replace(points=([10.0, 20.00001], [0.0, 0.0], [1.0])), REST)}, [],
    ),
    "it ends before its motion": (
        [FIRST, entry(2.0, CUT.shifted(10.0), 2, ended="stop")], {"stops": [(2.1, "stop")]},
        ["2.000000 s: it ends at 2.250000 s, its motion at 3.000000 s",
         "2.250000 s: it moves without an entry in the log",
         "2.000000 s: the last entry ends at 11.25, the axis is at 20"],
    ),
    "the axis is elsewhere": (
        [FIRST, SECOND], {"a": track([0.0, 1.0, 2.0, 3.0], [SHORT, hold(10.0), SHORT.shifted(10.0), hold(20.1)])},
        ["2.000000 s: the last entry ends at 20, the axis is at 20.1"],
    ),
    "the axis is there but for rounding": (
        [FIRST, SECOND],
        {"a": track([0.0, 1.0, 2.0, 3.0], [SHORT, hold(10.0), SHORT.shifted(10.0), hold(20.00001)])}, [],
    ),
    "the zero was moved since": (
        [FIRST, SECOND],
        {"a": track([0.0, 1.0, 2.0, 3.0], [SHORT, hold(10.0), SHORT.shifted(10.0), hold(25.0)]),
         "data": [0.0, 0.0, 0.0, 5.0]}, [],
    ),
    "the zero was moved before": (
        [FIRST, SECOND], {"data": [0.0, 0.0, 5.0, 5.0]}, [],
    ),
    "in progress at the end of the run": (
        [FIRST, SECOND], {"until": 2.5, "a": track(
            [0.0, 1.0, 2.0], [SHORT, hold(10.0), SHORT.shifted(10.0)], move=SECOND), "orders": (ONE, REST, TWO)}, [],
    ),
    "in progress, but its axis is not": (
        [FIRST, SECOND], {"until": 2.5, "a": track(
            [0.0, 1.0, 2.0], [SHORT, hold(10.0), SHORT.shifted(10.0)]), "orders": (ONE, REST, TWO)},
        ["2.000000 s: its entry ends at 3 s, the run at 2.5 s"],
    ),
    "in progress at another speed": (
        [FIRST, SECOND], {"until": 2.25, "a": track(
            [0.0, 1.0, 2.0], [SHORT, hold(10.0), SLOW], move=SECOND), "orders": (ONE, REST, TWO)},
        ["2.000000 s: its entries run at 10 counts/s at the end of the run, the axis at 5"],
    ),
    # The stop is the end of the first entry, and the start of the second one.
    "a stop between two entries": (
        [entry(0.0, SHORT, 1, ended="stop"), entry(1.0, SHORT.shifted(10.0), 2)],
        {"a": track([0.0, 1.0, 2.0], [SHORT, SHORT.shifted(10.0), hold(20.0)]), "orders": (ONE, TWO, REST),
         "begun": {0.0, 1.0}, "stops": [(1.0, "stop")]},
        [],
    ),
    "a stop between two entries that none states": (
        [entry(0.0, SHORT, 1), entry(1.0, SHORT.shifted(10.0), 2)],
        {"a": track([0.0, 1.0, 2.0], [SHORT, SHORT.shifted(10.0), hold(20.0)]), "orders": (ONE, TWO, REST),
         "begun": {0.0, 1.0}, "stops": [(1.0, "stop")]},
        ["1.000000 s: a stop was commanded at 1.000000 s, but is not logged"],
    ),
    "a stop with a profile of its own": (
        [FIRST],
        {"a": track([0.0, 0.5, 1.0], [SHORT, SHORT, hold(10.0)]), "orders": (ONE, Order("stop", 1), REST),
         "begun": {0.0}, "stops": [(0.5, "stop")]},
        ["0.000000 s: a stop was commanded at 0.500000 s, but is not logged"],
    ),
    "a stop of one that stops": (
        [FIRST],
        {"a": track([0.0, 0.5, 1.0], [SHORT, SHORT, hold(10.0)]), "orders": (ONE, Order("stop", 1), REST),
         "begun": {0.0}, "stops": [(0.6, "stop")]},
        [],
    ),
    # What follows a master ends by a stop, even at the end of its entry.
    "a stop at the end of a slave": (
        [FIRST],
        {"a": track([0.0, 1.0], [SHORT, hold(10.0)]), "orders": (Order("Gear", 1, tie=Tie(MASTER)), REST),
         "begun": {0.0}, "stops": [(1.0, "stop")]},
        ["0.000000 s: a stop was commanded at 1.000000 s, but is not logged"],
    ),
    # A slave at rest from 1 s to 2 s needs no entry.
    "a slave whose master rests": (
        [FIRST, SECOND],
        {"a": track([0.0, 1.0, 2.0, 3.0], [SHORT, WITHIN, SHORT.shifted(10.0), hold(20.0)]),
         "orders": (ONE, Order("Gear", 1), TWO, REST)},
        [],
    ),
    "a zero that is set as the last entry begins": (
        [FIRST, SECOND],
        {"a": track(
            [0.0, 1.0, 2.0, 2.0, 3.0], [SHORT, hold(10.0), SHORT.shifted(10.0), SHORT.shifted(15.0), hold(25.0)]),
         "orders": (ONE, REST, TWO, TWO, REST), "data": [0.0, 0.0, 0.0, 5.0, 5.0]},
        [],
    ),
    "a zero that was set after the only entry": (
        [FIRST],
        {"a": track([0.0, 1.0], [SHORT, hold(10.0)]), "orders": (ONE, REST), "begun": {0.0}, "data": [0.0, 5.0]},
        ["0.000000 s: the last entry ends at 15, the axis is at 10"],
    ),
    "a jog that is logged as complete": (
        [FIRST, entry(2.0, JOG.cut(1.0).shifted(10.0), 2)],
        {"a": track([0.0, 1.0, 2.0, 3.0], [SHORT, hold(10.0), JOG.cut(1.0).shifted(10.0), hold(18.75)]),
         "orders": (ONE, REST, Order("jog", 2), REST)},
        ["2.000000 s: it is logged as complete, but is still moving"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", CASES)
def test_the_entries_of_an_axis_are_its_motion(name: str) -> None:
    entries, given, expected = CASES[name]
    assert violations(entries, **given) == expected


# The order of the last profile, the time at which the entry ended, and whether that is its own end. The profile
# takes from 2 s to 3 s.
AT_END: dict[str, tuple[Order, float, bool]] = {
    "its own end": (TWO, 3.0, True),
    "its own end by rounding": (TWO, 3.0 - 3e-15, True),
    "before it": (TWO, 2.9, False),
    "a jog has none": (Order("jog", 2), 3.0, False),
    "nor has a stop": (Order("stop", 2), 3.0, False),
    "nor has a gear": (Order("Gear", 2), 3.0, False),
}


@pytest.mark.parametrize("name", AT_END)
def test_the_last_profile_of_an_entry_reaches_its_own_end(name: str) -> None:
    order, end, expected = AT_END[name]
    a = track([0.0, 2.0], [SHORT, SHORT])
    run: Any = SimpleNamespace(expected_motion=SimpleNamespace(of={0: [REST, order]}))
    assert _is_at_end(run, a, 1, end, 1e-14) is expected
    # A profile that begins one digit before the end has replaced it.
    replaced = track([0.0, 2.0, 3.0 - 5e-16], [SHORT, SHORT, SHORT])
    assert _is_at_end(run, replaced, 1, end, 1e-14) is False


@pytest.mark.parametrize(
    ("origin", "direction", "length", "expected"),
    [
        (2.0, 1, 8.0, True),
        (2.0, 1, 8.000007, True),
        (2.0, 1, 8.00001, False),
        (18.0, -1, 8.0, True),
        (18.0, 1, 8.0, False),
    ],
)
def test_a_flying_move_ends_with_the_distance_of_its_master(
    origin: float, direction: int, length: float, expected: bool
) -> None:
    """The master is at 10 counts at 1 s. A millionth of the distance is rounding."""
    master: Any = track([0.0, 1.0], [SHORT, hold(10.0)])
    tie = Tie(master, origin=origin, direction=direction, table=((0.0, length), (0.0, 5.0), "even"))
    run: Any = SimpleNamespace(
        expected_motion=SimpleNamespace(of={0: [TWO._replace(tie=tie)]}), track=lambda each: master
    )
    assert _is_at_end(run, track([0.0], [SHORT]), 0, 1.0, 1e-14) is expected


@pytest.mark.parametrize(
    ("start", "end", "index"),
    [
        (0.0, 1.0, 0),
        (0.0, 1.5, 1),
        (0.0, 2.0, 1),
        (0.0, 2.0 + 2e-15, 1),
        (2.0, 2.0, 2),
        (2.0, 2.5, 2),
        (0.0, 0.0, 0),
    ],
)
def test_the_last_profile_of_an_entry_began_before_its_end(start: float, end: float, index: int) -> None:
    assert _last(track([0.0, 1.0, 2.0], [SHORT, SHORT, SHORT]), start, end) == index


@pytest.mark.parametrize(
    ("refused", "last", "expected"),
    [
        ({}, 4.0, False),
        ({0: 4.0}, 3.0, True),
        ({0: 3.0}, 3.0, False),
        ({1: 4.0}, 4.0, True),
        ({1: 4.0}, 3.0, False),
    ],
)
def test_a_move_that_was_rejected_as_the_run_ended_waits(
    refused: dict[int, float], last: float, expected: bool
) -> None:
    """The run ends at 4 s. Another axis counts if a profile of this one begins then."""
    run: Any = SimpleNamespace(until=4.0, expected_motion=SimpleNamespace(refused=refused))
    assert _is_refused(run, track([0.0, last], [SHORT, SHORT])) is expected


@pytest.mark.parametrize(
    ("fields", "waits"),
    [
        ({}, True),
        ({"released": False}, False),
        ({"action": SimpleNamespace(lies_on_top=True)}, False),
    ],
)
def test_a_released_move_does_not_wait_at_rest(fields: dict[str, Any], waits: bool) -> None:
    move = SimpleNamespace(**{"line": 5, "action": None, "released": True, **fields})
    a = track([0.0, 1.0, 2.0, 3.0], [SHORT, hold(10.0), SHORT.shifted(10.0), hold(20.0)], waiting=[move])
    message = "axis 0: its move is waiting at the end of the run, but nothing is in motion"
    assert violations([FIRST, SECOND], a=a) == [message] * waits
    assert violations([FIRST, SECOND], a=a, refused={0: 9.0}) == []
    assert violations([FIRST, SECOND], a=a, was_cut=True) == []
    a.move = SECOND
    assert violations([FIRST, SECOND], a=a) == []
