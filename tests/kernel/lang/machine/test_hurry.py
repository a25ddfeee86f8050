"""A loop of motions without a wait is reported once, while the run goes on."""

from __future__ import annotations

import pytest

from motionlang.kernel import Machine, Source, run


@pytest.mark.slow
def test_warn_is_called_once_for_each_warning(monkeypatch: pytest.MonkeyPatch) -> None:
    """The log is checked at 1025 profiles, and 2048 later. One motion every 30 us gives 4000 in 0.12 s."""
    monkeypatch.setattr("motionlang.kernel.log.log.INTERVAL", 2048)
    reported: list[tuple[float, int]] = []

    def begun(machine: Machine) -> None:
        machine.warn = lambda diagnostic: reported.append((machine.clock.now, diagnostic.line))

    text = "Dim k As Float\nLoop\n  k = k + 0.001\n  JOG(0) = k\nEnd Loop\n"
    result = run(Source("a.mnt", text), until=0.12, begun=begun)
    ((time, line),) = reported
    (found,) = result.diagnostics
    assert (line, time, found.count) == (4, found.first, 2)
    assert time < 0.04
    assert result.machine.warned == [found]
