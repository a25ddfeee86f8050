"""The start of a path before the end of the previous one, each rule by hand.

The previous path covers 20 counts at 10 counts/s and 10 counts/s²: it is at 5 after 1 s, at 15 after 2 s, and at
rest after 3 s. At 2 s it has 5 left.
"""

from __future__ import annotations

from math import inf
from types import SimpleNamespace
from typing import Any

from motionlang.analysis.proof.blends import _check_begin, _plan_index, _planned
from motionlang.analysis.proof.checker import Proof
from motionlang.log.order import Order, PathOrder
from motionlang.planners import hold, plan_trapezoid, plan_velocity
from tests.cases import cases

FREE = (inf,)


def path(**fields: Any) -> PathOrder:
    return PathOrder(
        (0,), (1.0,), 0.0, 0, True, (20.0,), (0.0, 0.0), 0.0, (), (0, 1), None, FREE, FREE, FREE, 0.0, entry=1
    )._replace(**fields)  # fmt: skip


def ordered(**fields: Any) -> Order:
    return Order("path", 4, speed=10.0, rates=(10.0, 10.0), shape="trapezoid", path=path(**fields))


FIRST = ordered()


def violations(blend: float, **fields: Any) -> list[str]:
    """Return the violations of a path that begins at 2 s, or as given."""
    begin = fields.get("begin", 2.0)
    second = ordered(entry=2, begun=begin, blend=blend, **fields.get("path", {}))
    before: Any = SimpleNamespace(
        profile=plan_trapezoid(0.0, 20.0, 10.0, 10.0, 10.0),
        start_time=0.0,
        axis=0,
        ended=fields.get("ended", ""),
    )
    begun: Any = SimpleNamespace(profile=hold(0.0), start_time=begin, axis=0)
    starts, orders = fields.get("starts", [0.0, begin]), fields.get("orders", [FIRST])
    master: Any = SimpleNamespace(index=0, starts=starts)
    prompts = fields.get("prompts", [])
    earlier = fields.get("earlier", FIRST)
    run: Any = SimpleNamespace(
        members=lambda each: [begun] if each.entry == 2 else [before] if fields.get("logged", True) else [],
        path_before=lambda move: fields.get("before", before) if move is begun else None,
        rest_of=lambda move: fields.get("rest_of"),
        order_of=lambda move: earlier,
        origins=lambda each: [0.0],
        paths={0: [before, begun]},
        expected_motion=SimpleNamespace(
            of={0: [*orders, second]},
            prompted=lambda number, first, last: [each for each in prompts if first <= each[0] <= last],
        ),
    )
    proof = Proof()
    _check_begin(proof, run, master, len(starts) - 1, second)
    assert all(each.line == 4 for each in proof.violations)
    return [each.message.removeprefix(f"path from {begin:.6f} s: ") for each in proof.violations]


