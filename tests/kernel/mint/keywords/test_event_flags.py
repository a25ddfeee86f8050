"""A handler of an event that the simulated machine never raises gives a message."""

from __future__ import annotations

import pytest

from motionlang.commands.check import check
from motionlang.kernel import Source
from motionlang.kernel.mint import DIALECT
from motionlang.kernel.mint.keywords.event_kinds import KINDS, SINGLE, SOURCELESS


def handler(kind: str) -> Source:
    name = kind.upper() + ("" if kind in SINGLE else "1")
    return Source("a.mnt", f"WAIT = 1\nEnd\nEvent {name}\n  PRINT 1\nEnd Event\n")


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_event_can_be_handled(kind: str) -> None:
    messages = [each.message for each in check(handler(kind), DIALECT)]
    name = kind.upper() + ("" if kind in SINGLE else "1")
    assert messages == ([f"the event {name} never occurs here"] if kind in SOURCELESS else [])


def test_warning_names_what_raises_the_event() -> None:
    (warning,) = check(handler("knife"), DIALECT)
    assert (warning.severity, warning.line, warning.hint) == ("warning", 3, "EVENTPEND(16, 0, 0) raises it")
