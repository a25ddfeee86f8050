"""Common fixtures of the MCCL tests: run a text and return the run."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from motionlang import Run, run
from motionlang.kernel import Source

Runner = Callable[..., Run]


@pytest.fixture
def mccl() -> Runner:
    """Return a function that runs an MCCL text, with the keywords of `motionlang.run`."""

    def start(text: str, **options: object) -> Run:
        return run(Source("test.mcl", text), dialect="mccl", **options)  # type: ignore[arg-type]

    return start
