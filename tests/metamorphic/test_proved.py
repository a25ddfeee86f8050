"""Random jobs of several axes, each proved: contours, and trains of slaves.

Contours have limits and events in motion. `MOTIONLANG_LONG=2000` runs that many of each.
"""

from __future__ import annotations

import os
from collections.abc import Callable

import pytest

from motionlang.kernel import Source
from tests.cases import examples
from tests.metamorphic.jobs import Contour, Train
from tests.proof import prove, run

COUNT = int(os.environ.get("MOTIONLANG_LONG", examples(40)))
KINDS: dict[str, Callable[[int], Contour | Train]] = {
    "contours": lambda seed: Contour(seed, events=False),
    "contours with events": lambda seed: Contour(seed, events=True),
    "masters and slaves": Train,
}


@pytest.mark.parametrize("kind", KINDS)
def test_random_jobs_keep_every_bound_and_end(kind: str) -> None:
    for seed in range(COUNT):
        machine = {"controller.instruction_time": 1e-9}
        job = KINDS[kind](seed)
        result = run(Source("job.mnt", job.text), machine=machine, until=2000.0)
        messages = [each.message for each in (*result.diagnostics, *prove(result, views=False).violations)]
        assert (result.status, messages) == ("ended", []), f"{kind}, seed {seed}:\n{job.text}"
