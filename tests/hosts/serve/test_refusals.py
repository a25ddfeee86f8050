"""Rejected hosts: one line at once, then one per second with the number of others."""

from __future__ import annotations

from motionlang.hosts.serve.refusals import Refusals


def test_at_most_one_line_a_second() -> None:
    time, lines = [100.0], list[str]()
    refusals = Refusals(lines.append, lambda: time[0])
    assert refusals.left is None
    for number in range(5):
        refusals.add(f"host {number}")
        time[0] += 0.125
    assert lines == ["host 0"]
    assert refusals.left == 1.0 - 5 * 0.125
    refusals.report()
    assert lines == ["host 0"]
    time[0] = 101.0
    refusals.report()
    assert lines == ["host 0", "host 4 (3 more since the last line)"]
    assert refusals.left is None
    refusals.add("host 5")
    assert len(lines) == 2
    refusals.flush()
    assert lines[2:] == ["host 5"]
    time[0] = 103.0
    refusals.add("host 6")
    assert lines[3:] == ["host 6"]
