"""Forged logs: the proof rejects each of 100 single changes.

`-m long` takes all of them.
"""

from __future__ import annotations

import pytest

from tests.forged.logs import Forged, candidates, chosen, forge


def accepted(logs: list[Forged]) -> list[str]:
    """Return the forged logs whose motion differs, but which the proof accepts."""
    found = []
    for each in logs:
        result, differs = forge(each)
        if differs and not result.proof().violations:
            found.append(str(each))
    return found


def test_a_forged_log_is_rejected() -> None:
    logs = chosen(112)
    assert sum(forge(each)[1] for each in logs) >= 100
    assert accepted(logs) == []


@pytest.mark.long
def test_every_forged_log_is_rejected() -> None:
    assert accepted(list(candidates())) == []
