"""A log entry agrees with its profile to a millionth of its size.

Of a count, if that is more."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.analysis.proof.checker import Proof
from motionlang.analysis.proof.prove import _check_move
from motionlang.planners import Profile, hold, plan_trapezoid
from tests.cases import cases


def violations(profile: Profile, target: float, **fields: Any) -> list[str]:
    """Return the violations of an entry at 0 s whose axis has gone on to another."""
    given = {"kind": "move", "until": 1e9, "offset": 0.0, "ended": "", "is_last": False, **fields}
    move: Any = SimpleNamespace(
        profile=profile,
        axis=0,
        start_time=0.0,
        line=3,
        offset=given["offset"],
        target=target,
        ended=given["ended"],
        overlaid=True,  # its track is that of two moves, and is not compared
    )
    axis = SimpleNamespace(move=move if given["is_last"] else None)
    order = SimpleNamespace(kind=given["kind"])
    run: Any = SimpleNamespace(axes={0: axis}, until=given["until"], order_of=lambda move: order)
    proof = Proof()
    _check_move(proof, run, move)
    assert proof.counts["moves"] == 1
    return [each.message.removeprefix("axis 0 from 0.000000 s: ") for each in proof.violations]


# 1000 counts at 100 counts/s and 100 counts/s² take 11 s.
MILLION, THOUSAND = (plan_trapezoid(0.0, size, size / 10.0, size / 10.0, size / 10.0) for size in (1e6, 1e3))
TENTH = plan_trapezoid(0.0, 0.1, 1.0, 1.0, 1.0)
# A profile, its target, other fields of the entry, and the violations.
ENTRIES: tuple[tuple[Profile, float, dict[str, Any], list[str]], ...] = (
    (MILLION, 1e6, {}, []),
    (MILLION, 1e6 + 0.99, {}, []),
    (MILLION, 1e6 + 1.01, {}, ["it ends at 1e+06, commanded 1e+06"]),
    (THOUSAND, 1000.000999, {}, []),
    (THOUSAND, 1000.01, {}, ["it ends at 1000, commanded 1000.01"]),
    (TENTH, 0.1000009, {}, []),
    (TENTH, 0.100002, {}, ["it ends at 0.1, commanded 0.100002"]),
    # Its end is that of its profile and an offset.
    (THOUSAND, 1005.0, {"offset": 5.0}, []),
    (THOUSAND, 1000.0, {"offset": 5.0}, ["it ends at 1005, commanded 1000"]),
    # An entry that still runs, has been ended, or has no target need not reach one.
    (THOUSAND, 7.0, {"is_last": True}, []),
    (THOUSAND, 7.0, {"ended": "stop"}, []),
    (THOUSAND, 7.0, {"kind": "jog"}, []),
    (THOUSAND, 7.0, {"until": 10.9}, []),
    (THOUSAND, 7.0, {"until": 11.0}, ["it ends at 1000, commanded 7"]),
    (THOUSAND, 7.0, {"kind": "step"}, ["it ends at 1000, commanded 7"]),
    (hold(5.0), 7.0, {"kind": "rest", "until": 1e300}, []),
)


@cases("profile, target, fields, wanted", ENTRIES)
def test_an_entry_ends_at_its_target(
    profile: Profile, target: float, fields: dict[str, Any], wanted: list[str]
) -> None:
    assert violations(profile, target, **fields) == wanted


@pytest.mark.parametrize(
    ("field", "factor", "wanted"),
    [
        ("duration", 1.0 + 0.9e-6, []),
        ("duration", 1.0 + 1.1e-6, ["the phases take 11 s, the move 11 s"]),
        ("distance", 1.0 + 0.9e-6, []),
        ("distance", 1.0 + 1.1e-6, ["the phases cover 1000 counts, the move 1000"]),
    ],
)
def test_the_phases_of_an_entry_add_up(field: str, factor: float, wanted: list[str]) -> None:
    """A profile whose duration or distance is stated a millionth too long."""

    class Stated:
        def __getattr__(self, name: str) -> Any:
            value = getattr(THOUSAND, name)
            return value * factor if name == field else value

    profile: Any = Stated()
    assert violations(profile, 1000.0) == wanted
