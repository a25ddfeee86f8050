"""Which events of a run make its exit status 1."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

from motionlang.kernel import Source
from motionlang.kernel.controller import HOMING
from motionlang.kernel.failures import failed_events, located
from tests.cases import cases

NONE: frozenset[str] = frozenset()


def event(
    kind: str, axis: int | None = 0, time: float = 1.0, at: int = -1, ordered: int = 0, text: str = "why"
) -> tuple[object, ...]:
    return time, kind, axis, None, None, at, ordered, text


def run(*events: tuple[object, ...]) -> Any:
    """Return a run with events, in which axes 0 and 5 moved; the line of an offset is a tenth of it."""
    log = SimpleNamespace(events=list(events), moves=[SimpleNamespace(axis=axis) for axis in (0, 5)])
    language = SimpleNamespace(locate=lambda source, at: (1 + at // 10, 1))
    return SimpleNamespace(machine=SimpleNamespace(log=log), dialect=language, source=Source("a.mnt", ""))


LIMIT = "a.mnt: limit on axis 0 at 1 s (why); --allow limit accepts it"
FAULT = "a.mnt: fault on axis 0 at 1 s (why); --allow fault accepts it"
HANDLER, CLEARED = event("handler", None), event("cleared")
# The events, the kinds that are allowed, and the messages.
RUNS: tuple[tuple[list[tuple[object, ...]], frozenset[str], list[str]], ...] = (
    ([event("limit")], NONE, [LIMIT]),
    ([event("limit")], frozenset(("limit",)), []),
    ([event("limit")], frozenset(("fault",)), [LIMIT]),
    # The first of a kind and axis.
    ([event("limit"), event("limit", time=2.0), event("limit", 1, 1234567.8)], NONE,
     [LIMIT, "a.mnt: limit on axis 1 at 1.23457e+06 s (why); --allow limit accepts it"]),
    ([event("velocity jump"), event("wait")], NONE, []),
    # A line that the event states precedes that of its offset; an offset of 0 is one.
    ([event("limit", at=0)], NONE, [LIMIT.replace("mnt:", "mnt:1:", 1)]),
    ([event("limit", at=25)], NONE, [LIMIT.replace("mnt:", "mnt:3:", 1)]),
    ([event("limit", at=25, ordered=7)], NONE, [LIMIT.replace("mnt:", "mnt:7:", 1)]),
    # A fault is handled by a handler, or by clearing it on its axis, afterwards; a limit is not.
    ([event("fault")], NONE, [FAULT]),
    ([event("fault"), HANDLER], NONE, []),
    ([event("fault"), CLEARED], NONE, []),
    ([HANDLER, CLEARED, event("fault")], NONE, [FAULT]),
    ([event("fault"), event("cleared", 1)], NONE, [FAULT]),
    ([event("limit"), HANDLER], NONE, [LIMIT]),
    ([event("abort"), event("e-stop")], frozenset(("fault",)), []),
    ([event("abort")], NONE, [FAULT.replace("fault", "abort", 1)]),
    ([event("soft limit")], NONE, [LIMIT.replace("limit on", "soft limit on").replace("--allow", "--allow soft-limit")
                                   .replace("soft-limit limit", "soft-limit")]),
    # One message for all axes that have the event at the same time.
    ([event("limit"), event("limit", 2), event("limit", 1, text="else")], NONE,
     [LIMIT.replace("axis 0", "axes 0, 2"), LIMIT.replace("axis 0", "axis 1").replace("why", "else")]),
    ([event("limit", text="")], NONE, [LIMIT.replace(" (why)", "")]),
    # ABORT is an error of every axis; the message names those that moved, if any did.
    ([event("abort"), event("abort", 1, at=25), event("abort", 5, at=25)], NONE,
     [FAULT.replace("fault", "abort", 1), FAULT.replace("a.mnt: fault on axis 0", "a.mnt:3: abort on axis 5", 1)]),
    ([event("abort", 1), event("abort", 2)], NONE, [FAULT.replace("fault on axis 0", "abort on axes 1, 2", 1)]),
    # A homing looks for its limit.
    ([event("limit", text=HOMING)], NONE, []),
)  # fmt: skip


@cases("events, allowed, messages", RUNS)
def test_the_messages_of_events(
    events: list[tuple[object, ...]], allowed: frozenset[str], messages: list[str]
) -> None:
    made = run(*events)
    assert [f"{located(each, made)}; {each.hint}" for each in failed_events(made, allowed)] == messages
