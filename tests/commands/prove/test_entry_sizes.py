"""A log entry agrees with its profile to a millionth of its size.

Of a count, if that is more."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from motionlang.commands.prove.checker import Proof
from motionlang.commands.prove.checks import _check_move
from motionlang.kernel.planners import Profile, hold, plan_trapezoid
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


def compared(
    profile: Profile,
    start: float = 2.0,
    until: float = 1e9,
    error: Callable[[float], float] = lambda _: 0.0,
    **fields: Any,
) -> tuple[list[tuple[float, bool]], list[str]]:
    """Return the times at which an entry is compared with its track.

    Also return which are its end, and the violations. The track differs by an `error`, which depends on the time.
    """
    found: list[tuple[float, bool]] = []
    starts = fields.get("starts", [0.0])

    def logged(a: Any, move: Any, time: float, ending: bool) -> float:
        found.append((time, ending))
        return profile.position(time - start) + error(time)

    move: Any = SimpleNamespace(
        profile=profile, axis=0, start_time=start, line=3, offset=0.0, target=0.0, ended="", overlaid=False
    )
    axis = SimpleNamespace(
        index=0,
        move=None,
        starts=starts,
        index_at=lambda time: max(k for k, at in enumerate(starts) if at <= time),
    )
    expected = SimpleNamespace(data={0: fields.get("data", [0.0])})
    run: Any = SimpleNamespace(
        axes={0: axis}, until=until, order_of=lambda move: SimpleNamespace(kind="jog"),
        expected_motion=expected, logged=logged,
    )  # fmt: skip
    proof = Proof()
    _check_move(proof, run, move)
    return found, [each.message.removeprefix(f"axis 0 from {start:.6f} s: ") for each in proof.violations]


# The profile takes 11 s from 2 s on; other fields of the run; the times, and if the last one is the end.
TIMES: list[tuple[Profile, dict[str, Any], list[float], bool]] = [
    (THOUSAND, {}, [2.0, 4.31, 7.5, 11.13, 13.0], True),
    (THOUSAND, {"until": 12.0}, [2.0, 4.1, 7.0, 10.3, 12.0], True),
    (THOUSAND, {"until": 1.0}, [2.0], False),
    (hold(5.0).cut(0.0), {}, [2.0] * 5, False),
    # A new zero at 7 s, and one that a later one cancels.
    (THOUSAND, {"starts": [0.0, 7.0], "data": [1.0, 4.0]}, [2.0, 4.31], False),
    (THOUSAND, {"starts": [0.0, 7.0, 8.0], "data": [1.0, 4.0, 1.0]}, [2.0, 4.31, 11.13, 13.0], True),
    (THOUSAND, {"starts": [0.0, 7.0], "data": [1.0]}, [2.0, 4.31, 7.5, 11.13, 13.0], True),
    (THOUSAND, {"data": []}, [2.0, 4.31, 7.5, 11.13, 13.0], True),
    (THOUSAND, {"starts": []}, [], False),
]


@cases("profile, fields, times, has_end", TIMES)
def test_an_entry_is_compared_with_its_track_at_five_times(
    profile: Profile, fields: dict[str, Any], times: list[float], has_end: bool
) -> None:
    found, wanted = compared(profile, **fields)
    assert [time for time, _ in found] == pytest.approx(times)
    assert [ending for _, ending in found] == [False] * (len(times) - 1) + [has_end] * bool(times)
    assert wanted == []


# 1000 counts in 2 ms at up to 1e6 counts/s.
FAST = plan_trapezoid(0.0, 1e3, 1e6, 1e9, 1e9)
ERRORS: list[tuple[Profile, float, float, list[str]]] = [
    (THOUSAND, 2.0, 0.000_999, []),
    (THOUSAND, 2.0, 0.001_1, ["the log has it at 0 at 2.000000 s, the track at 0.0011"]),
    (THOUSAND, 2.0, -5.0, ["the log has it at 0 at 2.000000 s, the track at -5"]),
    (TENTH.shifted(-3e3), 2.0, 0.002_9, []),
    (TENTH, 2.0, 0.000_000_9, []),
    (TENTH, 2.0, 0.000_001_1, ["the log has it at 0 at 2.000000 s, the track at 1.1e-06"]),
]


@cases("profile, start, error, wanted", ERRORS)
def test_an_entry_agrees_with_its_track(
    profile: Profile, start: float, error: float, wanted: list[str]
) -> None:
    assert compared(profile, start, error=lambda _: error)[1] == wanted


def test_an_entry_late_in_a_run_is_as_exact_as_its_time() -> None:
    """Eight roundings of 1e6 s at 1e6 counts/s are 0.8 mcounts, and a millionth is 1."""
    for error, count in ((0.0016, 0), (0.0021, 1)):
        middle = 1e6 + 0.5 * FAST.duration

        def at_speed(time: float, error: float = error, middle: float = middle) -> float:
            return error if abs(time - middle) < 1e-6 else 0.0

        assert len(compared(FAST, 1e6, error=at_speed)[1]) == count