EARLY = "it begins {} before the end of the previous one, commanded at most {}"
LATE = "it begins {} before the end of the previous one, commanded {}"
REST = Order("rest", 0)
BEGINS: dict[str, tuple[float, dict[str, Any], list[str]]] = {
    "as commanded": (5.0, {}, []),
    "too early": (4.0, {}, [EARLY.format(5, 4)]),
    "too late": (6.0, {}, [LATE.format(5, 6)]),
    # A millionth of 20 is rounding.
    "early by rounding": (4.999_981, {}, []),
    "early by more": (4.999_979, {}, [EARLY.format(5, 4.99998)]),
    "late by rounding": (5.000_019, {}, []),
    "late by more": (5.000_021, {}, [LATE.format(5, 5.00002)]),
    # It may overlap half of the previous path.
    "more than half": (15.0, {"begin": 1.5}, []),
    "early in the first half": (15.0, {"begin": 1.4}, [EARLY.format(11, 10)]),
    "not blended": (0.0, {"begin": 3.0}, []),
    "not blended, and early": (0.0, {}, []),
    "not blended, of one that is": (0.0, {"path": {"tails": (FIRST,)}}, [EARLY.format(5, 0)]),
    # BLEND begins it at once; any prompt may begin it later, but not one of another time.
    "by BLEND": (4.0, {"prompts": [(2.0, "blend")]}, []),
    "by GO": (4.0, {"prompts": [(2.0, "go")]}, [EARLY.format(5, 4)]),
    "by GO, late": (6.0, {"prompts": [(2.0, "go")]}, []),
    "after GO": (6.0, {"prompts": [(1.9, "go")]}, [LATE.format(5, 6)]),
    "another distance": (6.0, {"prompts": [(1.0, "blend_distance")]}, []),
    "another mode": (4.0, {"prompts": [(1.0, "blend_mode")]}, []),
    "another mode afterwards": (4.0, {"prompts": [(2.1, "blend_mode")]}, [EARLY.format(5, 4)]),
    "suspended": (6.0, {"path": {"comes_to_rest": True}}, []),
    "suspended, and early": (4.0, {"path": {"comes_to_rest": True}}, [EARLY.format(5, 4)]),
    # There is no previous path, or it does not lead to this one.
    "the first": (4.0, {"before": None}, []),
    "of an axis at rest": (4.0, {"orders": [REST]}, []),
    "the rest of an entry": (4.0, {"rest_of": FIRST}, []),
    "after a move": (4.0, {"earlier": Order("move", 2)}, []),
    "after other axes": (4.0, {"earlier": ordered(members=(1,))}, []),
    "after a stop": (4.0, {"earlier": ordered(comes_to_rest=True)}, []),
    "after itself": (4.0, {"earlier": ordered(entry=2)}, []),
    "after one that was ended": (4.0, {"ended": "stop"}, []),
    "after one that was ended, but blended": (
        4.0, {"ended": "stop", "path": {"tails": (FIRST,)}}, [EARLY.format(5, 4)],
    ),
    "after one that is not logged": (4.0, {"logged": False}, []),
    # What began at the same time takes no time.
    "after an end at the same time": (4.0, {"starts": [0.0, 2.0, 2.0], "orders": [FIRST, REST]}, [EARLY.format(5, 4)]),
    "after a rest": (4.0, {"starts": [0.0, 1.0, 2.0], "orders": [FIRST, REST]}, []),
}  # fmt: skip


@cases("name", BEGINS)
def test_a_path_begins_at_its_distance_from_the_end_of_the_previous_one(name: str) -> None:
    blend, fields, expected = BEGINS[name]
    assert violations(blend, **fields) == expected


def test_joined_paths_were_planned_when_the_first_of_them_began() -> None:
    """Three paths of 1 s follow one another. A rest or a gap separates them."""
    jog, rest = (
        plan_velocity("trapezoid", 0.0, 10.0, 10.0, 1.0, 1.0).cut(1.0),
        plan_trapezoid(0.0, 5.0, 10.0, 20.0, 20.0),
    )

    def planned(*entries: tuple[float, Any]) -> float:
        moves: list[Any] = [SimpleNamespace(start_time=start, profile=profile) for start, profile in entries]
        run: Any = SimpleNamespace(
            path_before=lambda move: moves[k - 1] if (k := moves.index(move)) else None
        )
        return _planned(run, moves[-1])

    assert planned((4.0, jog)) == 4.0
    assert planned((4.0, jog), (5.0, jog), (6.0, jog)) == 4.0
    assert planned((4.0, jog), (5.1, jog), (6.1, jog)) == 5.1
    assert planned((4.0, None), (5.0, jog), (6.0, jog)) == 5.0
    assert planned((4.0, rest), (4.0 + rest.duration, jog)) == 4.0 + rest.duration


TAIL, OTHER = ordered(entry=9), ordered(entry=8)
FASTER, STOPS = TAIL._replace(speed=11.0), ordered(entry=9, comes_to_rest=True)
# The orders of the profiles up to the one at which the tail is blended, and the index of its plan.
PLANS: list[tuple[tuple[Order, ...], int]] = [
    ((), 0),
    ((TAIL,), 0),
    ((TAIL, TAIL), 0),
    ((OTHER, TAIL), 1),
    ((TAIL, OTHER), 2),
    ((FASTER, TAIL), 1),
    ((STOPS, TAIL, TAIL), 1),
    ((TAIL._replace(rates=(10.0, 11.0)), TAIL, TAIL), 1),
    ((ordered(entry=8, tails=(TAIL,)), TAIL), 0),
    ((ordered(entry=8, tails=(FASTER,)), TAIL), 1),
    ((REST, TAIL), 1),
]


@cases("orders, expected", PLANS)
def test_the_profile_at_which_a_blended_path_was_planned(orders: tuple[Order, ...], expected: int) -> None:
    run: Any = SimpleNamespace(expected_motion=SimpleNamespace(of={0: [*orders, OTHER]}))
    master: Any = SimpleNamespace(index=0)
    assert _plan_index(run, master, len(orders), TAIL) == expected
