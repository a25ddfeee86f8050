"""The rules of inputs that `init` finds in a recording."""

from __future__ import annotations

import pytest

from motionlang.commands.recording import RecordedTable
from motionlang_explore.init.recorded.drafting import entries_of
from motionlang_explore.init.recorded.recording import measured_recording
from tests.commands.recording.spelled import STEP

# The keys and the figures of each input.
Rules = list[tuple[tuple[str, ...], dict[str, float]]]


def rules_of(table: RecordedTable) -> Rules:
    _, given, _ = entries_of(measured_recording(table, ()))
    entries: list[dict[str, float]] = given["input"]  # type: ignore[assignment]
    return [(tuple(each), each) for each in entries]


def assert_same_rules(found: Rules, right: Rules) -> None:
    """Check that rules have the same keys, and figures within a step."""
    assert [keys for keys, _ in found] == [keys for keys, _ in right]
    for (_, mine), (_, exact) in zip(found, right, strict=True):
        assert mine == pytest.approx(exact, abs=STEP)
