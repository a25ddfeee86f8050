"""Forged logs: the proof rejects each of 100 single changes.

`-m long` takes all of them.
"""

from __future__ import annotations

import pytest

from tests.proof import prove
from tests.proof.forged.logs import Forged, candidates, chosen, forge


def verdicts(logs: list[Forged]) -> dict[str, bool]:
    """Return whether the proof accepts each of the forged logs whose motion differs."""
    found = {}
    for each in logs:
        result, differs = forge(each)
        if differs:
            found[str(each)] = not prove(result).violations
    return found


@pytest.mark.slow
def test_a_forged_log_is_rejected() -> None:
    found = verdicts(chosen(112))
    assert len(found) >= 100
    assert [name for name, is_accepted in found.items() if is_accepted] == []


@pytest.mark.long
def test_every_forged_log_is_rejected() -> None:
    assert not any(verdicts(list(candidates())).values())
